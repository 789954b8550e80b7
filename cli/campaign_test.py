# SPDX-License-Identifier: Apache-2.0
"""Campaigns that stop and go on. Usage: campaign_test.py PATH_OF_QUADBOUND [unittest options]"""

import json
import os
import pathlib
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = ""
# Cases of a few milliseconds, some of them with a finding.
SMALL = ("--family", "regular,star", "--max-n", "9", "--seed", "3", "--max-cells", "20000")
STRICT = ("--min-tangent", "2/5", "--shrink-tries", "3")


class CampaignTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def start(self, *arguments, **more):
        return subprocess.Popen([PROGRAM, "fuzz", *map(str, arguments)], cwd=self.folder,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)

    def run_it(self, *arguments, status=0, **more):
        """Standard output and standard error."""
        process = self.start(*arguments, **more)
        output, error = process.communicate()
        self.assertEqual(process.returncode, status, (arguments, error))
        return output, error

    def lines(self, name):
        return (self.folder / name).read_text().splitlines()

    def wait_for_lines(self, name, count):
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            if (self.folder / name).exists() and len(self.lines(name)) >= count:
                return
            time.sleep(0.005)
        self.fail(f"{name} has no {count} lines")

    def stopped(self, *arguments, by, lines):
        """Starts a campaign, stops it, and returns standard output and standard error."""
        process = self.start(*arguments)
        self.wait_for_lines(arguments[arguments.index("--journal") + 1], lines)
        process.send_signal(by)
        output, error = process.communicate()
        self.assertEqual(process.returncode, -by, error)
        return output, error


class StoredCounters(CampaignTest):
    """The mesher counts its work; all counts are integers of the algorithm, the same on every
    machine. A change that means to change them runs this with STORE_COUNTERS=1 and says why."""

    STORED = pathlib.Path(__file__).with_name("stored_counters.json")

    def test_a_campaign_counts_what_it_has_counted_before(self):
        self.run_it("--count", 130, "--seed", 1, "--max-cells", 30000, "--max-seconds", 1000,
                    "--summary", "summary.json", "--quiet")
        summary = json.loads((self.folder / "summary.json").read_text())
        counted = {
            "counters": summary["counters"],
            "families": {name: {key: family[key] for key in ("proved", "vertices", "cells", "quads")}
                         for name, family in summary["families"].items()},
            "constructions": {name: made["quads"]
                              for name, made in summary["constructions"].items()}}
        if "STORE_COUNTERS" in os.environ:
            self.STORED.write_text(json.dumps(counted, indent=1) + "\n")
        self.maxDiff = None
        self.assertEqual(counted, json.loads(self.STORED.read_text()))


