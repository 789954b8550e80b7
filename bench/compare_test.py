#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What bench/compare finds and what it does not, on made records; and history, record on them."""
import contextlib
import copy
import importlib.machinery
import importlib.util
import io
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE))
import history  # noqa: E402
import record  # noqa: E402


def module(name):
    loader = importlib.machinery.SourceFileLoader(name, str(HERE / name))
    made = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(made)
    return made


compare = module("compare")
STAGES = ["tree", "insertion", "meshing", "verification", "whole"]
NAMES = [f"{stage}/{family}/1000" for family in ("regular", "blob", "lake", "comb")
         for stage in STAGES]
SAMPLES = 20


def entry(name, noise, slowdown=1.0):
    """A sample: right but for a disturbance of up to 10 %, and now and then one of a half."""
    disturbed = 0.5 if noise.random() < 0.02 else 0.1 * noise.random()
    time = 1e-7 * (1 + len(name)) * slowdown * (1 + disturbed)
    return {"name": name, "run_name": name, "run_type": "iteration", "repetitions": 1,
            "iterations": 10, "real_time": 1, "cpu_time": 1, "time_unit": "ms",
            "time_per_quad": time, "quads_per_second": 1 / time, "quads": 31988.0,
            "cells": 47185.0, "rounds": 1.0, "smallest_angle": 18.521,
            "peak_bytes_per_quad": 100 + noise.random()}


def run(noise, slowdown=1.0):
    return {"context": {"date": "2026-01-01", "executable": "./polygons_bench", "compiler": "GCC",
                        "load_avg": [1, 1, 1]},
            "benchmarks": [entry(name, noise, slowdown) for _ in range(SAMPLES) for name in NAMES]}


def made(noise, slowdown=1.0):
    return {**record.record([run(noise, slowdown)], "", "0000000"), "turns": "once"}


class Judging(unittest.TestCase):
    def setUp(self):
        self.noise = random.Random(1)
        self.base = made(self.noise)
        self.head = made(self.noise)

    def judged(self, accepted=None):
        """(exit status, output)."""
        with tempfile.TemporaryDirectory() as folder:
            paths = [pathlib.Path(folder) / name for name in ("base.json", "head.json", "ok.json")]
            for path, content in zip(paths, (self.base, self.head, accepted)):
                path.write_text(json.dumps(content))
            output = io.StringIO()
            with contextlib.redirect_stdout(output):
                try:
                    status = compare.judge(*map(compare.read, paths[:2]),
                                           paths[2] if accepted is not None else None)
                except SystemExit as end:
                    status = 2
                    output.write(end.code)
            return status, output.getvalue()

    def test_noise_is_no_finding(self):
        for _ in range(30):
            faults, _ = compare.findings(made(self.noise), made(self.noise), compare.Accepted(None))
            self.assertEqual(faults, [])
        self.assertEqual(self.judged()[0], 0)

    def test_slowdown(self):
        self.head = made(self.noise, slowdown=1.2)
        status, text = self.judged()
        self.assertEqual(status, 1)
        self.assertEqual(text.count(": slower: "), len(NAMES))

    def test_faster_is_said_but_good(self):
        self.head = made(self.noise, slowdown=0.8)
        status, text = self.judged()
        self.assertEqual(status, 0)
        self.assertEqual(text.count(": better: "), len(NAMES))

    def test_overlap_is_no_finding(self):
        times = self.head["benchmarks"][NAMES[0]]["ns_per_quad"]
        left_out = compare.outliers(SAMPLES, 4 * len(NAMES))
        times["values"] = [2 * time if i > left_out else time
                           for i, time in enumerate(times["values"])]
        self.assertEqual(self.judged()[0], 0)

    def test_more_memory(self):
        peaks = self.head["benchmarks"][NAMES[0]]["peak_bytes_per_quad"]
        peaks["values"] = [peak + 20 for peak in peaks["values"]]
        status, text = self.judged()
        self.assertEqual(status, 1)
        self.assertIn(f"{NAMES[0]}: needs more memory", text)

    def test_counters_and_quality_figures(self):
        for counter, value in (("cells", 47186), ("smallest_angle", 18.5)):
            with self.subTest(counter):
                self.head = copy.deepcopy(self.base)
                before = self.base["benchmarks"][NAMES[1]]["counters"][counter]
                self.head["benchmarks"][NAMES[1]]["counters"][counter] = value
                status, text = self.judged()
                self.assertEqual(status, 1)
                self.assertIn(f"FAIL {NAMES[1]}: {counter} was {before} and is {value}", text)
                named = {"benchmark": "*/regular/1000", "counter": counter, "from": before,
                         "to": value, "why": "a test"}
                self.assertEqual(self.judged([named])[0], 0)
                self.assertEqual(self.judged([{**named, "to": 1}])[0], 1)
                self.assertEqual(self.judged([{**named, "benchmark": "*/blob/*"}])[0], 1)

    def test_lost_and_new_counters(self):
        del self.head["benchmarks"][NAMES[0]]["counters"]["rounds"]
        self.head["benchmarks"][NAMES[1]]["counters"]["moves"] = 3
        status, text = self.judged()
        self.assertEqual(status, 1)
        self.assertIn("rounds was 1 and is None", text)
        self.assertIn("moves was None and is 3", text)

    def test_vanished_benchmark(self):
        del self.head["benchmarks"][NAMES[2]]
        status, text = self.judged()
        self.assertEqual(status, 1)
        self.assertIn(f"FAIL {NAMES[2]}: gone", text)
        gone = {"benchmark": NAMES[2], "vanished": True, "why": "a test"}
        self.assertEqual(self.judged([gone])[0], 0)

    def test_new_benchmark(self):
        self.head["benchmarks"]["whole/new/1000"] = self.head["benchmarks"][NAMES[0]]
        status, text = self.judged()
        self.assertEqual(status, 0)
        self.assertIn("whole/new/1000: new", text)

    def test_times_not_taken_in_turns(self):
        self.head = {**made(self.noise, slowdown=2), "turns": "at another time"}
        status, text = self.judged()
        self.assertEqual(status, 0)
        self.assertIn("not measured in turns", text)
        self.head["benchmarks"][NAMES[0]]["counters"]["quads"] += 1
        self.assertEqual(self.judged()[0], 1)

    def test_bad_input_is_no_finding(self):
        self.assertEqual(self.judged([{"benchmark": "*", "why": "all"}])[0], 2)
        self.assertEqual(self.judged([{"benchmark": "*", "vanished": True, "why": ""}])[0], 2)
        del self.head["version"]
        self.assertEqual(self.judged()[0], 2)


