#!/usr/bin/env python3
"""Claim. `mesh hex` makes all hexahedra of Schneiders' pyramid valid, better than the literature;
`mesh untangle` moves interior vertices only, and makes a spoiled grid valid; `mesh boundary` places
meshes of the table on convex polyhedra, or with a free boundary. The same bytes for any number of
threads.
Oracle. Scaled Jacobians and determinants computed here, from their definition, on the written file;
hex_files.py, which reads it on its own; the published 0.316 for 36 hexahedra.
"""
import json
import math
import os
import random

import hex_files
import program

PYRAMID = os.path.join(program.INPUTS, "schneiders-pyramid.obj")


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def determinant(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))


def least_scaled_jacobian(mesh):
    """Corners of VTK: i has the neighbours before and after it in its quad, and i + 4 or i - 4."""
    points, hexahedra = mesh
    least = 1.0
    for cell in hexahedra:
        for i in range(8):
            base = i - i % 4
            after, before, other = base + (i + 1) % 4, base + (i + 3) % 4, (i + 4) % 8
            edges = [minus(points[cell[j]], points[cell[i]]) for j in (after, before, other)]
            if i >= 4:
                edges[0], edges[1] = edges[1], edges[0]
            lengths = [math.sqrt(sum(x * x for x in edge)) for edge in edges]
            if min(lengths) == 0:
                return 0.0
            least = min(least, determinant(*edges) / math.prod(lengths))
    return least


def grid(n, spoil):
    """n^3 cubes, inner points moved by `spoil`, as Medit and as numbers."""
    m = n + 1
    points = [(x, y, z) for z in range(m) for y in range(m) for x in range(m)]
    inner = [all(0 < k < n for k in p) for p in points]
    points = [spoil(p) if is_inner else p for p, is_inner in zip(points, inner)]
    offsets = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    cells = [[x + a + m * (y + b + m * (z + c)) for a, b, c in offsets]
             for z in range(n) for y in range(n) for x in range(n)]
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    lines += [" ".join(map(repr, p)) + " 0" for p in points]
    lines += ["Hexahedra", str(len(cells))]
    lines += [" ".join(str(v + 1) for v in cell) + " 0" for cell in cells] + ["End", ""]
    return points, inner, "\n".join(lines)


