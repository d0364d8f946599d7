#!/usr/bin/env python3
"""Claim. `check --delaunay` accepts Delaunay triangulations in each format, with the points that they
must have; it says no (exit 1) with a law and a witness to others, and exit 3 to what is no mesh.
Oracle. Meshes written out by hand: two tetrahedra on both sides of a triangle, with their apexes far
apart, and the three around the edge between the apexes.
"""
import json
import struct

import program

POINTS = [(2, 0, 0), (-1, 2, 0), (-1, -2, 0), (0, 0, -4), (0, 0, 4)]
CELLS = [(0, 1, 2, 4), (1, 0, 2, 3)]
FLIPPED = [(0, 1, 3, 4), (1, 2, 3, 4), (2, 0, 3, 4)]


def hxtet(points, cells):
    return (b"HXTET\0\0\1" + struct.pack("<QQ", len(points), len(cells)) +
            b"".join(struct.pack("<3d", *p) for p in points) +
            b"".join(struct.pack("<4I", *c) for c in cells))


def vtk(points, cells, kind=10):
    rows = "".join(f"{len(c)} " + " ".join(map(str, c)) + "\n" for c in cells)
    return ("# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            f"POINTS {len(points)} double\n" + "".join("%s %s %s\n" % p for p in points) +
            f"CELLS {len(cells)} {sum(len(c) + 1 for c in cells)}\n{rows}"
            f"CELL_TYPES {len(cells)}\n" + f"{kind}\n" * len(cells))


def vtu(points, cells):
    numbers = " ".join(str(x) for p in points for x in p)
    return ('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">\n'
            f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">\n'
            '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">'
            f'{numbers}</DataArray></Points>\n<Cells>\n'
            '<DataArray type="Int64" Name="connectivity" format="ascii">'
            + " ".join(str(v) for c in cells for v in c) + '</DataArray>\n'
            '<DataArray type="Int64" Name="offsets" format="ascii">'
            + " ".join(str(4 * i + 4) for i in range(len(cells))) + '</DataArray>\n'
            '<DataArray type="UInt8" Name="types" format="ascii">'
            + " ".join("10" for _ in cells) + '</DataArray>\n'
            '</Cells></Piece></UnstructuredGrid></VTKFile>\n')


def xyz(points):
    return "# points\n" + "".join("%s %s %s\n" % p for p in points)


