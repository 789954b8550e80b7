#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turns the JSON of runs of the benchmarks into a record, and the record into tables.

record.py RUN.json... -o RECORD [--table TEXT.md] [--command COMMAND] [--commit COMMIT]

RECORD is a file, or a folder that gets MACHINE/COMMIT.json. A record holds the median, least and
largest CPU time of each benchmark, its deterministic counters and quality figures, and of the
machine what the times depend on, but no names of hosts or folders.
"""
import argparse
import json
import math
import os
import pathlib
import platform
import re
import statistics
import subprocess
import sys

SCHEMA = {"format": "quadbound-bench", "version": 2}
TIMED = {"quads_per_second", "time_per_quad", "peak_bytes_per_quad"}
MEASURED_BY_BENCHMARK = {
    "name", "family_index", "per_family_instance_index", "run_name", "run_type", "repetitions",
    "repetition_index", "threads", "iterations", "real_time", "cpu_time", "time_unit"}
BEGIN, END = "<!-- record: begin -->", "<!-- record: end -->"


def cpu_model():
    info = pathlib.Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return platform.processor() or platform.machine()


def slug(name):
    """The name of a machine's folder: "AMD EPYC" becomes amd-epyc."""
    return re.sub(r"[^a-z0-9]+", "-", re.sub(r"\((r|tm)\)|processor|cpu", "", name.lower())).strip("-")


def commit():
    here = pathlib.Path(__file__).parent
    done = subprocess.run(["git", "rev-parse", "--short=7", "HEAD"], cwd=here, text=True,
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


def exact(value):
    """Google Benchmark writes counters as doubles: whole ones are numbers of something."""
    return int(value) if float(value).is_integer() else value


def summary(suite, entries):
    """One benchmark of a record. Its counters must not differ from run to run."""
    counters = {key: exact(value) for key, value in sorted(entries[0].items())
                if key not in MEASURED_BY_BENCHMARK | TIMED}
    for entry in entries:
        if any(entry[key] != value for key, value in counters.items()):
            sys.exit(f"{entry['run_name']}: counters differ between repetitions")
    result = {"suite": suite, "repetitions": len(entries), "counters": counters}
    for key, measured, unit in (("ns_per_quad", "time_per_quad", 1e9),
                                ("peak_bytes_per_quad", "peak_bytes_per_quad", 1)):
        values = [unit * entry[measured] for entry in entries if measured in entry]
        if values:
            result[key] = {"median": statistics.median(values), "least": min(values),
                           "largest": max(values), "values": sorted(values)}
    return result


def record(runs, command, of_commit):
    context = runs[0]["context"]
    benchmarks = {}
    for run in runs:
        suite = pathlib.Path(run["context"]["executable"]).name
        for name, entries in repetitions(run).items():
            if name in benchmarks:
                sys.exit(f"{name}: in two runs")
            benchmarks[name] = summary(suite, entries)
    return {**SCHEMA, "commit": of_commit or commit(), "date": context["date"], "command": command,
            "machine": {"cpu": cpu_model(), "cores": os.cpu_count(),
                        "compiler": context["compiler"],
                        "system": platform.system(), "load_average": context["load_avg"]},
            "benchmarks": benchmarks}


def exponent(points):
    """Slope of log time against log work by least squares."""
    xs = [math.log(x) for x, _ in points]
    ys = [math.log(y) for _, y in points]
    mean_x, mean_y = statistics.mean(xs), statistics.mean(ys)
    return (sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys)) /
            sum((x - mean_x) ** 2 for x in xs))


