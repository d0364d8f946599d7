#!/usr/bin/env python3
"""Claim. No verb hands on a mesh of a table that lies: each says which table it is. `table check` and
`table get` know what the celebrated boundaries are called.
Oracle. A table written here, byte by byte from docs/formats/table.md, with a digest that is
right and a mesh that is wrong: the cube and, apart from it, one hexahedron twice.
usage: forged_table_test.py PROGRAM
"""
import hashlib
import json
import os
import struct

import program

SHIPPED = os.path.join(program.REPOSITORY, "tables", "data", "hexatlas.hxt")
CUBE = os.path.join(program.INPUTS, "cube.obj")
KEY = bytes.fromhex("08a5df")
TWO_CUBES = bytes.fromhex("022972977f")
SPINDLE = bytes.fromhex("088a577f")


def stored(raw):
    """One Zstandard frame with one raw block; below 256 bytes."""
    header = b"\x28\xb5\x2f\xfd" + bytes([0x20, len(raw)])
    return header + struct.pack("<I", 1 | len(raw) << 3)[:3] + raw


def table(cells, interior, key=KEY, name=""):
    payload = b"\x01" + b"".join(struct.pack("<8H", *cell) for cell in cells)
    raw = struct.pack("<I", len(payload)) + payload
    block = stored(raw)
    index = 128 + 32
    directory = index + len(key) + 8
    names = directory + 16 + len(block)
    body = struct.pack("<IIQQQ", 2 * len(key), len(key), 0, 1, index)
    body += key + struct.pack("<HHHH", len(cells), interior, 1, 0)
    body += struct.pack("<QII", directory + 16, len(block), len(raw)) + block
    if name:
        body += struct.pack("<IB", 0, len(name)) + name.encode()
    head = b"hexatlas" + struct.pack("<IIQQIIIIQQQ", 2, 0x0A0B0C0D, 128 + len(body), 1, 1, 1,
                                     bool(name), 64, index, directory, names)
    head = head.ljust(128, b"\0")
    digest = hashlib.sha256(head + body).digest()
    return head[:96] + digest + body


