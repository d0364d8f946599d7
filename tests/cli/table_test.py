#!/usr/bin/env python3
"""Claim. `table info` and `table get` say what a table holds: its names, its counts, each mesh by
name and by code, and why there is none; a chart has what the numbers say.
Oracle. docs/formats/table.md, code.md and census.md, read again here, in table_files.py and in
tests/sabotage/reference_code.py; hashlib; `hexatlas check` for the meshes that `get` prints.
"""
import hashlib
import json
import os
import shutil
import struct
import sys
from xml.etree import ElementTree

import program
import surfaces
from table_files import CENSUS_ROWS, QUICK, TableTest, UnclaimedTest, with_claim, write_census

sys.path.insert(0, os.path.join(program.REPOSITORY, "tests", "sabotage"))
import reference_code  # noqa: E402

SHIPPED = os.path.join(program.REPOSITORY, "tables", "data", "hexatlas.hxt")
TWO_CUBES = "q1:022972977f"


def stacked_cubes():
    quads = list(reference_code.CUBE)
    reference_code.glue_cube(quads, 0)
    return quads


class MeshTest(program.ProgramTest):
    def expect_mesh(self, said):
        keys = ["code", "quads", "hexahedra", "interior_vertices", "lower_bound", "table", "sha256",
                "searched", "boundary", "cells"]
        self.assertEqual([key for key in said if key != "literature"], keys)
        self.assertEqual(said["quads"], len(said["boundary"]))
        self.assertEqual(said["hexahedra"], len(said["cells"]))
        self.assertLessEqual(said["lower_bound"], said["hexahedra"])
        self.assertEqual(said["code"], reference_code.code([tuple(q) for q in said["boundary"]]))
        inner = said["interior_vertices"]
        points = [(str(v), str(v * v), str(v ** 3)) for v in range(said["quads"] + 2 + inner)]
        self.write("boundary.obj", surfaces.obj(points[:said["quads"] + 2], said["boundary"]))
        rows = "".join("8 " + " ".join(str(cell[i]) for i in (0, 1, 3, 2, 4, 5, 7, 6)) + "\n"
                       for cell in said["cells"])
        count = len(said["cells"])
        self.write("mesh.vtk", "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                   f"POINTS {len(points)} double\n" + "".join(" ".join(p) + "\n" for p in points) +
                   f"CELLS {count} {9 * count}\n{rows}CELL_TYPES {count}\n" + "12\n" * count)
        ran = self.expect(0, self.hexatlas("check", "mesh.vtk", "--boundary", "boundary.obj"))
        self.assertEqual(ran.err, "")