class Untangle(program.ProgramTest):
    def mesh(self, name):
        return hex_files.read_vtk(self.read(name).decode())

    def test_the_pyramid_is_valid(self):
        ran = self.expect(0, self.hexatlas("mesh", "hex", PYRAMID, "-o", "out.vtk", "--json",
                                           "--require-valid"))
        said = json.loads(ran.out)
        self.assertEqual((said["hexahedra"], said["valid"], said["inverted"]), (36, 36, 0))
        least = least_scaled_jacobian(self.mesh("out.vtk"))
        self.assertGreater(least, 0.316)
        self.assertAlmostEqual(least, said["min_scaled_jacobian"], places=9)
        self.assertEqual(sum(said["histogram"][:3]), 0)
        self.assertEqual(sum(said["histogram"]), 36)

    def test_a_spoiled_grid(self):
        rng = random.Random(3)
        points, inner, text = grid(4, lambda p: tuple(4 * rng.random() for _ in p))
        self.write("in.mesh", text)
        for option in ((), ("--harmonic",)):
            ran = self.expect(0, self.hexatlas("mesh", "untangle", "in.mesh", "-o", "out.vtk", "--json",
                                               "--require-valid", "--effort", "2", *option))
            said = json.loads(ran.out)
            self.assertGreater(said["before"]["inverted"], 0)
            self.assertEqual((said["free_vertices"], said["after"]["valid"]), (27, 64))
            mesh = self.mesh("out.vtk")
            self.assertAlmostEqual(least_scaled_jacobian(mesh), said["after"]["min_scaled_jacobian"],
                                   places=9)
            self.assertGreater(least_scaled_jacobian(mesh), 0.9)
            for old, new, is_inner in zip(points, mesh[0], inner):
                if not is_inner:
                    self.assertEqual(old, new)
            self.assertEqual(len(mesh[0]), len(points))

    def test_places_stay_if_none_is_better(self):
        rng = random.Random(5)
        points, _, text = grid(3, lambda p: tuple(x + 0.1 * rng.random() for x in p))
        self.write("in.mesh", text)
        ran = self.expect(0, self.hexatlas("mesh", "untangle", "in.mesh", "-o", "out.vtk", "--effort", "0"))
        self.assertEqual(hex_files.bits(self.mesh("out.vtk")[0]), hex_files.bits(points))
        self.assertEqual(ran.err, "")
        # A small block with a cell so far away that its own size is lost in a frame of both.
        lines = grid(3, lambda p: p)[2].split("\n")
        begin, count = lines.index("Vertices") + 2, 64
        rows = [[float(x) for x in line.split()[:3]] for line in lines[begin:begin + count]]
        far = [(1e8 + x, float(y), float(z)) for x, y, z in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                                                            (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
        points = [tuple(1e-9 * x for x in row) for row in rows] + far
        cells = lines[lines.index("Hexahedra") + 2:][:27] + [" ".join(map(str, [*range(65, 73), 0]))]
        self.write("in.mesh", "\n".join(
            ["MeshVersionFormatted 2", "Dimension 3", "Vertices", "72", *("%r %r %r 0" % p for p in points),
             "Hexahedra", "28", *cells, "End", ""]))
        for effort in "02":
            ran = self.expect(0, self.hexatlas("mesh", "untangle", "in.mesh", "-o", "out.vtk", "--effort", effort, "--json"))
            said = json.loads(ran.out)
            self.assertEqual((said["before"]["valid"], said["after"]), (28, said["before"]))
            self.assertEqual(hex_files.bits(self.mesh("out.vtk")[0]), hex_files.bits(points))
            self.assertEqual(ran.err, {"0": "", "2": "hexatlas: note: no better places were found; those given stay\n"}[effort])

    def test_interfaces_stay(self):
        """Between two regions, and where quads are listed: the plane x = 2."""
        rng = random.Random(4)
        points, inner, text = grid(4, lambda p: p if p[0] == 2 else (p[0], 4 * rng.random(), p[2]))
        head, cells = text.split("Hexahedra\n64\n")
        cells = cells.splitlines()[:-1]
        at = {point: v for v, point in enumerate(points)}
        quads = [[at[(2, y + b, z + c)] for b, c in ((0, 0), (1, 0), (1, 1), (0, 1))]
                 for z in range(4) for y in range(4)]
        coloured = [cell[:-1] + ("1" if i % 4 < 2 else "-2") for i, cell in enumerate(cells)]
        listed = f"Quadrilaterals\n{len(quads)}\n" + "".join(
            " ".join(str(v + 1) for v in quad) + " 5\n" for quad in quads)
        for more, rows in (("", coloured), (listed, cells)):
            self.write("in.mesh", head + more + "Hexahedra\n64\n" + "\n".join([*rows, "End", ""]))
            said = json.loads(self.expect(0, self.hexatlas("mesh", "untangle", "in.mesh", "-o", "out.vtk", "--json",
                                                           "--require-valid", "--effort", "2")).out)
            self.assertEqual((said["free_vertices"], said["interface_vertices"]), (18, 9))
            self.assertGreater(said["before"]["inverted"], 0)
            for old, new, is_inner in zip(points, self.mesh("out.vtk")[0], inner):
                self.assertTrue(old == new or (is_inner and old[0] != 2))
            ran = self.expect(0, self.hexatlas("mesh", "untangle", "in.mesh", "-o", "out.vtk", "--effort", "0"))
            self.assertIn(", 18 free vertices, 9 on interfaces kept\n", ran.out)
            ran = self.expect(0, self.hexatlas("simplify", "in.mesh", "-o", "small.vtk", "--tries", "1"))
            self.assertIn("note: in.mesh has 25 vertices on interfaces", ran.err)
        said = json.loads(self.expect(0, self.hexatlas("mesh", "untangle", "in.mesh", "-o", "out.vtk", "--json",
                                                       "--effort", "0", "--free-boundary")).out)
        self.assertEqual((said["free_vertices"], said["interface_vertices"]), (125, 0))

    def test_points_of_no_cell_are_not_free(self):
        points, _, text = grid(2, lambda p: p)
        self.write("in.mesh", text.replace(f"Vertices\n{len(points)}\n", f"Vertices\n{len(points) + 1}\n")
                   .replace("Hexahedra", "7 8 9 0\nHexahedra"))
        for options, free in (((), 1), (("--free-boundary",), len(points))):
            said = json.loads(self.expect(0, self.hexatlas(
                "mesh", "untangle", "in.mesh", "-o", "out.vtk", "--json", *options)).out)
            self.assertEqual(said["free_vertices"], free)
            self.assertEqual(self.mesh("out.vtk")[0][-1], (7, 8, 9))

    def test_hexahedra_inside_out_are_turned_over(self):
        rng = random.Random(5)
        _, _, text = grid(3, lambda p: tuple(3 * rng.random() for _ in p))
        head, cells = text.split("Hexahedra\n27\n")
        turned = [line.split() for line in cells.splitlines()[:27]]
        turned = [" ".join(line[4:8] + line[0:4] + line[8:]) for line in turned]
        self.write("in.mesh", head + "\n".join(["Hexahedra", "27", *turned, "End", ""]))
        ran = self.expect(0, self.hexatlas("mesh", "untangle", "in.mesh", "-o", "out.vtk", "--require-valid"))
        self.assertIn("note: 27 of the 27 hexahedra of in.mesh were inside out and turned over", ran.err)
        self.write("right.mesh", text)
        self.assertEqual(self.expect(0, self.hexatlas("mesh", "untangle", "right.mesh", "-o", "out.vtk")).err, "")

    def test_hexahedra_that_overlap_wherever_they_are_placed(self):
        _, _, text = grid(2, lambda p: p)
        head, cells = text.split("Hexahedra\n8\n")
        lines = cells.splitlines()[:8]
        first = lines[0].split()
        for name, cell, words in (("twice.mesh", lines[0], "on the same side"),
                                  ("turned.mesh", " ".join(first[4:8] + first[0:4] + first[8:]), "on the same side"),
                                  ("twisted.mesh", " ".join(first[:5] + [first[6], first[5]] + first[7:]), "different cycles")):
            listed = [*lines, cell] if name == "twice.mesh" else [cell, *lines[1:]]
            self.write(name, head + "\n".join(["Hexahedra", str(len(listed)), *listed, "End", ""]))
            ran = self.hexatlas("mesh", "untangle", name, "-o", "out.vtk")
            self.expect_fault(ran, name)
            self.assertIn(words, ran.err)

    def test_bad_meshes(self):
        self.write("two.mesh", grid(1, None)[2].replace("1 2 4 3", "1 2 4 1"))
        self.expect_fault(self.hexatlas("mesh", "untangle", "two.mesh", "-o", "out.vtk"), "two.mesh")
        self.write("in.mesh", grid(1, None)[2])
        self.expect(2, self.hexatlas("mesh", "untangle", "in.mesh", "-o", "in.mesh"))

    def test_boundaries_without_coordinates(self):
        for name, convex, free in (("cube", 1, 1), ("two-cubes", math.sqrt(0.5), 1),
                                   ("three-around-an-edge", 0.7698, math.sqrt(0.75))):
            for option, least in (((), convex), (("--free-boundary",), free)):
                ran = self.expect(0, self.hexatlas("mesh", "boundary", name, "-o", "out.vtk", "--json",
                                                   "--require-valid", *option))
                said = json.loads(ran.out)
                self.assertEqual(said["valid"], said["hexahedra"])
                self.assertEqual(said["free_boundary"], bool(option))
                found = least_scaled_jacobian(self.mesh("out.vtk"))
                self.assertAlmostEqual(found, said["min_scaled_jacobian"], places=9)
                self.assertAlmostEqual(found, least, places=2)
                self.expect(0, self.hexatlas("check", "out.vtk"))

    def test_threads(self):
        pyramid = ("mesh", "hex", PYRAMID)
        spindle = ("mesh", "boundary", "octagonal-spindle", "--require-valid", "--effort", "1")
        for code, command in program.share_of(((0, pyramid), (4, spindle))):
            for threads in ("1", "3"):
                self.expect(code, self.hexatlas(*command, "-o", f"{threads}.vtk", "-j", threads))
            self.assertEqual(self.read("1.vtk"), self.read("3.vtk"))


if __name__ == "__main__":
    program.main()
