#!/usr/bin/env python3
"""Claim. `table info`, `get`, `check` and `build` say what a table holds, refuse tables that are
damaged, and write the same bytes for the same content; a build that is stopped leaves nothing.
Oracle. docs/formats/table.md and code.md, read again here and in tests/sabotage/reference_code.py;
hashlib; `hexatlas check` for the meshes that `get` prints.
"""
import hashlib
import json
import os
import signal
import sqlite3
import struct
import subprocess
import sys
import time
from xml.etree import ElementTree

import program
import surfaces

sys.path.insert(0, os.path.join(program.REPOSITORY, "tests", "sabotage"))
import reference_code  # noqa: E402

# A quick build: it finds meshes for the cube and two cubes.
QUICK = ("--max-quads", "6", "--width", "100", "--rounds", "1", "--growths", "0", "--collared", "0")
SMALL = (*QUICK, "--also", "two-cubes", "--max-hexahedra", "4")
SHIPPED = os.path.join(program.REPOSITORY, "tables", "data", "hexatlas.hxt")
HEADER, DIGEST = 128, 96


def signed(data):
    """The bytes with the digest that belongs to them."""
    data = bytearray(data)
    data[DIGEST:HEADER] = bytes(HEADER - DIGEST)
    data[DIGEST:HEADER] = hashlib.sha256(data).digest()
    return bytes(data)


def stacked_cubes():
    quads = list(reference_code.CUBE)
    reference_code.glue_cube(quads, 0)
    return quads


class TableTest(program.ProgramTest):
    def build(self, name, *options):
        return self.expect(0, self.hexatlas("table", "build", "-o", name, *SMALL, *options))

    def expect_mesh(self, said):
        keys = ["code", "quads", "hexahedra", "interior_vertices", "lower_bound", "boundary", "cells"]
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


