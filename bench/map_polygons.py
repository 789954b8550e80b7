#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Takes some polygons out of a map, as files of one polygon each.

They are ranked by their number of vertices, holes included, the largest first; of equal ones, the first in
the map first. Those of ranks 1, 2, ... --first are taken, then every rank that is twice the last
(--first 10: 1 to 10, 20, 40, 80, ...), down to --least vertices. Coordinates stay as they are.

A map is GeoJSON, or GSHHG as Debian's gmt-gshhg-full has it (.nc; needs Debian's python3-netcdf4): its coasts, lakes,
islands in lakes and ponds on them, each without what lies in it. Coordinates of GSHHG are counted in 1/65535 of a degree,
as the file does; it has a vertex wherever a coast passes a whole degree.

Example: map_polygons.py /usr/share/gmt-gshhg/binned_GSHHS_f.nc polygons
"""
import argparse
import json
import pathlib
import sys


def polygons(value):
    """All of a GeoJSON text, in its order."""
    kind = value.get("type")
    if kind == "Polygon":
        yield value["coordinates"]
    elif kind == "MultiPolygon":
        yield from value["coordinates"]
    elif kind == "Feature":
        if value["geometry"] is not None:
            yield from polygons(value["geometry"])
    elif kind in ("FeatureCollection", "GeometryCollection"):
        for part in value["features" if kind == "FeatureCollection" else "geometries"]:
            yield from polygons(part)


TURN = 360 * 65535  # of GSHHG's units


def segments(data):
    """Of each polygon of GSHHG, by number: pieces of its ring, which the file cuts at the borders of squares."""
    data.set_auto_mask(False)
    numbers = {name: data[name][:].tolist() for name in (
        "Embedded_npts_levels_exit_entry_for_a_segment", "Id_of_first_point_in_a_segment", "Id_of_GSHHS_ID",
        "N_segments_in_a_bin")}
    # Stored as 16 bits with a sign, meant without.
    east, north = (data[f"Relative_{way}_from_SW_corner_of_bin"][:].astype("uint16").tolist()
                   for way in ("longitude", "latitude"))
    # Squares of one degree, row by row from the north-west corner.
    square_of = (square for square, count in enumerate(numbers["N_segments_in_a_bin"]) for _ in range(count))
    pieces = {}
    for square, packed, start, owner in zip(square_of, *list(numbers.values())[:3]):
        row, column = divmod(square, 360)
        west, south = 65535 * column, 65535 * (89 - row)
        points = range(start, start + (packed >> 9))
        pieces.setdefault(owner, []).append([(west + east[i], south + north[i]) for i in points])
    return pieces


def joined(pieces):
    """The closed ring of some pieces that lead on to each other; None where it goes around a pole, or meets itself where
    it is cut."""
    starting_at = {(piece[0][0] % TURN, piece[0][1]): piece for piece in pieces}
    if len(starting_at) != len(pieces):
        return None
    ring = [pieces[0][0]]
    for _ in pieces:
        x, y = ring[-1]
        piece = starting_at[x % TURN, y]
        ring += [(x + px - piece[0][0], py) for px, py in piece[1:]]
    return ring if ring[0] == ring[-1] else None


def moved_east_of(west, ring):
    """A ring that is counted from another meridian, by whole turns."""
    turns = (min(x for x, _ in ring) - west) // TURN
    return [(x - turns * TURN, y) for x, y in ring]


def gshhg(path):
    """All polygons of GSHHG, with those that lie directly in them as holes."""
    import netCDF4
    with netCDF4.Dataset(path) as data:
        rings = {owner: joined(pieces) for owner, pieces in sorted(segments(data).items())}
        parents = data["Id_of_parent_polygons"][:].tolist()
    found = {}
    for owner, ring in rings.items():
        if ring is None:
            print(f"polygon {owner} goes around a pole or meets itself where it is cut: left out")
        else:
            found[owner] = [ring]
    west = {owner: min(x for x, _ in rings[owner]) for owner in found}
    for owner in found:
        parent = parents[owner]
        if parent in found:
            found[parent].append(moved_east_of(west[parent], rings[owner]))
    return list(found.values())


def size(polygon):
    """Vertices; each ring ends with its first one again."""
    return sum(len(ring) - 1 for ring in polygon)


def ranks(first, count):
    """From 1, those that are taken of so many."""
    rank = 1
    while rank <= count:
        yield rank
        rank = rank + 1 if rank < first else 2 * rank


def main():
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("map", type=pathlib.Path, help="GeoJSON, or GSHHG (.nc)")
    parser.add_argument("folder", type=pathlib.Path, help="for the polygons: RANK.geojson")
    parser.add_argument("--first", type=int, default=10, help="how many of the largest (%(default)s)")
    parser.add_argument("--least", type=int, default=100, help="vertices (%(default)s)")
    options = parser.parse_args()
    if options.first < 1:
        parser.error("--first must be at least 1")
    try:
        read = gshhg(options.map) if options.map.suffix == ".nc" else polygons(json.loads(options.map.read_text()))
        found = sorted(read, key=size, reverse=True)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"map_polygons.py: {options.map}: {error}")
    options.folder.mkdir(parents=True, exist_ok=True)
    large = [polygon for polygon in found if size(polygon) >= options.least]
    for rank in ranks(options.first, len(large)):
        file = options.folder / f"{rank:05}.geojson"
        file.write_text(json.dumps({"type": "Polygon", "coordinates": large[rank - 1]}) + "\n")
    print(f"{len(found)} polygons, {len(large)} of {options.least} vertices or more")


if __name__ == "__main__":
    main()
