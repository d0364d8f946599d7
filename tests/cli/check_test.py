#!/usr/bin/env python3
"""Claim. `check` accepts a mesh with its boundary, says no (exit 1) to each damage that leaves the
file well formed, and exit 3 to files that are not. The same for certificates of lower bounds and
for sectors.
Oracle. The damage is put in here: two cubes on one another, written out by hand; certificates of one
record, the face budget: 8 quads, one hexahedron has 6; a sector of 30 hexahedra from a file, and a
layer of 26 around it, one for each quad.
"""
import itertools
import json
import os
import shutil
import struct

import program
import surfaces

BAD = ("", "nonsense\n", "\0\0\0")


def points_of_two_cubes():
    return [(str(x), str(y), str(z)) for z in range(3) for y in range(2) for x in range(2)]


# VTK's order of corners; vertex x + 2 y + 4 z.
CELLS = [[0, 1, 3, 2, 4, 5, 7, 6], [4, 5, 7, 6, 8, 9, 11, 10]]
QUADS = [[0, 2, 3, 1], [8, 9, 11, 10]] + [
    [a + 4 * z, b + 4 * z, b + 4 * z + 4, a + 4 * z + 4]
    for z in range(2) for a, b in ((0, 1), (1, 3), (3, 2), (2, 0))]


def vtk(points, cells, kind="12"):
    rows = "".join(f"{len(cell)} " + " ".join(map(str, cell)) + "\n" for cell in cells)
    return ("# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            f"POINTS {len(points)} double\n" + "".join(" ".join(p) + "\n" for p in points) +
            f"CELLS {len(cells)} {sum(len(c) + 1 for c in cells)}\n{rows}"
            f"CELL_TYPES {len(cells)}\n" + f"{kind}\n" * len(cells))


def certificate(hexahedra=1, interior=0, kind="ball", log=b"\x01"):
    """That the octagonal spindle has no mesh, in a Zstandard frame of one raw block."""
    quads = "".join(f"{i} {(i + 1) % 8} {(i + 2) % 8} {8 + i % 2}\n" for i in range(8))
    text = (f"hexatlas-bound 2\nboundary q1:088a577f\nquads 8\n{quads}kind {kind}\n"
            f"hexahedra {hexahedra}\ninterior {interior}\nsymmetry no\nlog {len(log)}\n").encode() + log
    return (b"\x28\xb5\x2f\xfd\xa0" + struct.pack("<I", len(text)) +
            struct.pack("<I", len(text) << 3 | 1)[:3] + text)


def scarred_sector():
    """Vertices and hexahedra of the one sector of that file; it has scars."""
    name = os.path.join(program.REPOSITORY, "tests", "tables", "check", "scarred.hxs")
    with open(name, encoding="ascii") as file:
        lines = file.read().splitlines()
    return int(lines[1].split()[2]), [[int(v) for v in line.split()] for line in lines[2:]]


def surface_of_sector():
    """Quads counter-clockwise from outside, as in docs/formats/sectors.md."""
    p, r = (6, 7, 9, 10, 12, 13), {1: 8, 3: 11, 5: 14}
    quads = [[0, 1, 2, 3], [0, 3, 4, 5]]
    for i in range(6):
        b, w = (i, (i + 1) % 6)[::1 if i % 2 == 0 else -1]
        y, z = 16 + 2 * i, 17 + 2 * i
        wall = [[w, p[w], y, b], [p[w], r[w], z, y], [r[w], 15, p[b], z], [p[b], b, y, z]]
        quads += [quad[::1 if i % 2 == 1 else -1] for quad in wall]
    return quads


def layer_around(sector):
    vertices, cells = sector
    return vertices + 28, [[a + 28, b + 28, d + 28, c + 28, a, b, d, c]
                           for a, b, c, d in surface_of_sector()
                           ] + [[v + 28 for v in cell] for cell in cells]


def hxs(*sectors):
    return "hexatlas sectors 1\n" + "".join(
        f"sector {len(cells)} {vertices}\n" + "".join(" ".join(map(str, c)) + "\n" for c in cells)
        for vertices, cells in sectors)