class Build(TableTest):
    def test_same_bytes_for_any_number_of_threads(self):
        self.build("a.hxt", "-j", "1")
        self.build("b.hxt", "-j", "2")
        self.assertEqual(self.read("a.hxt"), self.read("b.hxt"))
        manifests = [json.loads(self.read(f"{name}.manifest.json")) for name in "ab"]
        for manifest in manifests:
            for key in ("command", "file"):
                del manifest[key]
        self.assertEqual(*manifests)

    def test_manifest(self):
        ran = self.build("small.hxt", "--seed", "5")
        self.assertEqual(self.listing(), ["small.census.sqlite", "small.hxt", "small.manifest.json"])
        data = self.read("small.hxt")
        digest = hashlib.sha256(data).hexdigest()
        self.assertEqual(ran.out, f"small.hxt: 2 meshes, {len(data)} bytes, sha256 {digest}\n")
        self.assertEqual(ran.err, "")
        manifest = json.loads(self.read("small.manifest.json"))
        self.assertEqual(list(manifest), ["format", "file", "bytes", "sha256", "entries",
                                          "complete_through", "by_quads",
                                          "names", "command", "seed", "program", "commit"])
        self.assertEqual(manifest["sha256"], digest)
        self.assertEqual(manifest["bytes"], len(data))
        self.assertEqual((manifest["seed"], manifest["complete_through"]), (5, 6))
        self.assertEqual(manifest["command"],
                         "hexatlas " + " ".join(["table", "build", "-o", "small.hxt", *SMALL, "--seed", "5"]))
        one = {"entries": 1, "least": 1, "greatest": 1, "total": 1}
        self.assertEqual(manifest["by_quads"]["6"], one)

    def test_what_would_be_in_vain_is_told_before_the_search(self):
        os.mkdir(self.path("folder.hxt"))
        os.mkdir(self.path("b.manifest.json"))
        for output, named in (("nowhere/a.hxt", "nowhere/a.hxt"), ("folder.hxt", "folder.hxt"),
                              ("b.hxt", "b.manifest.json"), ("c" * 300, "c" * 300),
                              ("c" * 250, "c" * 250 + ".manifest.json")):
            ran = self.hexatlas("table", "build", "-o", output, "--max-quads", "18")
            self.expect_fault(ran, named)
        for word in ("pyramid", "q1:", "q1:zz", "q1:08a5d", "q1:18a5df", "08a5df"):
            ran = self.hexatlas("table", "build", "-o", "a.hxt", "--max-quads", "18", "--also", word)
            self.expect_fault(ran, word)
        self.assertEqual(self.listing(), ["b.manifest.json", "folder.hxt"])

    def test_a_manifest_that_cannot_be_written(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        os.symlink("/dev/full", self.path("a.manifest.json"))
        ran = self.expect(5, self.hexatlas("table", "build", "-o", "a.hxt", *SMALL))
        self.assertEqual(ran.out, "")
        self.assertIn("the table a.hxt was written, its manifest or its census was not\n", ran.err)
        os.remove(self.path("a.manifest.json"))
        self.expect(0, self.hexatlas("table", "check", "a.hxt"))

    def test_seeds_are_whole_numbers_of_64_bits(self):
        for word, seed in (("0", 0), ("010", 10), ("9007199254740993", 2**53 + 1),
                           ("18446744073709551615", 2**64 - 1)):
            self.build("a.hxt", "--seed", word)
            self.assertEqual(json.loads(self.read("a.manifest.json"))["seed"], seed)
        for word in ("-1", "+1", "1e3", "1.5", "0x5", "seven", "", " 7", "7 ",
                     "18446744073709551616", "1" * 400):
            with self.subTest(seed=word):
                ran = self.expect(2, self.hexatlas("table", "build", "-o", "b.hxt", *SMALL,
                                                   "--seed", word))
                self.assertRegex(ran.err, r"\Ahexatlas: --seed: [^\n]+\n\Z")
        self.assertEqual(self.listing(), ["a.census.sqlite", "a.hxt", "a.manifest.json"])

    def test_wrong_options(self):
        for options in (["-o", "-"], ["-o", ""], ["--output="], ["-o", "a.hxt", "--max-quads", "40"],
                        ["-o", "a.hxt", "--max-quads", "ten"], ["-o", "a.hxt", "--seed", "-1"],
                        ["-o", "a.hxt", "-j", "0"], ["-o", "a.hxt", "--max-hexahedra", "0"], []):
            with self.subTest(options=options):
                ran = self.expect(2, self.hexatlas("table", "build", *options))
                self.assertRegex(ran.err, r"\Ahexatlas: [^\n]+\n\Z")
                self.assertEqual(self.listing(), [])

    def test_stopped_by_force(self):
        for delay in (0.05, 0.3):
            for number in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT):
                with subprocess.Popen(
                        [program.PROGRAM, "table", "build", "-o", "a.hxt", "--max-quads", "14", "-j",
                         "1"], cwd=self.folder, stdout=subprocess.PIPE,
                        stderr=subprocess.DEVNULL) as running:
                    time.sleep(delay)
                    running.send_signal(number)
                    self.assertEqual(running.communicate()[0], b"")
                self.assertNotEqual(running.returncode, 0)
                self.assertEqual(self.listing(), [])

    def test_what_is_not_found_is_said(self):
        ran = self.expect(4, self.hexatlas("table", "build", "-o", "a.hxt", *QUICK, "--also",
                                           "octagonal-spindle", "--max-hexahedra", "2"))
        self.assertEqual(ran.err, "hexatlas: no mesh found for q1:088a577f; it is not in the table\n")
        self.assertEqual(self.listing(), ["a.census.sqlite", "a.hxt", "a.manifest.json"])


