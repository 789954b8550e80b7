# SPDX-License-Identifier: Apache-2.0
"""VTK reads our .vtu: same points bit for bit, same quads, and it measures the shapes as we do."""

import math

import read_back
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

VTK_QUAD = 9


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


def main():
    folder, meshes = read_back.samples()
    for mesh in meshes:
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(folder / f"{mesh.name}.vtu"))
        reader.Update()
        assert reader.GetErrorCode() == 0, mesh.name
        grid = reader.GetOutput()
        assert grid.GetNumberOfCells() == len(mesh.quads), mesh.name
        if not mesh.quads:
            continue
        assert grid.GetPoints().GetData().GetDataTypeAsString() == "double"
        read_back.same_points(mesh, vtk_to_numpy(grid.GetPoints().GetData()))
        quads = []
        for i in range(grid.GetNumberOfCells()):
            assert grid.GetCellType(i) == VTK_QUAD, (mesh.name, i)
            cell = grid.GetCell(i)
            quads.append([cell.GetPointId(k) for k in range(4)])
        read_back.same_quads(mesh, quads)
        check_numbers(mesh, grid)
        if mesh.name != "huge":  # its squares overflow there
            check_shapes(mesh, grid)


main()
