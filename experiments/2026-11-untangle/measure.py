"""Rows: harmonic places against those found, on one thread.
usage: measure.py PROGRAM INPUTS FOLDER
"""
import json
import os
import random
import subprocess
import sys

PROGRAM, INPUTS, FOLDER = sys.argv[1:]


def run(*arguments):
    ran = subprocess.run([PROGRAM, "mesh", *arguments, "-o", os.path.join(FOLDER, "out.vtu"), "--json",
                          "--threads", "1"], check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(ran.stdout)


def row(name, before, after, hexahedra, elapsed):
    print(name, hexahedra, *("%d\t%d\t%.4f" % (r["valid"], r["inverted"], r["min_scaled_jacobian"])
                             for r in (before, after)), "%.2f" % elapsed, sep="\t", flush=True)


def grid(name, n, amplitude):
    """n^3 cubes as Medit, inner points moved at random."""
    rng, m = random.Random(5), n + 1
    inside = range(1, n)
    with open(name, "w", encoding="ascii") as file:
        print("MeshVersionFormatted 2\nDimension 3\nVertices", m ** 3, file=file)
        for z in range(m):
            for y in range(m):
                for x in range(m):
                    moves = x in inside and y in inside and z in inside
                    print(*(k + amplitude * rng.uniform(-1, 1) if moves else k for k in (x, y, z)), 0,
                          file=file)
        print("Hexahedra", n ** 3, file=file)
        steps = (0, 1, 1 + m, m, m * m, m * m + 1, m * m + m + 1, m * m + m)
        for first in (1 + x + m * (y + m * z) for z in range(n) for y in range(n) for x in range(n)):
            print(*(first + step for step in steps), 0, file=file)
        print("End", file=file)
    return name


print("mesh", "hexahedra", "valid_before", "inverted_before", "least_before", "valid_after",
      "inverted_after", "least_after", "seconds", sep="\t")
for file_name in sorted(os.listdir(INPUTS)):
    path = os.path.join(INPUTS, file_name)
    start, end = run("hex", path, "--effort", "0"), run("hex", path)
    row(file_name.removesuffix(".obj"), start, end, end["hexahedra"], end["seconds"])
for size, moved, effort in ((20, 0.3, 10), (20, 0.8, 10), (67, 0.3, 1), (67, 0.3, 10), (67, 0.8, 10)):
    made = run("untangle", grid(os.path.join(FOLDER, "in.mesh"), size, moved), "--effort", str(effort))
    row(f"grid of {size}^3, points moved by up to {moved}, effort {effort}", made["before"],
        made["after"], made["hexahedra"], made["seconds"])
