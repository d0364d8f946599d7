#!/usr/bin/env python3
"""Asks for meshes of random boundaries that are not in the table. Prints time and success.

usage: queries.py PROGRAM TABLE QUADS NUMBER
"""
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time

PARTS, SHARDS = 200, 10


def faces_of(record):
    """The vertices and the quads of a map in planar code."""
    vertices, at, around = record[0], 1, []
    for _ in range(vertices):
        end = record.index(0, at)
        around.append([v - 1 for v in record[at:end]])
        at = end + 1
    quads, seen = [], set()
    for v in range(vertices):
        for w in around[v]:
            quad, a, b = [], v, w
            while (a, b) not in seen:
                seen.add((a, b))
                quad.append(a)
                ring = around[b]
                a, b = b, ring[(ring.index(a) + 1) % len(ring)]
            if quad:
                quads.append(quad)
    return vertices, quads


def some_of(program, quads, number, draw, path):
    """So many maps at random from a random shard of all 3-connected ones."""
    subprocess.run([program, "enum", "quadrangulations", "--quads", str(quads), "--shard",
                    f"{draw.randrange(PARTS)}/{PARTS}", "-o", path], check=True,
                   stdout=subprocess.DEVNULL)
    with open(path, "rb") as file:
        data = file.read()[len(b">>planar_code<<"):]
    size = 1 + 4 * quads + quads + 2  # a number of vertices, neighbours, a zero per vertex
    places = draw.sample(range(len(data) // size), min(number, len(data) // size))
    return [faces_of(data[size * i:size * (i + 1)]) for i in places]


def main():
    program, table = (os.path.abspath(path) for path in sys.argv[1:3])
    quads, number = (int(word) for word in sys.argv[3:5])
    draw = random.Random(quads)
    times, hexahedra, misses = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        while len(times) < number:
            wanted = min(number - len(times), max(1, number // SHARDS))
            for vertices, faces in some_of(program, quads, wanted, draw,
                                           os.path.join(folder, "list")):
                with open(os.path.join(folder, "s.off"), "w", encoding="ascii") as file:
                    file.write(f"OFF\n{vertices} {len(faces)} 0\n")
                    file.writelines(f"{v} {v * v} {v ** 3}\n" for v in range(vertices))
                    file.writelines("4 " + " ".join(map(str, f)) + "\n" for f in faces)
                code = subprocess.run([program, "code", os.path.join(folder, "s.off")], check=True,
                                      capture_output=True, text=True).stdout.split()[0]
                began = time.perf_counter()
                ran = subprocess.run([program, "table", "get", "--table", table, "--code", code, "--search"],
                                     check=False, capture_output=True, text=True)
                times.append(time.perf_counter() - began)
                if ran.returncode == 0:
                    hexahedra.append(json.loads(ran.stdout)["hexahedra"])
                else:
                    misses += 1
    times.sort()
    print(os.path.basename(table), quads, number, f"{100 * (number - misses) / number:.1f}", f"{statistics.median(times):.3f}",
          f"{times[int(0.95 * number)]:.3f}", f"{times[-1]:.3f}", f"{statistics.mean(hexahedra):.1f}",
          max(hexahedra), sep="\t")


main()