class Read(TableTest):
    made = {}  # one build for all tests

    def setUp(self):
        super().setUp()
        if not self.made:
            self.build("small.hxt")
            self.made.update({name: self.read(name) for name in self.listing()})
        for name, data in self.made.items():
            self.write(name, data)
        self.good = self.made["small.hxt"]

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
        by_code = self.expect(0, self.hexatlas("table", "get", "--table", "small.hxt", "--code",
                                               said["code"]))
        literature = said.pop("literature")
        self.assertEqual(literature["hexahedra"], 2)
        self.assertEqual(json.loads(by_code.out), said)  # a code has no name
        to_file = self.expect(0, self.hexatlas("table", "get", "--table", "small.hxt", "--name",
                                               "two-cubes", "-o", "mesh.json"))
        self.assertEqual((to_file.out, self.read("mesh.json").decode()), ("", by_name.out))

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
        self.assertRegex(ran.err, r"\Ahexatlas: q1:02228a2a5777df7f \(16 quads\)[^\n]+\n\Z")

    def test_damaged_tables_are_refused_with_the_reason(self):
        def put(at, number, form="<I"):
            data = bytearray(self.good)
            struct.pack_into(form, data, at, number)
            return bytes(data)

        middle = len(self.good) // 2
        damages = {
            "empty": (b"", "empty"), "cut": (self.good[:-1], "truncated"),
            "half": (self.good[:middle], "truncated"), "header only": (self.good[:60], "not a table"),
            "longer": (self.good + b"\0", "truncated or damaged"),
            "magic": (b"HEXATLAS" + self.good[8:], "not a table"), "text": (b"text\n" * 99, "not a"),
            "version": (put(8, 1), "version 1"), "version, signed": (signed(put(8, 1)), "version 1"),
            "claim, signed": (signed(put(72, 7)), "damaged"),
            "zeros, signed": (signed(put(80, 1)), "damaged"),
            "byte order": (put(12, 0x0D0C0B0A), "byte order"),
            "one bit": (self.good[:middle] + bytes([self.good[middle] ^ 1]) +
                        self.good[middle + 1:], "SHA-256"),
            "entries, signed": (signed(put(24, 3, "<Q")), "damaged"),
            "sections, signed": (signed(put(32, 200)), "damaged"),
            "names, signed": (signed(put(40, 9)), "damaged"),
            "block size, signed": (signed(put(44, 0)), "damaged"),
        }
        self.write("cube.obj", surfaces.obj(*surfaces.cube()))
        for name, (data, said) in damages.items():
            with self.subTest(damage=name):
                self.write("bad.hxt", data)
                for words in (["table", "info", "bad.hxt"],
                              ["table", "get", "--table", "bad.hxt", "--name", "cube"],
                              ["mesh", "hex", "cube.obj", "-o", "a.vtk", "--table", "bad.hxt"]):
                    ran = self.hexatlas(*words)
                    self.expect_fault(ran, "bad.hxt")
                    self.assertIn(said, ran.err)
                ran = self.hexatlas("table", "check", "bad.hxt")
                self.assertIn(ran.code, (1, 3), ran)
                self.assertIn("bad.hxt: ", ran.out + ran.err)
        self.assertNotIn("a.vtk", self.listing())

    def test_check_finds_what_no_digest_shows(self):
        first = struct.unpack_from("<Q", self.good, 48)[0]  # the cube's entry, a key of 3 bytes
        for name, place in (("hexahedra", 3), ("interior vertices", 5), ("bound", 7), ("zero", 9)):
            data = bytearray(self.good)
            struct.pack_into("<H", data, first + place, 2)
            with self.subTest(field=name):
                self.write("bad.hxt", signed(data))
                ran = self.expect(1, self.hexatlas("table", "check", "bad.hxt"))
                self.assertRegex(ran.out, r"\Abad\.hxt: rejected: [^\n]+\n\Z")

    def test_check_reads_the_manifest(self):
        ran = self.expect(0, self.hexatlas("table", "check", "small.hxt"))
        self.assertIn("as its manifest says", ran.out)
        text = self.read("small.manifest.json").decode()
        digest = hashlib.sha256(self.good).hexdigest()
        self.write("small.manifest.json", text.replace(digest, "0" * 64))
        self.expect(1, self.hexatlas("table", "check", "small.hxt"))
        claims = json.loads(text)
        for key, value in (("format", "hexatlas table 1"), ("file", "other.hxt"), ("bytes", 1),
                           ("entries", 3), ("complete_through", 8), ("by_quads", {}), ("names", {}), ("more", 1)):
            with self.subTest(key=key):
                self.write("small.manifest.json",
                           json.dumps({**claims, key: value}, indent=2) + "\n")
                ran = self.expect(1, self.hexatlas("table", "check", "small.hxt"))
                self.assertRegex(ran.out, r"\Asmall\.hxt: rejected: [^\n]+manifest[^\n]+\n\Z")
        for other in (text.replace('"seed": 1', '"seed": 1.0'), text + "\n"):
            self.assertNotEqual(other, text)
            self.write("small.manifest.json", other)
            self.expect(1, self.hexatlas("table", "check", "small.hxt"))
        # Who made it, and how, a table cannot tell: that is only claimed.
        self.write("small.manifest.json", json.dumps({**claims, "seed": 9, "commit": "x"}, indent=2)
                   + "\n")
        self.expect(0, self.hexatlas("table", "check", "small.hxt"))
        for content in ("", "{}", "[]", "not json", text.replace('"entries": 2', '"entries": "x"')):
            self.write("small.manifest.json", content)
            self.expect_fault(self.hexatlas("table", "check", "small.hxt"), "small.manifest.json")
        os.remove(self.path("small.manifest.json"))
        ran = self.expect(0, self.hexatlas("table", "check", "small.hxt"))
        self.assertIn("no manifest", ran.out)

    def test_a_name_that_leaves_no_room_for_a_manifest(self):
        name = self.write("t" * 250, self.good)
        self.assertIn("no manifest", self.expect(0, self.hexatlas("table", "check", name)).out)

    def test_no_table(self):
        os.mkdir(self.path("folder.hxt"))
        for name in ("missing.hxt", "folder.hxt"):
            for verb in ("info", "check"):
                self.expect_fault(self.hexatlas("table", verb, name), name)


