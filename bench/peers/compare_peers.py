#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Meshes the same polygons with quadbound and with what people would use instead, has quadbound
judge all meshes, and writes a table.

compare_peers.py BUILD -o results/peers.md
compare_peers.py BUILD -o /tmp/rows.md --only bamg    # the rows of one mesher

Wants the programs quadbound and peer_cgal in BUILD, gmsh, and ffbamg of Debian's freefem++. Each
mesher runs in a process of its own with a limit of time; time and memory are that process's,
reading and writing files included.
"""
import argparse
import fractions
import json
import math
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
sys.dont_write_bytecode = True
import record  # noqa: E402

LIMIT = 120  # seconds of CPU time for one mesh
LOWER = math.degrees(math.atan2(1, 3))
UPPER = 180 - math.degrees(math.atan2(1, 7))

TAME = ["regular:n=100", "blob:n=200", "blob:n=2000", "plate:n=4", "orthogonal:n=60", "lake"]
SHARP = ["star:n=60", "sharp:n=30", "growth:n=60", "two-opt:n=60", "x-monotone:n=60"]

GMSH = {
    "gmsh 6 + Blossom": {"Mesh.Algorithm": 6, "Mesh.RecombinationAlgorithm": 1},
    "gmsh 8 + Blossom": {"Mesh.Algorithm": 8, "Mesh.RecombinationAlgorithm": 1},
    "gmsh 6 + full-quad": {"Mesh.Algorithm": 6, "Mesh.RecombinationAlgorithm": 3},
    "gmsh 6 subdivided": {"Mesh.Algorithm": 6, "Mesh.RecombinationAlgorithm": 1,
                          "Mesh.SubdivisionAlgorithm": 1},
}

# -2q splits triangles into three quads and quads into four; -thetaquad joins triangles first, where
# the quad has no angle below that.
BAMG = {
    "bamg -2q": ["-2q"],
    "bamg -thetaquad -2q": ["-thetaquad", str(LOWER), "-2q"],
}
BAMG_VERTICES = 3_000_000  # -nbv, the most that it makes; it has memory for them from the start
BAMG_DIGITS = 12  # that it writes


# ---- The polygons


def make_polygon(quadbound, recipe, path):
    if recipe == "lake":
        lake = HERE.parents[1] / "paper" / "data" / "superior-303.geojson"
        path.write_text(lake.read_text())
        return
    subprocess.run([quadbound, "generate", recipe, "-o", path], check=True)


def rings_of(path):
    made = json.loads(path.read_text())
    while made["type"] != "Polygon":
        made = made["features"][0] if "features" in made else made["geometry"]
    return [ring[:-1] for ring in made["coordinates"]]


def sizes_of(ring):
    """The size at a vertex is the shorter of its two edges, as usual where nothing else is known."""
    return [min(math.dist(ring[i], ring[i - 1]), math.dist(ring[i], ring[(i + 1) % len(ring)]))
            for i in range(len(ring))]


def geo_text(rings):
    """gmsh's own format."""
    lines, loops, count = [], [], 0
    for ring in rings:
        size = len(ring)
        for i, ((x, y), h) in enumerate(zip(ring, sizes_of(ring))):
            lines.append(f"Point({count + i + 1}) = {{{x!r}, {y!r}, 0, {h!r}}};")
        lines += [f"Line({count + i + 1}) = {{{count + i + 1}, {count + (i + 1) % size + 1}}};"
                  for i in range(size)]
        lines.append(f"Curve Loop({len(loops) + 1}) = {{{count + 1}:{count + size}}};")
        loops.append(len(loops) + 1)
        count += size
    surface = ", ".join(str(loop) for loop in loops)
    return "\n".join([*lines, f"Plane Surface(1) = {{{surface}}};", "Recombine Surface {1};", ""])


def bamg_text(rings):
    """bamg's own format. Every vertex is a corner, so that edges stay straight, and required; the
    domain is on the left of the first edge, as the outer ring is counter-clockwise."""
    points = [point for ring in rings for point in ring]
    sizes = [repr(size) for ring in rings for size in sizes_of(ring)]
    edges, count = [], 0
    for ring in rings:
        edges += [f"{count + i + 1} {count + (i + 1) % len(ring) + 1} 1" for i in range(len(ring))]
        count += len(ring)
    all_vertices = [str(count), *(str(i + 1) for i in range(count))]
    return "\n".join(["MeshVersionFormatted 0", "Dimension 2",
                      "Vertices", str(count), *(f"{x!r} {y!r} 1" for x, y in points),
                      "Edges", str(count), *edges, "hVertices", *sizes,
                      "Corners", *all_vertices, "RequiredVertices", *all_vertices,
                      "SubDomainFromGeom", "1", "2 1 1 1", ""])


# ---- Running


# A process counts the memory of the one that started it, up to its exec, as its own: so a small
# one starts it, and 10 MiB are what is least seen.
LAUNCHER = """
import os, resource, subprocess, sys
limit = int(sys.argv[1])
resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5))
child = subprocess.Popen(sys.argv[2:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
_, status, usage = os.wait4(child.pid, 0)
print(os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, usage.ru_maxrss)
"""


