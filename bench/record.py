#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turns the JSON of a run of point_sets_bench into a record, and the record into a table.

record.py RUN.json -o RECORD.json [--table TABLE.md] [--command COMMAND]

A record holds the median, least and largest CPU time of each benchmark, its deterministic counters,
and of the machine what the times depend on, but no names of hosts or folders.
"""
import argparse
import json
import math
import os
import pathlib
import platform
import statistics
import subprocess
import sys

SCHEMA = {"format": "quadbound-bench", "version": 1}
STAGES = ["tree", "templates", "warping", "verification", "whole"]
TIMED = {"quads_per_second", "time_per_quad", "peak_bytes_per_quad"}
MEASURED_BY_BENCHMARK = {
    "name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions",
    "repetition_index", "threads", "iterations", "real_time", "cpu_time", "time_unit"}


def cpu_model():
    info = pathlib.Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return platform.processor() or platform.machine()


def commit():
    here = pathlib.Path(__file__).parent
    done = subprocess.run(["git", "rev-parse", "--short=12", "HEAD"], cwd=here, text=True,
                          capture_output=True, check=False)
    return done.stdout.strip() or "unknown"


def repetitions(run):
    """The repetitions of each benchmark, by its name."""
    by_name = {}
    for entry in run["benchmarks"]:
        if entry["run_type"] != "iteration":
            continue
        if entry.get("error_occurred"):
            sys.exit(f"{entry['name']}: {entry['error_message']}")
        by_name.setdefault(entry["run_name"], []).append(entry)
    return by_name


def summary(entries):
    """One benchmark of a record. Its deterministic counters must not differ from run to run."""
    counters = {key: value for key, value in entries[0].items()
                if key not in MEASURED_BY_BENCHMARK | TIMED}
    for entry in entries:
        if any(entry[key] != value for key, value in counters.items()):
            sys.exit(f"{entry['run_name']}: counters differ between repetitions")
    times = [1e9 * entry["time_per_quad"] for entry in entries]
    result = {"repetitions": len(entries),
              "ns_per_quad": {"median": statistics.median(times), "least": min(times),
                              "largest": max(times)},
              "counters": {key: int(value) for key, value in sorted(counters.items())}}
    peaks = [entry["peak_bytes_per_quad"] for entry in entries if "peak_bytes_per_quad" in entry]
    if peaks:
        result["peak_bytes_per_quad"] = statistics.median(peaks)
    return result


def record(run, command, of_commit):
    context = run["context"]
    return {**SCHEMA, "commit": of_commit or commit(), "date": context["date"], "command": command,
            "machine": {"cpu": cpu_model(), "cores": os.cpu_count(),
                        "compiler": context["compiler"],
                        "system": platform.system(), "load_average": context["load_avg"]},
            "benchmarks": {name: summary(entries) for name, entries in repetitions(run).items()}}


def exponent(points):
    """Slope of log time against log work by least squares."""
    xs = [math.log(x) for x, _ in points]
    ys = [math.log(y) for _, y in points]
    mean_x, mean_y = statistics.mean(xs), statistics.mean(ys)
    return (sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys)) /
            sum((x - mean_x) ** 2 for x in xs))


def cases(benchmarks):
    """(family, n) of all point sets, in the order of the run."""
    return list(dict.fromkeys((name.split("/")[1], int(name.split("/")[2]))
                              for name in benchmarks if name.count("/") == 2))


def table(made):
    benchmarks = made["benchmarks"]

    def time(stage, family, n):
        entry = benchmarks.get(f"{stage}/{family}/{n}")
        return entry["ns_per_quad"]["median"] if entry else None

    lines = ["| points | n | quads | " + " | ".join(STAGES) + " | quads/s | bytes per quad |",
             "| --- |" + " ---: |" * (len(STAGES) + 4)]
    for family, n in cases(benchmarks):
        whole = benchmarks.get(f"whole/{family}/{n}")
        if not whole:
            continue
        cells = [f"{time(stage, family, n):.0f}" if time(stage, family, n) else "" for stage in STAGES]
        peak = whole.get("peak_bytes_per_quad")
        lines.append(" | ".join(
            [f"| {family}", f"{n:,}", f"{whole['counters']['quads']:,}", *cells,
             f"{1e3 / time('whole', family, n):.2f} million", f"{peak:.0f} |" if peak else "|"]))
    return "\n".join([*lines, "", *exponents(benchmarks)])


def exponents(benchmarks):
    """Over all uniform sets, and over those of a thousand points or more, beyond the caches."""
    lines = []
    for stage in STAGES:
        sizes = [(int(name.split("/")[2]), entry["counters"]["quads"], entry["ns_per_quad"]["median"])
                 for name, entry in benchmarks.items() if name.startswith(f"{stage}/uniform/")]
        fits = [f"quads^{exponent(points):.3f} from {points[0][0]:,} quads on"
                for points in ([(q, q * t) for n, q, t in sizes if n >= least] for least in (1, 1000))
                if len(points) > 2]
        if fits:
            lines.append(f"- {stage}: time ~ " + ", ".join(fits))
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("--command", default="")
    parser.add_argument("--commit", help="what was built; the present one if left out")
    options = parser.parse_args()
    made = record(json.loads(options.run.read_text()), options.command, options.commit)
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_text(json.dumps(made, indent=1) + "\n")
    if options.table:
        options.table.write_text(table(made) + "\n")
    print(table(made))


if __name__ == "__main__":
    main()
