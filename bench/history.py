#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the records of one machine over time, one small plot for each benchmark of a whole road.

history.py results/bench/MACHINE -o history.svg [--stage STAGE]

Times are in nanoseconds per quad, from zero; bars reach from the least to the largest. Records were
not measured in turns: a step says where to look, bench/compare says whether it is one.
"""
import argparse
import html
import json
import pathlib

COLUMNS, WIDTH, HEIGHT = 3, 300, 170
LEFT, RIGHT, TOP, BOTTOM = 50, 15, 34, 34
INK, BAR, GRID = "#1b4f72", "#85a9c5", "#dddddd"


def records(folder):
    """Oldest first."""
    made = [json.loads(path.read_text()) for path in folder.glob("*.json")]
    return sorted((one for one in made if one.get("format") == "quadbound-bench"),
                  key=lambda one: one["date"])


def series(made, stage):
    """By benchmark: (index of the record, its times)."""
    result = {}
    for index, one in enumerate(made):
        for name, entry in one["benchmarks"].items():
            if name.startswith(f"{stage}/") and "ns_per_quad" in entry:
                result.setdefault(name, []).append((index, entry["ns_per_quad"]))
    return result


def text(x, y, words, size=11, anchor="start"):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}">'
            f"{html.escape(words)}</text>")


def line(x0, y0, x1, y1, colour, width=1):
    return (f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1:.1f}" y2="{y1:.1f}" stroke="{colour}" '
            f'stroke-width="{width}"/>')


def plot(name, points, commits, left, top):
    largest = max(times["largest"] for _, times in points)
    span = WIDTH - LEFT - RIGHT
    x_of = [left + LEFT + span * (i + 0.5) / len(commits) for i in range(len(commits))]
    bottom = top + HEIGHT - BOTTOM

    def y_of(time):
        return bottom - (HEIGHT - TOP - BOTTOM) * time / largest

    out = [text(left + LEFT, top + TOP - 12, name, 12)]
    for time in (0, largest):
        out += [line(left + LEFT, y_of(time), left + WIDTH - RIGHT, y_of(time), GRID),
                text(left + LEFT - 6, y_of(time) + 4, f"{time:.0f}", 10, "end")]
    for index, times in points:
        x = x_of[index]
        out.append(line(x, y_of(times["least"]), x, y_of(times["largest"]), BAR, 4))
        out.append(f'<circle cx="{x:.1f}" cy="{y_of(times["median"]):.1f}" r="3" fill="{INK}">'
                   f'<title>{html.escape(commits[index])}: {times["median"]:.0f} ns</title></circle>')
        # In two rows: neighbours are closer than a name is wide.
        out.append(text(x, bottom + 14 + 11 * (index % 2), commits[index], 9, "middle"))
    path = " ".join(f"{x_of[i]:.1f},{y_of(times['median']):.1f}" for i, times in points)
    out.append(f'<polyline points="{path}" fill="none" stroke="{INK}"/>')
    return out


def drawing(made, stage):
    plots = series(made, stage)
    commits = [one["commit"] for one in made]
    rows = -(-len(plots) // COLUMNS)
    width, height = COLUMNS * WIDTH, rows * HEIGHT + 30
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
           f'viewBox="0 0 {width} {height}" font-family="DejaVu Sans, sans-serif">',
           f'<rect width="{width}" height="{height}" fill="white"/>',
           text(LEFT, 20, f"{made[0]['machine']['cpu']}: nanoseconds per quad", 13)]
    for i, (name, points) in enumerate(plots.items()):
        out += plot(name, points, commits, WIDTH * (i % COLUMNS), 30 + HEIGHT * (i // COLUMNS))
    return "\n".join([*out, "</svg>", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, metavar="MACHINE")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--stage", default="whole")
    options = parser.parse_args()
    made = records(options.folder)
    if not series(made, options.stage):
        parser.error(f"{options.folder}: no records of {options.stage}")
    options.output.write_text(drawing(made, options.stage))


if __name__ == "__main__":
    main()
