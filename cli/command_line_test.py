# SPDX-License-Identifier: Apache-2.0
"""Drives the program as its users do. Usage: command_line_test.py PATH_OF_QUADBOUND [unittest options]"""

import json
import os
import pathlib
import pty
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = ""
DATA = pathlib.Path(__file__).resolve().parent.parent / "paper" / "data"
FORMATS = ("json", "vtu", "msh", "obj", "svg", "pdf", "png")
# All coordinates of its mesh are doubles, and the paper's warping breaks it.
RECIPE = "uniform:n=20,seed=1,bits=8"


class CommandLineTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def path(self, name):
        return str(self.folder / name)

    def file(self, name, text):
        (self.folder / name).write_text(text)
        return self.path(name)

    def run_it(self, *arguments, status=0):
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, cwd=self.folder)
        done.stdout_text = done.stdout.decode()
        done.stderr_text = done.stderr.decode()
        self.assertEqual(done.returncode, status, (arguments, done.stderr_text))
        return done

    def one_line(self, *arguments, status=2):
        """What the program says on standard error: one line."""
        text = self.run_it(*arguments, status=status).stderr_text
        self.assertRegex(text, r"\Aquadbound: [^\n]+\n\Z")
        return text

    def points(self, recipe=RECIPE, name="points.csv"):
        self.run_it("generate", recipe, "-o", name)
        return self.path(name)

    def names(self):
        return sorted(entry.name for entry in self.folder.iterdir())


class Usage(CommandLineTest):
    def commands(self):
        text = self.run_it("--help").stdout_text
        commands = re.findall(r"^  ([a-z]+) ", text.split("Subcommands:")[1], re.MULTILINE)
        self.assertIn("fuzz", commands)
        return [c for c in commands if c != "quadbound"]

    def test_help_of_every_command_has_an_example(self):
        self.assertIn("quadbound mesh --points", self.run_it("--help").stdout_text)
        for command in self.commands():
            text = self.run_it(command, "--help").stdout_text
            self.assertRegex(text, rf"(?m)^Examples?:\n  quadbound {command}\b", command)

    def test_version(self):
        self.assertRegex(self.run_it("--version").stdout_text, r"^quadbound \d+\.\d+\.\d+\n$")

    def test_unknown_options_and_commands_are_refused(self):
        points = self.points()
        self.one_line("no-such-command")
        self.one_line("--no-such-option")
        self.one_line()
        for command in self.commands():
            self.one_line(command, "--no-such-option")
        self.assertIn("--bogus", self.one_line("mesh", "--points", points, "--bogus"))
        self.one_line("mesh", points)  # a polygon, without --points
        self.one_line("mesh", "--points", points, "--grid", "7x7")
        self.one_line("mesh", "--points", points, "one-too-many")
        self.one_line("fuzz", "--points", "--count", "minus-one")
        self.one_line("fuzz", "--points", "--count", "1", "--seconds", "1")
        self.assertIn("lattice-corners", self.one_line("fuzz", "--points", "--families", "nothing"))
        self.assertIn("lattice-corners", self.one_line("generate", "nothing"))

    def test_unknown_extensions_are_refused_before_the_work(self):
        points = self.points()
        self.assertIn(".foo", self.one_line("mesh", "--points", points, "-o", "a.json", "-o", "b.foo"))
        self.assertEqual(self.names(), ["points.csv"])


