#!/usr/bin/env python3
"""Claim. `mesh hybrid` counts the candidates of Kuhn lattices as published, writes conforming meshes
that the judge accepts with the boundary of the tetrahedra, in each format, the same bytes for any
number of threads; and says in one line what is wrong with anything else.
Oracle. `check --hybrid --boundary`; the published counts.
"""
import itertools
import json
import os
import pty
import random

import program
import surfaces
from hybrid_files import kuhn

CHANCE = random.Random(20261122)
TIMES = ("seconds", "search_seconds", "threads")


def medit(points, cells, regions=None):
    regions = regions or [1] * len(cells)
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    lines += ["%r %r %r 0" % p for p in points]
    lines += ["Tetrahedra", str(len(cells))]
    lines += ["%d %d %d %d %d" % (*(v + 1 for v in c), r) for c, r in zip(cells, regions)]
    return "\n".join(lines + ["End", ""])


class MeshHybridTest(program.ProgramTest):
    def counts(self, file, *options):
        return json.loads(self.succeeds("mesh", "hybrid", file, "--count", "--json", *options).out)

    def lattice(self, n):
        return self.write(f"kuhn{n}.mesh", medit(*kuhn(n)))

    def random_mesh(self):
        self.write("points.xyz", "".join("%r %r %r\n" % tuple(CHANCE.random() for _ in range(3))
                                         for _ in range(100)))
        self.succeeds("mesh", "delaunay", "points.xyz", "-o", "tetrahedra.vtu")
        return "tetrahedra.vtu"

    def succeeds(self, *arguments):
        return self.expect(0, self.hexatlas(*arguments))

    def test_counts_of_lattices(self):
        for n, numbers in {1: (1, 6, 6), 2: (68, 120, 72), 3: (453, 570, 270)}.items():
            found = self.counts(self.lattice(n), "--quality", "1e-4")
            self.assertEqual(tuple(found["candidates"].values()), numbers)
            self.assertEqual(list(found["candidates"]), ["hexahedra", "prisms", "pyramids"])
            self.assertEqual(sum(found["classes"].values()) + found["without_class"], numbers[0])
            self.assertEqual((found["tetrahedra"], found["undecided"]), (6 * n ** 3, 0))

    def test_cubes_of_a_lattice(self):
        made = json.loads(
            self.succeeds("mesh", "hybrid", self.lattice(3), "-o", "cubes.vtu", "--json").out)
        self.assertEqual(made["selected"],
                         {"hexahedra": 27, "prisms": 0, "pyramids": 0, "tetrahedra": 0})
        self.assertEqual(made["volume_fraction"]["hexahedra"], 1)
        self.assertAlmostEqual(made["min_scaled_jacobian"].pop("hexahedra"), 1)
        self.assertEqual(made["min_scaled_jacobian"], {"prisms": None, "pyramids": None, "tetrahedra": None})
        self.succeeds("check", "cubes.vtu")

    def test_candidates_without_a_mesh(self):
        self.counts(self.lattice(1), "--candidates", "list.txt")
        self.assertEqual(self.read("list.txt").split(b"\n")[0], b"candidates 1 0.1 1 6 6")

    def test_progress_is_for_terminals(self):
        tetrahedra = self.random_mesh()
        self.assertEqual(self.succeeds("mesh", "hybrid", tetrahedra, "-o", "silent.vtu").err, "")
        try:
            terminal, line = pty.openpty()
        except OSError as error:
            self.skipTest(f"no pseudo-terminal here: {error}")
        self.expect(0, self.hexatlas("mesh", "hybrid", tetrahedra, "-o", "watched.vtu", stderr=line))
        os.close(line)
        shown = os.read(terminal, 65536).decode()
        os.close(terminal)
        for phase in ("vertices searched", "candidates tried, of at most", "cells closed"):
            self.assertRegex(shown, phase + ": [0-9]+ of [0-9]+, ")
        self.assertTrue(shown.endswith("\r\x1b[K"), shown)
        self.assertEqual(self.read("watched.vtu"), self.read("silent.vtu"))

    def test_each_format_is_accepted(self):
        tetrahedra = self.random_mesh()
        for extension in program.share_of(("vtk", "vtu", "mesh", "msh"), least=2):
            output = f"hybrid.{extension}"
            made = json.loads(
                self.succeeds("mesh", "hybrid", tetrahedra, "-o", output, "--json").out)
            self.assertTrue(made["conforming"], made)
            self.assertGreater(made["selected"]["hexahedra"], 0)
            self.assertAlmostEqual(sum(made["volume_fraction"].values()), 1)
            self.succeeds("check", "--hybrid", output, "--boundary", tetrahedra)
        ran = self.succeeds("mesh", "hybrid", tetrahedra, "-o", "plain.vtk", "--no-conforming")
        self.assertIn("not conforming", ran.out)
        self.assertEqual(self.hexatlas("check", "--hybrid", "plain.vtk").code, 1)

    def test_same_bytes_for_any_number_of_threads(self):
        tetrahedra = self.random_mesh()
        said = []
        for threads in "12":
            ran = self.succeeds("mesh", "hybrid", tetrahedra, "-o", threads + ".vtk",
                                "--candidates", threads + ".txt", "-j", threads, "--json")
            said.append({k: v for k, v in json.loads(ran.out).items() if k not in TIMES})
        self.assertEqual(*said)
        for extension in (".vtk", ".txt"):
            self.assertEqual(self.read("1" + extension), self.read("2" + extension))
        lines = self.read("1.txt").decode().splitlines()
        numbers = list(said[0]["candidates"].values())
        self.assertEqual(len(lines), 1 + sum(numbers))
        self.assertEqual(lines[0].split()[3:], [str(n) for n in numbers])

    def test_tetrahedra_inside_out_are_turned_over(self):
        points, cells = kuhn(1)
        inside_out = [(a, b, d, c) for a, b, c, d in cells]
        self.write("right.mesh", medit(points, cells))
        self.write("inside-out.mesh", medit(points, inside_out))
        right = self.succeeds("mesh", "hybrid", "right.mesh", "-o", "right.vtk")
        self.assertEqual(right.err, "")
        turned = self.succeeds("mesh", "hybrid", "inside-out.mesh", "-o", "turned.vtk")
        self.assertIn("note: the tetrahedra of inside-out.mesh are inside out", turned.err)
        for mesh in ("right.vtk", "turned.vtk"):
            for boundary in ("right.mesh", "inside-out.mesh"):
                self.succeeds("check", "--hybrid", mesh, "--boundary", boundary)
        self.write("both.mesh", medit(points, inside_out[:1] + cells[1:]))
        ran = self.expect(1, self.hexatlas("check", "--hybrid", "right.vtk", "--boundary", "both.mesh"))
        self.assertIn("rejected: given-mesh: ", ran.out)

    def refuses(self, text, words):
        self.write("bad.mesh", text)
        ran = self.hexatlas("mesh", "hybrid", "bad.mesh", "-o", "none.vtu")
        self.expect_fault(ran, "bad.mesh")
        self.assertIn(words, ran.err)
        self.assertFalse(os.path.exists(self.path("none.vtu")))

    def test_bad_input(self):
        points, cells = kuhn(1)
        turned = [list(c) for c in cells]
        turned[2][0], turned[2][1] = turned[2][1], turned[2][0]
        self.refuses(medit(points, turned), "bad.mesh: tetrahedron 2 is inverted")
        self.refuses(medit(points, cells + [[0, 1, 2, 3]]), "tetrahedron 6 has volume zero")
        self.refuses(medit(points, cells + [cells[4]]), "tetrahedra 4 and 6 have the same vertices")
        self.refuses(medit(points, cells + [[0, 1, 7, 9]]), "bad.mesh:")
        hexahedra = "Hexahedra\n1\n1 2 4 3 5 6 8 7 0\nEnd"
        self.refuses(medit(points, cells).replace("End", hexahedra), "bad.mesh:")

    def test_regions(self):
        points, cells = kuhn(1)
        self.write("regions.mesh", medit(points, cells, [1, 1, 1, 2, 1, 1]))
        self.assertEqual(self.counts("regions.mesh")["candidates"]["hexahedra"], 0)
        self.assertEqual(self.succeeds("mesh", "hybrid", "regions.mesh", "-o", "regions.vtk").err, "")
        found = self.read("regions.vtk").decode().split("LOOKUP_TABLE default\n")[1].split()
        self.assertEqual(sorted(found), ["1"] * (len(found) - 1) + ["2"])
        # One region has its number, too.
        self.write("one.mesh", medit(points, cells, [42] * len(cells)))
        self.succeeds("mesh", "hybrid", "one.mesh", "-o", "out.mesh")
        lines = self.read("out.mesh").decode().split("\n")
        self.assertEqual(lines[lines.index("Hexahedra") + 2].split()[-1], "42")

    def test_surfaces(self):
        points, cells = kuhn(2)
        text = medit(points, cells)
        a, b, c, _ = (v + 1 for v in cells[5])
        self.write("surfaces.mesh", text.replace("Tetrahedra", f"Triangles\n2\n{a} {b} {c} 4\n{a} {b} {c} 4\nTetrahedra"))
        ran = self.succeeds("mesh", "hybrid", "surfaces.mesh", "-o", "surfaces.vtk")
        self.assertIn("note: the coloured triangles inside surfaces.mesh", ran.err)

    def box(self, sides, cut=False):
        """The surface of a box of unit squares, each cut in two."""
        points, triangles = {}, []
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for side in (0, sides[axis]):
                for i, j in itertools.product(range(sides[u]), range(sides[v])):
                    corner = []
                    for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0, 0, 0]
                        p[axis], p[u], p[v] = side, i + a, j + b
                        corner.append(points.setdefault(tuple(p), len(points) + 1))
                    if side == 0:
                        corner.reverse()
                    triangles += [(corner[0], corner[1], corner[2]), (corner[0], corner[2], corner[3])]
        if cut:
            triangles.pop()
        self.write("box.obj", "".join("v %d %d %d\n" % p for p in points)
                   + "".join("f %d %d %d\n" % t for t in triangles))
        return "box.obj"

    def test_a_point_inside_a_cell(self):
        """A cube of twelve tetrahedra around its middle is a hexahedron, and the middle is in no cell."""
        points, quads = surfaces.cube()
        points = [tuple(map(float, p)) for p in points] + [(0.5, 0.5, 0.5)]
        self.write("middle.mesh", medit(points, [(c[i], c[j], c[k], 8)
                                                 for c in quads for i, j, k in ((0, 2, 1), (0, 3, 2))]))
        made = json.loads(self.succeeds("mesh", "hybrid", "middle.mesh", "-o", "middle.vtu", "--json").out)
        self.assertEqual((made["selected"]["hexahedra"], made["points_inside_cells"]), (1, 1))
        said = self.succeeds("mesh", "hybrid", "middle.mesh", "-o", "middle.vtu").out
        self.assertIn("1 point of the tetrahedra is inside a cell", said)
        self.succeeds("check", "--hybrid", "middle.vtu", "--boundary", "middle.mesh")

    def test_triangles_that_are_no_facets(self):
        points, cells = kuhn(1)  # all facets have the first or the last vertex
        self.write("across.mesh", medit(points, cells).replace(
            "Tetrahedra", "Triangles\n2\n1 5 8 4\n5 3 2 7\nTetrahedra"))
        ran = self.succeeds("mesh", "hybrid", "across.mesh", "-o", "across.vtk")
        self.assertIn("note: 1 coloured triangle of across.mesh is no facet of a tetrahedron: ignored\n", ran.err)

    def test_lattice_inside_a_box(self):
        ran = self.succeeds("mesh", "hybrid", self.box((4, 3, 2)), "--fill", "lattice", "-o",
                            "box.vtu", "--json")
        made = json.loads(ran.out)
        self.assertEqual(made["selected"]["hexahedra"], 24)
        self.assertEqual(made["selected"]["tetrahedra"], 0)
        self.assertEqual(made["lattice"]["points"], 6)
        self.assertEqual(made["lattice"]["spacing"], 1)
        self.succeeds("check", "--hybrid", "box.vtu")
        # A thin box with diagonals by chance.
        points, quads = surfaces.block(6, 6, 1)
        chance, halves = random.Random(3), []
        for a, b, c, d in quads:
            halves += [[a, b, c], [a, c, d]] if chance.random() < 0.5 else [[b, c, d], [b, d, a]]
        self.write("thin.obj", surfaces.obj(points, halves))
        made = json.loads(self.succeeds("mesh", "hybrid", "thin.obj", "--fill", "lattice", "-o", "thin.vtu", "--json").out)
        self.assertGreater(made["lattice"]["exchanged_diagonals"], 0)
        said = self.succeeds("mesh", "hybrid", "thin.obj", "--fill", "lattice", "-o", "thin.vtu").out
        self.assertIn(f"by {made['lattice']['exchanged_diagonals']} exchange", said)
        kept = json.loads(self.succeeds("mesh", "hybrid", "thin.obj", "--fill", "lattice", "-o", "thin.vtu", "--json",
                                        "--keep-diagonals").out)
        self.assertEqual(kept["lattice"]["exchanged_diagonals"], 0)
        # Parts of the surface are not kept, and that is said.
        points, quads = surfaces.block(1, 1, 1)
        for number, note in ((5, ""), (6, "hexatlas: note: --fill keeps the surface, but not the parts ")):
            rows = [f"{a + 1} {b + 1} {c + 1} {r}" for i, q in enumerate(quads) for a, b, c, r in
                    ((*q[:3], number if i == 0 else 5), (q[0], *q[2:], 5))]
            self.write("parts.mesh", "\n".join(
                ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points)),
                 *("%r %r %r 0" % tuple(map(float, p)) for p in points), "Triangles", str(len(rows)), *rows, "End", ""]))
            ran = self.succeeds("mesh", "hybrid", "parts.mesh", "--fill", "lattice", "-o", "parts.vtu")
            self.assertEqual(ran.err[:len(note)] if note else ran.err, note)
        ran = self.hexatlas("mesh", "hybrid", self.box((2, 2, 2), cut=True), "--fill", "lattice",
                            "-o", "open.vtu")
        self.expect_fault(ran, "box.obj")
        for factor in ("1e307", "1e-300"):
            box = self.read(self.box((2, 2, 2))).decode()
            self.write("box.obj", "".join(
                "v " + " ".join(str(float(x) * float(factor)) for x in line.split()[1:]) + "\n"
                if line.startswith("v") else line + "\n" for line in box.splitlines()))
            ran = self.hexatlas("mesh", "hybrid", "box.obj", "--fill", "lattice", "-o", "far.vtu")
            self.expect_fault(ran, "box.obj")
            self.assertIn("scaled", ran.err)
        self.assertEqual(self.hexatlas("mesh", "hybrid", "box.obj", "--spacing", "1", "-o",
                                       "x.vtu").code, 2)

    def test_triangles_into_quads(self):
        for output in ("quads.obj", "quads.off", "quads.vtk", "quads.vtu", "quads.mesh", "quads.msh"):
            ran = self.succeeds("mesh", "quads", self.box((3, 2, 2)), "-o", output, "--json")
            made = json.loads(ran.out)
            self.assertEqual(made["selected"], {"quads": 32, "triangles": 0})
            self.assertEqual((made["triangles"], made["min_quality"]), (64, 1))
            self.succeeds("code", output)
        self.write("one.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\n"
                              "f 1 2 3\nf 1 3 4\nf 2 5 3\n")
        self.succeeds("mesh", "quads", "one.obj", "-o", "mixed.off")
        self.assertEqual(self.read("mixed.off").decode().splitlines()[-2:], ["3 1 4 2", "4 0 1 2 3"])
        self.expect_fault(self.hexatlas("mesh", "quads", "mixed.off", "-o", "x.obj"), "mixed.off")

    def test_quads_have_the_reference_of_their_triangles(self):
        head = ("MeshVersionFormatted 2\nDimension 3\nVertices 6\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
                "2 0 0 0\n2 1 0 0\nTriangles 4\n")
        self.write("parts.mesh", head + "1 2 3 7\n1 3 4 7\n2 5 6 7\n2 6 3 8\nEnd\n")
        self.succeeds("mesh", "quads", "parts.mesh", "-o", "made.mesh")
        self.assertTrue(self.read("made.mesh").decode().endswith(
            "Triangles\n2\n2 5 6 7\n2 6 3 8\nQuadrilaterals\n1\n1 2 3 4 7\nEnd\n"))
        self.write("parts.mesh", head + "1 2 3 7\n1 3 4 -7\n2 5 6 7\n2 6 3 8\nEnd\n")
        ran = self.hexatlas("mesh", "quads", "parts.mesh", "-o", "made.mesh")
        self.expect_fault(ran, "parts.mesh")
        self.assertIn("parts.mesh:12: reference -7", ran.err)

    def test_triangles_of_opposite_orientation_make_no_quad(self):
        self.write("two.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n")
        ran = self.succeeds("mesh", "quads", "two.obj", "-o", "none.off")
        self.assertIn("note: 1 edge between two triangles of opposite orientation", ran.err)
        self.assertEqual(ran.out, "none.off of 2 triangles: 0 quads and 2 triangles left, of 0 candidates\n")
        made = json.loads(self.succeeds("mesh", "quads", "two.obj", "-o", "none.off", "--json").out)
        self.assertEqual((made["min_quality"], made["mean_quality"]), (None, None))

    def test_wrong_use(self):
        file = self.lattice(1)
        for options in ([], ["--count", "-o", "x.vtu"], ["--count", "--quality", "1"], ["-o", file],
                        ["--count", "--quality", "nan"], ["-o", "x.vtu", "--fill", "lattice", "--spacing", "nan"],
                        ["-o", "x.vtu", "--fill", "lattice", "--spacing", "inf"],
                        ["-o", "x.vtu", "--fill", "lattice", "--spacing", "0"]):
            ran = self.expect(2, self.hexatlas("mesh", "hybrid", file, *options))
            self.assertLess(len(ran.err), 200)
        ran = self.expect(2, self.hexatlas("mesh", "hybrid", file, "-o", "x.vtu", "--candidates", "x.vtu"))
        self.assertIn("--output and --candidates are the same file", ran.err)
        for words in (("mesh", "quads", file, "-o", "x.obj", "--quality", "nan"),
                      ("view", file, "-o", "x.html", "--explode", "nan"), ("view", file, "-o", "x.html", "--shrink", "nan")):
            self.expect(2, self.hexatlas(*words))
        self.assertEqual(self.hexatlas("mesh", "hybrid", "none.mesh", "--count").code, 3)


if __name__ == "__main__":
    program.main()
