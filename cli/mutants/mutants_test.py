# SPDX-License-Identifier: Apache-2.0
"""Breaks the mesher on purpose and asks whether random campaigns see it.

Each mutant of mutants.json is one piece of a source file of algo/ replaced by another. Its unit is
compiled alone and linked before the libraries of the build, so that the judge and the generators
are those of the build. It is caught where a campaign of the mutated program has a finding (a claim,
a crash, a hang), or refuses cases that the program of the build proves.

Usage: mutants_test.py BUILD_FOLDER [ID ... | --all] [-o RESULTS.md]

Without ids: QUICK, for the tests. Ends with status 1 if a mutant survives."""

import argparse
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
SOURCES = HERE.parent.parent
UNIT_OF_HEADER = {"algo/apply_template.hpp": "algo/quadrangulation.cpp"}
# One of the templates, one of the strips, one of the kites: compiling takes nearly all the time.
QUICK = ("t4-order", "bump-order", "kite-moves")
# The cheap campaign first: it is enough for nearly all. The longest takes a minute.
CAMPAIGNS = (("--count", "26"), ("--count", "520"), ("--seconds", "60"))
LIMITS = ("--seed", "1", "--max-cells", "30000", "--max-seconds", "2", "--shrink-tries", "0")
POINTS = ("--points", "--count", "200", "--seed", "1")


NO_FAULTS = """Tried too, not caught, and left out: they break nothing, as something else makes up for them. Condition A.3 for
points eight times as close (the 5x5 grids ask for more); aligned centres whose quads are not looked at (none has
been refused in the campaigns so far); pentagons not judged again after rounding; a kite's v placed for an angle a
little off. A point that no quad uses is left out of the mesh."""


