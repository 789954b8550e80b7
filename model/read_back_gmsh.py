# SPDX-License-Identifier: Apache-2.0
"""gmsh reads our .msh without a word: same nodes bit for bit, same quads, rings and groups."""

import gmsh
import read_back

LINE, TRIANGLE, QUADRILATERAL = 1, 2, 3


def read_nodes(mesh):
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    points = [None] * len(mesh.points)
    for i, tag in enumerate(tags):
        points[int(tag) - 1] = coordinates[3 * i : 3 * i + 3]
    read_back.same_points(mesh, points)


def read_elements(element_type, entity):
    """Corner lists of the elements of one type on an entity, in the order of their tags."""
    corners = element_type + 1  # true of the three types above
    tags, nodes = gmsh.model.mesh.getElementsByType(element_type, entity)
    elements = {}
    for i, tag in enumerate(tags):
        elements[int(tag)] = [int(n) - 1 for n in nodes[corners * i : corners * i + corners]]
    return [elements[tag] for tag in sorted(elements)]


def read_rings():
    """The closed rings in the order of their numbers."""
    rings = {}
    for _, group in gmsh.model.getPhysicalGroups(1):
        name = gmsh.model.getPhysicalName(1, group)
        (curve,) = gmsh.model.getEntitiesForPhysicalGroup(1, group)
        lines = read_elements(LINE, curve)
        for (_, end), (start, _) in zip(lines, lines[1:] + lines[:1]):
            assert end == start, (name, lines)
        rings[int(name.removeprefix("ring "))] = [tuple(line) for line in lines]
    assert sorted(rings) == list(range(len(rings)))
    return [rings[i] for i in range(len(rings))]


def check(mesh):
    read_nodes(mesh)
    (group,) = gmsh.model.getPhysicalGroups(2)
    assert gmsh.model.getPhysicalName(*group) == "domain"
    (surface,) = gmsh.model.getEntitiesForPhysicalGroup(*group)
    read_back.same_quads(mesh, read_elements(QUADRILATERAL, surface))
    read_back.same_triangles(mesh, read_elements(TRIANGLE, surface))
    assert set(gmsh.model.mesh.getElementTypes()) <= {LINE, TRIANGLE, QUADRILATERAL}
    rings = read_rings()
    lines = [line for ring in rings for line in ring]
    assert len(lines) == len(set(lines)), mesh.name
    assert set(lines) == read_back.boundary(mesh), mesh.name
    expected = {"hole": [18, 6, 4], "touching": [4, 4]}.get(mesh.name)
    if expected:
        assert [len(ring) for ring in rings] == expected, (mesh.name, rings)


def main():
    folder, meshes = read_back.samples()
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for mesh in meshes:
        if not mesh.quads:
            continue
        gmsh.logger.start()
        gmsh.open(str(folder / f"{mesh.name}.msh"))
        complaints = [line for line in gmsh.logger.get() if not line.startswith("Info")]
        gmsh.logger.stop()
        assert not complaints, (mesh.name, complaints)
        check(mesh)
        gmsh.clear()
    gmsh.finalize()


main()
