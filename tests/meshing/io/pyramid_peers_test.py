#!/usr/bin/env python3
"""Claim. VTK and Gmsh open the mesh of each surface of the experiment in each format, with the
numbers of points and hexahedra that `mesh hex --json` states and without a word of warning.
Oracle. VTK's readers and the gmsh program; Euler's formula: a sphere of n quads has n + 2 points.
That both speak up at a damaged file is checked first. Exit 77 if either is missing.

usage: pyramid_peers_test.py HEXATLAS FOLDER_OF_SURFACES
"""
import json
import pathlib
import re
import shutil
import sys
import tempfile

from peers_test import SKIP, Failures, import_vtk, read_with_vtk, run

SURFACES = 11
KINDS_OF_VTK = ("vtu", "vtk")
KINDS_OF_GMSH = ("mesh", "msh")


def write_meshes(hexatlas, surfaces, folder, failures):
    """{path: (points, hexahedra) that the program states}. Points as good as possible in one format,
    which takes most of the time; in the others as they are at first."""
    stated = {}
    for surface in surfaces:
        for kind in KINDS_OF_VTK + KINDS_OF_GMSH:
            path = folder / f"{surface.stem}.{kind}"
            effort = () if kind == KINDS_OF_VTK[0] else ("--effort", "0")
            result = run(hexatlas, "mesh", "hex", surface, "-o", path, "--json", *effort)
            failures.expect(result.returncode == 0, f"mesh hex, {path.name}: {result.stderr}")
            if result.returncode == 0:
                summary = json.loads(result.stdout)
                stated[path] = (summary["quads"] + 2 + summary["interior_vertices"], summary["hexahedra"])
    return stated


def damaged(path):
    """A copy without its second half; of MEDIT, where Gmsh takes a cut silently, without vertices."""
    copy = path.with_name("damaged-" + path.name)
    text = path.read_bytes()
    copy.write_bytes(text.replace(b"Vertices", b"Corners") if path.suffix == ".mesh" else text[:len(text) // 2])
    return copy


def opened_by_vtk(vtk, path):
    """((points, hexahedra), what VTK said); -1 hexahedra if there is another cell."""
    window = vtk.vtkStringOutputWindow()
    vtk.vtkOutputWindow.SetInstance(window)
    grid = read_with_vtk(vtk, path)
    cells = grid.GetNumberOfCells()
    pure = all(grid.GetCellType(i) == vtk.VTK_HEXAHEDRON for i in range(cells))
    return (grid.GetNumberOfPoints(), cells if pure else -1), window.GetOutput()


def opened_by_gmsh(paths, folder):
    """([(points, hexahedra)], the exit status, what Gmsh said), all files in one run."""
    script = folder / "open.geo"
    script.write_text("".join(f'Delete Model;\nMerge "{path}";\n'
                              'Printf("read %.0f %.0f", Mesh.NbNodes, Mesh.NbHexahedra);\n' for path in paths))
    result = run("gmsh", script, "-")
    text = result.stdout + result.stderr
    figures = re.findall(r"^read (\d+) (\d+)$", text, re.MULTILINE)
    return [(int(points), int(hexahedra)) for points, hexahedra in figures], result.returncode, text


def is_silent(text):
    return "Warning" not in text and "Error" not in text


def check_vtk(vtk, stated, failures):
    paths = [path for path in stated if path.suffix[1:] in KINDS_OF_VTK]
    for kind in KINDS_OF_VTK:
        path = next((path for path in paths if path.suffix[1:] == kind), None)
        failures.expect(path and opened_by_vtk(vtk, damaged(path))[1], f"VTK speaks up at a damaged {kind} file")
    for path in paths:
        found, said = opened_by_vtk(vtk, path)
        failures.expect(found == stated[path], f"VTK, {path.name}: {found}, not {stated[path]}")
        failures.expect(said == "", f"VTK, {path.name}: {said}")


def check_gmsh(stated, folder, failures):
    paths = [path for path in stated if path.suffix[1:] in KINDS_OF_GMSH]
    for path in map(damaged, paths[:len(KINDS_OF_GMSH)]):
        _, _, text = opened_by_gmsh([path], folder)
        failures.expect(not is_silent(text), f"Gmsh speaks up at {path.name}")
    found, status, text = opened_by_gmsh(paths, folder)
    failures.expect(status == 0 and is_silent(text), f"Gmsh: {status}: {text}")
    failures.expect(len(found) == len(paths), f"Gmsh opened {len(found)} of {len(paths)} files")
    for path, figures in zip(paths, found):
        failures.expect(figures == stated[path], f"Gmsh, {path.name}: {figures}, not {stated[path]}")


def main():
    vtk = import_vtk()
    if shutil.which("gmsh") is None:
        print("skipped: no gmsh")
        return SKIP
    hexatlas = sys.argv[1]
    surfaces = sorted(pathlib.Path(sys.argv[2]).glob("*.obj"))
    failures = Failures()
    failures.expect(len(surfaces) == SURFACES, f"{len(surfaces)} surfaces, not {SURFACES}")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        stated = write_meshes(hexatlas, surfaces, folder, failures)
        check_vtk(vtk, stated, failures)
        check_gmsh(stated, folder, failures)
    print(f"{len(stated)} files, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