def limited(command):
    """(status, CPU seconds, peak bytes) of a process; status None where the limit ran out."""
    done = subprocess.run([sys.executable, "-S", "-c", LAUNCHER, str(LIMIT), *map(str, command)],
                          stdout=subprocess.PIPE, text=True, check=True)
    status, seconds, kibibytes = done.stdout.split()
    ran_out = int(status) in (-signal.SIGXCPU, -signal.SIGKILL)
    return None if ran_out else int(status), float(seconds), 1024 * int(kibibytes)


def commands(options, polygon, folder):
    """By mesher: the command and the file it writes."""
    quadbound = options.build / "cli" / "quadbound"
    ours, proved, cgal = folder / "ours.obj", folder / "proved.json", folder / "cgal.obj"
    yield "quadbound", [quadbound, "mesh", polygon, "-o", proved, "-q"], proved
    yield "quadbound --no-verify", [quadbound, "mesh", polygon, "-o", ours, "-q", "--no-verify"], ours
    yield "CGAL, triangles in 3", [options.build / "bench" / "peers" / "peer_cgal", polygon, cgal], cgal
    for i, (name, settings) in enumerate(GMSH.items()):
        out = folder / f"gmsh{i}.msh"
        extra = [word for key, value in settings.items()
                 for word in ("-setnumber", key, str(value))]
        yield name, ["gmsh", "-2", "-format", "msh41", "-o", out, folder / "polygon.geo", *extra], out
    for i, (name, words) in enumerate(BAMG.items()):
        out = folder / f"bamg{i}.mesh"
        yield name, ["ffbamg", "-g", folder / "polygon.g", "-o", out, "-nbv", BAMG_VERTICES, *words], out


# ---- The meshes


def read_json(path):
    """Ours, with exact coordinates."""
    made = json.loads(path.read_text())
    points = [tuple(float(fractions.Fraction(value)) for value in vertex)
              for vertex in made["vertices"]]
    return points, made["quads"]


def read_obj(path):
    points, faces = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words and words[0] == "v":
            points.append((float(words[1]), float(words[2])))
        elif words and words[0] == "f":
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return points, faces


def read_msh(path):
    """The nodes and faces of gmsh 4.1."""
    words = iter(path.read_text().split())
    points, number, faces = [], {}, []
    for word in words:
        if word == "$Nodes":
            blocks, *_ = [int(next(words)) for _ in range(4)]
            for _ in range(blocks):
                _, _, _, count = [int(next(words)) for _ in range(4)]
                tags = [next(words) for _ in range(count)]
                for tag in tags:
                    number[tag] = len(points)
                    points.append((float(next(words)), float(next(words))))
                    next(words)
        elif word == "$Elements":
            blocks, *_ = [int(next(words)) for _ in range(4)]
            for _ in range(blocks):
                _, _, kind, count = [int(next(words)) for _ in range(4)]
                nodes = {15: 1, 1: 2, 2: 3, 3: 4}[kind]
                for _ in range(count):
                    next(words)
                    face = [number[next(words)] for _ in range(nodes)]
                    if nodes > 2:
                        faces.append(face)
    return points, faces


