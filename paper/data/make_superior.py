#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes superior-303.geojson, superior-303.csv, coast-1000.csv and coast-10000.csv.

Needs the Debian packages gmt-gshhg-full and python3-netcdf4, nothing else; the recipe is told in
README.md. All arithmetic after reading is on integers, so the bytes are the same everywhere.
"""

import argparse
import heapq
import json
from fractions import Fraction
from pathlib import Path

import netCDF4
import numpy

SHORELINES = "/usr/share/gmt-gshhg/binned_GSHHS_f.nc"
PER_DEGREE = 65535  # GSHHG keeps positions in units of 1/65535 of a degree
MICRO = 10**6  # and we in units of a millionth of a degree of latitude
COSINE = 672367  # cos(47.75 degrees) in millionths
WEST, SOUTH = 267, 46  # our origin: 93 W, 46 N

VERTICES = 303
SMALLEST_RING = 4

# Longitude east of Greenwich and latitude, in degrees, of places that the recipe names.
OPEN_LAKE = (272.5, 47.7)
DULUTH = (267.9, 46.75)
POINT_IROQUOIS = (275.37, 46.485)  # the lake ends between this point
GROS_CAP = (275.408, 46.545)  # and this one, where St. Marys River begins
COPPER_ISLAND = (271.9, 47.3)  # north end of the Keweenaw peninsula, cut off by a canal
CANAL_NORTH = (271.38, 47.225)
CANAL_SOUTH = (271.565, 46.98)
KEWEENAW_POINT = (272.3, 47.43)


class Shorelines:
    """The polygons of GSHHG, which the file keeps as segments cut at the borders of bins."""

    def __init__(self, path):
        data = netCDF4.Dataset(path)
        data.set_auto_mask(False)
        read = lambda name: data.variables[name][:]
        self.area = read("The_km_squared_area_of_polygons")
        self.parent = read("Id_of_parent_polygons")
        self.polygon = read("Id_of_GSHHS_ID")
        info = read("Embedded_npts_levels_exit_entry_for_a_segment").astype(numpy.uint32)
        self.count, self.level = info >> 9, info >> 6 & 7
        self.first = read("Id_of_first_point_in_a_segment")
        self.dx = read("Relative_longitude_from_SW_corner_of_bin").astype(numpy.uint16)
        self.dy = read("Relative_latitude_from_SW_corner_of_bin").astype(numpy.uint16)
        # Bins of one degree, row by row from the north-west corner.
        bins = numpy.arange(len(read("N_segments_in_a_bin")))
        self.bin = numpy.repeat(bins, read("N_segments_in_a_bin"))

    def segment(self, index):
        row, column = divmod(int(self.bin[index]), 360)
        points = slice(int(self.first[index]), int(self.first[index]) + int(self.count[index]))
        west, south = column * PER_DEGREE, (89 - row) * PER_DEGREE
        return [(west + int(x), south + int(y)) for x, y in zip(self.dx[points], self.dy[points])]

    def ring(self, polygon):
        """The vertices in order: where a segment ends at a bin's border, the next one starts."""
        segments = [self.segment(i) for i in numpy.flatnonzero(self.polygon == polygon)]
        starting_at = {segment[0]: segment for segment in segments}
        assert len(starting_at) == len(segments)
        vertices, segment = [], segments[0]
        for _ in segments:
            vertices += segment[:-1]
            segment = starting_at[segment[-1]]
        assert segment is segments[0]
        assert len(set(vertices)) == len(vertices)
        return vertices

    def polygons_of_level(self, level, parent=None):
        """Largest first."""
        found = numpy.unique(self.polygon[self.level == level]).tolist()
        chosen = [p for p in found if parent is None or self.parent[p] == parent]
        return sorted(chosen, key=lambda p: -self.area[p])


def contains(ring, point):
    """Whether the ring winds around the point; exact on integers."""
    inside = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > point[1]) != (by > point[1]):
            left = (bx - ax) * (point[1] - ay) - (by - ay) * (point[0] - ax)
            inside ^= (left > 0) == (by > ay)
    return inside


def raw(place):
    return tuple(round(degrees * PER_DEGREE) for degrees in place)


def nearest(ring, place):
    x, y = raw(place)
    return min(range(len(ring)), key=lambda i: (ring[i][0] - x) ** 2 + (ring[i][1] - y) ** 2)