class Read(TableTest, MeshTest):
    def test_info(self):
        said = json.loads(self.expect(0, self.hexatlas("table", "info", "small.hxt", "--json")).out)
        self.assertEqual(list(said), ["file", "bytes", "sha256", "entries", "complete_through",
                                      "by_quads", "names"])
        self.assertEqual(said["file"], "small.hxt")
        self.assertEqual(said["sha256"], hashlib.sha256(self.good).hexdigest())
        entries = struct.unpack_from("<Q", self.good, 24)[0]
        self.assertEqual(said["entries"], entries)
        self.assertEqual(sum(row["entries"] for row in said["by_quads"].values()), entries)
        stacked = reference_code.code(stacked_cubes())
        self.assertEqual(said["names"]["cube"],
                         {"code": reference_code.code(reference_code.CUBE), "hexahedra": 1,
                          "literature": {"hexahedra": 1, "source": "evident from the construction"}})
        self.assertEqual(said["names"]["two-cubes"]["code"], stacked)
        self.assertEqual(said["names"]["two-cubes"]["literature"]["hexahedra"], 2)
        text = self.expect(0, self.hexatlas("table", "info", "small.hxt")).out
        for word in ("cube", stacked, said["sha256"], f"{entries} meshes"):
            self.assertIn(word, text)

    def test_get_by_name_code_and_file(self):
        by_name = self.expect(0, self.hexatlas("table", "get", "--table", "small.hxt", "--name",
                                               "two-cubes"))
        said = json.loads(by_name.out)
        self.assertEqual(by_name.out.count("\n"), 1)
        self.expect_mesh(said)
        digest = hashlib.sha256(self.good).hexdigest()
        self.assertEqual((said["table"], said["sha256"], said["searched"]), ("small.hxt", digest, False))
        by_code = self.expect(0, self.hexatlas("table", "get", "--table", "small.hxt", "--code",
                                               said["code"]))
        self.assertEqual(said["literature"]["hexahedra"], 2)
        self.assertEqual(by_code.out, by_name.out)
        to_file = self.expect(0, self.hexatlas("table", "get", "--table", "small.hxt", "--name",
                                               "two-cubes", "-o", "mesh.json"))
        self.assertEqual((to_file.out, self.read("mesh.json").decode()), ("", by_name.out))

    def test_a_table_is_not_lost(self):
        """Nor what lies beside it."""
        os.symlink("small.hxt", self.path("link.hxt"))
        before = {name: self.read(name) for name in self.listing()}
        for name in ("small.hxt", "./small.hxt", "link.hxt", "small.manifest.json", "small.census.sqlite"):
            for words in (("list", "small.hxt", "-o", name),
                          ("get", "--name", "cube", "--table", "small.hxt", "-o", name),
                          ("info", "small.hxt", "--by", "quads", "--svg", name)):
                ran = self.expect(2, self.hexatlas("table", *words))
                self.assertRegex(ran.err, r" are the same file\. See `hexatlas table [a-z]+ --help`\.\n\Z")
        self.assertEqual({name: self.read(name) for name in self.listing()}, before)

    def test_a_table_on_standard_input(self):
        for words in (("list", "-"), ("info", "-"), ("get", "--name", "cube", "--table", "-")):
            ran = self.expect(0, self.hexatlas("table", *words, stdin=self.good))
            same = self.expect(0, self.hexatlas("table", *[word.replace("-", "small.hxt") if word == "-" else word
                                                           for word in words]))
            self.assertEqual(ran.out, same.out.replace("small.hxt", "standard input"))

    def test_words_of_other_flags_are_refused_with_the_code(self):
        quads = stacked_cubes()
        code = reference_code.code(quads)
        degree = {}
        for quad in quads:
            for v in quad:
                degree[v] = degree.get(v, 0) + 1
        words = set()
        for q in range(len(quads)):
            for i in range(4):
                for step in (1, -1):
                    letters = reference_code.word(quads, (q, i), step, degree)
                    words.add("q1:" + "".join(f"{4 * int(a) + int(b):x}"
                                              for a, b in zip(letters[::2], letters[1::2])))
        self.assertGreater(len(words), 2)
        self.assertIn(code, words)
        for word in sorted(words - {code}):
            ran = self.hexatlas("table", "get", "--table", "small.hxt", "--code", word)
            self.expect_fault(ran, word)
            self.assertIn(code, ran.err)

    def test_codes_that_no_mesh_can_have(self):
        for surface, said in ((surfaces.cube_with_cut_quad(1), ("7 quads", "odd")),
                              (surfaces.cube_with_cut_quad(2), ("3-connected", "opposite")),
                              (surfaces.four_lenses(), ("3-connected", "opposite"))):
            code = reference_code.code([tuple(quad) for quad in surface[1]])
            ran = self.expect(1, self.hexatlas("table", "get", "--table", "small.hxt", "--code",
                                               code))
            self.assertEqual(ran.out, "")
            self.assertRegex(ran.err, r"\Ahexatlas: " + code + r": no hexahedral mesh [^\n]+\n\Z")
            for word in said:
                self.assertIn(word, ran.err)
        # Two quads, in a word that is not canonical.
        self.expect(1, self.hexatlas("table", "get", "--table", "small.hxt", "--code", "q1:05"))

    def test_get_what_is_not_there(self):
        for option, word in (("--name", "nobody"), ("--name", "Cube"), ("--code", "q1:zz"),
                             ("--code", "q1:08a5d"), ("--code", "08a5df"), ("--code", "q1:08A5DF"),
                             ("--code", "q1:000000"), ("--code", "q1:" + "0" * 500)):
            with self.subTest(word=word):
                ran = self.hexatlas("table", "get", "--table", "small.hxt", option, word)
                self.expect_fault(ran, word)
        ran = self.expect(4, self.hexatlas("table", "get", "--table", "small.hxt", "--code",
                                           "q1:02228a2a5777df7f"))
        self.assertRegex(ran.err, r"\Ahexatlas: q1:02228a2a5777df7f \(16 quads\)[^\n]+; --search looks for a mesh\n\Z")
        for options in ((), ("--search",)):  # 28 quads are too many
            ran = self.expect(4, self.hexatlas("table", "get", "--table", "small.hxt", "--code",
                                               "q1:0888888888888a55555577ffffff", *options))
            self.assertRegex(ran.err, r"\A[^\n]+ \(28 quads\) [^\n]+ at most 26; `hexatlas mesh hex`[^\n]+\n\Z")
            self.assertEqual(ran.out, "")

    def test_no_output_takes_its_place(self):
        cube = os.path.join(program.INPUTS, "cube.obj")
        self.expect(0, self.hexatlas("mesh", "hex", cube, "-o", "cube.vtk"))
        self.write("s.hxs", "sectors")
        os.symlink("small.hxt", self.path("link.vtk"))
        before = self.listing()
        for words in (("mesh", "hex", cube), ("mesh", "boundary", "cube"), ("simplify", "cube.vtk")):
            outputs = [("--output", "link.vtk", ())]
            if words[0] == "mesh":
                outputs += [("--report", name, ("-o", "a.vtk")) for name in ("small.hxt", "./small.hxt")]
            for option, name, others in outputs:
                ran = self.expect(2, self.hexatlas(*words, "--table", "small.hxt", option, name, *others))
                self.assertIn(f"the table and {option} are the same file", ran.err)
        ran = self.expect(2, self.hexatlas("mesh", "hex", cube, "-o", "a.vtk", "--sectors", "s.hxs", "--report", "s.hxs"))
        self.assertIn("--sectors and --report are the same file", ran.err)
        self.assertEqual(self.read("small.hxt"), self.good)
        self.assertEqual(self.read("s.hxs"), b"sectors")
        self.assertEqual(self.listing(), before)

    def test_a_list_has_what_get_says(self):
        rows = [line.split("\t") for line in
                self.expect(0, self.hexatlas("table", "list", "small.hxt")).out.splitlines()]
        self.assertEqual(rows[0], ["code", "quads", "hexahedra", "interior_vertices", "lower_bound"])
        self.assertEqual(len(rows) - 1, struct.unpack_from("<Q", self.good, 24)[0])
        for row in rows[1:]:
            said = json.loads(self.expect(0, self.hexatlas("table", "get", "--table", "small.hxt",
                                                           "--code", row[0])).out)
            self.assertEqual([str(said[key]) for key in rows[0]], row)
        for option, place in (("--quads", 1), ("--at-least", 2)):
            for row in rows[1:]:
                self.expect(0, self.hexatlas("table", "list", "small.hxt", option, row[place], "-o", "l.tsv"))
                kept = [other for other in rows[1:] if option == "--at-least" and
                        int(other[place]) >= int(row[place]) or other[place] == row[place]]
                self.assertEqual([line.split("\t") for line in self.read("l.tsv").decode().splitlines()],
                                 rows[:1] + kept)

    def test_an_empty_list_says_so(self):
        for option, number in (("--quads", "8"), ("--at-least", "3")):
            ran = self.expect(0, self.hexatlas("table", "list", "small.hxt", option, number))
            self.assertEqual(ran.err, "hexatlas: note: there is no such boundary in small.hxt\n")
            self.assertEqual(len(ran.out.splitlines()), 1)

    def test_a_name_with_a_line_feed(self):
        ran = self.hexatlas("table", "get", "--table", "small.hxt", "--name", "a\nb")
        self.expect_fault(ran, "a\\x0ab")

    def test_no_table(self):
        os.mkdir(self.path("folder.hxt"))
        for name in ("missing.hxt", "folder.hxt"):
            for verb in ("info", "check"):
                self.expect_fault(self.hexatlas("table", verb, name), name)


