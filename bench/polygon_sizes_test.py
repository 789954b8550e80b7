#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""polygon_sizes on families and files, and map_polygons.py. Usage: polygon_sizes_test.py PATH_OF_POLYGON_SIZES"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import map_polygons  # noqa: E402

PROGRAM = ""


class Column(list):
    """Of a file of GSHHG: what map_polygons.py asks of numpy."""

    def __getitem__(self, _):
        return self

    def tolist(self):
        return list(self)

    def astype(self, _):
        return Column(x & 0xFFFF for x in self)


class Shorelines(dict):
    def set_auto_mask(self, _):
        pass


def square(x, side=1.0, y=0):
    return [[x, y], [x + side, y], [x + side, y + side], [x, y + side], [x, y]]


def fan(x, count):
    """A ring of count + 2 vertices."""
    top = [[x + i / count, 1 - (i / count) ** 2 / 3] for i in range(count, -1, -1)]
    return [[x, 0]] + top + [[x, 0]]


class Sizes(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_it(self, *arguments, status=0):
        done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, status, (arguments, done.stderr))
        return done

    def polygon(self, name, *rings):
        (self.folder / name).write_text(json.dumps({"type": "Polygon", "coordinates": rings}))

    def rows(self, *arguments):
        """Cells of the rows of the first table below its head."""
        lines = self.run_it(*arguments).stdout.splitlines()
        head = next(i for i, line in enumerate(lines) if line.startswith("| ---"))
        rows = []
        for line in lines[head + 1:]:
            if not line.startswith("|"):
                break
            rows.append([cell.strip() for cell in line.strip("|").split("|")])
        return rows

    def test_every_family_is_measured(self):
        rows = self.rows("--most", 10, "--seeds", 1)
        self.assertGreater(len(rows), 20)
        for row in rows:
            self.assertEqual(row[2:4], ["1", "0"], row)
            self.assertTrue(all(row), row)

    def test_a_family_that_was_refused_is_not_tried_at_the_next_size(self):
        rows = self.rows("--family", "regular,plate", "--most", 1000, "--seeds", 1, "--max-cells", 1000)
        self.assertEqual([row[0] + " " + row[1] for row in rows], ["regular 10", "regular 32", "plate 4"])
        self.assertEqual([row[3] for row in rows], ["0", "1", "1"])

    def test_files_have_the_same_columns_and_none_is_left_out(self):
        self.polygon("good.geojson", square(0, 4), square(1, y=1)[::-1])
        self.polygon("bow-tie.geojson", [[0, 0], [1, 1], [1, 0], [0, 1], [0, 0]])
        self.polygon("large.geojson", fan(0, 200))
        good, bow_tie, large = self.rows("--max-cells", 3000, "good.geojson", "bow-tie.geojson", "large.geojson")
        self.assertEqual(good[:3], ["good.geojson", "8", "1"])
        self.assertTrue(all(float(cell) > 0 for cell in good[3:]), good)
        self.assertRegex(bow_tie[3], r"^invalid: ring 0, vertex \d+: .")
        self.assertRegex(large[3], r"^refused: .*3000")

    def test_usage_errors(self):
        for arguments in (("--no-such-option",), ("--family", "no-such"), ("no-such.geojson",), ("--seeds", 0)):
            done = self.run_it(*arguments, status=2)
            self.assertRegex(done.stderr, r"\Apolygon_sizes: [^\n]+\n\Z")
        self.assertIn("Examples:\n  polygon_sizes", self.run_it("--help").stdout)

    def take(self, text, *options, status=0):
        (self.folder / "map.json").write_text(text)
        done = subprocess.run([sys.executable, "-B", map_polygons.__file__, "map.json", "out", *map(str, options)],
                              capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def test_maps_are_ranked_and_taken_apart(self):
        many = [[fan(3 * i, 10 + i)] for i in range(6)] + [[square(90)]]
        parts = [{"type": "MultiPolygon", "coordinates": many},
                 {"type": "Polygon", "coordinates": [square(50, 9), square(51, y=1)[::-1], square(53, y=1)[::-1]]}]
        features = [{"type": "Feature", "properties": {}, "geometry": part} for part in parts]
        for collection in ({"type": "GeometryCollection", "geometries": parts},
                           {"type": "FeatureCollection", "features": features}):
            self.take(json.dumps(collection), "--first", 2, "--least", 12)
            files = sorted((self.folder / "out").iterdir())
            self.assertEqual([file.stem for file in files], ["00001", "00002", "00004"])
            sizes = [sum(len(ring) - 1 for ring in json.loads(file.read_text())["coordinates"]) for file in files]
            self.assertEqual(sizes, [17, 16, 14])
        self.assertEqual(self.rows(files[0])[0][1], "17")

    def test_gshhg_is_put_together(self):
        """A square across the meridian of Greenwich, in two pieces: one in the north-west square, one in the last of its row."""
        counts = [0] * 360 * 180
        counts[0] = counts[359] = 1
        data = Shorelines(
            Embedded_npts_levels_exit_entry_for_a_segment=Column([(4 << 9) + 3, 4 << 9]),
            Id_of_first_point_in_a_segment=Column([0, 4]), Id_of_GSHHS_ID=Column([7, 7]), N_segments_in_a_bin=Column(counts),
            Relative_longitude_from_SW_corner_of_bin=Column([0, 9, 9, 0, -1, -10, -10, -1]),
            Relative_latitude_from_SW_corner_of_bin=Column([1, 1, 19, 19, 19, 19, 1, 1]))
        pieces = map_polygons.segments(data)
        self.assertEqual(list(pieces), [7])
        ring = map_polygons.joined(pieces[7])
        low = 65535 * 89
        self.assertEqual(ring, [(0, low + 1), (9, low + 1), (9, low + 19), (0, low + 19), (-9, low + 19), (-9, low + 1),
                                (0, low + 1)])
        turn = map_polygons.TURN
        hole = [(turn - 3, low + 5), (turn - 2, low + 5), (turn - 2, low + 6), (turn - 3, low + 5)]
        self.assertEqual(map_polygons.moved_east_of(-9, hole)[0], (-3, low + 5))

    def test_rings_that_are_none_are_not_put_together(self):
        around = [[(0, 5), (map_polygons.TURN, 5)]]
        self.assertIsNone(map_polygons.joined(around))
        eight = [[(0, 0), (1, 0), (0, 0)], [(0, 0), (0, 1), (0, 0)]]
        self.assertIsNone(map_polygons.joined(eight))

    def test_a_map_that_is_none_is_refused(self):
        self.assertRegex(self.take("{", status=1).stderr, r"\Amap_polygons.py: map.json: [^\n]+\n\Z")


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