class DelaunayTest(program.ProgramTest):
    def test_accepts_each_format_with_its_points(self):
        self.write("points.xyz", xyz(POINTS))
        self.write("points.bin", b"".join(struct.pack("<3d", *p) for p in POINTS))
        for name, content in (("good.hxtet", hxtet(POINTS, CELLS)), ("good.vtk", vtk(POINTS, CELLS)),
                              ("good.vtu", vtu(POINTS, CELLS)), ("good", hxtet(POINTS, CELLS))):
            with self.subTest(file=name):
                self.write(name, content)
                ran = self.expect(0, self.hexatlas("check", "--delaunay", name))
                self.assertEqual(
                    ran.out, f"{name}: accepted: a Delaunay triangulation, 2 tetrahedra, 5 points "
                    "(0 of them duplicates), 7 facets, 6 of them on the boundary; 0 interior facets "
                    "between tetrahedra of one sphere\n")
                for points in ("points.xyz", "points.bin", name):
                    ran = self.expect(0, self.hexatlas("check", "--delaunay", name, "--points", points))
                    self.assertIn(f"; its points are those of {points}\n", ran.out)

    def test_json(self):
        self.write("good.vtk", vtk(POINTS, CELLS))
        said = json.loads(self.expect(0, self.hexatlas("check", "--json", "--delaunay", "good.vtk")).out)
        self.assertEqual(said, {
            "accepted": True, "law": "none", "reason": "", "points": 5, "duplicates": 0,
            "hidden": 0, "tetrahedra": 2, "facets": 7, "boundary_facets": 6, "boundary_vertices": 5,
            "cospherical": 0, "signs": said["signs"]})
        self.assertEqual(sorted(said["signs"]), ["by_double", "by_integers", "by_words"])

    def test_says_no_with_the_law_and_a_witness(self):
        for law, points, cells in (
                ("corners", POINTS, []), ("corners", POINTS, [(0, 1, 2, 2)]),
                ("positive", POINTS, [(1, 0, 2, 4), CELLS[1]]),
                ("two-tetrahedra", POINTS + [(0, 0, 3)], CELLS + [(0, 1, 2, 5)]),
                ("opposite-sides", POINTS + [(0, 0, 3)], [CELLS[0], (0, 1, 2, 5)]),
                ("unused-point", POINTS + [(0, 0, 3)], CELLS),
                ("unused-point", POINTS, CELLS[:1]),
                ("empty-spheres", POINTS, FLIPPED)):
            with self.subTest(law=law):
                self.write("bad.hxtet", hxtet(points, cells))
                ran = self.expect(1, self.hexatlas("check", "--delaunay", "bad.hxtet"))
                self.assertRegex(ran.out, rf"\Abad\.hxtet: rejected: {law}: [^\n]+\n\Z")
                ran = self.expect(1, self.hexatlas("check", "--delaunay", "bad.hxtet", "--json"))
                self.assertEqual(json.loads(ran.out)["law"], law)

    def test_points_must_be_those_of_the_file(self):
        self.write("good.vtk", vtk(POINTS, CELLS))
        for name, points in (("order.xyz", POINTS[::-1]), ("fewer.xyz", POINTS[:4]),
                             ("more.xyz", POINTS + POINTS[:1]),
                             ("ulp.xyz", [("2.0000000000000004", 0, 0)] + POINTS[1:])):
            with self.subTest(points=name):
                self.write(name, xyz(points))
                ran = self.expect(1, self.hexatlas("check", "--delaunay", "good.vtk", "--points", name))
                self.assertIn("rejected: given-points: ", ran.out)

    def test_weights(self):
        self.write("two.vtk", vtk(POINTS, CELLS))
        self.write("three.hxtet", hxtet(POINTS, FLIPPED))
        self.write("one.hxtet", hxtet(POINTS, CELLS[:1]))
        for name, weights, accepted, law in (
                ("two.vtk", (0, 0, 0, 0, 0), True, "none"), ("two.vtk", (-7, -7, -7, -7, -7), True, "none"),
                ("three.hxtet", (0, 0, 0, 0, 0), False, "empty-spheres"),
                ("two.vtk", (0, 0, 0, 20, 20), False, "empty-spheres"),
                ("three.hxtet", (0, 0, 0, 20, 20), True, "none"),
                ("one.hxtet", (0, 0, 0, -1e300, 0), False, "hidden-point")):
            for points in ("w.xyz", "w.bin"):
                with self.subTest(file=name, weights=weights, points=points):
                    self.write("w.xyz", "".join("%s %s %s " % p + f"{w}\n" for p, w in zip(POINTS, weights)))
                    self.write("w.bin", b"".join(struct.pack("<4d", *p, w) for p, w in zip(POINTS, weights)))
                    ran = self.expect(0 if accepted else 1, self.hexatlas(
                        "check", "--delaunay", name, "--points", points, "--weights", "--json"))
                    self.assertEqual(json.loads(ran.out)["law"], law)
        inside = POINTS + [(0, 0, 1)]
        self.write("two.hxtet", hxtet(inside, CELLS))
        for weight, accepted in ((-100, True), (100, False)):
            self.write("w.xyz", "".join("%s %s %s " % p + f"{weight if p == (0, 0, 1) else 0}\n" for p in inside))
            ran = self.expect(0 if accepted else 1, self.hexatlas(
                "check", "--delaunay", "two.hxtet", "--points", "w.xyz", "--weights"))
            self.assertIn("accepted: a regular triangulation, 2 tetrahedra, 6 points (0 of them duplicates, "
                          "1 hidden)" if accepted else
                          "rejected: hidden-point: point 5 is in no tetrahedron, but inside the orthosphere "
                          "of tetrahedron 0", ran.out)

    def test_malformed(self):
        good = hxtet(POINTS, CELLS)
        self.write("good.hxtet", good)
        for name, content in (("cut.hxtet", good[:-1]), ("long.hxtet", good + b"\0"),
                              ("index.hxtet", hxtet(POINTS, [(0, 1, 2, 5)])),
                              ("nan.hxtet", hxtet([(float("nan"), 0, 0)], [])),
                              ("empty.vtk", ""), ("cells.vtk", vtk(POINTS, [(0, 1, 2, 3, 4)], 14)),
                              ("other.stl", "solid\n")):
            with self.subTest(file=name):
                self.write(name, content)
                self.expect_fault(self.hexatlas("check", "--delaunay", name), name)
                self.expect_fault(
                    self.hexatlas("check", "--delaunay", "good.hxtet", "--points", "missing.xyz"),
                    "missing.xyz")

    def test_usage(self):
        self.write("good.hxtet", hxtet(POINTS, CELLS))
        self.expect(2, self.hexatlas("check", "good.hxtet", "--points", "good.hxtet"))
        self.expect(2, self.hexatlas("check", "--delaunay", "good.hxtet", "--weights"))
        self.expect_fault(self.hexatlas("check", "--delaunay", "good.hxtet", "--points", "good.hxtet",
                                        "--weights"), "good.hxtet")
        for option in ("--boundary", "--completeness"):
            self.expect(2, self.hexatlas("check", "--delaunay", "good.hxtet", option, "good.hxtet"))
        self.expect_fault(self.hexatlas("check", "good.hxtet"), "good.hxtet")


if __name__ == "__main__":
    program.main()
