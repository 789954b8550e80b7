# SPDX-License-Identifier: Apache-2.0
"""What the read_back_*.py tests share: the exact mesh file is the truth that other files must match."""

import json
import struct
import sys
from fractions import Fraction
from pathlib import Path


class Mesh:
    """Coordinates rounded to nearest as the exporters must round them, and the faces."""

    def __init__(self, path):
        content = json.loads(path.read_text(encoding="utf-8"))
        self.name = path.stem
        self.points = [(float(Fraction(x)), float(Fraction(y))) for x, y in content["vertices"]]
        self.quads = [tuple(quad) for quad in content["quads"]]
        self.faces = [tuple(face) for face in content.get("faces", [])]
        self.construction = content.get("construction")
        self.level = content.get("level")


def samples():
    """All sample meshes with their folder; the folder is the script's only argument."""
    folder = Path(sys.argv[1])
    meshes = [Mesh(path) for path in sorted(folder.glob("*.json"))]
    assert len(meshes) >= 10, f"only {len(meshes)} samples in {folder}"
    return folder, meshes


def bits(value):
    return struct.pack("<d", value)


def same_points(mesh, points):
    """points: (x, y, z) in the order of the mesh; bit for bit."""
    assert len(points) == len(mesh.points), (mesh.name, len(points), len(mesh.points))
    for i, ((x, y), read) in enumerate(zip(mesh.points, points)):
        assert [bits(c) for c in (x, y, 0.0)] == [bits(c) for c in read], (mesh.name, i, read, (x, y))


def same_faces(mesh, expected, faces):
    read = [tuple(int(v) for v in face) for face in faces]
    assert read == expected, (mesh.name, read[:4], expected[:4])


def same_quads(mesh, quads):
    same_faces(mesh, mesh.quads, quads)


def same_triangles(mesh, triangles):
    same_faces(mesh, mesh.faces, triangles)


def boundary(mesh):
    """The directed edges that have no counterpart."""
    faces = mesh.quads + mesh.faces
    edges = {(f[i - 1], f[i]) for f in faces for i in range(len(f))}
    return {(a, b) for a, b in edges if (b, a) not in edges}