class ForgedTableTest(program.ProgramTest):
    def mesh_with(self, cells, interior):
        self.write("forged.hxt", table(cells, interior))
        return self.hexatlas("mesh", "hex", CUBE, "-o", "out.vtk", "--table", "forged.hxt")

    def sound_cell(self):
        """The cube's own cell in canonical labels, as the shipped table has it."""
        got = self.expect(0, self.hexatlas("table", "get", "--name", "cube"))
        return json.loads(got.out)["cells"][0]

    def test_a_sound_table_is_used(self):
        self.expect(0, self.mesh_with([self.sound_cell()], 0))
        self.assertTrue(os.path.exists(self.path("out.vtk")))

    def test_a_lying_table_is_not_believed(self):
        apart = [8, 9, 10, 11, 12, 13, 14, 15]
        ran = self.expect(3, self.mesh_with([self.sound_cell(), apart, apart], 8))
        self.assertIn("forged.hxt: holds a mesh", ran.err)
        self.assertFalse(os.path.exists(self.path("out.vtk")))

    def test_no_verb_hands_it_on(self):
        self.write("forged.hxt", table([[0] * 8], 0))
        for words in (("table", "get", "--name", "cube", "--table", "forged.hxt"),
                      ("table", "get", "--code", "q1:022972977f", "--search", "--table", "forged.hxt"),
                      ("table", "bounds", "forged.hxt", "-o", "out.hxt", "--max-hexes", "2"),
                      ("mesh", "boundary", "cube", "--table", "forged.hxt", "-o", "out.vtk")):
            self.expect_fault(self.hexatlas(*words), "forged.hxt")
        self.assertEqual(self.listing(), ["forged.hxt"])

    def test_no_mesh_is_made_smaller_by_it(self):
        points = [(x, y, z) for z in range(4) for y in range(2) for x in range(2)]
        cells = [[4 * z + i for i in (0, 1, 3, 2, 4, 5, 7, 6)] for z in range(3)]
        self.write("three.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 16\n" +
                   "".join(f"{x} {y} {z} 0\n" for x, y, z in points) + "Hexahedra 3\n" +
                   "".join(" ".join(str(v + 1) for v in cell) + " 0\n" for cell in cells) + "End\n")
        for cell in ([0] * 8, list(range(8))):
            self.write("forged.hxt", table([cell], 0, key=TWO_CUBES))
            self.expect_fault(self.hexatlas("simplify", "three.mesh", "-o", "out.vtk", "--table", "forged.hxt"),
                              "forged.hxt")
        self.assertEqual(self.listing(), ["forged.hxt", "three.mesh"])

    def test_bounds_go_on_with_no_such_mesh(self):
        """What lies at -o is read as well."""
        self.expect(0, self.hexatlas("table", "build", "-o", "small.hxt", "--max-quads", "8", "--start-from",
                                     SHIPPED, "--width", "10", "--rounds", "1", "--growths", "0", "--cut", "0",
                                     "--collared", "0", "--symmetric", "0", "--max-hexahedra", "1"))
        two = [list(range(8)), [4, 5, 6, 7, 8, 9, 0, 1]]
        self.write("forged.hxt", table(two, 0, SPINDLE))
        self.expect_fault(self.hexatlas("table", "bounds", "small.hxt", "-o", "forged.hxt", "--max-hexes", "2"),
                          "forged.hxt")
        self.write("forged.hxt", b"hexatlas, but no table")
        ran = self.hexatlas("table", "bounds", "small.hxt", "-o", "forged.hxt", "--max-hexes", "2")
        self.expect_fault(ran, "forged.hxt")
        self.write("forged.hxt", b"something else")
        ran = self.expect(0, self.hexatlas("table", "bounds", "small.hxt", "-o", "forged.hxt", "--max-hexes", "2"))
        self.assertIn("note: forged.hxt: ", ran.err)
        self.assertIn("; it will be replaced\n", ran.err)

    def test_names_are_those_of_their_boundaries(self):
        cell = self.sound_cell()
        self.write("named.hxt", table([cell], 0, name="cube"))
        self.expect(0, self.hexatlas("table", "check", "named.hxt"))
        self.write("named.hxt", table([cell], 0, name="two-cubes"))
        ran = self.expect(1, self.hexatlas("table", "check", "named.hxt"))
        self.assertIn("two-cubes is the name of q1:022972977f, not of q1:08a5df", ran.out)
        self.expect(4, self.hexatlas("table", "get", "--name", "two-cubes", "--table", "named.hxt"))
        self.write("named.hxt", table([cell], 0, name="mine"))
        got = self.expect(0, self.hexatlas("table", "get", "--name", "mine", "--table", "named.hxt"))
        self.assertEqual(json.loads(got.out)["cells"], [cell])
        # What is published is about the boundary, not about what the table calls it.
        self.assertEqual(json.loads(got.out)["literature"]["hexahedra"], 1)
        got = self.expect(0, self.hexatlas("table", "get", "--code", "q1:08a5df", "--table", "named.hxt"))
        self.assertEqual(json.loads(got.out)["literature"]["hexahedra"], 1)

    def test_a_search_does_not_begin_with_it(self):
        # Two hexahedra on the ten vertices of the spindle's boundary, which is not theirs.
        two = [list(range(8)), [4, 5, 6, 7, 8, 9, 0, 1]]
        self.write("forged.hxt", table(two, 0, SPINDLE))
        ran = self.hexatlas("table", "build", "-o", "a.hxt", "--max-quads", "8", "--start-from",
                            "forged.hxt")
        self.expect_fault(ran, "forged.hxt")
        self.assertFalse(os.path.exists(self.path("a.hxt")))


if __name__ == "__main__":
    program.main()