class Suite:
    """The timed benchmarks STAGE/FAMILY/N of one program, in the order of the run."""

    def __init__(self, made, name):
        self.entries = {tuple(key.split("/")): entry for key, entry in made["benchmarks"].items()
                        if entry["suite"] == name and "ns_per_quad" in entry}
        self.stages = list(dict.fromkeys(stage for stage, _, _ in self.entries))
        self.cases = list(dict.fromkeys((family, n) for _, family, n in self.entries
                                        if ("whole", family, n) in self.entries))

    def time(self, stage, family, n):
        entry = self.entries.get((stage, family, n))
        return entry["ns_per_quad"]["median"] if entry else None

    def row(self, family, n):
        whole = self.entries["whole", family, n]
        counters = whole["counters"]
        times = [self.time(stage, family, n) for stage in self.stages]
        peak = whole.get("peak_bytes_per_quad")
        insertion, total = self.time("insertion", family, n), self.time("whole", family, n)
        cells = [family, f"{int(n):,}", f"{counters['quads']:,}"]
        if self.has_rounds():
            cells.append(f"{counters['rounds']}")
        cells += [f"{time:.0f}" if time else "" for time in times]
        if self.has_rounds():
            cells += [f"{100 * insertion / total:.0f} %" if insertion else "",
                      f"{1e3 / self.time('meshing', family, n):.2f}"]
        return cells + [f"{1e3 / total:.2f}", f"{peak['median']:.0f}" if peak else ""]

    def has_rounds(self):
        return "meshing" in self.stages

    def table(self):
        head = ["input", "n", "quads", *(["rounds"] if self.has_rounds() else []), *self.stages,
                *(["insertion of whole", "million quads/s, no proof"] if self.has_rounds() else []),
                "million quads/s", "bytes per quad"]
        rows = [head, ["---", *["---:"] * (len(head) - 1)],
                *(self.row(family, n) for family, n in self.cases)]
        return ["| " + " | ".join(row) + " |" for row in rows]

    def exponents(self):
        """By family of three sizes or more: over all of them, and from a thousand on, where an
        input is beyond the caches."""
        lines = []
        for family in dict.fromkeys(family for family, _ in self.cases):
            for stage in self.stages:
                sizes = [(int(n), entry["counters"]["quads"], entry["ns_per_quad"]["median"])
                         for (s, f, n), entry in self.entries.items() if (s, f) == (stage, family)]
                fits = {}
                for least in (1, 1000):
                    points = [(q, q * t) for n, q, t in sizes if n >= least]
                    if len(points) > 2:
                        fits[points[0][0]] = exponent(points)
                if fits:
                    lines.append(f"- {family}, {stage}: time ~ " + ", ".join(
                        f"quads^{fit:.3f} from {first:,} quads on" for first, fit in fits.items()))
        return lines


def conditions(made):
    machine = made["machine"]
    load = ", ".join(f"{x:.1f}" for x in machine["load_average"])
    return [f"Commit {made['commit']}, {made['date']}. {machine['cpu']}, {machine['cores']} cores, "
            f"{machine['compiler']}, {machine['system']}; load before the run {load}.",
            *(["", f"`{made['command']}`"] if made["command"] else [])]


def tables(made):
    lines = ["Nanoseconds of CPU time per quad, the median of all repetitions."]
    for name in dict.fromkeys(entry["suite"] for entry in made["benchmarks"].values()):
        suite = Suite(made, name)
        if suite.cases:
            lines += ["", *suite.table(), "", *suite.exponents()]
    return "\n".join([*lines, "", *conditions(made)])


def put_into(path, text):
    """Between the two marks of a text; a file without them becomes the text."""
    old = path.read_text() if path.exists() else ""
    if BEGIN in old and END in old:
        before, after = old.split(BEGIN)[0], old.split(END)[1]
        path.write_text(f"{before}{BEGIN}\n{text}\n{END}{after}")
    else:
        path.write_text(text + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("runs", type=pathlib.Path, nargs="+", metavar="RUN.json")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--table", type=pathlib.Path,
                        help="a text that gets the tables, between its marks where it has them")
    parser.add_argument("--command", default="")
    parser.add_argument("--commit", help="what was built; the present one if left out")
    options = parser.parse_args()
    made = record([json.loads(run.read_text()) for run in options.runs], options.command,
                  options.commit)
    output = options.output
    if output.is_dir():
        output = output / slug(made["machine"]["cpu"]) / f"{made['commit']}.json"
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(json.dumps(made, indent=1) + "\n")
    if options.table:
        put_into(options.table, tables(made))
    print(tables(made))


if __name__ == "__main__":
    main()