def arc(ring, start, end, through):
    """The vertices from one place to another, on the way round that passes a third."""
    first = nearest(ring, start)
    turned = ring[first:] + ring[:first]
    last, middle = nearest(turned, end), nearest(turned, through)
    return turned[: last + 1] if middle <= last else [turned[0]] + turned[: last - 1 : -1]


def lake_and_islands(shores):
    """Lake Superior's outline and two largest islands; and the polygon of all three lakes."""
    lake = next(p for p in shores.polygons_of_level(2) if contains(shores.ring(p), raw(OPEN_LAKE)))
    great_lakes = shores.ring(lake)
    outline = arc(great_lakes, POINT_IROQUOIS, GROS_CAP, DULUTH)
    islands = [shores.ring(p) for p in shores.polygons_of_level(3, lake)[:20]]
    copper_island = next(island for island in islands if contains(island, raw(COPPER_ISLAND)))
    outline = arc(outline, CANAL_SOUTH, CANAL_NORTH, DULUTH) + arc(
        copper_island, CANAL_NORTH, CANAL_SOUTH, KEWEENAW_POINT
    )
    inside = [i for i in islands if i is not copper_island and contains(outline, i[0])]
    return [outline] + inside[:2], great_lakes


def rounded_quotient(numerator, denominator):
    return (2 * numerator + denominator) // (2 * denominator)


def project(ring):
    """Equirectangular, true to scale at 47.75 N, in millionths of a degree of latitude."""
    return [
        (
            rounded_quotient((x - WEST * PER_DEGREE) * COSINE, PER_DEGREE),
            rounded_quotient((y - SOUTH * PER_DEGREE) * MICRO, PER_DEGREE),
        )
        for x, y in ring
    ]


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


class Simplification:
    """Visvalingam's method on several rings at once, which stay simple and disjoint.

    Again and again the vertex goes whose triangle with its two neighbours has the least area; ties
    go to the vertex that comes first. A vertex must wait while any other lies in its triangle.
    """

    def __init__(self, rings):
        self.points = [point for ring in rings for point in ring]
        self.array = numpy.array(self.points, dtype=numpy.int64)
        self.alive = numpy.ones(len(self.points), dtype=bool)
        self.before, self.after, self.ring_of, self.sizes = [], [], [], []
        for ring in rings:
            first, size = len(self.before), len(ring)
            self.before += [first + (i - 1) % size for i in range(size)]
            self.after += [first + (i + 1) % size for i in range(size)]
            self.ring_of += [len(self.sizes)] * size
            self.sizes.append(size)
        self.heap = [(self.doubled_area(v), v) for v in range(len(self.points))]
        heapq.heapify(self.heap)

    def triangle(self, vertex):
        return self.before[vertex], vertex, self.after[vertex]

    def doubled_area(self, vertex):
        return abs(cross(*(self.points[v] for v in self.triangle(vertex))))

    def blocked(self, vertex):
        corners = self.triangle(vertex)
        a, b, c = (self.array[v] for v in corners)
        sides = []
        for start, end in ((a, b), (b, c), (c, a)):
            offset = self.array - start
            sides.append((end[0] - start[0]) * offset[:, 1] - (end[1] - start[1]) * offset[:, 0])
        left = numpy.minimum.reduce(sides) >= 0
        right = numpy.maximum.reduce(sides) <= 0
        within = (left | right) & self.alive
        within[list(corners)] = False
        return bool(within.any())

    def remove(self, vertex):
        before, _, after = self.triangle(vertex)
        self.alive[vertex] = False
        self.after[before], self.before[after] = after, before
        self.sizes[self.ring_of[vertex]] -= 1
        for neighbour in (before, after):
            heapq.heappush(self.heap, (self.doubled_area(neighbour), neighbour))

    def reduce_to(self, wanted):
        waiting = []
        while sum(self.sizes) > wanted:
            area, vertex = heapq.heappop(self.heap)
            if not self.alive[vertex] or area != self.doubled_area(vertex):
                continue  # an entry from before a neighbour went
            if self.sizes[self.ring_of[vertex]] <= SMALLEST_RING or self.blocked(vertex):
                waiting.append((area, vertex))
                continue
            self.remove(vertex)
            for entry in waiting:
                heapq.heappush(self.heap, entry)
            waiting.clear()

    def rings(self):
        result = [[] for _ in self.sizes]
        for vertex in numpy.flatnonzero(self.alive):
            result[self.ring_of[vertex]].append(self.points[vertex])
        return result


def simplified(rings, wanted):
    simplification = Simplification(rings)
    simplification.reduce_to(wanted)
    return simplification.rings()


