# SPDX-License-Identifier: Apache-2.0
"""VTK reads our .vtu: same points bit for bit, same quads, and it measures the shapes as we do."""

import math

import read_back
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

VTK_POLYGON, VTK_QUAD = 7, 9


def check_shapes(mesh, grid):
    measures = {
        "min_angle": "SetQuadQualityMeasureToMinAngle",
        "max_angle": "SetQuadQualityMeasureToMaxAngle",
        "scaled_jacobian": "SetQuadQualityMeasureToScaledJacobian",
    }
    for name, setter in measures.items():
        quality = vtkMeshQuality()
        quality.SetInputData(grid)
        getattr(quality, setter)()
        quality.Update()
        theirs = quality.GetOutput().GetCellData().GetArray("Quality")
        ours = grid.GetCellData().GetArray(name)
        for i in range(len(mesh.quads)):
            a, b = ours.GetValue(i), theirs.GetValue(i)
            # VTK works on rounded coordinates: far from the origin its angles are off.
            assert math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-6), (mesh.name, name, i, a, b)


def check_numbers(mesh, grid):
    for name in ("construction", "level"):
        array = grid.GetCellData().GetArray(name)
        expected = getattr(mesh, name)
        assert (array is None) == (expected is None), (mesh.name, name)
        if expected is not None:
            assert array.GetDataTypeAsString() == "unsigned char"
            assert list(vtk_to_numpy(array)) == expected, (mesh.name, name)


def cells_of_type(grid, cell_type):
    cells = [i for i in range(grid.GetNumberOfCells()) if grid.GetCellType(i) == cell_type]
    corners = []
    for i in cells:
        cell = grid.GetCell(i)
        corners.append([cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())])
    return corners


def main():
    folder, meshes = read_back.samples()
    for mesh in meshes:
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(folder / f"{mesh.name}.vtu"))
        reader.Update()
        assert reader.GetErrorCode() == 0, mesh.name
        grid = reader.GetOutput()
        assert grid.GetNumberOfCells() == len(mesh.quads) + len(mesh.faces), mesh.name
        if not mesh.quads:
            continue
        assert grid.GetPoints().GetData().GetDataTypeAsString() == "double"
        read_back.same_points(mesh, vtk_to_numpy(grid.GetPoints().GetData()))
        read_back.same_quads(mesh, cells_of_type(grid, VTK_QUAD))
        read_back.same_triangles(mesh, cells_of_type(grid, VTK_POLYGON))
        check_numbers(mesh, grid)
        if mesh.name != "huge":  # its squares overflow there
            check_shapes(mesh, grid)


main()
