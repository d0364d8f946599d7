#!/usr/bin/env python3
"""Claim. VTK and Gmsh read our tetrahedra with the same numbers of points and tetrahedra, all of positive volume and the
coordinates bit for bit, Gmsh without a word of warning; we read the tetrahedra that they write, and the points of the .ply and .xyz
files that they write; .bin and .hxtet are what docs/formats says.
Oracle. VTK (readers, writers), the gmsh program, and Python's own packing of numbers. Exit 77 if VTK or gmsh is missing.

usage: tetrahedra_peers_test.py MESH_TOOL
"""
import random
import struct
import sys

from peers_test import (POINTS, check_gmsh_opens, close, converted_by_gmsh, printed, read_with_vtk, run, run_peers,
                        written_by_vtk)

TETRAHEDRA = 72  # of the mesh that mesh_tool writes


def volume(a, b, c, d):
    """Six times the volume of a tetrahedron."""
    u, v, w = ([q - p for p, q in zip(a, e)] for e in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]))


def unpack_hxtet(path):
    """(points, tetrahedra) as the text of the format has them."""
    data = path.read_bytes()
    magic, points, tetrahedra = struct.unpack_from("<8sQQ", data)
    coordinates = struct.unpack_from(f"<{3 * points}d", data, 24)
    corners = struct.unpack_from(f"<{4 * tetrahedra}I", data, 24 + 24 * points)
    if magic != b"HXTET\0\0\1" or len(data) != 24 + 24 * points + 16 * tetrahedra:
        return "damaged"
    return list(zip(*[iter(coordinates)] * 3)), list(zip(*[iter(corners)] * 4))


def check_ours(vtk, tool, folder, failures):
    """The mesh of mesh_tool, as Python reads it."""
    path = folder / "ours.hxtet"
    run(tool, "write-tetrahedra", "hxtet", path)
    mesh = unpack_hxtet(path)
    failures.expect((len(mesh[0]), len(mesh[1])) == (POINTS, TETRAHEDRA), f"hxtet: {mesh}")
    failures.expect(all(volume(*(mesh[0][i] for i in cell)) > 0 for cell in mesh[1]), "positive volumes")
    failures.expect(printed(tool, "print-tetrahedra", path) == mesh, "hxtet read back")
    for kind in ("vtk", "vtu"):
        path = folder / f"ours.{kind}"
        run(tool, "write-tetrahedra", kind, path)
        grid = read_with_vtk(vtk, path)
        numbers = range(grid.GetNumberOfCells())
        failures.expect(all(grid.GetCellType(i) == vtk.VTK_TETRA for i in numbers), f"VTK, {kind}: types")
        cells = [tuple(grid.GetCell(i).GetPointId(k) for k in range(4)) for i in numbers]
        failures.expect(cells == mesh[1], f"VTK, {kind}: cells")
        failures.expect([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())] == mesh[0], f"VTK, {kind}: points")
    for kind, extension in (("gmsh4", "msh"), ("medit", "mesh")):
        path = folder / f"ours.{extension}"
        run(tool, "write-tetrahedra", kind, path)
        check_gmsh_opens(path, folder, failures, TETRAHEDRA)
        for target, tolerance in converted_by_gmsh(path, folder, failures):
            theirs = printed(tool, "print-tetrahedra", target)
            failures.expect(close(mesh, theirs, tolerance), f"written by gmsh: {target.name}")
    return mesh


def check_theirs(vtk, tool, folder, mesh, failures):
    grid = read_with_vtk(vtk, folder / "ours.vtu")
    grid.InsertNextCell(vtk.VTK_TRIANGLE, 3, (0, 1, 2))  # ignored
    for path, is_text in written_by_vtk(vtk, grid, folder):
        theirs = printed(tool, "print-tetrahedra", path)
        failures.expect(not isinstance(theirs, str) and theirs[1] == mesh[1] and
                        close(mesh, theirs, 1e-4 if is_text else 0), f"written by VTK: {path.name}")
        points = printed(tool, "print-points", path)
        failures.expect(not isinstance(points, str) and points[0] == theirs[0], f"points of {path.name}: {points}")


def expect_points(tool, path, expected, tolerance, failures):
    found = printed(tool, "print-points", path)
    failures.expect(not isinstance(found, str) and len(found[0]) == len(expected) and
                    all(abs(a - b) <= tolerance for p, q in zip(found[0], expected) for a, b in zip(p, q)),
                    f"points of {path.name}: {found}")


def check_points(vtk, tool, folder, failures):
    numbers = random.Random(1)
    expected = [tuple(numbers.uniform(-1, 1) for _ in range(3)) for _ in range(200)]
    path = folder / "packed.bin"
    path.write_bytes(b"".join(struct.pack("<3d", *p) for p in expected))
    expect_points(tool, path, expected, 0, failures)
    path = folder / "printed.xyz"
    path.write_text("# by Python\r\n" + "".join("%r\t%r %r 0\r\n" % p for p in expected))
    expect_points(tool, path, expected, 0, failures)

    sphere = vtk.vtkSphereSource()
    sphere.Update()
    data = sphere.GetOutput()
    expected = [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
    for binary in (False, True):
        writer = vtk.vtkPLYWriter()
        writer.SetInputData(data)
        writer.SetFileName(str(folder / f"vtk-{binary}.ply"))
        writer.SetDataByteOrderToLittleEndian()
        writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
        writer.Write()
        expect_points(tool, folder / f"vtk-{binary}.ply", expected, 0 if binary else 1e-5, failures)
    writer = vtk.vtkSimplePointsWriter()
    writer.SetInputData(data)
    writer.SetFileName(str(folder / "vtk.xyz"))
    writer.Write()
    expect_points(tool, folder / "vtk.xyz", expected, 1e-5, failures)


def check_all(vtk, tool, folder, failures):
    mesh = check_ours(vtk, tool, folder, failures)
    check_theirs(vtk, tool, folder, mesh, failures)
    check_points(vtk, tool, folder, failures)


if __name__ == "__main__":
    sys.exit(run_peers(check_all))
