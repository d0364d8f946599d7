"""Certificates of lower bounds drawn at random from a table, each judged.
usage: sample.py PROGRAM TABLE COUNT
"""
import json
import os
import random
import sqlite3
import subprocess
import sys
import tempfile

program, table, count = os.path.abspath(sys.argv[1]), sys.argv[2], int(sys.argv[3])
census = sqlite3.connect(table.removesuffix(".hxt") + ".census.sqlite")
rows = census.execute("SELECT quads, code, lower_bound FROM census WHERE lower_bound > 1 "
                      "ORDER BY code").fetchall()
drawn = random.Random(20261123).sample(rows, min(count, len(rows)))
print("quads", "certificates", "accepted", "records", "bytes", sep="\t")
tally = {}
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "bound.hxb")
    for quads, code, bound in drawn:
        made = subprocess.run([program, "enum", "hexmeshes", code, "--ball", "--max-hexes",
                               str(bound - 1), "--certificate", path, "--json"],
                              capture_output=True, text=True, check=True)
        judged = subprocess.run([program, "check", path], capture_output=True, check=False)
        said = json.loads(made.stdout)
        row = tally.setdefault(quads, [0, 0, 0, 0])
        for i, value in enumerate((1, judged.returncode == 0, said["records"], said["bytes"])):
            row[i] += value
for quads in sorted(tally):
    print(quads, *tally[quads], sep="\t")
