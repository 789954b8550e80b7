#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Takes some polygons out of a map, as files of one polygon each.

They are ranked by their number of vertices, holes included, the largest first; of equal ones, the first in
the map first. Those of ranks 1, 2, ... --first are taken, then every rank that is twice the last
(--first 10: 1 to 10, 20, 40, 80, ...), down to --least vertices. Coordinates stay as they are.

Example: map_polygons.py map.geo.json polygons
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
    parser.add_argument("map", type=pathlib.Path, help="GeoJSON")
    parser.add_argument("folder", type=pathlib.Path, help="for the polygons: RANK.geojson")
    parser.add_argument("--first", type=int, default=10, help="how many of the largest (%(default)s)")
    parser.add_argument("--least", type=int, default=100, help="vertices (%(default)s)")
    options = parser.parse_args()
    if options.first < 1:
        parser.error("--first must be at least 1")
    try:
        found = sorted(polygons(json.loads(options.map.read_text())), key=size, reverse=True)
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