class TwoTables(TableTest):
    """The larger table beside the program is for boundaries that the first does not claim to have."""

    def setUp(self):
        super().setUp()
        self.copy = shutil.copy(program.PROGRAM, self.path("hexatlas"))
        os.mkdir(self.path("tables"))
        cube = program.made_by("table", "build", "-o", "cube.hxt", *QUICK, "--max-hexahedra", "2")["cube.hxt"]
        self.write(os.path.join("tables", "hexatlas.hxt"), cube)

    def get(self, code, *options):
        return self.hexatlas("table", "get", *options, "--code", code, executable=self.copy)

    def test_is_asked_for_what_the_first_lacks(self):
        first, larger = (os.path.join("tables", name) for name in ("hexatlas.hxt", "hexatlas-22.hxt"))
        surface = os.path.join(program.INPUTS, "two-cubes.obj")
        cases = ((None, 4), (with_claim(self.good, 8), 0), (with_claim(self.good, 10), 0))
        for data, code in cases:
            if data is not None:
                self.write(larger, data)
            with self.subTest(claims=data is not None, code=code):
                ran = self.expect(code, self.get(TWO_CUBES))
                if code == 4:
                    self.assertIn(self.path(first), ran.err)
                self.expect(code, self.hexatlas("mesh", "hex", surface, "-o", "a.vtk", "--method", "table",
                                                executable=self.copy))
                self.expect(code, self.hexatlas("mesh", "boundary", TWO_CUBES, "-o", "b.vtk", executable=self.copy))
                self.expect(0, self.get("q1:08a5df"))
        self.expect(4, self.get(TWO_CUBES, "--table", first))
        listed = self.expect(0, self.hexatlas("table", "list", "--quads", "10", executable=self.copy)).out
        self.assertEqual(len(listed.splitlines()), 1 + 1)
        for name in (first, larger):
            before = self.read(name)
            for words in (("list", "--quads", "10"), ("get", "--code", TWO_CUBES)):
                ran = self.expect(2, self.hexatlas("table", *words, "-o", name, executable=self.copy))
                self.assertIn("are the same file", ran.err)
            self.assertEqual(self.read(name), before)
        self.write(larger, self.good[:-1])
        self.expect_fault(self.get(TWO_CUBES), self.path(larger))
        self.expect(0, self.get("q1:08a5df"))