class BadInput(CommandLineTest):
    FILES = (
        ("empty.csv", "", ""),
        ("header-only.csv", "x,y\n", ""),
        ("duplicate.csv", "0,0\n1,1\n0,0\n", "vertex 0: vertex 2 "),
        ("zeros.csv", "1,1\n0,0\n-0,0\n", "vertex 1: vertex 2 "),
        ("nan.csv", "0,0\nnan,1\n", "vertex 1: "),
        ("infinite.csv", "0,0\n1,inf\n", "vertex 1: "),
        ("too-large.csv", "0,0\n1e999,1\n", "vertex 1: "),
        ("too-small.csv", "0,0\n1e-305,1\n", "vertex 1: "),
        ("missing-column.csv", "0,0\n1\n", "vertex 1: "),
        ("text.csv", "0,0\n1,one\n", "vertex 1: "),
        ("garbage.csv", "0,0\n1,1x\n", "vertex 1: "),
        ("garbage.txt", "0 0\n1 1 # fine\n1 2 3\n", "vertex 2: "),
        ("truncated.node", "3 2 0 0\n1 0 0\n2 1 1\n", ""),
        ("cut-in-line.node", "3 2 0 0\n1 0 0\n2 1", "vertex 1: "),
        ("trailing.node", "1 2 0 0\n1 0 0\n2 1 1\n", ""),
        ("points.dat", "0,0\n", ""),
    )

    def test_input_validated_one_line_names_file_and_vertex(self):
        for name, text, place in self.FILES:
            with self.subTest(name):
                path = self.file(name, text)
                line = self.one_line("mesh", "--points", path, "-o", "mesh.json")
                self.assertTrue(line.startswith(f"quadbound: {path}: {place}"), line)
                self.assertFalse((self.folder / "mesh.json").exists())

    def test_files_that_cannot_be_read(self):
        (self.folder / "folder.csv").mkdir()
        for name in ("nothing.csv", "folder.csv", "nowhere/points.csv"):
            self.assertIn(name + ": ", self.one_line("mesh", "--points", name))

    def test_verify_refuses_unreadable_points_and_meshes(self):
        points = self.points()
        self.run_it("mesh", "--points", points, "-o", "mesh.json")
        self.assertIn("nothing.csv", self.one_line("verify", "--points", "nothing.csv", "mesh.json"))
        self.assertIn("nothing.json", self.one_line("verify", "--points", points, "nothing.json"))
        whole = (self.folder / "mesh.json").read_text()
        for name, text in (("empty.json", ""), ("cut.json", whole[: len(whole) // 2]),
                           ("not.json", "{}"), ("text.obj", "v 0 zero 0\n"), ("cut.msh", "$Nodes\n"),
                           ("mesh.vtu", "<VTKFile/>")):
            self.file(name, text)
            self.assertIn(name, self.one_line("verify", "--points", points, name))


class Budgets(CommandLineTest):
    def test_the_line_names_the_option_to_raise(self):
        points = self.points("uniform:n=3000,seed=1")
        for option in (("--max-cells", 1000), ("--max-seconds", 1e-9)):
            line = self.one_line("mesh", "--points", points, "-o", "mesh.json", *option, status=3)
            self.assertIn(f"raise {option[0]}", line)
        self.assertEqual(self.names(), ["points.csv"])

    def test_points_too_close_for_exact_coordinates(self):
        points = self.file("close.csv", "0,0\n1e-200,0\n1,1\n")
        self.assertIn("too close", self.one_line("mesh", "--points", points, status=3))


class Writing(CommandLineTest):
    def test_max_angle_broken_by_the_papers_warping_writes_nothing(self):
        points = self.points()
        self.file("mesh.json", "as it was")
        done = self.run_it("mesh", "--points", points, "--warp", "paper", "-o", "mesh.json", "-o",
                           "mesh.svg", status=1)
        self.assertRegex(done.stderr_text, "claim max-angle fails")
        self.assertEqual((self.folder / "mesh.json").read_text(), "as it was")
        self.assertEqual(self.names(), ["mesh.json", "points.csv"])

    def test_no_place_to_write_leaves_nothing_behind(self):
        points = self.points()
        (self.folder / "folder.json").mkdir()
        for target in ("nowhere/mesh.json", "folder.json", "points.csv/mesh.json", "/proc/mesh.json"):
            for format_ in ("json", "svg", "png"):
                target = target.replace("json", format_) if target != "folder.json" else target
                line = self.one_line("mesh", "--points", points, "-o", target)
                self.assertIn(target, line)
        self.one_line("mesh", "--points", points, "--report", "nowhere/report.json")
        self.one_line("generate", RECIPE, "-o", "nowhere/points.csv")
        self.assertEqual(self.names(), ["folder.json", "points.csv"])

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_read_only_folder(self):
        points = self.points()
        (self.folder / "locked").mkdir(mode=0o555)
        self.one_line("mesh", "--points", points, "-o", "locked/mesh.json")

    def test_full_disk(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        with open("/dev/full", "wb") as full:
            done = subprocess.run([PROGRAM, "generate", "uniform:n=1000"], stdout=full,
                                  stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"cannot be written", done.stderr)

    def test_several_outputs_and_deterministic_bytes_of_every_format(self):
        points = self.points()
        runs = []
        for run in ("first", "second"):
            (self.folder / run).mkdir()
            outputs = [argument for f in FORMATS for argument in ("-o", f"{run}/mesh.{f}")]
            self.run_it("mesh", "--points", points, *outputs)
            self.assertEqual(len(list((self.folder / run).iterdir())), len(FORMATS))
            runs.append({f: (self.folder / run / f"mesh.{f}").read_bytes() for f in FORMATS})
        for f in FORMATS:
            self.assertTrue(runs[0][f])
            self.assertEqual(runs[0][f], runs[1][f], f)

    def test_standard_output(self):
        points = pathlib.Path(self.points()).read_bytes()
        self.assertEqual(self.run_it("generate", RECIPE, "-o", "-").stdout, points)
        self.assertEqual(self.run_it("generate", RECIPE).stdout, points)
        self.run_it("mesh", "--points", "points.csv", "-o", "mesh.json")
        mesh = self.run_it("mesh", "--points", "points.csv", "-o", "-").stdout
        self.assertEqual(mesh, (self.folder / "mesh.json").read_bytes())

    def test_an_interrupt_while_writing_leaves_no_partial_file(self):
        points = self.points("uniform:n=4000,seed=1")
        interrupted = 0
        for attempt in range(5):
            outputs = [a for i in range(6) for a in ("-o", f"{attempt}-{i}.vtu")]
            process = subprocess.Popen([PROGRAM, "mesh", "--points", points, "--no-verify", *outputs],
                                       cwd=self.folder, stderr=subprocess.DEVNULL)
            while process.poll() is None and not list(self.folder.glob("*.tmp")):
                time.sleep(0.001)
            process.send_signal(signal.SIGINT)
            interrupted += process.wait() == -signal.SIGINT
            self.assertEqual(list(self.folder.glob("*.tmp")), [])
            for whole in self.folder.glob("*.vtu"):
                self.assertTrue(whole.read_bytes().rstrip().endswith(b"</VTKFile>"))
            if interrupted:
                return
        self.fail("never caught the program while it was writing")


class Generating(CommandLineTest):
    def rings(self, name):
        feature = json.loads((self.folder / name).read_text())
        return feature.get("geometry", feature)["coordinates"]

    def families(self):
        text = self.run_it("generate", "--help").stdout_text.split("\nPolygons")[1]
        return re.findall(r"^  ([a-z-]+) +\S", text.split("Examples:")[0], re.MULTILINE)

    def test_holes_and_count(self):
        self.run_it("generate", "growth", "--n", 50, "--holes", 2, "--seed", 8, "--count", 3, "-o",
                    "p.geojson")
        self.assertEqual(self.names(), ["p-10.geojson", "p-8.geojson", "p-9.geojson"])
        for name in self.names():
            self.assertEqual([len(ring) for ring in self.rings(name)], [51, 7, 7])
        self.run_it("generate", "growth:n=50,seed=9,holes=2", "-o", "alone.geojson")
        self.assertEqual(self.rings("alone.geojson"), self.rings("p-9.geojson"))

    def test_the_extension_chooses_the_format(self):
        for recipe, names in (("star:n=20,seed=2,holes=2", ("p.geojson", "p.poly", "p.wkt", "q.json")),
                              (RECIPE, ("p.csv", "p.node", "p.xyz", "p.txt"))):
            meshes = set()
            for name in names:
                self.run_it("generate", recipe, "-o", name)
                points = ["--points"] if recipe == RECIPE else []
                self.run_it("mesh", *points, name, "-o", "mesh.json")
                meshes.add((self.folder / "mesh.json").read_bytes())
            self.assertEqual(len(meshes), 1, recipe)
        before = self.names()
        self.assertIn("p.svg: not a polygon file", self.one_line("generate", "koch:n=12", "-o", "p.svg"))
        self.assertIn("p.wkt: not a point file", self.one_line("generate", RECIPE, "-o", "p.wkt"))
        self.one_line("generate", "koch:n=12", "-o", "p")
        self.assertEqual(self.names(), before)

    def test_gallery_in_every_format_of_pictures(self):
        for name, start in (("g.svg", b"<?xml"), ("g.pdf", b"%PDF"), ("g.png", b"\x89PNG")):
            self.run_it("generate", "--gallery", name)
            self.assertTrue((self.folder / name).read_bytes().startswith(start))
        text = (self.folder / "g.svg").read_text()
        self.assertIn("koch", self.families())
        for family in self.families():
            self.assertIn(f">{family}<", text)

    def test_statistics_of_all_families_or_one(self):
        self.run_it("generate", "--statistics", "s.md", "--n", 24, "--count", 3)
        text = (self.folder / "s.md").read_text()
        for family in self.families():
            self.assertIn(f"| {family} | 3 | 0 |", text)
        self.assertIn("Not covered by any of them: ", text)
        self.run_it("generate", "koch", "--statistics", "s.json", "--n", 12, "--count", 2)
        koch, total = json.loads((self.folder / "s.json").read_text())["families"]
        self.assertEqual((koch["name"], koch["polygons"], koch["vertices"]), ("koch", 2, 24))
        self.assertEqual(sum(koch["angles"]) + koch["straight"], 24)
        self.assertEqual(total["feature_size"], koch["feature_size"])
        self.assertIn("# What", self.run_it("generate", "star", "--statistics", "-").stdout_text)
        self.assertIn(".md", self.one_line("generate", "--statistics", "s.csv"))
        self.one_line("generate", "nothing", "--statistics", "-")
        self.one_line("generate", "star", "--statistics", "-", "--set", "low=40")

    def test_what_cannot_be_made_is_refused(self):
        self.assertIn("FAMILY", self.one_line("generate"))
        self.assertIn(".svg", self.one_line("generate", "--gallery", "g.jpg"))
        self.assertIn("--count", self.one_line("generate", "star", "--count", 2))
        self.assertIn("multiple of 4", self.one_line("generate", "gear", "--n", 13))
        self.assertIn("holes", self.one_line("generate", "uniform", "--holes", 1))
        self.one_line("generate", "star", "--gallery", "g.svg")
        self.assertIn("2^-20", self.one_line("generate", "sharp:n=20000,depth=16"))
        self.assertEqual(self.names(), [])


class Judging(CommandLineTest):
    def meshed(self, recipe=RECIPE):
        points = self.points(recipe)
        self.run_it("mesh", "--points", points, "-o", "mesh.json", "-o", "mesh.obj", "-o", "mesh.msh")
        return points

    def verdicts(self, *arguments, status):
        self.run_it("verify", "-q", *arguments, "--report", "report.json", status=status)
        report = json.loads((self.folder / "report.json").read_text())
        return {claim["id"]: claim["exact"] for claim in report["claims"]}

    def test_thm_1_holds_for_our_file(self):
        verdicts = self.verdicts("--points", self.meshed(), "mesh.json", status=0)
        self.assertEqual(set(verdicts.values()), {"holds"})

    def test_foreign_meshes_are_judged_but_for_the_cells_they_do_not_tell(self):
        points = self.meshed()
        for mesh in ("mesh.obj", "mesh.msh"):
            verdicts = self.verdicts("--points", points, mesh, status=0)
            self.assertEqual({id for id, verdict in verdicts.items() if verdict != "holds"},
                             {"size-3N", "thm-1"}, mesh)
            self.assertEqual(verdicts["size-3N"], "not-decided")

    def test_thm_13_of_a_polygon_is_judged(self):
        self.file("square.geojson", '{"type":"Polygon","coordinates":[[[0,0],[2,0],[2,2],[0,2],[0,0]]]}')
        good = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n"
        self.file("good.obj", good)
        verdicts = self.verdicts("square.geojson", "good.obj", status=0)
        self.assertEqual({id for id, verdict in verdicts.items() if verdict != "holds"},
                         {"size-5N", "thm-13"})
        self.file("moved.obj", good.replace("v 2 2 0", "v 2 1.5 0"))
        verdicts = self.verdicts("square.geojson", "moved.obj", status=1)
        self.assertEqual(verdicts["boundary-kept"], "fails")

    def test_a_moved_vertex_breaks_claims_by_name(self):
        points = self.meshed()
        mesh = json.loads((self.folder / "mesh.json").read_text())
        first = (self.folder / "points.csv").read_text().split()[1].split(",")
        as_numbers = [[self.number(x), self.number(y)] for x, y in mesh["vertices"]]
        vertex = as_numbers.index([float(first[0]), float(first[1])])
        mesh["vertices"][vertex][0] += "1" if "/" not in mesh["vertices"][vertex][0] else "7"
        self.file("moved.json", json.dumps(mesh))
        done = self.run_it("verify", "--points", points, "moved.json", status=1)
        self.assertRegex(done.stdout_text, r"(?m)^points-kept +fails")
        self.assertRegex(done.stdout_text, r"(?m)^thm-1 +fails")

    @staticmethod
    def number(text):
        numerator, _, denominator = text.partition("/")
        return int(numerator) / int(denominator or 1)

    def test_deterministic_report_whatever_the_threads(self):
        points = self.meshed("uniform:n=300,seed=2")
        texts = []
        for threads in (1, 2, 0):
            report = f"report-{threads}.json"
            self.run_it("mesh", "--points", points, "--threads", threads, "--report", report)
            texts.append((self.folder / report).read_bytes())
            again = self.run_it("verify", "-q", "--points", points, "mesh.json", "--threads", threads,
                                "--report", "-").stdout
            texts.append(again)
        self.assertEqual(len(set(texts)), 1)

    def test_thm_1_holds_for_small_and_extreme_sets(self):
        sets = {
            "one": "0.3,0.7\n", "origin": "0,0\n", "two": "0,0\n3,1\n",
            "collinear": "0,0\n1,2\n2,4\n3,6\n", "horizontal": "0,5\n1,5\n7,5\n",
            "offset": "1000000.25,1000000\n1000001,1000000.5\n1000000.3,1000000.7\n",
            "tiny": "1e-300,2e-300\n3e-300,1e-300\n-2e-300,0\n",
            "huge": "1e300,2e300\n3e300,1e300\n-2e300,0\n",
        }
        for name, text in sets.items():
            with self.subTest(name):
                points = self.file(f"{name}.csv", text)
                self.run_it("mesh", "--points", points, "-o", f"{name}.json")
                self.run_it("verify", "-q", "--points", points, f"{name}.json")


class Polygons(CommandLineTest):
    RECIPE = "star:n=12,seed=1,holes=1"
    INVALID = (
        ("empty.geojson", "", ""),
        ("two.geojson", [[[0, 0], [1, 0]]], "ring 0"),
        ("bow-tie.geojson", [[[0, 0], [2, 2], [2, 0], [0, 2]]], "ring 0, vertex "),
        ("repeated.geojson", [[[0, 0], [2, 0], [2, 0], [0, 2]]], "ring 0, vertex 1"),
        ("flat.geojson", [[[0, 0], [1, 0], [2, 0]]], "ring 0"),
        ("outside.geojson", [[[0, 0], [2, 0], [0, 2]], [[5, 5], [6, 5], [5, 6]]], "ring 1"),
        ("crossing.geojson", [[[0, 0], [4, 0], [0, 4]], [[1, 1], [9, 1], [1, 2]]], "ring 0, vertex 1"),
        ("touching.geojson", [[[0, 0], [4, 0], [0, 4]], [[0, 0], [1, 1], [1, 2]]], "ring 0, vertex 0"),
        ("tiny.geojson", [[[0, 0], [1e-305, 0], [0, 1]]], "ring 0, vertex 1"),
        ("cut.geojson", '{"type": "Polygon", "coordinates": [[[0, 0], [1', ""),
        ("point.geojson", '{"type": "Point", "coordinates": [0, 0]}', ""),
        ("polygon.dat", "0 0", ""),
    )

    def polygon(self, recipe=RECIPE, name="polygon.geojson"):
        self.run_it("generate", recipe, "-o", name)
        return self.path(name)

    def rings(self, name, rings):
        closed = [ring + ring[:1] for ring in rings]
        return self.file(name, json.dumps({"type": "Polygon", "coordinates": closed}))

    def claims(self, *arguments):
        self.run_it("verify", "-q", *arguments, "--report", "report.json")
        report = json.loads((self.folder / "report.json").read_text())
        return {claim["id"]: claim["exact"] for claim in report["claims"]}

    def cells(self, *arguments):
        self.run_it("mesh", "polygon.geojson", *arguments, "-o", "mesh.json", "--statistics", "s.json")
        self.assertEqual(set(self.claims("polygon.geojson", "mesh.json").values()), {"holds"})
        return json.loads((self.folder / "s.json").read_text())["cells"]

    def test_thm_13_proved_for_all_formats_with_deterministic_bytes(self):
        polygon = self.polygon()
        runs = []
        for run in ("first", "second"):
            (self.folder / run).mkdir()
            outputs = [argument for f in FORMATS for argument in ("-o", f"{run}/mesh.{f}")]
            done = self.run_it("mesh", polygon, *outputs, "--report", f"{run}/proof.json",
                               "--statistics", f"{run}/statistics.json")
            self.assertRegex(done.stderr_text, r"\A18 vertices, N = \d+ cells .*; thm-13 proved\n\Z")
            runs.append({p.name: p.read_bytes() for p in (self.folder / run).iterdir()})
        self.assertEqual(len(runs[0]), len(FORMATS) + 2)
        for name, content in runs[0].items():
            self.assertTrue(content)
            self.assertEqual(content, runs[1][name], name)
        claims = self.claims(polygon, "first/mesh.json")
        self.assertEqual(set(claims.values()), {"holds"})
        self.assertLessEqual({"boundary-kept", "min-angle", "max-angle", "size-5N", "thm-13"},
                             set(claims))

    def test_all_formats_of_polygons_give_the_same_mesh(self):
        square = [[0, 0], [4, 0], [4, 4], [0, 4]]
        hole = [[1, 1], [1, 2], [2, 2], [2, 1]]
        self.rings("p.geojson", [square, hole])
        self.file("p.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))\n")
        vertices = "".join(f"{i} {x} {y}\n" for i, (x, y) in enumerate(square + hole, 1))
        segments = "".join(f"{i} {i} {i % 4 + 1 if i < 5 else i % 4 + 5}\n" for i in range(1, 9))
        self.file("p.poly", f"8 2 0 0\n{vertices}8 0\n{segments}1\n1 1.5 1.5\n")
        meshes = {self.run_it("mesh", "-q", f"p.{f}", "-o", "-").stdout
                  for f in ("geojson", "wkt", "poly")}
        self.assertEqual(len(meshes), 1)

    def test_orientation_of_the_file_does_not_matter(self):
        square = [[0, 0], [4, 0], [4, 4], [0, 4]]
        hole = [[1, 1], [1, 2], [2, 2], [2, 1]]
        for name, rings in (("a", [square, hole]), ("b", [square[::-1], hole[::-1]])):
            polygon = self.rings(f"{name}.geojson", rings)
            self.run_it("mesh", polygon, "-o", f"{name}.json")
            self.run_it("verify", "-q", polygon, f"{name}.json")

    def test_statistics(self):
        self.run_it("mesh", "-q", self.polygon("sharp:n=8,seed=2"), "--statistics", "s.json")
        statistics = json.loads((self.folder / "s.json").read_text())
        self.assertEqual(statistics["input_vertices"], 8)
        self.assertEqual(sum(statistics["constructions"].values()), statistics["quads"])
        self.assertEqual(sum(statistics["degrees"].values()), statistics["vertices"])
        self.assertGreater(statistics["scaled_jacobian"]["smallest"], 0)
        made = statistics["section_3_4"]
        self.assertLessEqual({"cells_before_separation", "rounds", "separation_splits",
                              "dead_end_splits", "restarts", "kites", "kept_quads",
                              "alpha_vertices_by_level", "centres_aligned"}, set(made))
        self.assertEqual(made["kites"], 4)  # at every tip
        self.assertGreaterEqual(made["rounds"], 1)

    def test_sizes_asked_for(self):
        self.polygon()
        free = self.cells()
        self.file("sizes.csv", "# near a corner\n0.5,0.1,0.01\n\n0.1,0.5,0.02\n")
        for options in (("--max-size", 0.05), ("--refine-near", "0.5,0.1,0.01"),
                        ("--refine-near", "-0.2,0.3,0.3,0.1,0.02", "--refine-near", "0,0,0.01"),
                        ("--size-field", "sizes.csv"), ("--boundary-size", 0.02),
                        ("--boundary-size", 0.02, "--boundary-growth", 0.3)):
            self.assertGreater(self.cells(*options), free, options)
        self.assertEqual(self.cells("--max-size", 1000), free)

    def test_sizes_that_are_none_are_refused(self):
        polygon = self.polygon()
        self.file("two.csv", "0,0,1\n0,0\n")
        self.file("zero.csv", "0,0,0\n")
        for number in ("0", "-1", "nan", "inf", "much", ""):
            for option in ("--max-size", "--boundary-size"):
                line = self.one_line("mesh", polygon, option, number, "-o", "mesh.json")
                self.assertIn(option, line)
                self.assertLess(len(line), 200)
        for source in ("1,2", "a,b,c", "0,0,0", "0,0,-1", "0,0,nan", "0,0,1,1", "0,0,1,", ""):
            self.assertIn("--refine-near", self.one_line("mesh", polygon, "--refine-near", source))
        self.assertIn("nothing.csv", self.one_line("mesh", polygon, "--size-field", "nothing.csv"))
        self.assertIn("line 2", self.one_line("mesh", polygon, "--size-field", "two.csv"))
        self.assertIn("line 1", self.one_line("mesh", polygon, "--size-field", "zero.csv"))
        self.one_line("mesh", polygon, "--boundary-growth", 1)
        self.one_line("mesh", polygon, "--boundary-size", 1, "--boundary-growth", -1)
        for option in ("--max-size", "--boundary-size"):
            self.one_line("mesh", "--points", polygon, option, 1)
        self.assertEqual(self.names(), ["polygon.geojson", "two.csv", "zero.csv"])

    def test_budgets(self):
        polygon = self.polygon()
        self.file("mesh.json", "as it was")
        for option in (("--max-cells", 50), ("--max-seconds", 0), ("--max-seconds", 1e-9)):
            line = self.one_line("mesh", polygon, "-o", "mesh.json", *option, status=3)
            self.assertTrue(line.startswith(f"quadbound: {polygon}: "), line)
            self.assertIn(f"raise {option[0]}", line)
        self.assertEqual((self.folder / "mesh.json").read_text(), "as it was")
        deep = self.rings("deep.geojson", [[[-1, -1], [1, -1], [1, 1], [-1, 1]],
                                           [[0, 0], [0, 1e-250], [1e-250, 0]]])
        self.assertIn("exact coordinates end", self.one_line("mesh", deep, status=3))
        for number in ("-1", "nan", "long"):
            self.assertIn("--max-seconds", self.one_line("mesh", polygon, "--max-seconds", number))

    def test_input_validated_one_line_names_file_and_vertex(self):
        for name, content, place in self.INVALID:
            with self.subTest(name):
                is_text = isinstance(content, str)
                path = self.file(name, content) if is_text else self.rings(name, content)
                line = self.one_line("mesh", path, "-o", "mesh.json")
                self.assertTrue(line.startswith(f"quadbound: {path}: {place}"), line)
                self.assertFalse((self.folder / "mesh.json").exists())

    def test_options_of_point_sets_are_refused(self):
        polygon = self.polygon()
        for option in (("--warp", "paper"), ("--grid", "5x5"), ("--two-two", "paper")):
            line = self.one_line("mesh", polygon, *option)
            self.assertIn(option[0], line)
            self.assertIn("--points", line)

    def test_no_verify(self):
        polygon = self.polygon()
        done = self.run_it("mesh", polygon, "--no-verify", "-o", "fast.json")
        self.assertIn("not verified", done.stderr_text)
        self.assertNotIn("proved", done.stderr_text)
        self.run_it("mesh", polygon, "-o", "slow.json")
        self.assertEqual((self.folder / "fast.json").read_bytes(),
                         (self.folder / "slow.json").read_bytes())


class Progress(CommandLineTest):
    LONG_WORK = ("fuzz", "--points", "-q", "--seconds", "3", "--families", "uniform")

    def test_nothing_appears_where_standard_error_is_no_terminal(self):
        self.assertEqual(self.run_it(*self.LONG_WORK).stderr, b"")

    def test_a_line_appears_on_a_terminal_and_goes_away(self):
        ours, theirs = pty.openpty()
        process = subprocess.Popen([PROGRAM, *self.LONG_WORK], stderr=theirs, cwd=self.folder)
        os.close(theirs)
        text = b""
        try:
            while piece := os.read(ours, 4096):
                text += piece
        except OSError:  # how Linux ends a terminal
            pass
        os.close(ours)
        self.assertEqual(process.wait(), 0)
        self.assertIn(b"s left", text)
        self.assertTrue(text.endswith(b"\r\x1b[K"))


class Fuzz(CommandLineTest):
    def test_deterministic_table_and_report_whatever_the_threads(self):
        outputs = set()
        for threads in (1, 2):
            done = self.run_it("fuzz", "--points", "--count", 60, "--seed", 5, "--threads", threads,
                               "--report", "report.json")
            outputs.add((done.stdout, (self.folder / "report.json").read_bytes()))
        self.assertEqual(len(outputs), 1)
        self.assertFalse((self.folder / "findings").exists())

    def test_max_angle_findings_of_the_papers_warping_can_be_replayed(self):
        done = self.run_it("fuzz", "--points", "--count", 10, "--families", "lattice-corners,uniform",
                           "--warp", "paper", "--findings", "found", status=1)
        self.assertIn("quadbound: finding: ", done.stderr_text)
        lines = (self.folder / "found/INDEX").read_text().splitlines()
        self.assertTrue(lines)
        for line in lines:
            claim, origin, replay, _ = line.split("\t")
            self.assertRegex(origin, r"^(lattice-corners|uniform):n=\d+,seed=")
            program, *arguments = shlex.split(replay)
            self.assertEqual(program, "quadbound")
            self.assertIn(f"claim {claim} ", self.run_it(*arguments, status=1).stderr_text)

    def test_a_campaign_that_never_reached_a_construction_fails_and_names_it(self):
        done = self.run_it("fuzz", "--points", "-q", "--count", 100, "--max-n", 1, "--families",
                           "grid", status=1)
        self.assertRegex(done.stderr_text, r"(?m)^quadbound: .*stitching case .* was never reached")


class FuzzPolygons(CommandLineTest):
    STRICT = ("--min-tangent", "2/5")  # what no mesh of more than a few cells keeps

    def findings(self, folder="found"):
        lines = (self.folder / folder / "INDEX").read_text().splitlines()
        return [line.split("\t") for line in lines]

    def test_deterministic_table_and_summary_whatever_the_threads(self):
        outputs = set()
        for threads in (1, 3):
            done = self.run_it("fuzz", "--count", 30, "--seed", 5, "--max-n", 20, "--max-cells", 20000,
                               "--threads", threads, "--summary", "summary.json")
            outputs.add((done.stdout, (self.folder / "summary.json").read_bytes()))
        self.assertEqual(len(outputs), 1)
        self.assertEqual([entry.name for entry in (self.folder / "findings").iterdir()],
                         ["journal-5.jsonl"])
        summary = json.loads((self.folder / "summary.json").read_text())
        self.assertEqual(summary["all"]["cases"], 30)
        self.assertEqual(summary["findings"], [])
        self.assertEqual(sum(c["quads"] for c in summary["constructions"].values()),
                         summary["all"]["quads"])

    def test_findings_are_kept_shrunk_and_replayed(self):
        done = self.run_it("fuzz", "--count", 6, "--family", "star,blob", "--max-n", 20, *self.STRICT,
                           "--shrink-tries", 40, "--findings", "found", status=1)
        self.assertIn("quadbound: finding: min-angle: ", done.stderr_text)
        findings = self.findings()
        self.assertTrue(findings)
        for claim, recipe, replay, _ in findings:
            self.assertRegex(recipe, r"^(star|blob):n=\d+,seed=")
            program, *arguments = shlex.split(replay)
            self.assertEqual(program, "quadbound")
            self.assertIn(f"claim {claim} ", self.one_line(*arguments, status=1))
            self.run_it(*arguments[:3])  # without the stricter bound
            case = self.folder / arguments[2]
            small = case.with_name(case.stem + "-small.geojson")
            self.assertIn(f"claim {claim} ", self.one_line("fuzz", "--replay", small, *self.STRICT,
                                                           status=1))
            self.assertLessEqual(small.stat().st_size, case.stat().st_size)

    def test_a_budget_is_counted_apart(self):
        done = self.run_it("fuzz", "--count", 2, "--family", "star", "--max-cells", 10,
                           "--summary", "summary.json")
        self.assertIn("refused: 2\n", done.stdout_text)
        summary = json.loads((self.folder / "summary.json").read_text())
        self.assertEqual((summary["all"]["too_many_cells"], len(summary["refusals"])), (2, 2))
        self.assertIn("--max-cells", self.one_line("fuzz", "--replay", "star:n=9,seed=1",
                                                   "--max-cells", 10, status=3))

    def test_replay_of_a_recipe_and_of_what_is_none(self):
        self.assertIn("thm-13 proved", self.run_it("fuzz", "--replay", "star:n=9,seed=1").stdout_text)
        self.assertEqual(self.run_it("fuzz", "-q", "--replay", "star:n=9,seed=1").stdout, b"")
        self.one_line("fuzz", "--replay", "nothing:n=9")
        self.one_line("fuzz", "--replay", "missing.geojson")
        self.one_line("fuzz", "--replay", self.file("bow.wkt", "POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))"))

    def test_corpus_with_folders_of_what_must_fail(self):
        self.one_line("fuzz", "--corpus", "missing")
        for name in ("good", "bad/known-failing"):
            (self.folder / "corpus" / name).mkdir(parents=True)
        self.one_line("fuzz", "--corpus", "corpus")
        self.file("corpus/good/square.wkt", "POLYGON((0 0, 2 0, 2 2, 0 2, 0 0))")
        self.file("corpus/good/bow.wkt", "POLYGON((0 0, 2 2, 2 0, 0 2, 0 0))")
        self.assertIn("2 cases, 0 bad", self.run_it("fuzz", "--corpus", "corpus").stdout_text)
        self.file("corpus/bad/known-failing/square.wkt", "POLYGON((0 0, 2 0, 2 2, 0 2, 0 0))")
        self.assertIn("3 cases, 1 bad", self.run_it("fuzz", "--corpus", "corpus", status=1).stdout_text)

    def test_wrong_usage_is_refused(self):
        self.assertIn("spiral-band", self.one_line("fuzz", "--family", "nothing"))
        for wrong in ("2", "0/1", "1/8", "a/b", "1/2/3"):
            self.one_line("fuzz", "--count", 1, "--min-tangent", wrong)
        self.one_line("fuzz", "--warp", "paper")
        self.one_line("fuzz", "--points", "--replay", "star:n=9")
        self.one_line("fuzz", "--count", 1, "--seconds", 1)

    def test_a_campaign_by_the_clock_ends(self):
        begin = time.monotonic()
        self.run_it("fuzz", "-q", "--seconds", 1, "--family", "regular", "--max-n", 10)
        self.assertLess(time.monotonic() - begin, 60)

    def test_a_campaign_that_never_reached_a_construction_fails_and_names_it(self):
        done = self.run_it("fuzz", "-q", "--count", 1000, "--family", "regular", "--max-cells", 1,
                           status=1)
        self.assertIn("quadbound: kite tip was never reached", done.stderr_text)


class Prove(CommandLineTest):
    def test_theorem_1_is_proved_without_trees(self):
        text = self.run_it("prove", "theorem-1", "--trees", 0).stdout_text
        self.assertIn("proved for all of them", text)

    def test_lemmas_have_a_verdict_each(self):
        text = self.run_it("prove", "lemmas", "--trees", 2).stdout_text
        self.assertLessEqual({f"lemma-{k}" for k in range(2, 13)},
                             set(re.findall(r"lemma-\d+", text)))

    def test_insertion_of_a_file(self):
        ring = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]
        self.file("square.geojson", json.dumps({"type": "Polygon", "coordinates": [ring]}))
        text = self.run_it("prove", "insertion", "square.geojson").stdout_text
        self.assertIn("| square.geojson | 1 | 1 |", text)

    def test_corners(self):
        text = self.run_it("prove", "corners", "--corners", 1).stdout_text
        self.assertRegex(text, r"\| all \|  \| 36 \| \d+ \| \d+ \| \d+ \| 0 \| 0 \|\n")
        self.assertIn("The hardest: place (", text)

    def test_options_of_another_theorem_are_refused(self):
        for arguments in (("corners", "--trees", 5), ("theorem-1", "--corners", 5),
                          ("lemmas", "--seeds", 1), ("corners", "square.geojson")):
            self.assertIn("does nothing with " + arguments[0], self.one_line("prove", *arguments))
        self.one_line("prove", "theorem-99")


class Reproduce(CommandLineTest):
    def test_sizes_that_are_given_win_over_full(self):
        self.run_it("reproduce", "--max-n", 100, "--full", "--trees", 20, "--audits", 100,
                    "--data", DATA, "--out", "out")
        self.assertIn("quadbound reproduce --max-n 100 --trees 20 --audits 100\n",
                      (self.folder / "out" / "reproduction.md").read_text())

    def test_help_names_the_sizes_of_full(self):
        self.assertRegex(self.run_it("reproduce", "--help").stdout_text,
                         r"--full is --max-n \d{6,} --trees \d{4,} --audits \d{5,}")


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
