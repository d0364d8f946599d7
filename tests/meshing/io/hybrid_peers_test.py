#!/usr/bin/env python3
"""Claim. VTK and Gmsh read our hybrid meshes with the same points and cells of each shape, and find
the volume of each positive; so the corners of prisms and pyramids are in the order of each format.
We read what they write, in each encoding, as the same mesh; prisms that Gmsh writes for VTK, too.
Oracle. VTK (cell sizes, orientation of the facets of cells, writers), the gmsh program, and volumes
computed here. Gmsh 4.8 passes over prisms and pyramids in .mesh: there it is asked for the rest.
Exit 77 if either is missing.

usage: hybrid_peers_test.py MESH_TOOL
"""
import collections
import sys

from peers_test import (check_gmsh_opens, close, converted_by_gmsh, printed, read_with_vtk, run, run_peers,
                        said_by_gmsh, written_by_vtk)

COUNTS = {4: 12, 8: 6, 6: 4, 5: 12}  # of corners, in the mesh of mesh_tool
# The facets of each cell in the project's order of corners, counterclockwise seen from outside.
FACETS = {4: ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)),
          5: ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
          6: ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
          8: ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))}
WRONG_ORIENTATION = 0x20  # of vtkCellValidator


def det(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]))


def volume(corners):
    """Facets as cones from their mean, so that both cells at a quad agree."""
    total = 0
    for facet in FACETS[len(corners)]:
        points = [corners[i] for i in facet]
        mean = [sum(p[k] for p in points) / len(points) for k in range(3)]
        total += sum(det(mean, a, b) for a, b in zip(points, points[1:] + points[:1])) / 6
    return total


def coordinates(mesh):
    """The cells as lists of points, in an order that does not depend on that of the file."""
    return sorted([len(cell), *(tuple(round(x, 9) for x in mesh[0][i]) for i in cell)] for cell in mesh[1])


def check_vtk_reads_ours(vtk, tool, folder, mesh, failures):
    types = {4: vtk.VTK_TETRA, 5: vtk.VTK_PYRAMID, 6: vtk.VTK_WEDGE, 8: vtk.VTK_HEXAHEDRON}
    for kind in ("vtk", "vtu"):
        path = folder / f"ours.{kind}"
        run(tool, "write-hybrid", kind, path)
        failures.expect(printed(tool, "print-hybrid", path) == mesh, f"our own {path.name}")
        grid = read_with_vtk(vtk, path)
        numbers = range(grid.GetNumberOfCells())
        failures.expect([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())] == mesh[0], f"VTK, {kind}: points")
        failures.expect([grid.GetCellType(i) for i in numbers] == [types[len(c)] for c in mesh[1]],
                        f"VTK, {kind}: types")
        sizes = vtk.vtkCellSizeFilter()
        sizes.SetInputData(grid)
        sizes.Update()
        values = sizes.GetOutput().GetCellData().GetArray("Volume")
        # VTK cuts warped cells in its own way.
        failures.expect(all(0.7 < values.GetValue(i) / volume([mesh[0][v] for v in mesh[1][i]]) < 1.4 for i in numbers),
                        f"VTK, {kind}: volumes {[values.GetValue(i) for i in numbers]}")
        validator = vtk.vtkCellValidator
        states = {len(mesh[1][i]): validator.Check(grid.GetCell(i), 1e-9) for i in numbers}
        failures.expect(not any(state & WRONG_ORIENTATION for state in states.values()),
                        f"VTK, {kind}: orientation of facets: {states}")


def check_we_read_vtk(vtk, tool, folder, mesh, failures):
    grid = read_with_vtk(vtk, folder / "ours.vtu")
    grid.InsertNextCell(vtk.VTK_TRIANGLE, 3, (0, 1, 2))  # ignored
    for path, is_text in written_by_vtk(vtk, grid, folder):
        theirs = printed(tool, "print-hybrid", path)
        failures.expect(not isinstance(theirs, str) and theirs[1] == mesh[1] and
                        close(mesh, theirs, 1e-4 if is_text else 0), f"written by VTK: {path.name}")


def check_gmsh(tool, folder, mesh, failures):
    path = folder / "ours.msh"
    run(tool, "write-hybrid", "gmsh4", path)
    failures.expect(printed(tool, "print-hybrid", path) == mesh, "our own ours.msh")
    check_gmsh_opens(path, folder, failures, len(mesh[1]))
    for target, _ in converted_by_gmsh(path, folder, failures):
        theirs = printed(tool, "print-hybrid", target)
        failures.expect(not isinstance(theirs, str) and coordinates(theirs) == coordinates(mesh),
                        f"written by gmsh: {target.name}")
    target = folder / "by-gmsh.vtk"
    said_by_gmsh(failures, path, "-save_all", "-save", "-format", "vtk", "-o", target)
    theirs = printed(tool, "print-hybrid", target)
    failures.expect(not isinstance(theirs, str) and coordinates(theirs) == coordinates(mesh),
                    f"written by gmsh for VTK: {theirs}")
    path = folder / "ours.mesh"
    run(tool, "write-hybrid", "medit", path)
    failures.expect(printed(tool, "print-hybrid", path) == mesh, "our own ours.mesh")
    check_gmsh_opens(path, folder, failures, COUNTS[4] + COUNTS[8])


def check_all(vtk, tool, folder, failures):
    run(tool, "write-hybrid", "vtu", folder / "first.vtu")
    mesh = printed(tool, "print-hybrid", folder / "first.vtu")
    failures.expect(collections.Counter(map(len, mesh[1])) == COUNTS, "numbers of cells")
    failures.expect(all(volume([mesh[0][v] for v in cell]) > 0 for cell in mesh[1]), "positive volumes")
    check_vtk_reads_ours(vtk, tool, folder, mesh, failures)
    check_we_read_vtk(vtk, tool, folder, mesh, failures)
    check_gmsh(tool, folder, mesh, failures)


if __name__ == "__main__":
    sys.exit(run_peers(check_all))
