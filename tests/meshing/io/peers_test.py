#!/usr/bin/env python3
"""Claim. VTK and Gmsh read our hexahedral meshes with the same numbers of points and hexahedra, all
of positive volume, Gmsh without a word of warning; we read the surfaces and meshes that they write
in each encoding, bit for bit where they write all bits.
Oracle. VTK (cell size filter, writers) and the gmsh program. Exit 77 if either is missing.

usage: peers_test.py MESH_TOOL
"""
import itertools
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HEXAHEDRA = 12  # of the grid that mesh_tool writes
POINTS = 36
QUADS = 32
SKIP = 77


def import_vtk():
    try:
        import vtk
        return vtk
    except ImportError:
        # Another interpreter may come first on the path than the one that has the module.
        if sys.executable != "/usr/bin/python3" and pathlib.Path("/usr/bin/python3").exists():
            sys.exit(subprocess.run(["/usr/bin/python3", *sys.argv]).returncode)
        print("skipped: no VTK for Python")
        sys.exit(SKIP)


class Failures(list):
    def expect(self, condition, text):
        if not condition:
            self.append(text)
            print("FAILED:", text)


def run(*words):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True)


def printed(tool, verb, path):
    """(points, cells) as mesh_tool reads them, or the message with which it refuses them."""
    result = run(tool, verb, path)
    if result.returncode != 0:
        return result.stderr
    rows = result.stdout.split("\n")
    points, cells = map(int, rows[0].split())
    return ([tuple(map(float, row.split())) for row in rows[1:1 + points]],
            [tuple(map(int, row.split())) for row in rows[1 + points:1 + points + cells]])


def read_with_vtk(vtk, path):
    reader = vtk.vtkXMLUnstructuredGridReader() if path.suffix == ".vtu" else vtk.vtkUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def check_vtk_reads_ours(vtk, tool, folder, failures):
    for kind in ("vtk", "vtu"):
        path = folder / f"ours.{kind}"
        run(tool, "write-hexahedra", kind, path)
        grid = read_with_vtk(vtk, path)
        failures.expect(grid.GetNumberOfPoints() == POINTS, f"VTK, {kind}: points")
        failures.expect(grid.GetNumberOfCells() == HEXAHEDRA, f"VTK, {kind}: cells")
        failures.expect(all(grid.GetCellType(i) == vtk.VTK_HEXAHEDRON for i in range(grid.GetNumberOfCells())),
                        f"VTK, {kind}: types")
        # The scaled Jacobian is positive only if the corners are in VTK's order.
        quality = vtk.vtkMeshQuality()
        quality.SetInputData(grid)
        quality.SetHexQualityMeasureToScaledJacobian()
        quality.Update()
        values = quality.GetOutput().GetCellData().GetArray("Quality")
        failures.expect(all(values.GetValue(i) > 0.1 for i in range(values.GetNumberOfTuples())),
                        f"VTK, {kind}: scaled Jacobian")


def make_vtk_surface(vtk, single):
    points = vtk.vtkPoints()
    points.SetDataType(vtk.VTK_FLOAT if single else vtk.VTK_DOUBLE)
    coordinates = [(x / 3, y / 7 - 0.1 * x, z * 1e-5 + x * y) for z, y, x in itertools.product(range(2), repeat=3)]
    for point in coordinates:
        points.InsertNextPoint(point)
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    for quad in quads:
        grid.InsertNextCell(vtk.VTK_QUAD, 4, quad)
    grid.InsertNextCell(vtk.VTK_LINE, 2, (0, 7))
    names = vtk.vtkIntArray()
    names.SetName("names")
    for i in range(7):
        names.InsertNextValue(i)
    grid.GetCellData().AddArray(names)
    return grid, [points.GetPoint(i) for i in range(8)], quads


def vtu_writers(vtk):
    modes = {"ascii": lambda w: w.SetDataModeToAscii(), "inline": lambda w: w.SetDataModeToBinary(),
             "appended-raw": lambda w: (w.SetDataModeToAppended(), w.EncodeAppendedDataOff()),
             "appended-base64": lambda w: (w.SetDataModeToAppended(), w.EncodeAppendedDataOn())}
    compressors = {"zlib": lambda w: w.SetCompressorTypeToZLib(), "none": lambda w: w.SetCompressorTypeToNone()}
    headers = {"UInt32": lambda w: w.SetHeaderTypeToUInt32(), "UInt64": lambda w: w.SetHeaderTypeToUInt64()}
    for choice in itertools.product(modes.items(), compressors.items(), headers.items()):
        writer = vtk.vtkXMLUnstructuredGridWriter()
        for _, apply in choice:
            apply(writer)
        writer.SetBlockSize(64)  # several blocks even in a small file
        yield "-".join(name for name, _ in choice) + ".vtu", writer


def legacy_writers(vtk):
    for version in (42, 51):
        writer = vtk.vtkUnstructuredGridWriter()
        writer.SetFileVersion(version)
        writer.SetFileTypeToASCII()
        yield f"legacy{version}.vtk", writer