def text_of(micro):
    return f"{'-' if micro < 0 else ''}{abs(micro) // MICRO}.{abs(micro) % MICRO:06d}"


def as_read(point):
    """The exact value of the doubles that a reader of our files gets."""
    return tuple(Fraction(float(text_of(coordinate))) for coordinate in point)


def segments_meet(a, b, c, d):
    def sign(value):
        return (value > 0) - (value < 0)

    def in_box(p, q, r):
        return all(min(p[i], q[i]) <= r[i] <= max(p[i], q[i]) for i in (0, 1))

    turns = [sign(cross(*t)) for t in ((a, b, c), (a, b, d), (c, d, a), (c, d, b))]
    if turns[0] * turns[1] < 0 and turns[2] * turns[3] < 0:
        return True
    touching = zip(turns, ((a, b, c), (a, b, d), (c, d, a), (c, d, b)))
    return any(turn == 0 and in_box(*triple) for turn, triple in touching)


def check_polygon(rings):
    """Simple, disjoint rings with the holes inside, exactly, as a reader gets them."""
    exact = [[as_read(point) for point in ring] for ring in rings]
    edges = [edge for ring in exact for edge in zip(ring, ring[1:] + ring[:1])]
    for i, (a, b) in enumerate(edges):
        assert a != b
        for c, d in edges[i + 1 :]:
            if len({a, b, c, d}) == 4:
                assert not segments_meet(a, b, c, d), (a, b, c, d)
            else:  # neighbours share one end and must not fold back
                shared = a if a in (c, d) else b
                p = b if shared == a else a
                q = d if shared == c else c
                dot = sum((p[k] - shared[k]) * (q[k] - shared[k]) for k in (0, 1))
                assert cross(shared, p, q) != 0 or dot < 0
    assert all(contains(exact[0], hole[0]) for hole in exact[1:])
    assert not any(contains(exact[1], vertex) for vertex in exact[2])
    assert not any(contains(exact[2], vertex) for vertex in exact[1])
    assert len({point for ring in exact for point in ring}) == VERTICES


def oriented(ring, counter_clockwise):
    area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1]))
    return ring if (area > 0) == counter_clockwise else ring[::-1]


def geojson(rings, source):
    properties = {
        "name": "Lake Superior with Isle Royale and St. Ignace Island",
        "source": source,
        "licence": "LGPL-3.0-or-later, as the data it is derived from",
        "recipe": "paper/data/make_superior.py; see paper/data/README.md",
        "coordinates": "((longitude + 93) * 0.672367, latitude - 46) in degrees, to a millionth",
        "vertices": sum(len(ring) for ring in rings),
    }
    lines = [
        "[" + ",\n".join(f"[{text_of(x)}, {text_of(y)}]" for x, y in ring + ring[:1]) + "]"
        for ring in rings
    ]
    coordinates = "[" + ",\n".join(lines) + "]"
    return (
        '{"type": "Feature",\n"properties": '
        + json.dumps(properties, indent=1)
        + ',\n"geometry": {"type": "Polygon",\n"coordinates": '
        + coordinates
        + "}}\n"
    )


def csv(points):
    distinct = list(dict.fromkeys(points))
    return "x,y\n" + "".join(f"{text_of(x)},{text_of(y)}\n" for x, y in distinct)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path(__file__).parent, help="folder")
    folder = parser.parse_args().output
    print("needs the Debian packages gmt-gshhg-full and python3-netcdf4")
    version = netCDF4.Dataset(SHORELINES).version
    source = f"GSHHG {version} (Wessel and Smith), full resolution, from Debian's gmt-gshhg-full"

    rings, great_lakes = lake_and_islands(Shorelines(SHORELINES))
    rings = simplified([project(ring) for ring in rings], VERTICES)
    rings = [oriented(ring, i == 0) for i, ring in enumerate(rings)]
    check_polygon(rings)
    (folder / "superior-303.geojson").write_text(geojson(rings, source))
    (folder / "superior-303.csv").write_text(csv([point for ring in rings for point in ring]))
    print("superior-303: rings of", *(len(ring) for ring in rings), "vertices")
    for wanted in (1000, 10000):
        (points,) = simplified([project(great_lakes)], wanted)
        text = csv(points)
        assert text.count("\n") == wanted + 1
        (folder / f"coast-{wanted}.csv").write_text(text)
        print(f"coast-{wanted}: {wanted} points")


if __name__ == "__main__":
    main()
