#!/usr/bin/env python3
"""Claim. `table check` accepts a table that is as it says, as its manifest and its census say, and
complete as far as it claims; all verbs refuse tables that are damaged, with the reason.
Oracle. The damage is put in here, at places from docs/formats/table.md; hashlib; a census that
table_files.py writes; the numbers of rooted quadrangulations of the literature.
"""
import contextlib
import hashlib
import json
import os
import re
import sqlite3
import struct

import program
import surfaces
from table_files import CENSUS_ROWS, TableTest, UnclaimedTest, signed, write_census


class Besides(TableTest):
    """What lies beside the table."""

    def expect_damaged(self, name):
        """The answer is no, and an object with --json."""
        ran = self.expect(1, self.hexatlas("table", "check", "small.hxt"))
        self.assertRegex(ran.out, r"\Asmall\.hxt: rejected: beside it, " + re.escape(name) + r": is (not a|damaged)[^\n]+\n\Z")
        said = json.loads(self.expect(1, self.hexatlas("table", "check", "small.hxt", "--json")).out)
        self.assertFalse(said["accepted"])
        self.assertIn(name, said["reason"])


class Damage(TableTest):
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
        for name, (data, said) in program.share_of(list(damages.items()), least=5):
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

    def test_lower_bounds_are_called_claims(self):
        key = bytes.fromhex("022972977f")  # two cubes
        data = bytearray(self.good)
        struct.pack_into("<H", data, data.index(key) + len(key) + 4, 2)
        self.write("bound.hxt", signed(data))
        ran = self.expect(0, self.hexatlas("table", "check", "bound.hxt"))
        self.assertIn("1 lower bound: a claim that nothing here proves\n", ran.out)
        ran = self.expect(0, self.hexatlas("table", "check", "bound.hxt", "--json"))
        self.assertEqual(json.loads(ran.out)["claimed_bounds"], 1)
        self.write("good.hxt", self.good)
        self.assertNotIn("bound", self.expect(0, self.hexatlas("table", "check", "good.hxt")).out)

    def test_check_finds_what_no_digest_shows(self):
        first = struct.unpack_from("<Q", self.good, 48)[0]  # the cube's entry, a key of 3 bytes
        for name, place in (("hexahedra", 3), ("interior vertices", 5), ("bound", 7), ("zero", 9)):
            data = bytearray(self.good)
            struct.pack_into("<H", data, first + place, 2)
            with self.subTest(field=name):
                self.write("bad.hxt", signed(data))
                ran = self.expect(1, self.hexatlas("table", "check", "bad.hxt"))
                self.assertRegex(ran.out, r"\Abad\.hxt: rejected: [^\n]+\n\Z")


class Shares(TableTest):
    def test_each_mesh_is_judged_in_one_share(self):
        self.write("good.hxt", self.good)
        entries = struct.unpack_from("<Q", self.good, 24)[0]
        judged = []
        for part in range(3):
            shard = f"{part}/3"
            said = json.loads(self.expect(0, self.hexatlas("table", "check", "good.hxt", "--json",
                                                           "--shard", shard)).out)
            self.assertEqual((said["shard"], said["accepted"]), (shard, True))
            self.assertEqual(said["entries"], entries)
            judged.append(said["judged_meshes"])
            text = self.expect(0, self.hexatlas("table", "check", "good.hxt", "--shard", shard)).out
            self.assertIn(f"good.hxt: share {shard} accepted, {judged[-1]} of {entries} meshes judged: ", text)
        self.assertEqual(sum(judged), entries)
        whole = json.loads(self.expect(0, self.hexatlas("table", "check", "good.hxt", "--json")).out)
        self.assertNotIn("shard", whole)
        self.assertEqual(whole["judged_meshes"], entries)

    def test_what_is_no_share(self):
        for shard in ("3/3", "1", "-1/2", "0/0", "a/b"):
            self.assertIn("--shard", self.expect(2, self.hexatlas("table", "check", "--shard", shard)).err)


class Manifest(Besides):
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
            self.expect_damaged("small.manifest.json")
        os.remove(self.path("small.manifest.json"))
        ran = self.expect(0, self.hexatlas("table", "check", "small.hxt"))
        self.assertIn("no manifest", ran.out)

    def test_a_name_that_leaves_no_room_for_a_manifest(self):
        name = self.write("t" * 250, self.good)
        self.assertIn("no manifest", self.expect(0, self.hexatlas("table", "check", name)).out)


class Census(Besides, UnclaimedTest):
    def test_check_reads_the_census(self):
        census, digest = self.path("small.census.sqlite"), hashlib.sha256(self.good).hexdigest()
        write_census(census, digest, CENSUS_ROWS)
        ran = self.expect(0, self.hexatlas("table", "check", "small.hxt"))
        self.assertIn("; as its census says\n", ran.out)
        os.rename(census, self.path("kept"))
        for link in (False, True):  # the link leads to nothing
            if link:
                os.symlink("nowhere", census)
            self.assertIn("; no census beside it\n", self.expect(0, self.hexatlas("table", "check", "small.hxt")).out)
        os.rename(self.path("kept"), census)
        two, one = CENSUS_ROWS
        for name, rows, said in (
                ("a row less", [one], "1 row"),
                ("symmetry", [two, one[:2] + (24,) + one[3:]], "numbers"),
                ("hexahedra", [two, one[:4] + (2,) + one[5:]], "numbers"),
                ("another code", [two, ("q1:088a577f",) + one[1:]], "not in")):
            with self.subTest(damage=name):
                write_census(census, digest, rows)
                ran = self.expect(1, self.hexatlas("table", "check", "small.hxt"))
                self.assertRegex(ran.out, r"\Asmall\.hxt: rejected: [^\n]+census[^\n]+\n\Z")
                self.assertIn(said, ran.out)
        for change in ("UPDATE census SET hexahedra = hexahedra + 4294967296",
                       "UPDATE census SET lower_bound = lower_bound - 4294967296",
                       "UPDATE about SET format = 2",
                       "INSERT INTO about SELECT * FROM about",
                       "UPDATE about SET format = 4294967297"):
            with self.subTest(change=change):
                write_census(census, digest, CENSUS_ROWS)
                with contextlib.closing(sqlite3.connect(census)) as database, database:
                    database.execute(change)
                self.expect_damaged("small.census.sqlite")
        write_census(census, "0" * 64, CENSUS_ROWS)
        self.expect(1, self.hexatlas("table", "check", "small.hxt"))
        self.write("small.census.sqlite", b"no database")
        self.expect_damaged("small.census.sqlite")


class Complete(UnclaimedTest):
    def test_a_table_without_a_claim(self):
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
        data = bytearray(self.good)
        for claim, code in ((6, 0), (8, 1)):
            struct.pack_into("<I", data, 72, claim)
            self.write("claims.hxt", signed(data))
            ran = self.expect(code, self.hexatlas("table", "check", "claims.hxt"))
        self.assertIn("with 8 quads the rooted sum is 0 of 4", ran.out)
        ran = self.expect(1, self.hexatlas("table", "check", "claims.hxt", "--json"))
        said = json.loads(ran.out)
        self.assertFalse(said["accepted"])
        self.assertIn("0 of 4", said["reason"])


if __name__ == "__main__":
    program.main()