def read_bamg(path, rings):
    """bamg's mesh; its digits of the polygon's vertices are replaced by all that these have."""
    def rounded(value):
        return f"{float(value):.{BAMG_DIGITS}g}"
    inputs = {(rounded(x), rounded(y)): (float(x), float(y)) for ring in rings for x, y in ring}
    section, points, faces = "", [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words and words[0][0].isalpha():
            section = words[0]
        elif section == "Vertices" and len(words) == 3:
            x, y = words[:2]
            points.append(inputs.get((rounded(x), rounded(y)), (float(x), float(y))))
        elif section in ("Triangles", "Quadrilaterals") and len(words) > 3:
            faces.append([int(word) - 1 for word in words[:-1]])
    return points, faces


def write_obj(path, points, faces):
    lines = [f"v {x!r} {y!r} 0" for x, y in points]
    lines += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def corners(points, face):
    """(vertex, angle in degrees) of a counter-clockwise face."""
    for i, v in enumerate(face):
        at, after, before = points[v], points[face[(i + 1) % len(face)]], points[face[i - 1]]
        u = (after[0] - at[0], after[1] - at[1])
        w = (before[0] - at[0], before[1] - at[1])
        angle = math.degrees(math.atan2(u[0] * w[1] - u[1] * w[0], u[0] * w[0] + u[1] * w[1]))
        yield v, angle % 360


def counter_clockwise(points, face):
    area = sum(points[face[i - 1]][0] * points[v][1] - points[face[i - 1]][1] * points[v][0]
               for i, v in enumerate(face))
    return face if area > 0 else face[::-1]


def figures(points, faces, rings):
    """What the judge does not count. A corner that is a whole input angle is left out, as by the
    judge: it is the only one at its vertex, which is a vertex of the polygon."""
    faces = [counter_clockwise(points, face) for face in faces]
    quads = [face for face in faces if len(face) == 4]
    uses = [0] * len(points)
    for face in faces:
        for v in face:
            uses[v] += 1
    inputs = {(float(x), float(y)) for ring in rings for x, y in ring}
    outside, jacobians, extremes = 0, [], [360.0, 0.0]
    for quad in quads:
        made = list(corners(points, quad))
        judged = [angle for v, angle in made if uses[v] > 1 or points[v] not in inputs]
        if judged:
            extremes = [min(extremes[0], *judged), max(extremes[1], *judged)]
        # A millionth of a degree for the rounding of coordinates.
        outside += any(angle < LOWER - 1e-6 or angle > UPPER + 1e-6 for angle in judged)
        jacobians.append(min(math.sin(math.radians(angle)) for _, angle in made))
    return {"quads": len(quads), "triangles": len(faces) - len(quads), "outside": outside,
            "smallest": extremes[0], "largest": extremes[1],
            "jacobian": statistics.fmean(jacobians) if jacobians else 0}


def failed_claims(options, polygon, mesh, folder):
    report = folder / "report.json"
    quadbound = options.build / "cli" / "quadbound"
    done = subprocess.run([quadbound, "verify", polygon, mesh, "-q", "--report", report],
                          capture_output=True, text=True, check=False)
    if done.returncode == 2:
        return done.stderr.strip().splitlines()[-1]
    claims = json.loads(report.read_text())["claims"]
    failed = [claim["id"] for claim in claims if claim["exact"] == "fails"]
    return ", ".join(name for name in failed if name != "thm-13") or "none"


# ---- The table


def row(options, recipe, polygon, rings, folder):
    for name, command, out in commands(options, polygon, folder):
        if not name.startswith(options.only):
            continue
        status, seconds, peak = limited(command)
        label = f"| {recipe} | {name} |"
        if status is None:
            yield f"{label} no mesh within {LIMIT} s of CPU time | | | | | | | |"
        elif status != 0 or not out.exists():
            how = f"died of signal {-status}" if status < 0 else f"status {status}"
            yield f"{label} {how} | | | | | | | |"
        else:
            if out.suffix == ".mesh":
                mesh, out = out, out.with_suffix(".obj")
                write_obj(out, *read_bamg(mesh, rings))
            reader = {".json": read_json, ".msh": read_msh, ".obj": read_obj}[out.suffix]
            made = figures(*reader(out), rings)
            share = 100 * made["outside"] / made["quads"] if made["quads"] else 0
            yield (f"{label} {made['quads']:,} | {made['triangles']:,} | {share:.2f} % | "
                   f"{made['smallest']:.2f} | {made['largest']:.2f} | {made['jacobian']:.3f} | "
                   f"{made['quads'] / seconds:,.0f} | {peak / 2**20:.0f} | "
                   f"{failed_claims(options, polygon, out, folder)} |")


def version_of_gmsh():
    done = subprocess.run(["gmsh", "--version"], capture_output=True, text=True, check=True)
    return (done.stdout + done.stderr).strip()


FOOT = """Seconds are those of the process, reading and writing files included, so that small meshes tell more of the
start of a program than of its mesher. Angles are in degrees, without the corners that are whole input angles. A
boundary of doubles seldom lies exactly on slanted edges: files other than quadbound's own, which holds rationals, fail
*boundary-kept* and *area* there by rounding alone. gmsh 8 is its packing of parallelograms, which crashes in Debian's build.
The sizes of gmsh and bamg are the lengths of the edges at each vertex; CGAL's are not bounded. bamg's triangles are split
into three quads; with `-thetaquad 18.43` those that are joined to quads first, into four. It has memory for three
million vertices from the start. Its vertices on the polygon's are given back the digits that its files do not keep."""

HEAD = """| polygon | mesher | quads | triangles left | quads outside | smallest | largest | mean scaled Jacobian | quads/s | MiB | claims that fail |
| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |"""


def lines(options):
    for title, recipes in (("Tame", TAME), ("Sharp", SHARP)):
        yield from ("", f"{title} polygons:", "", HEAD)
        for recipe in recipes:
            with tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                polygon = folder / "polygon.geojson"
                make_polygon(options.build / "cli" / "quadbound", recipe, polygon)
                rings = rings_of(polygon)
                (folder / "polygon.geo").write_text(geo_text(rings))
                (folder / "polygon.g").write_text(bamg_text(rings))
                for line in row(options, recipe, polygon, rings, folder):
                    print(line, file=sys.stderr)
                    yield line
    yield from ("", FOOT, "")
    yield (f"Commit {record.commit()}; gmsh {version_of_gmsh()}, CGAL and ffbamg of Debian; "
           f"{record.cpu_model()}, load {os.getloadavg()[0]:.1f}.")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--only", default="", help="the first word of a mesher's name")
    options = parser.parse_args()
    record.put_into(options.output, "\n".join(lines(options)))


if __name__ == "__main__":
    main()
