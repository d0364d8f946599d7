"""Rows: the meshes of the table with at most 8 hexahedra, on Koebe polyhedra and with a free boundary.
usage: small.py PROGRAM TABLE_WITHOUT_EXTENSION FOLDER
"""
import json
import os
import sqlite3
import subprocess
import sys

PROGRAM, TABLE, FOLDER = sys.argv[1:]


def placed(code, *options):
    ran = subprocess.run([PROGRAM, "mesh", "boundary", code, "-o", os.path.join(FOLDER, "out.vtu"),
                          "--table", TABLE + ".hxt", "--json", "--threads", "1", *options],
                         check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(ran.stdout)


census = sqlite3.connect(f"file:{TABLE}.census.sqlite?mode=ro", uri=True)
print("code", "quads", "hexahedra", "valid_convex", "least_convex", "valid_free", "least_free", "seconds",
      sep="\t")
for code, quads, hexahedra in census.execute(
        "SELECT code, quads, hexahedra FROM census WHERE hexahedra <= 8 ORDER BY hexahedra, code"):
    convex, free = placed(code), placed(code, "--free-boundary")
    print(code, quads, hexahedra, convex["valid"], "%.4f" % convex["min_scaled_jacobian"],
          free["valid"], "%.4f" % free["min_scaled_jacobian"],
          "%.2f" % (convex["seconds"] + free["seconds"]), sep="\t", flush=True)
