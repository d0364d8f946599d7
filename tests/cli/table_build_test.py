#!/usr/bin/env python3
"""Claim. `table build` writes the same bytes for any number of threads, a manifest and a census
beside them, and tells before the search what would be in vain; a build that is stopped leaves
nothing.
Oracle. A second build; hashlib; the signals are sent from here.
"""
import contextlib
import hashlib
import itertools
import json
import os
import shlex
import signal
import sqlite3
import subprocess
import time
import unittest

import program
from table_files import QUICK, SMALL, WITH_CUTS

SHIPPED = os.path.join(program.REPOSITORY, "tables", "data", "hexatlas.hxt")


class Build(program.ProgramTest):
    def build(self, name, *options):
        return self.expect(0, self.hexatlas("table", "build", "-o", name, *SMALL, *options))

    def test_same_bytes_for_any_number_of_threads(self):
        for name, threads in (("a.hxt", "1"), ("b.hxt", "2")):
            self.expect(0, self.hexatlas("table", "build", "-o", name, *WITH_CUTS, "--also", "two-cubes",
                                         "--max-hexahedra", "4", "-j", threads))
        self.assertEqual(self.read("a.hxt"), self.read("b.hxt"))
        manifests = [json.loads(self.read(f"{name}.manifest.json")) for name in "ab"]
        for manifest in manifests:
            for key in ("command", "file"):
                del manifest[key]
        self.assertEqual(*manifests)

    def test_start_from_tables_and_a_search(self):
        self.build("a.hxt", "--state", "a.state")
        no_search = ("--max-quads", "6", "--also", "two-cubes", "--width", "100", "--rounds", "1",
                     "--max-hexahedra", "1", "--growths", "0", "--cut", "0", "--collared", "0",
                     "--symmetric-ball-hexahedra", "0")
        for files, said in ((["a.hxt"], "a.hxt: 1 mesh taken over\n"),
                            (["a.state", "a.hxt"], "a.hxt: 0 meshes taken over\n"),
                            (["a.state"], "")):
            ran = self.expect(0, self.hexatlas("table", "build", "-o", "b.hxt", *no_search,
                                               "--start-from", *files))
            self.assertEqual(ran.err.replace("hexatlas: ", ""), said)
            table, first = (json.loads(self.expect(0, self.hexatlas(
                "table", "info", name, "--by", "quads", "--json")).out) for name in ("b.hxt", "a.hxt"))
            self.assertEqual([row["total"] for row in table["by_quads"].values()],
                             [row["total"] for row in first["by_quads"].values()])
        ran = self.hexatlas("table", "build", "-o", "c.hxt", "--start-from", "a.state", "a.state")
        self.expect_fault(ran, "a.state")
        ran = self.hexatlas("table", "build", "-o", "c.hxt", *no_search, "--seed", "9", "--start-from", "a.state")
        self.expect_fault(ran, "a.state")
        self.assertRegex(ran.err, r"boundaries of at most [0-9]+ quads, [0-9]+ balls per boundary and level, "
                                  r"100 per level, seed 1\n\Z")
        for other in ("--irregular", "--simple-zones"):
            ran = self.hexatlas("table", "build", "-o", "c.hxt", *no_search, other, "2",
                                "--start-from", "a.state")
            self.expect_fault(ran, "a.state")
        self.write("d.hxt", b"neither a table nor a search")
        self.expect_fault(self.hexatlas("table", "build", "-o", "c.hxt", "--start-from", "d.hxt"),
                          "d.hxt")

    def rows(self, name):
        """Of each boundary of at most 12 quads: hexahedra, how and when they were found, and the mesh."""
        census = contextlib.closing(sqlite3.connect(self.path(name.replace(".hxt", ".census.sqlite"))))
        with census as database:
            rows = database.execute("SELECT code, hexahedra, source, found FROM census WHERE quads <= 12")
            return {code: (*row, json.loads(self.expect(0, self.hexatlas(
                "table", "get", "--table", name, "--code", code)).out)["cells"]) for code, *row in rows}

    def test_dates_are_read_before_the_search(self):
        for date in ("yesterday", "-1", "1e9", "253402300800", "9223372036854775808"):
            ran = self.hexatlas("table", "build", "-o", "a.hxt", *SMALL, env={"SOURCE_DATE_EPOCH": date})
            self.expect_fault(ran, "SOURCE_DATE_EPOCH")
        self.assertEqual(self.listing(), [])

    def test_a_saved_search_does_not_begin_anew(self):
        self.build("a.hxt", "--state", "a.state")
        ran = self.build("a.hxt", "--state", "a.state", "--start-from", "a.hxt")
        self.assertIn("note: a.state goes on with what it has", ran.err)

    def test_a_table_that_is_replaced_keeps_its_boundaries(self):
        self.build("a.hxt")
        before = {name: self.read(name) for name in self.listing()}
        search = ("--max-quads", "6", "--width", "1", "--rounds", "1", "--max-hexahedra", "1", "--growths", "0")
        os.symlink("a.hxt", self.path("link.hxt"))
        for name in ("a.hxt", "link.hxt"):
            ran = self.hexatlas("table", "build", "-o", "a.hxt", *search, "--start-from", name)
            self.expect_fault(ran, name)
            self.assertIn("1 mesh of other boundaries", ran.err)
        os.remove(self.path("link.hxt"))
        self.assertEqual({name: self.read(name) for name in self.listing()}, before)
        self.expect(0, self.hexatlas("table", "build", "-o", "a.hxt", *search, "--also", "two-cubes", "--start-from", "a.hxt"))
        self.assertEqual(self.read("a.hxt"), before["a.hxt"])

    def test_of_equal_meshes_those_of_the_first_table_stay(self):
        # The search finds most of these small meshes itself, in an order of its own.
        small = ("--max-quads", "12", *QUICK[4:], "--width", "1000", "--max-hexahedra", "6")
        self.hexatlas("table", "build", "-o", "own.hxt", *small, env={"SOURCE_DATE_EPOCH": "0"})
        rows = {name: self.rows(name) for name in ("own.hxt", SHIPPED)}
        self.assertEqual({row[2] for row in rows["own.hxt"].values()}, {"1970-01-01"})
        equal = [code for code, own in rows["own.hxt"].items() if own[0] == rows[SHIPPED][code][0]]
        self.assertTrue(any(rows["own.hxt"][code][-1] != rows[SHIPPED][code][-1] for code in equal))
        for names in (("own.hxt", SHIPPED), (SHIPPED, "own.hxt")):
            self.expect(0, self.hexatlas("table", "build", "-o", "both.hxt", *small, "--start-from", *names))
            for code, both in self.rows("both.hxt").items():
                known = [rows[name][code] for name in names if code in rows[name]]
                self.assertEqual(both, min(known, key=lambda row: row[0]), code)

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
        self.build("it's a table.hxt")
        command = json.loads(self.read("it's a table.manifest.json"))["command"]
        self.assertEqual(shlex.split(command), ["hexatlas", "table", "build", "-o", "it's a table.hxt", *SMALL])
        one = {"entries": 1, "least": 1, "greatest": 1, "total": 1}
        self.assertEqual(manifest["by_quads"]["6"], one)

    def test_what_would_be_in_vain_is_told_before_the_search(self):
        os.mkdir(self.path("folder.hxt"))
        os.mkdir(self.path("b.manifest.json"))
        for output, named in (("nowhere/a.hxt", "nowhere/a.hxt"), ("folder.hxt", "folder.hxt"),
                              ("b.hxt", "b.manifest.json"), ("c" * 300 + ".hxt", "c" * 300 + ".hxt"),
                              ("c" * 246 + ".hxt", "c" * 246 + ".manifest.json")):
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
        for options in (["-o", "-"], ["-o", ""], ["--output="], ["-o", "a.bak"], ["-o", "a.hxt", "--max-quads", "40"],
                        ["-o", "a.hxt", "--state", "-"], ["-o", "a.hxt", "--state", "a.hxt"],
                        ["-o", "a.hxt", "--state", "./a.manifest.json"],
                        ["-o", "a.hxt", "--state", self.path("a.census.sqlite")],
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

    def test_collars_are_as_thick_and_wide_as_asked_for(self):
        # A ball of 5 hexahedra, of which the sweep knows 2: a collar of 3 is wanted, with up to 20
        # quads inside.
        code = "q1:0208208a97979797ddff"
        found = {}
        for options in (("2", "26", "3000", "0"), ("3", "12", "3000", "0"), ("3", "26", "3000", "0"),
                        ("3", "30", "1", "1000")):
            thick, widest, width, narrow = options
            self.hexatlas("table", "build", "-o", "c.hxt", *WITH_CUTS[:-2], "--also", code, "--cut", "0",
                          "--max-hexahedra", "2", "--collared", "5", "--collar-hexahedra", thick,
                          "--collar-widest", widest, "--collar-width", width,
                          "--collar-narrow", narrow)
            ran = self.hexatlas("table", "get", "--table", "c.hxt", "--code", code)
            found[options] = json.loads(ran.out)["hexahedra"] if ran.code == 0 else None
        self.assertEqual(list(found.values()), [None, None, 5, 5])

    def test_symmetric_collars(self):
        # As above: a reflection exchanges two of the five hexahedra. The last two fill the cavity of the
        # other two with a symmetric ball.
        code = "q1:0208208a97979797ddff"
        found = {}
        for options in (("0", "3", "26", "500", "0"), ("5", "2", "26", "500", "0"), ("5", "3", "12", "500", "0"),
                        ("5", "3", "26", "500", "0"), ("5", "3", "36", "1", "0"),
                        ("0", "2", "26", "500", "3"), ("5", "2", "26", "500", "2"), ("5", "2", "26", "500", "3")):
            boundaries, thick, widest, width, balls = options
            self.hexatlas("table", "build", "-o", "c.hxt", *WITH_CUTS[:-4], "--also", code, "--cut", "0",
                          "--max-hexahedra", "2", "--collared", "0", "--symmetric", boundaries,
                          "--symmetric-hexahedra", thick, "--symmetric-widest", widest,
                          "--symmetric-width", width, "--symmetric-ball-hexahedra", balls,
                          "--symmetric-ball-width", "100", "--symmetric-ball-widest", "22")
            ran = self.hexatlas("table", "get", "--table", "c.hxt", "--code", code)
            found[options] = json.loads(ran.out)["hexahedra"] if ran.code == 0 else None
        self.assertEqual(list(found.values()), [None, None, None, 5, 5, None, None, 5])

    @unittest.skipIf(program.SANITIZED, "tests/enum/flips and tests/tables/build anneal there")
    def test_annealing(self):
        # Two balls joined along a disc have some 70 hexahedra; the best known mesh has 35.
        code = "q1:0088a572a5ddff"
        known = ("--max-quads", "12", "--width", "300", *WITH_CUTS[4:], "--max-hexahedra", "8")
        self.hexatlas("table", "build", "-o", "known.hxt", *known, "--cut", "0", "--start-from", SHIPPED)
        found = {"0": [], "1": []}
        for seed, boundaries in itertools.product(program.share_of(("1", "2", "3")), found):
            self.hexatlas("table", "build", "-o", "a.hxt", *known, "--also", code, "--start-from", "known.hxt",
                          "--per-class", "5", "--cut", "1", "--cuts-each", "1", "--seed", seed,
                          "--annealed", boundaries, "--anneal-starts", "2", "--anneal-rounds", "20",
                          "--anneal-leaps", "2", "--anneal-faulty", "3", "--anneal-cut", "3", "--anneal-transplant", "3",
                          "--collar-width", "300", "--symmetric-width", "100", "--symmetric-ball-hexahedra", "8")
            ran = self.expect(0, self.hexatlas("table", "get", "--table", "a.hxt", "--code", code))
            found[boundaries].append(json.loads(ran.out)["hexahedra"])
        self.assertTrue(all(a <= b for a, b in zip(found["1"], found["0"])), found)
        self.assertLess(sum(found["1"]), sum(found["0"]))


if __name__ == "__main__":
    program.main()
