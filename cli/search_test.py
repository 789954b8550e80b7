# SPDX-License-Identifier: Apache-2.0
"""Searches for hard polygons, the worst ever seen, pictures.
Usage: search_test.py PATH_OF_QUADBOUND [unittest options]"""

import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
SMALL = ("--family", "regular,star", "--max-n", "8", "--max-cells", "20000")
OBJECTIVES = ("smallest-angle", "largest-angle", "cells", "seconds-per-vertex", "fall-back-levels")


class SearchTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_it(self, *arguments, status=0):
        """Standard output and standard error."""
        done = subprocess.run([PROGRAM, "fuzz", *map(str, arguments)], cwd=self.folder,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, status, (arguments, done.stderr))
        return done.stdout, done.stderr

    def json(self, name):
        return json.loads((self.folder / name).read_text())

    def search(self, objective, *more, count=2, steps=30):
        return self.run_it("--search", objective, *SMALL, "--count", count, "--steps", steps,
                           "--summary", "summary.json", *more)[0]


class Search(SearchTest):
    def test_every_objective_is_pushed_and_never_back(self):
        def value(text):
            numbers = [float(number) for number in re.findall(r"[\d.]+", text)]
            return numbers if "/" in text else numbers[0]

        for objective in OBJECTIVES:
            self.search(objective)
            climbs = self.json("summary.json")["climbs"]
            self.assertEqual(len(climbs), 2)
            for climb in climbs:
                start, best = value(climb["start"]["value"]), value(climb["best"]["value"])
                if objective == "smallest-angle":
                    start, best = best, start
                self.assertGreaterEqual(best, start, objective)
                self.assertGreater(climb["tries"], 5)

    def test_the_same_seed_gives_the_same_bytes_whatever_the_threads(self):
        seen = set()
        for threads, name in ((1, "one"), (2, "two")):
            table = self.search("cells", "--threads", threads, "--worst-ever", f"{name}.json")
            files = [(self.folder / name).read_bytes() for name in
                     ("summary.json", "findings/cells-1-0.geojson", "findings/cells-1-1.geojson")]
            worst = (self.folder / f"{name}.json").read_text().replace(f"{name}/", "")
            seen.add((table.replace(f"{name}.json", ""), *files, worst))
        self.assertEqual(len(seen), 1)
        other = self.search("cells", "--seed", 2)
        self.assertNotIn(other, {entry[0] for entry in seen})

    def test_the_best_polygon_can_be_replayed(self):
        self.search("cells")
        for climb in self.json("summary.json")["climbs"]:
            program, fuzz, *arguments = shlex.split(climb["replay"])
            self.assertEqual((program, fuzz), ("quadbound", "fuzz"))
            output, _ = self.run_it(*arguments)
            self.assertIn(f"{climb['best']['vertices']} vertices, {climb['best']['cells']} cells, ",
                          output)

    def test_a_finding_ends_a_climb_and_is_kept(self):
        self.run_it("--search", "smallest-angle", *SMALL, "--count", 1, "--steps", 3, "--shrink-tries",
                    3, "--min-tangent", "3/7", "--summary", "summary.json", status=1)
        climb = self.json("summary.json")["climbs"][0]
        self.assertEqual(climb["best"]["claim"], "min-angle")
        self.run_it(*shlex.split(climb["replay"])[2:], status=1)
        self.assertTrue((self.folder / "findings/INDEX").exists())

    def test_wrong_usage_is_refused(self):
        self.run_it("--search", "nothing", status=2)
        self.run_it("--search", "cells", "--resume", status=2)
        self.run_it("--search", "cells", "--points", status=2)
        self.run_it("--steps", 3, status=2)


class WorstEver(SearchTest):
    SIDES = ("smallest", "largest")

    def entries(self, name="worst.json"):
        """(construction, side) -> (degrees, input)."""
        return {(construction, side): (entry["degrees"], entry["input"])
                for construction, sides in self.json(name)["constructions"].items()
                for side, entry in sides.items()}

    def assert_no_less_extreme(self, after, before):
        for key, (degrees, _) in before.items():
            if key[1] == "smallest":
                self.assertLessEqual(after[key][0], degrees)
            else:
                self.assertGreaterEqual(after[key][0], degrees)

    def test_campaigns_and_searches_add_to_it_and_each_entry_can_be_replayed(self):
        self.run_it("--count", 10, *SMALL, "--worst-ever", "worst.json")
        before = self.entries()
        self.search("smallest-angle", "--seed", 2, "--worst-ever", "worst.json")
        after = self.entries()
        self.assert_no_less_extreme(after, before)
        self.assertNotEqual(before, after)
        self.assertTrue(any(entry.endswith(".geojson") for _, entry in after.values()))
        self.assertTrue(any(":n=" in entry for _, entry in after.values()))
        for key, (degrees, entry) in after.items():
            self.run_it("--replay", entry, "--worst-ever", "one.json")
            self.assertEqual(self.entries("one.json")[key][0], degrees)
            os.remove(self.folder / "one.json")
        table = (self.folder / "worst.md").read_text()
        self.assertEqual(table.count("\n| "), 2 + len(after) // 2)

    def test_the_same_again_changes_nothing(self):
        for _ in range(2):
            self.run_it("--count", 5, *SMALL, "--worst-ever", "worst.json")
            once = (self.folder / "worst.json").read_bytes()
        self.run_it("--count", 3, *SMALL, "--worst-ever", "worst.json")
        self.assertEqual((self.folder / "worst.json").read_bytes(), once)

    def test_other_files_are_left_alone(self):
        (self.folder / "worst.json").write_text("{}")
        self.run_it("--count", 1, *SMALL, "--worst-ever", "worst.json", status=2)
        self.assertEqual((self.folder / "worst.json").read_text(), "{}")
        self.run_it("--count", 1, *SMALL, "--worst-ever", "worst.txt", status=2)


class Picture(SearchTest):
    def test_a_campaign_is_drawn_and_so_are_its_merged_shards(self):
        self.run_it("--count", 20, *SMALL, "--picture", "whole.svg", "--summary", "whole.json")
        for shard in ("1/2", "2/2"):
            self.run_it("--count", 20, *SMALL, "--shard", shard)
        self.run_it("--merge", "findings/journal-1-1-of-2.jsonl", "findings/journal-1-2-of-2.jsonl",
                    "--picture", "merged.svg")
        drawn = (self.folder / "whole.svg").read_text()
        self.assertEqual((self.folder / "merged.svg").read_text(), drawn)
        self.assertIn("20 polygons: ", drawn)
        self.assertIn("bound 18.43", drawn)
        summary = self.json("whole.json")
        for histogram in summary["histograms"].values():
            self.assertEqual(sum(count for _, count in histogram), summary["all"]["proved"])
            self.assertEqual([start for start, _ in histogram],
                             sorted(start for start, _ in histogram))

    def test_other_formats(self):
        self.run_it("--count", 2, *SMALL, "--picture", "picture.png")
        self.assertTrue((self.folder / "picture.png").read_bytes().startswith(b"\x89PNG"))
        self.run_it("--count", 2, *SMALL, "--picture", "picture.pdf")
        self.assertTrue((self.folder / "picture.pdf").read_bytes().startswith(b"%PDF"))
        self.run_it("--count", 2, *SMALL, "--picture", "picture.txt", status=2)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
