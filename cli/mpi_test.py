# SPDX-License-Identifier: Apache-2.0
"""Campaigns over MPI. Usage: mpi_test.py PATH_OF_QUADBOUND [unittest options]"""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = ""
MPIRUN = ("mpirun", "-n", "4", "--oversubscribe", "--allow-run-as-root")
# Open MPI 4 ends all ranks with one of them unless told otherwise; then its own status is always 0.
RECOVERY = ("--enable-recovery",)


class MpiTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def start(self, *words):
        return subprocess.Popen(words, cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def campaign(self, count, *more):
        return (PROGRAM, "fuzz", "--count", str(count), "--family", "regular,star", "--max-n", "9",
                "--max-cells", "20000", "--min-tangent", "2/5", "--shrink-tries", "0", *more)

    def alone(self, count):
        """Table, summary and findings of the campaign without MPI."""
        process = self.start(*self.campaign(count, "--summary", "alone.json", "--findings", "found"))
        table, error = process.communicate()
        self.assertEqual(process.returncode, 1, error)
        index = sorted((self.folder / "found/INDEX").read_text().splitlines())
        os.remove(self.folder / "found/INDEX")
        os.remove(self.folder / "found/journal-1.jsonl")
        return table, (self.folder / "alone.json").read_bytes(), index

    def over_mpi(self, count, *more):
        return self.start(*MPIRUN, *more, *self.campaign(count, "--mpi", "--resume", "--summary",
                                                         "mpi.json", "--findings", "found"))

    def outcome(self, process, status=1):
        table, error = process.communicate(timeout=120)
        self.assertEqual(process.returncode, status, error)
        index = sorted((self.folder / "found/INDEX").read_text().splitlines())
        return table, (self.folder / "mpi.json").read_bytes(), index

    def cases(self):
        journal = self.folder / "found/journal-1.jsonl"
        return len(journal.read_text().splitlines()) - 1 if journal.exists() else 0

    def wait_for_cases(self, count):
        deadline = time.monotonic() + 60
        while self.cases() < count:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    @staticmethod
    def rank(process, number):
        """The process of a rank of this mpirun."""
        for entry in pathlib.Path("/proc").iterdir():
            try:
                if entry.name.isdigit() and f"PPid:\t{process.pid}\n" in (entry / "status").read_text():
                    environment = (entry / "environ").read_bytes().split(b"\0")
                    if f"OMPI_COMM_WORLD_RANK={number}".encode() in environment:
                        return int(entry.name)
            except OSError:
                pass
        raise LookupError(number)

    def test_the_same_as_without_mpi(self):
        alone = self.alone(60)
        self.assertEqual(self.outcome(self.over_mpi(60)), alone)

    def test_a_lost_rank_costs_nothing_where_mpirun_lets_the_others_live(self):
        alone = self.alone(200)
        process = self.over_mpi(200, *RECOVERY)
        self.wait_for_cases(20)
        os.kill(self.rank(process, 2), signal.SIGKILL)
        self.assertEqual(self.outcome(process, status=0), alone)

    def test_where_mpirun_ends_all_ranks_the_campaign_goes_on_with_resume(self):
        alone = self.alone(200)
        process = self.over_mpi(200)
        self.wait_for_cases(20)
        os.kill(self.rank(process, 2), signal.SIGKILL)
        process.communicate(timeout=60)
        self.assertNotIn(process.returncode, (0, 1))
        self.assertGreaterEqual(self.cases(), 20)
        self.assertEqual(self.outcome(self.over_mpi(200)), alone)

    def test_one_rank_is_too_few(self):
        process = self.start(*self.campaign(1, "--mpi"))
        _, error = process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.assertIn("quadbound: --mpi needs two ranks or more", error)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