class Unclaimed(TableTest):
    def small(self):
        """A table without a census and a claim; its digest."""
        self.build("small.hxt")
        os.remove(self.path("small.census.sqlite"))
        os.remove(self.path("small.manifest.json"))
        data = bytearray(self.read("small.hxt"))
        struct.pack_into("<I", data, 72, 0)
        self.write("small.hxt", signed(data))
        return hashlib.sha256(signed(data)).hexdigest()


class ByQuads(Unclaimed):
    def census(self, digest, rows, program="p"):
        """Written here from docs/formats/census.md with Python's own SQLite."""
        def word(text):
            return f"{len(text)} {text}\n"
        path = self.path("small.census.sqlite")
        if os.path.exists(path):
            os.remove(path)
        about = (digest, program, "c")
        text = "".join(map(word, about))
        for code, *rest in sorted(rows):
            text += "".join(f"{number}\n" for number in rest[:6])
            text += "".join(map(word, (code, *rest[6:])))
        database = sqlite3.connect(path)
        database.executescript(
            "PRAGMA application_id = 1213743921; PRAGMA user_version = 1;"
            "CREATE TABLE about (format INTEGER NOT NULL, table_format INTEGER NOT NULL, "
            "table_sha256 TEXT NOT NULL, program TEXT NOT NULL, \"commit\" TEXT NOT NULL, "
            "rows_sha256 TEXT NOT NULL) STRICT;"
            "CREATE TABLE census (code TEXT NOT NULL PRIMARY KEY, quads INTEGER NOT NULL, "
            "automorphisms INTEGER NOT NULL, rotations INTEGER NOT NULL, hexahedra INTEGER NOT NULL, "
            "interior_vertices INTEGER NOT NULL, lower_bound INTEGER NOT NULL, source TEXT NOT NULL, "
            "found TEXT NOT NULL) STRICT, WITHOUT ROWID;")
        database.execute("INSERT INTO about VALUES (1, 2, ?, ?, ?, ?)",
                         (*about, hashlib.sha256(text.encode()).hexdigest()))
        database.executemany("INSERT INTO census VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", rows)
        database.commit()
        database.close()

    ROWS = [("q1:022972977f", 10, 16, 8, 2, 0, 1, "given", "2026-01-02"),
            ("q1:08a5df", 6, 48, 24, 1, 0, 1, "beam", "2026-01-03")]

    def test_without_a_census(self):
        self.small()
        ran = self.expect(0, self.hexatlas("table", "info", "small.hxt", "--by", "quads", "--json"))
        said = json.loads(ran.out)
        self.assertEqual(said["read_from"], "small.hxt")
        self.assertEqual(said["by_quads"]["10"],
                         {"entries": 1, "of": None, "least": 2, "mean": 2.0, "median": 2.0,
                          "greatest": 2, "total": 2, "distribution": {"2": 1}})
        text = self.expect(0, self.hexatlas("table", "info", "small.hxt", "--by", "quads")).out
        self.assertIn("10 quads  2:1\n", text)
        self.assertIn("makes no claim", text)

    def test_with_a_census(self):
        digest = self.small()
        self.census(digest, self.ROWS)
        ran = self.expect(0, self.hexatlas("table", "info", "small.hxt", "--by", "quads", "--json"))
        said = json.loads(ran.out)
        self.assertEqual(said["read_from"], "small.census.sqlite")
        self.assertEqual(said["by_quads"]["10"]["sources"], {"given": 1})
        text = self.expect(0, self.hexatlas("table", "info", "small.hxt", "--by", "quads")).out
        self.assertIn("read from small.census.sqlite", text)
        self.assertIn("6 quads  beam:1\n", text)
        ran = self.expect(0, self.hexatlas("table", "check", "small.hxt"))
        self.assertIn("; as its census says\n", ran.out)
        for name, rows, program, said in (
                ("a row less", self.ROWS[1:], "p", "1 row"),
                ("symmetry", [self.ROWS[0], self.ROWS[1][:2] + (24,) + self.ROWS[1][3:]], "p", "numbers"),
                ("hexahedra", [self.ROWS[0], self.ROWS[1][:4] + (2,) + self.ROWS[1][5:]], "p", "numbers"),
                ("another code", [self.ROWS[0], ("q1:088a577f",) + self.ROWS[1][1:]], "p", "not in")):
            with self.subTest(damage=name):
                self.census(digest, rows, program)
                ran = self.expect(1, self.hexatlas("table", "check", "small.hxt"))
                self.assertRegex(ran.out, r"\Asmall\.hxt: rejected: [^\n]+census[^\n]+\n\Z")
                self.assertIn(said, ran.out)
        self.census("0" * 64, self.ROWS)
        self.expect(1, self.hexatlas("table", "check", "small.hxt"))
        self.expect_fault(self.hexatlas("table", "info", "small.hxt", "--by", "quads"),
                          "small.census.sqlite")
        self.write("small.census.sqlite", b"no database")
        for verb in (["info", "--by", "quads"], ["check"]):
            self.expect_fault(self.hexatlas("table", *verb, "small.hxt"), "small.census.sqlite")

    def test_chart(self):
        self.small()
        words = ("table", "info", "small.hxt", "--by", "quads", "--svg")
        self.expect(0, self.hexatlas(*words, "a.svg"))
        drawing = ElementTree.fromstring(self.read("a.svg"))
        name = "{http://www.w3.org/2000/svg}"
        self.assertEqual(len(drawing.findall(f"{name}g")), 2)
        self.assertEqual(len(drawing.findall(f"{name}g/{name}rect")), 2)
        self.assertIn("10 quads: 1 quadrangulation", drawing.find(f"{name}desc").text)
        self.assertEqual(self.expect(0, self.hexatlas(*words, "-")).out.encode(), self.read("a.svg"))
        self.expect_fault(self.hexatlas(*words, "no/where.svg"), "no/where.svg")
        for options in (["--svg", "a.svg"], ["--by", "hexahedra"], ["--by"]):
            ran = self.expect(2, self.hexatlas("table", "info", "small.hxt", *options))
            self.assertRegex(ran.err, r"\Ahexatlas: [^\n]+\n\Z")


