#!/usr/bin/env python3
"""When a mesh of each size was first in the table that this repository shipped.

usage: dates.py CENSUS
Each merge of tables used to date all meshes anew. This sets `found` in a copy of the shipped census to the
date that the first of the shipped ones, from which on a boundary has as many hexahedra as in CENSUS, has for
it; later merges keep what they are given (table build --start-from). A boundary whose number no shipped census
has keeps its date.
"""
import hashlib
import os
import sqlite3
import subprocess
import sys

SHIPPED = "tables/data/hexatlas.census.sqlite"
NUMBERS = "quads, automorphisms, rotations, hexahedra, interior_vertices, lower_bound"


def git(*words):
    return subprocess.run(["git", *words], check=True, stdout=subprocess.PIPE,
                          cwd=os.path.dirname(os.path.abspath(__file__))).stdout


def sizes_of(census):
    """Hexahedra and date of each boundary, by code."""
    database = sqlite3.connect(":memory:")
    database.deserialize(census)
    rows = database.execute("SELECT code, hexahedra, found FROM census")
    return {code: (hexahedra, found) for code, hexahedra, found in rows}


def first_dates(sizes):
    """By code: since when it has had its present size; `sizes`: of each version, the oldest first."""
    since = {}
    for version in sizes:
        for code, (hexahedra, found) in version.items():
            if since.get(code, (None,))[0] != hexahedra:
                since[code] = (hexahedra, found)
    return since


def word(text):
    return f"{len(text.encode())} {text}\n"


def digest_of(database):
    """docs/formats/census.md."""
    text = "".join(map(word, database.execute('SELECT table_sha256, program, "commit" FROM about').fetchone()))
    rows = database.execute(f"SELECT {NUMBERS}, code, source, found FROM census ORDER BY code")
    for *numbers, code, source, found in rows:
        text += "".join(f"{number}\n" for number in numbers) + word(code) + word(source) + word(found)
    return hashlib.sha256(text.encode()).hexdigest()


def main():
    commits = git("log", "--reverse", "--format=%H", "--", f":/{SHIPPED}").decode().split()
    since = first_dates(sizes_of(git("show", f"{commit}:{SHIPPED}")) for commit in commits)
    database = sqlite3.connect(sys.argv[1])
    kept = database.execute("SELECT rows_sha256 FROM about").fetchone()[0]
    if digest_of(database) != kept:
        sys.exit(f"{sys.argv[1]}: its digest is not that of its rows")
    with database:
        database.executemany(
            "UPDATE census SET found = ? WHERE code = ? AND hexahedra = ?",
            [(found, code, hexahedra) for code, (hexahedra, found) in since.items()])
        database.execute("UPDATE about SET rows_sha256 = ?", (digest_of(database),))
    database.execute("VACUUM")
    for found, count in database.execute("SELECT found, count(*) FROM census GROUP BY found ORDER BY found"):
        print(found, count, sep="\t")


if __name__ == "__main__":
    main()
