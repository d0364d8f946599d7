"""Lower bounds and proven minima of a table, per number of quads, from its census.
usage: bounds.py TABLE
"""
import collections
import sqlite3
import sys

census = sqlite3.connect(sys.argv[1].removesuffix(".hxt") + ".census.sqlite")
print("quads", "meshes", "proven smallest", "bounds of the others", sep="\t")
for (quads,) in census.execute("SELECT DISTINCT quads FROM census ORDER BY quads").fetchall():
    rows = census.execute("SELECT hexahedra, lower_bound FROM census WHERE quads = ?",
                          (quads,)).fetchall()
    open_ones = collections.Counter(bound for size, bound in rows if bound < size)
    print(quads, len(rows), sum(size == bound for size, bound in rows),
          " ".join(f"{bound}:{count}" for bound, count in sorted(open_ones.items())) or "-", sep="\t")