class Resume(CampaignTest):
    COUNT = 150

    def campaign(self, name, *more, count=COUNT):
        return ("--count", count, *SMALL, *STRICT, "--threads", 2, "--findings", f"{name}/found",
                "--summary", f"{name}.json", "--journal", f"{name}.jsonl", *more)

    def told(self, name):
        """The summary without the folder of the findings."""
        return (self.folder / f"{name}.json").read_text().replace(f"{name}/found", "found")

    def findings(self, name):
        return sorted(line.replace(f"{name}/found", "found") for line in
                      self.lines(f"{name}/found/INDEX"))

    def test_kill_9_and_ctrl_c_change_nothing_in_the_end(self):
        whole, _ = self.run_it(*self.campaign("whole"), status=1)
        self.stopped(*self.campaign("cut"), by=signal.SIGKILL, lines=20)
        _, error = self.stopped(*self.campaign("cut", "--resume"), by=signal.SIGINT, lines=60)
        self.assertRegex(error, r"quadbound: interrupted after \d+ cases.*--resume goes on\n\Z")
        so_far = json.loads(self.told("cut"))
        self.assertTrue(so_far["unfinished"])
        self.assertIn(so_far["all"]["cases"], range(59, self.COUNT))
        resumed, _ = self.run_it(*self.campaign("cut", "--resume"), status=1)
        self.assertEqual(resumed, whole)
        self.assertEqual(self.told("cut"), self.told("whole"))
        self.assertEqual(self.findings("cut"), self.findings("whole"))
        for name in ("whole", "cut"):
            for line in self.lines(f"{name}/found/INDEX"):
                case = self.folder / shlex.split(line.split("\t")[2])[3]
                self.assertTrue(case.exists())
                self.assertTrue(case.with_name(case.stem + "-small.geojson").exists())

    def test_what_is_done_is_not_done_again(self):
        self.run_it(*self.campaign("once"), status=1)
        before = self.told("once"), len(self.lines("once.jsonl"))
        begin = time.monotonic()
        self.run_it(*self.campaign("once", "--resume"), status=1)
        self.assertLess(time.monotonic() - begin, 5)
        self.assertEqual((self.told("once"), len(self.lines("once.jsonl")) - 1), before)

    def test_a_larger_count_adds_cases(self):
        whole, _ = self.run_it(*self.campaign("whole", count=40), status=1)
        self.run_it(*self.campaign("parts", count=15), status=1)
        parts, _ = self.run_it(*self.campaign("parts", "--resume", count=40), status=1)
        self.assertEqual((parts, self.told("parts")), (whole, self.told("whole")))
        _, error = self.run_it(*self.campaign("parts", "--resume", count=20), status=2)
        self.assertIn("is beyond --count 20", error)

    def test_a_torn_last_line_is_done_again(self):
        self.run_it(*self.campaign("whole", count=30), status=1)
        journal = self.folder / "whole.jsonl"
        text = journal.read_bytes()
        journal.write_bytes(text[:len(text) * 2 // 3].rstrip(b"\n"))
        before = self.told("whole")
        self.run_it(*self.campaign("whole", "--resume", count=30), status=1)
        self.assertEqual(self.told("whole"), before)
        self.assertEqual(len(self.lines("whole.jsonl")), 32)

    def test_a_full_disk_is_told_and_loses_no_finding(self):
        self.run_it(*self.campaign("whole", count=60), status=1)

        def no_room():  # a file of more than 6000 bytes is an error, as on a full disk
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (6000, 6000))

        _, error = self.run_it(*self.campaign("full", count=60), status=2, preexec_fn=no_room,
                               restore_signals=False)
        self.assertRegex(error, r"quadbound: \S+: cannot be written: File too large.*--resume")
        self.run_it(*self.campaign("full", "--resume", count=60), status=1)
        self.assertEqual(self.told("full"), self.told("whole"))
        self.assertEqual(self.findings("full"), self.findings("whole"))

    def test_a_finding_that_cannot_be_kept_is_told(self):
        (self.folder / "found").write_text("in the way")
        _, error = self.run_it("--count", 20, *SMALL, *STRICT, "--findings", "found", "--journal",
                               "journal.jsonl", status=2)
        command = [line for line in error.splitlines() if "cannot be kept" in line][0]
        words = shlex.split(command.split(": ")[-1])
        self.run_it(*words[2:], "-q", status=1)

    def test_journals_that_do_not_fit_are_refused(self):
        self.stopped(*self.campaign("cut"), by=signal.SIGTERM, lines=5)
        self.assertIn("--resume", self.run_it(*self.campaign("cut"), status=2)[1])
        for option in (("--seed", 4), ("--max-n", 10), ("--min-tangent", "3/7"), ("--family", "comb")):
            arguments = list(self.campaign("cut", "--resume"))
            arguments[arguments.index(option[0]) + 1] = option[1]
            self.assertIn("differs", self.run_it(*arguments, status=2)[1])
        (self.folder / "cut.jsonl").write_text("nothing of the kind\n")
        self.assertIn("line 1 ", self.run_it(*self.campaign("cut"), status=2)[1])
        self.assertEqual((self.folder / "cut.jsonl").read_text(), "nothing of the kind\n")
        self.run_it("--count", 1, "--journal", "/dev/null", status=2)
        self.run_it("--points", "--count", 1, "--resume", status=2)

    def test_two_campaigns_do_not_share_a_journal(self):
        process = self.start(*self.campaign("same", count=100000))
        self.wait_for_lines("same.jsonl", 3)
        _, error = self.run_it(*self.campaign("same", "--resume"), status=2)
        self.assertIn("another campaign is writing", error)
        process.send_signal(signal.SIGINT)
        process.communicate()
        self.assertEqual(process.returncode, -signal.SIGINT)

    def test_the_journal_is_beside_the_findings(self):
        self.run_it("--count", 2, *SMALL)
        self.assertEqual(os.listdir(self.folder / "findings"), ["journal-3.jsonl"])
        self.run_it("--count", 2, *SMALL)  # an ended campaign may be run again


class Shards(CampaignTest):
    COUNT = 60

    def journals(self, shards, *more):
        """Runs the shards of a campaign and returns their journals."""
        for shard in range(1, shards + 1):
            done = self.start("--count", self.COUNT, *SMALL, *STRICT, "--shard", f"{shard}/{shards}",
                              "--summary", "shard.json", "--threads", 2, *more)
            done.communicate()
            self.assertIn(done.returncode, (0, 1))
            summary = json.loads((self.folder / "shard.json").read_text())
            self.assertEqual(summary["shard"], [shard, shards])
            self.assertEqual(set(summary["families"]), {"regular", "star"})
        return [f"findings/journal-3-{shard}-of-{shards}.jsonl" for shard in range(1, shards + 1)]

    def test_merged_shards_are_the_whole_campaign(self):
        whole, _ = self.run_it("--count", self.COUNT, *SMALL, *STRICT, "--summary", "whole.json",
                               status=1)
        index = sorted(self.lines("findings/INDEX"))
        os.remove(self.folder / "findings/INDEX")
        journals = self.journals(4)
        merged, _ = self.run_it("--merge", *reversed(journals), "--summary", "merged.json", status=1)
        self.assertEqual(merged, whole)
        self.assertEqual((self.folder / "merged.json").read_bytes(),
                         (self.folder / "whole.json").read_bytes())
        self.assertEqual(sorted(self.lines("findings/INDEX")), index)

    def test_what_is_missing_or_does_not_fit_is_told(self):
        journals = self.journals(3)
        _, error = self.run_it("--merge", *journals[1:], "--summary", "merged.json", status=1)
        self.assertIn("20 of 60 cases are missing, the first is 0\n", error)
        self.assertTrue(json.loads((self.folder / "merged.json").read_text())["unfinished"])
        _, error = self.run_it("--merge", *journals, journals[0], status=2)
        self.assertRegex(error, r"case \d+ is in another journal as well")
        self.run_it("--count", 3, *SMALL[:-4], "--seed", 4, *SMALL[-2:])
        _, error = self.run_it("--merge", journals[0], "findings/journal-4.jsonl", status=2)
        self.assertIn("seed differs", error)

    def test_wrong_usage_is_refused(self):
        for wrong in ("0/4", "5/4", "4", "1/0", "a/b", "1/2/3", "/", "-1/2"):
            self.run_it("--count", 1, "--shard", wrong, status=2)
        self.run_it("--points", "--count", 1, "--shard", "1/2", status=2)
        self.run_it("--merge", "missing.jsonl", status=2)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