class Samples(unittest.TestCase):
    def test_chance(self):
        # One order of (2 n over n); by counting all orders of 2 x 4 samples for the others.
        self.assertAlmostEqual(compare.chance(20, 0) * math.comb(40, 20), 1)
        orders = list(itertools.combinations(range(8), 4))
        for left_out in (0, 1):
            hits = 0
            for head in orders:
                base = [place for place in range(8) if place not in head]
                hits += head[left_out] > base[-1 - left_out]
            self.assertAlmostEqual(compare.chance(4, left_out), hits / len(orders))

    def test_outliers(self):
        self.assertEqual(compare.outliers(20, 80), 3)
        self.assertIsNone(compare.outliers(3, 1))

    def test_exit_status_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            base, head, bad = (pathlib.Path(folder) / name for name in "abc")
            base.write_text(json.dumps(made(random.Random(6))))
            head.write_text(json.dumps(made(random.Random(7), slowdown=1.5)))
            bad.write_text("{}")
            for pair, status in (((base, base), 0), ((base, head), 1), ((base, bad), 2)):
                done = subprocess.run([sys.executable, "-B", HERE / "compare", "judge", *pair],
                                      capture_output=True, check=False)
                self.assertEqual(done.returncode, status)

    def test_least(self):
        noise = random.Random(2)
        runs = [run(noise) for _ in range(3)]
        least = {name: min(e["time_per_quad"] for r in runs for e in r["benchmarks"]
                           if e["run_name"] == name) for name in NAMES}
        merged = compare.least_of(runs)
        self.assertEqual({e["run_name"]: e["time_per_quad"] for e in merged["benchmarks"]}, least)


class Recording(unittest.TestCase):
    def test_slug(self):
        self.assertEqual(record.slug("AMD EPYC"), "amd-epyc")
        self.assertEqual(record.slug("Intel(R) Xeon(R) CPU @ 2.20GHz"), "intel-xeon-2-20ghz")

    def test_counters_that_differ_are_refused(self):
        bad = run(random.Random(3))
        bad["benchmarks"][-1]["quads"] += 1
        with self.assertRaises(SystemExit):
            record.record([bad], "", "0000000")

    def test_exponent(self):
        self.assertAlmostEqual(record.exponent([(q, 3 * q ** 1.2) for q in (1, 10, 100)]), 1.2)

    def test_tables_go_between_the_marks(self):
        with tempfile.TemporaryDirectory() as folder:
            text = pathlib.Path(folder) / "text.md"
            text.write_text(f"before\n{record.BEGIN}\nold\n{record.END}\nafter\n")
            record.put_into(text, record.tables(made(random.Random(4))))
            lines = text.read_text().splitlines()
        self.assertEqual((lines[0], lines[-1]), ("before", "after"))
        self.assertTrue(any(line.startswith("| regular | 1,000 | 31,988 | 1 |") for line in lines))
        self.assertNotIn("old", lines)

    def test_history(self):
        noise = random.Random(5)
        with tempfile.TemporaryDirectory() as folder:
            for day, slowdown in ((1, 1.0), (2, 0.5)):
                one = {**made(noise, slowdown), "date": f"2026-01-0{day}", "commit": f"000000{day}"}
                (pathlib.Path(folder) / f"{9 - day}.json").write_text(json.dumps(one))
            records = history.records(pathlib.Path(folder))
        picture = xml.etree.ElementTree.fromstring(history.drawing(records, "whole"))
        dots = list(picture.iter("{http://www.w3.org/2000/svg}circle"))
        self.assertEqual(len(dots), 2 * 4)
        heights = [float(dot.get("cy")) for dot in dots]
        self.assertTrue(all(before < after for before, after in zip(heights[::2], heights[1::2])))


if __name__ == "__main__":
    unittest.main()
