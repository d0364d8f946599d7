"""A small table, the bytes of tables and their census, for the tests of `hexatlas table`."""
import hashlib
import os
import sqlite3
import struct

import program

# A quick build: it finds meshes for the cube and two cubes.
WITH_CUTS = ("--max-quads", "6", "--width", "100", "--rounds", "1", "--growths", "0", "--symmetric", "0",
             "--collared", "0")
QUICK = (*WITH_CUTS, "--cut", "0")
SMALL = (*QUICK, "--also", "two-cubes", "--max-hexahedra", "4")
HEADER, DIGEST = 128, 96
# What a census of the small table may say.
CENSUS_ROWS = [("q1:022972977f", 10, 16, 8, 2, 0, 1, "given", "2026-01-02"),
               ("q1:08a5df", 6, 48, 24, 1, 0, 1, "beam", "2026-01-03")]


def signed(data):
    """The bytes with the digest that belongs to them."""
    data = bytearray(data)
    data[DIGEST:HEADER] = bytes(HEADER - DIGEST)
    data[DIGEST:HEADER] = hashlib.sha256(data).digest()
    return bytes(data)


def with_claim(data, quads):
    """The same table, but it claims to be complete through so many quads; 0: not to be."""
    data = bytearray(data)
    struct.pack_into("<I", data, 72, quads)
    return signed(data)


def without_claim(data):
    return with_claim(data, 0)


def write_census(path, digest, rows):
    """Written here from docs/formats/census.md with Python's own SQLite."""
    def word(text):
        return f"{len(text)} {text}\n"
    if os.path.exists(path):
        os.remove(path)
    about = (digest, "p", "c")
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


class TableTest(program.ProgramTest):
    """Each test has small.hxt with its manifest and census in its folder, built once per class."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.made = program.made_by("table", "build", "-o", "small.hxt", *SMALL)

    def setUp(self):
        super().setUp()
        for name, data in self.made.items():
            self.write(name, data)
        self.good = self.made["small.hxt"]


class UnclaimedTest(TableTest):
    """In each test small.hxt makes no claim, and no manifest and no census is beside it."""

    def setUp(self):
        super().setUp()
        for name in self.made:
            os.remove(self.path(name))
        self.good = without_claim(self.good)
        self.write("small.hxt", self.good)