class Build:
    """A build folder of Ninja, with its compile commands."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        self.program = self.folder / "cli" / "quadbound"
        units = json.loads((self.folder / "compile_commands.json").read_text())
        self.commands = {pathlib.Path(unit["file"]): unit["command"] for unit in units}

    def link_command(self):
        shown = subprocess.run(["ninja", "-t", "commands", "-s", "cli/quadbound"], cwd=self.folder,
                               check=True, capture_output=True, text=True).stdout
        return shown.strip().splitlines()[-1]

    def unit_of(self, file):
        """The unit that has the code of a file: itself, or for a header the one that says so."""
        own = SOURCES / file
        return own if own in self.commands else SOURCES / UNIT_OF_HEADER[file]


def source_of(mutant):
    """The text of its file. Ends the program where the piece to replace is not there once."""
    source = (SOURCES / mutant["file"]).read_text()
    if source.count(mutant["from"]) != 1:
        raise SystemExit(f"{mutant['id']}: its piece is {source.count(mutant['from'])} times in "
                         f"{mutant['file']}, not once")
    return source


def mutated_program(build, mutant, folder):
    """Compiles and links; the path of the program."""
    source = source_of(mutant)
    copy = folder / mutant["file"]
    copy.parent.mkdir(parents=True)
    copy.write_text(source.replace(mutant["from"], mutant["to"]))
    unit = build.unit_of(mutant["file"])
    mutated_unit = folder / unit.relative_to(SOURCES)
    if mutated_unit != copy:
        mutated_unit.write_text(unit.read_text())
    words = shlex.split(re.sub(r" -o \S+ -c \S+", "", build.commands[unit]))
    made = folder / "mutant.o"
    # No warnings: a piece left out may leave something unused.
    run([words[0], f"-I{folder}", *words[1:], "-w", "-o", str(made), "-c", str(mutated_unit)],
        build.folder)
    program = folder / "quadbound"
    link = build.link_command().removeprefix(": && ").removesuffix(" && :")
    words = shlex.split(link)
    words[words.index("-o") + 1] = str(program)
    # Before the libraries: the linker then leaves their unit of the same name where it is.
    words.insert(words.index("-o"), str(made))
    run(words, build.folder)
    return program


def run(words, folder):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{shlex.join(words)}\n{done.stderr}")


def campaign(program, arguments, folder):
    """The summary of a campaign, and its exit status."""
    summary = folder / "summary.json"
    summary.unlink(missing_ok=True)
    limits = () if "--points" in arguments else LIMITS
    done = subprocess.run([str(program), "fuzz", *arguments, *limits, "--summary", str(summary),
                           "--findings", str(folder / "findings"), "-q"], capture_output=True,
                          text=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{program}: ended with status {done.returncode}\n{done.stderr}")
    return json.loads(summary.read_text()), done.returncode


def claims_of(findings):
    """The claims that broke, the most frequent first."""
    count = {}
    for finding in findings:
        count[finding["claim"]] = count.get(finding["claim"], 0) + 1
    return [claim for claim, _ in sorted(count.items(), key=lambda item: (-item[1], item[0]))]


class Judgement:
    """How a mutant was caught; `how` is empty where it survived."""

    def __init__(self, how="", cases=0, seconds=0.0):
        self.how = how
        self.cases = cases
        self.seconds = seconds


def judge_on_points(program, folder):
    summary, status = campaign(program, POINTS, folder)
    cases = summary["all"]["sets"]
    return Judgement(", ".join(claims_of(summary["findings"])) if status == 1 else "", cases)


def judge_on_polygons(build, program, folder):
    for arguments in CAMPAIGNS:
        summary, status = campaign(program, arguments, folder)
        cases = summary["all"]["cases"]
        if summary["findings"]:
            return Judgement(", ".join(claims_of(summary["findings"])), cases)
        if status == 1:
            return Judgement("never reached: " + ", ".join(summary["never_reached"]), cases)
        if arguments[0] != "--count":
            continue
        before = campaign(build.program, arguments, folder)[0]["all"]
        more = summary["all"]["too_many_cells"] - before["too_many_cells"]
        if more > 0:
            return Judgement(f"{more} more refused for cells", cases)
    return Judgement()


def try_mutant(build, mutant):
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        program = mutated_program(build, mutant, folder)
        start = time.monotonic()
        if mutant.get("points"):
            judgement = judge_on_points(program, folder)
        else:
            judgement = judge_on_polygons(build, program, folder)
        judgement.seconds = time.monotonic() - start
    return judgement


def row(mutant, judgement):
    caught = judgement.how or "**survived**"
    breaks = mutant["breaks"].replace("|", "&#124;")
    return (f"| {mutant['id']} | {mutant['file']} | {breaks} | {caught} | "
            f"{judgement.cases:,} |")


def write_results(path, rows, caught):
    text = [f"# Mutants of the mesher: {caught} of {len(rows)} caught", "",
            "Each is one piece of `algo/` replaced by another (cli/mutants/mutants.json). *Caught by*:",
            "the claims that broke, most frequent first, or what else tells it from the original, in",
            "the first campaign that does, and how many random cases that had.", "",
            "`python3 cli/mutants/mutants_test.py build/release --all -o results/mutants.md`", "",
            "| mutant | file | what it breaks | caught by | cases |", "| --- | --- | --- | --- | ---: |",
            *rows, "", NO_FAULTS, ""]
    new = path.with_name(path.name + ".new")
    new.write_text("\n".join(text))
    new.rename(path)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", help="build folder of Ninja, built")
    parser.add_argument("ids", nargs="*", help=f"mutants; default: {' '.join(QUICK)}")
    parser.add_argument("--all", action="store_true", help="all of mutants.json")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="write a table")
    return parser.parse_args()


def main():
    options = parse_arguments()
    mutants = {mutant["id"]: mutant for mutant in json.loads((HERE / "mutants.json").read_text())}
    ids = list(mutants) if options.all else options.ids or QUICK
    unknown = [name for name in ids if name not in mutants]
    if unknown:
        raise SystemExit(f"no mutant {unknown[0]}; there are: {' '.join(mutants)}")
    for mutant in mutants.values():  # also those that are not tried now: so that none goes stale
        source_of(mutant)
    build = Build(options.build)
    rows, survivors = [], []
    for name in ids:
        judgement = try_mutant(build, mutants[name])
        rows.append(row(mutants[name], judgement))
        if not judgement.how:
            survivors.append(name)
        print(f"{name}: {judgement.how or 'SURVIVED'} ({judgement.cases} cases, "
              f"{judgement.seconds:.1f} s)", flush=True)
    if options.output:
        write_results(options.output, rows, len(rows) - len(survivors))
    print(f"{len(rows) - len(survivors)} of {len(rows)} mutants caught")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