class ByQuads(UnclaimedTest):
    def test_without_a_census(self):
        ran = self.expect(0, self.hexatlas("table", "info", "small.hxt", "--by", "quads", "--json"))
        said = json.loads(ran.out)
        self.assertEqual(said["read_from"], "small.hxt")
        self.assertEqual(said["by_quads"]["10"],
                         {"entries": 1, "of": None, "least": 2, "mean": 2.0, "median": 2.0,
                          "greatest": 2, "total": 2, "lower_bound": 1, "proven_smallest": 0,
                          "distribution": {"2": 1}})
        text = self.expect(0, self.hexatlas("table", "info", "small.hxt", "--by", "quads")).out
        self.assertIn("10 quads  2:1\n", text)
        self.assertIn("makes no claim", text)

    def test_with_a_census(self):
        census = self.path("small.census.sqlite")
        write_census(census, hashlib.sha256(self.good).hexdigest(), CENSUS_ROWS)
        ran = self.expect(0, self.hexatlas("table", "info", "small.hxt", "--by", "quads", "--json"))
        said = json.loads(ran.out)
        self.assertEqual(said["read_from"], "small.census.sqlite")
        self.assertEqual(said["by_quads"]["10"]["sources"], {"given": 1})
        text = self.expect(0, self.hexatlas("table", "info", "small.hxt", "--by", "quads")).out
        self.assertIn("read from small.census.sqlite", text)
        self.assertIn("6 quads  beam:1\n", text)
        write_census(census, "0" * 64, CENSUS_ROWS)
        self.expect_fault(self.hexatlas("table", "info", "small.hxt", "--by", "quads"),
                          "small.census.sqlite")
        self.write("small.census.sqlite", b"no database")
        self.expect_fault(self.hexatlas("table", "info", "--by", "quads", "small.hxt"),
                          "small.census.sqlite")

    def test_chart(self):
        words = ("table", "info", "small.hxt", "--by", "quads", "--svg")
        self.expect(0, self.hexatlas(*words, "a.svg"))
        drawing = ElementTree.fromstring(self.read("a.svg"))
        name = "{http://www.w3.org/2000/svg}"
        self.assertEqual(len(drawing.findall(f"{name}g")), 2)
        self.assertEqual(len(drawing.findall(f"{name}g/{name}rect")), 2)
        self.assertIn("10 quads: 1 quadrangulation", drawing.find(f"{name}desc").text)
        ran = self.expect(0, self.hexatlas(*words, "-", "--json"))
        self.assertEqual(ran.out.encode(), self.read("a.svg"))
        self.assertEqual(json.loads(ran.err)["entries"], 2)
        self.expect_fault(self.hexatlas(*words, "no/where.svg"), "no/where.svg")
        for options in (["--svg", "a.svg"], ["--by", "hexahedra"], ["--by"]):
            ran = self.expect(2, self.hexatlas("table", "info", "small.hxt", *options))
            self.assertRegex(ran.err, r"\Ahexatlas: [^\n]+\n\Z")


class Shipped(MeshTest):
    """Look-ups only; readme_test.py judges it as a whole."""

    def test_info(self):
        said = json.loads(self.expect(0, self.hexatlas("table", "info", "--json")).out)
        with open(SHIPPED, "rb") as file:
            self.assertEqual(said["sha256"], hashlib.sha256(file.read()).hexdigest())

    def test_its_named_meshes(self):
        names = json.loads(self.expect(0, self.hexatlas("table", "info", "--json")).out)["names"]
        self.assertIn("schneiders-pyramid", names)
        for name, entry in names.items():
            with self.subTest(name=name):
                said = json.loads(self.expect(0, self.hexatlas("table", "get", "--name", name)).out)
                self.expect_mesh(said)
                self.assertEqual((said["code"], said["hexahedra"]),
                                 (entry["code"], entry["hexahedra"]))


if __name__ == "__main__":
    program.main()