def written_by_vtk(vtk, grid, folder):
    """(path, whether it has fewer digits than the numbers: VTK's ASCII) of the grid in each encoding."""
    for name, writer in itertools.chain(vtu_writers(vtk), legacy_writers(vtk)):
        path = folder / name
        writer.SetFileName(str(path))
        writer.SetInputData(grid)
        writer.Write()
        yield path, name.endswith(".vtk") or name.startswith("ascii")


def check_we_read_vtk(vtk, tool, folder, failures):
    for single in (True, False):
        grid, points, quads = make_vtk_surface(vtk, single)
        for path, is_text in written_by_vtk(vtk, grid, folder):
            mesh = printed(tool, "print-surface", path)
            tolerance = 1e-5 if is_text else 0
            same = (not isinstance(mesh, str) and mesh[1] == quads and len(mesh[0]) == 8 and
                    all(abs(a - b) <= tolerance for p, q in zip(mesh[0], points) for a, b in zip(p, q)))
            failures.expect(same, f"written by VTK: {path.name}, single {single}: {mesh}")
    poly = vtk.vtkGeometryFilter()
    poly.SetInputData(grid)
    for version in (42, 51):
        writer = vtk.vtkPolyDataWriter()
        writer.SetInputConnection(poly.GetOutputPort())
        writer.SetFileVersion(version)
        writer.SetFileName(str(folder / "poly.vtk"))
        writer.Write()
        mesh = printed(tool, "print-surface", folder / "poly.vtk")
        failures.expect(not isinstance(mesh, str) and len(mesh[1]) == 6, f"PolyData {version}: {mesh}")


def check_gmsh_opens(path, folder, failures, cells=HEXAHEDRA):
    """Silently, and with positive Jacobians by Gmsh's own measure."""
    script = folder / "check.geo"
    script.write_text(f'Merge "{path}";\nPlugin(AnalyseMeshQuality).JacobianDeterminant = 1;\n'
                      "Plugin(AnalyseMeshQuality).Recompute = 1;\nPlugin(AnalyseMeshQuality).Run;\n")
    text = said_by_gmsh(failures, script, "-")
    checked = re.search(r"checking the Jacobian of (\d+) elements", text)
    least = re.search(r"minJ += +([-+.0-9e]+),", text)
    failures.expect(checked and int(checked[1]) == cells and least and float(least[1]) > 0,
                    f"gmsh finds positive Jacobians in {path.name}: {text}")


def said_by_gmsh(failures, *words):
    result = run("gmsh", *words)
    text = result.stdout + result.stderr
    failures.expect(result.returncode == 0 and "Warning" not in text and "Error" not in text,
                    f"gmsh {words}: {text}")
    return text


def converted_by_gmsh(source, folder, failures):
    """(path, tolerance) of the file in each version and encoding that Gmsh writes."""
    for version, binary in itertools.product(("msh2", "msh4"), (False, True)):
        target = folder / f"{source.stem}-{version}-{binary}.msh"
        said_by_gmsh(failures, source, "-save_all", "-save", "-format", version, "-o", target, *["-bin"] * binary)
        yield target, 0 if binary else 1e-15  # its ASCII has 16 digits


def close(mesh, other, tolerance):
    """True if the cells agree in their coordinates; Gmsh lists points in another order."""
    if isinstance(mesh, str) or isinstance(other, str) or len(mesh[1]) != len(other[1]):
        return False
    pairs = zip(itertools.chain(*mesh[1]), itertools.chain(*other[1]))
    return all(abs(a - b) <= tolerance * max(1, abs(a)) for i, j in pairs for a, b in zip(mesh[0][i], other[0][j]))


def check_gmsh(tool, folder, failures):
    for verb, kind in itertools.product(("hexahedra", "surface"), ("gmsh2", "gmsh4", "medit")):
        source = folder / f"{verb}-{kind}.{'mesh' if kind == 'medit' else 'msh'}"
        run(tool, f"write-{verb}", kind, source)
        ours = printed(tool, f"print-{verb}", source)
        failures.expect(not isinstance(ours, str) and len(ours[0]) == POINTS and
                        len(ours[1]) == (HEXAHEDRA if verb == "hexahedra" else QUADS), f"our own {source.name}")
        if verb == "hexahedra":
            check_gmsh_opens(source, folder, failures)
        for target, tolerance in converted_by_gmsh(source, folder, failures):
            theirs = printed(tool, f"print-{verb}", target)
            failures.expect(close(ours, theirs, tolerance), f"written by gmsh: {target.name}")
            # Gmsh drops points that no element uses.
            failures.expect(verb == "surface" or len(theirs[0]) == POINTS, f"points of {target.name}")


def run_peers(check):
    """check(vtk, tool, folder, failures) in an empty folder; the exit code."""
    vtk = import_vtk()
    if shutil.which("gmsh") is None:
        print("skipped: no gmsh")
        return SKIP
    failures = Failures()
    with tempfile.TemporaryDirectory() as name:
        check(vtk, sys.argv[1], pathlib.Path(name), failures)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


def check_all(vtk, tool, folder, failures):
    check_vtk_reads_ours(vtk, tool, folder, failures)
    check_we_read_vtk(vtk, tool, folder, failures)
    check_gmsh(tool, folder, failures)


if __name__ == "__main__":
    sys.exit(run_peers(check_all))
