# SPDX-License-Identifier: Apache-2.0
"""meshio reads our .vtu, .msh and .obj: same points bit for bit, same quads."""

import meshio
import read_back


def check_blocks(mesh, read, map_point):
    def faces(*kinds):
        found = [face for block in read.cells if block.type in kinds for face in block.data]
        return [[map_point(v) for v in face] for face in found]

    read_back.same_quads(mesh, faces("quad"))
    # meshio calls VTK's polygon by its name, with any number of corners.
    read_back.same_triangles(mesh, faces("triangle", "polygon"))
    known = {"quad", "triangle", "polygon", "line"}
    assert {block.type for block in read.cells} <= known, mesh.name


def check_msh(mesh, read):
    # meshio lists the nodes in the order of the file; a node's tag is our vertex number plus one.
    # Points lie at distinct places, so their coordinates tell which is which.
    place = {point: i for i, point in enumerate(mesh.points)}
    order = [place[(float(p[0]), float(p[1]))] for p in read.points]
    assert sorted(order) == list(range(len(mesh.points))), mesh.name
    points = [None] * len(order)
    for i, point in zip(order, read.points):
        points[i] = point
    read_back.same_points(mesh, points)
    check_blocks(mesh, read, lambda v: order[v])
    lines = [line for block in read.cells if block.type == "line" for line in block.data]
    assert {(order[a], order[b]) for a, b in lines} == read_back.boundary(mesh), mesh.name
    rings = [name for name in read.field_data if name.startswith("ring ")]
    assert "domain" in read.field_data and rings, mesh.name


def main():
    folder, meshes = read_back.samples()
    for mesh in meshes:
        if not mesh.quads:
            continue
        for extension in ("vtu", "obj"):
            read = meshio.read(folder / f"{mesh.name}.{extension}")
            read_back.same_points(mesh, read.points)
            check_blocks(mesh, read, lambda v: v)
        check_msh(mesh, meshio.read(folder / f"{mesh.name}.msh"))


main()