class Check(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("good.obj", surfaces.obj(points_of_two_cubes(), QUADS))

    def check(self, points, cells, *options, boundary="good.obj"):
        self.write("mesh.vtk", vtk(points, cells))
        return self.hexatlas("check", "mesh.vtk", "--boundary", boundary, *options)

    def test_accepted(self):
        points = points_of_two_cubes()
        ran = self.expect(0, self.check(points, CELLS))
        self.assertEqual(ran.err, "")
        self.assertRegex(ran.out, r"\Amesh\.vtk: accepted: 2 hexahedra, 12 vertices \(0 interior\), "
                                  r"20 edges, 11 quads, 10 of them on the boundary; [^\n]+\n\Z")
        said = json.loads(self.expect(0, self.check(points, CELLS, "--json")).out)
        self.assertEqual(said, {
            "accepted": True, "undecided": False, "reason": "", "vertices": 12, "interior_vertices": 0, "edges": 20,
            "quads": 11, "hexahedra": 2, "boundary_quads": 10, "ball_proof": said["ball_proof"],
            "valid_in_space": 2, "undecided_in_space": 0})
        self.assertIn(said["ball_proof"], ("shelling", "collapse"))
        self.expect(0, self.hexatlas("check", "mesh.vtk"))

    def test_each_exchange_of_two_labels_is_rejected(self):
        points = points_of_two_cubes()
        for i, j in program.share_of(list(itertools.combinations(range(8), 2))):
            cell = list(CELLS[0])
            cell[i], cell[j] = cell[j], cell[i]
            with self.subTest(exchanged=(i, j)):
                ran = self.expect(1, self.check(points, [cell, CELLS[1]]))
                self.assertRegex(ran.out, r"\Amesh\.vtk: rejected: [^\n]+\n\Z")
                self.assertEqual(ran.err, "")

    def test_each_other_label_is_rejected(self):
        points = points_of_two_cubes()
        others = [(i, v) for i in range(8) for v in range(12) if v != CELLS[0][i]]
        for i, v in program.share_of(others):
            cell = list(CELLS[0])
            cell[i] = v
            with self.subTest(corner=i, vertex=v):
                ran = self.check(points, [cell, CELLS[1]])
                self.assertIn(ran.code, (1, 3), ran)

    def test_other_meshes(self):
        points = points_of_two_cubes()
        moved = list(points)
        moved[3] = ("1.0000000000000002", "1", "0")
        for name, mesh in {
                "a hexahedron is missing": (points, CELLS[:1]),
                "a hexahedron twice": (points, CELLS + CELLS[:1]),
                "a point moved by one bit": (moved, CELLS),
                "a zero changed its sign": ([("-0", "0", "0")] + points[1:], CELLS),
                "a point too many": (points + [("5", "5", "5")], CELLS),
                "a point too few": (points[:8], CELLS[:1])}.items():
            with self.subTest(damage=name):
                ran = self.expect(1, self.check(*mesh))
                said = json.loads(self.expect(1, self.check(*mesh, "--json")).out)
                self.assertFalse(said["accepted"])
                self.assertIn(said["reason"], ran.out)
                self.assertGreater(len(said["reason"]), 10)

    def test_another_boundary(self):
        points = points_of_two_cubes()
        for name, quads in {
                "one quad of another diagonal": [[0, 3, 2, 1]] + QUADS[1:],
                "one quad missing": QUADS[1:],
                "a quad in the interior": QUADS[:-1] + [[4, 5, 7, 6]]}.items():
            with self.subTest(boundary=name):
                self.write("other.obj", surfaces.obj(points, quads))
                self.expect(1, self.check(points, CELLS, boundary="other.obj"))

    def test_malformed(self):
        text = vtk(points_of_two_cubes(), CELLS)
        for i, extension in enumerate((".vtk", ".vtu", ".mesh", ".msh")):
            name = "bad" + extension
            for content in program.share_of(BAD + (text[:100],), i, least=2):
                self.write(name, content)
                with self.subTest(file=name, content=content[:20]):
                    self.expect_fault(self.hexatlas("check", name), name)
                    self.expect_fault(self.hexatlas("check", name, "--json"), name)
        for place in program.share_of(range(41, len(text) - 3, 41), least=2):
            self.write("cut.vtk", text[:place])
            self.expect_fault(self.hexatlas("check", "cut.vtk"), "cut.vtk")
        for damage in (("POINTS 12", "POINTS 13"), ("CELLS 2 18", "CELLS 2 19"), ("\n12\n", "\n10\n"),
                       ("8 0 1", "8 0 77"), ("8 0 1", "8 0 -1"), ("1 1 2", "1 nan 2"),
                       ("8 0 1", "8 0 4294967297")):
            self.assertIn(damage[0], text)
            self.write("bad.vtk", text.replace(damage[0], damage[1], 1))
            with self.subTest(damage=damage):
                self.expect_fault(self.hexatlas("check", "bad.vtk"), "bad.vtk")

    def test_malformed_boundary(self):
        self.write("mesh.vtk", vtk(points_of_two_cubes(), CELLS))
        for key, (extension, _, _, _) in surfaces.FORMATS.items():
            for content in BAD[1:]:
                name = self.write("bad" + extension, content)
                with self.subTest(format=key, content=content):
                    self.expect_fault(
                        self.hexatlas("check", "mesh.vtk", "--boundary", name), name)

    def write_bytes(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)

    def test_certificate(self):
        self.write_bytes("spindle.hxb", certificate())
        ran = self.expect(0, self.hexatlas("check", "spindle.hxb"))
        self.assertEqual(ran.out, "spindle.hxb: accepted: q1:088a577f has no ball of at most "
                                  "1 hexahedron (any number of interior vertices); 1 record\n")
        self.write_bytes("named.vtk", certificate(kind="any"))
        said = json.loads(self.expect(0, self.hexatlas("check", "named.vtk", "--json")).out)
        self.assertEqual(said, {
            "accepted": True, "reason": "", "boundary": "q1:088a577f", "kind": "any",
            "hexahedra": 1, "interior": 0, "any_interior": True, "records": 1})
        # Branch on the first quad: without new vertices there is no hexahedron on it.
        self.write_bytes("few.hxb", certificate(3, log=b"\0\0"))
        ran = self.expect(0, self.hexatlas("check", "few.hxb"))
        self.assertIn("3 hexahedra (at most 0 interior vertices); 1 record", ran.out)

    def test_certificate_rejected(self):
        for bad in (certificate(2), certificate(log=b"\x02\x01"), certificate(log=b""),
                    certificate(log=b"\x01\x01"), certificate(log=b"\x09")):
            self.write_bytes("bad.hxb", bad)
            ran = self.expect(1, self.hexatlas("check", "bad.hxb"))
            self.assertRegex(ran.out, r"\Abad\.hxb: rejected: [^\n]+\n\Z")
            said = json.loads(self.expect(1, self.hexatlas("check", "bad.hxb", "--json")).out)
            self.assertFalse(said["accepted"])
            self.assertIn(said["reason"], ran.out)
        good = certificate()
        for bad in (good[:-1], good + b"x", certificate(65), certificate(kind="sphere")):
            self.write_bytes("bad.hxb", bad)
            self.expect_fault(self.hexatlas("check", "bad.hxb"), "bad.hxb")
        self.write_bytes("good.hxb", good)
        for option in ("--boundary", "--completeness"):
            self.assertEqual(self.hexatlas("check", "good.hxb", option, "good.obj").code, 2)

    def test_what_has_lost_its_first_words_is_told_by_its_name(self):
        for name in ("bad.hxc", "bad.hxb", "bad.hxs"):
            for content in (b"", b"hexa", b"\x28\xb5"):
                self.write_bytes(name, content)
                with self.subTest(file=name, content=content):
                    ran = self.hexatlas("check", name)
                    self.expect_fault(ran, name)
                    self.assertNotIn("mesh file", ran.err)
        catalogue = os.path.join(program.REPOSITORY, "tables", "data", "prism.hxc")
        for name in ("renamed.hxb", "renamed.hxl", "renamed.HXT", "renamed"):
            shutil.copyfile(catalogue, self.path(name))
            self.assertIn("2 classes of prism", self.expect(0, self.hexatlas("check", name)).out)
        for name, words in (("proof.hxl", "--completeness"), ("table.hxt", "table check")):
            self.write(name, "")
            self.assertIn(words, self.expect(2, self.hexatlas("check", name)).err)
        self.write_bytes("good.hxb", certificate())
        for option in ("--hybrid", "--delaunay"):
            self.assertIn(option, self.expect(2, self.hexatlas("check", "good.hxb", option)).err)

    def test_sectors(self):
        scarred = scarred_sector()
        layered = layer_around(scarred)
        claim = ("accepted: every 3-connected quadrangulation with an even number n of quads has a "
                 "mesh of at most 28 n hexahedra; ")
        for name, sectors, counts in (
                ("two.hxs", (scarred, layered), "2 sectors of 30 to 56 hexahedra"),
                ("named.vtk", (layered,), "1 sector of 56 hexahedra"),
                ("four.hxs", (layer_around(layered), layered, scarred, layered),
                 "4 sectors of 30 to 82 hexahedra")):
            with self.subTest(file=name):
                self.write(name, hxs(*sectors))
                ran = self.expect(0, self.hexatlas("check", name))
                self.assertEqual(ran.out, f"{name}: {claim}{counts}\n")
                self.assertEqual(ran.err, "")
                said = json.loads(self.expect(0, self.hexatlas("check", name, "--json")).out)
                self.assertEqual(said, {
                    "accepted": True, "undecided": False, "reason": "", "sectors": len(sectors),
                    "least": min(len(cells) for _, cells in sectors),
                    "least_without_scars": 56, "hexahedra_per_quad": 28})

    def test_sectors_rejected(self):
        scarred = scarred_sector()
        vertices, cells = layer_around(scarred)
        mirrored = [[cell[i ^ 1] for i in range(8)] for cell in cells]
        for name, sectors in {
                "scars": (scarred,),
                "a hexahedron is missing": (scarred, (vertices, cells[:-1])),
                "a hexahedron twice": ((vertices, cells + cells[:1]),),
                "mirrored": ((vertices, mirrored),),
                "a gap": ((vertices + 1, cells),)}.items():
            with self.subTest(damage=name):
                self.write("bad.hxs", hxs(*sectors))
                ran = self.expect(1, self.hexatlas("check", "bad.hxs"))
                self.assertRegex(ran.out, r"\Abad\.hxs: rejected: [^\n]+\n\Z")
                said = json.loads(self.expect(1, self.hexatlas("check", "bad.hxs", "--json")).out)
                self.assertEqual(said, {
                    "accepted": False, "undecided": False, "reason": said["reason"], "sectors": len(sectors),
                    "least": min(len(c) for _, c in sectors),
                    "least_without_scars": None, "hexahedra_per_quad": None})
                self.assertIn(said["reason"], ran.out)

    def test_sectors_malformed(self):
        good = hxs(layer_around(scarred_sector()))
        for line, text in (
                (1, good.replace("sectors 1", "sectors 2")), (1, good.replace("\n", "\r\n")),
                (2, good.replace(" 77\n", " 077\n")), (2, "hexatlas sectors 1\n"),
                (3, good.replace("28 29", "28  29", 1)), (58, good[:-1]), (59, good + "\n")):
            with self.subTest(line=line):
                self.write("bad.hxs", text)
                self.assertEqual(self.expect_fault(self.hexatlas("check", "bad.hxs"), "bad.hxs"), line)
        self.write("good.hxs", good)
        for option in ("--boundary", "--completeness"):
            ran = self.expect(2, self.hexatlas("check", "good.hxs", option, "good.obj"))
            self.assertIn("good.hxs is a file of sectors", ran.err)

    def test_files_that_are_no_files(self):
        os.mkdir(self.path("folder.vtk"))
        for name in ("missing.vtk", "folder.vtk", "good.obj", "noextension"):
            self.expect_fault(self.hexatlas("check", name), name)
        self.write("mesh.vtk", vtk(points_of_two_cubes(), CELLS))
        for name in ("missing.obj", "mesh.xyz"):
            self.expect_fault(self.hexatlas("check", "mesh.vtk", "--boundary", name), name)


if __name__ == "__main__":
    program.main()