class Complete(Unclaimed):
    def test_a_table_without_a_claim(self):
        self.small()
        text = self.expect(0, self.hexatlas("table", "check", "small.hxt")).out
        self.assertIn("complete: all 3-connected quadrangulations with 6 quads\n"
                      "10 quads: 1 entry, rooted sum 5 of 29, not complete\n"
                      "it makes no claim to be complete\n", text)
        self.expect(0, self.hexatlas("table", "check", "small.hxt", "--complete-through", "6"))
        for quads in ("8", "10", "32"):
            ran = self.expect(1, self.hexatlas("table", "check", "small.hxt", "--complete-through",
                                               quads))
            self.assertIn(f"it is complete through 6 quads, not {quads}\n", ran.out)
        for quads in ("4", "34", "x"):
            self.expect(2, self.hexatlas("table", "check", "small.hxt", "--complete-through", quads))
        said = json.loads(self.expect(0, self.hexatlas("table", "check", "small.hxt", "--json")).out)
        self.assertEqual((said["accepted"], said["claimed_through"], said["complete_through"]),
                         (True, 0, 6))
        self.assertEqual(said["by_quads"]["10"]["rooted_all"], 29)

    def test_a_claim_that_is_false(self):
        self.small()
        data = bytearray(self.read("small.hxt"))
        for claim, code in ((6, 0), (8, 1)):
            struct.pack_into("<I", data, 72, claim)
            self.write("claims.hxt", signed(data))
            ran = self.expect(code, self.hexatlas("table", "check", "claims.hxt"))
        self.assertIn("with 8 quads the rooted sum is 0 of 4", ran.out)
        ran = self.expect(1, self.hexatlas("table", "check", "claims.hxt", "--json"))
        said = json.loads(ran.out)
        self.assertFalse(said["accepted"])
        self.assertIn("0 of 4", said["reason"])


class Shipped(TableTest):
    def test_the_table_of_the_program_is_accepted(self):
        ran = self.expect(0, self.hexatlas("table", "check"))
        self.assertIn("as its manifest says", ran.out)
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
