#!/usr/bin/env python3
"""Asks for meshes of random boundaries that are not in the table. Prints time and success.

usage: queries.py PROGRAM QUADS NUMBER
"""
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time

CLASSES = {22: 598102, 24: 7437910}


def maps(data):
    """Lists of quads of a planar code file."""
    at = len(b">>planar_code<<")
    while at < len(data):
        vertices, at = data[at], at + 1
        around = []
        for _ in range(vertices):
            end = data.index(0, at)
            around.append([v - 1 for v in data[at:end]])
            at = end + 1
        quads, seen = [], set()
        for v in range(vertices):
            for w in around[v]:
                if (v, w) in seen:
                    continue
                quad, a, b = [], v, w
                while (a, b) not in seen:
                    seen.add((a, b))
                    quad.append(a)
                    ring = around[b]
                    a, b = b, ring[(ring.index(a) + 1) % len(ring)]
                quads.append(quad)
        yield vertices, quads


def main():
    program, quads, number = os.path.abspath(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    draw = random.Random(quads)
    times, hexahedra, misses = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        while len(times) < number:
            parts = max(1, CLASSES[quads] // 200)
            shard = f"{draw.randrange(parts)}/{parts}"
            subprocess.run([program, "enum", "quadrangulations", "--quads", str(quads), "--shard",
                            shard, "-o", os.path.join(folder, "list")], check=True,
                           stdout=subprocess.DEVNULL)
            with open(os.path.join(folder, "list"), "rb") as file:
                found = list(maps(file.read()))
            for vertices, faces in draw.sample(found, min(20, len(found), number - len(times))):
                with open(os.path.join(folder, "s.off"), "w", encoding="ascii") as file:
                    file.write(f"OFF\n{vertices} {len(faces)} 0\n")
                    file.writelines(f"{v} {v * v} {v ** 3}\n" for v in range(vertices))
                    file.writelines("4 " + " ".join(map(str, f)) + "\n" for f in faces)
                code = subprocess.run([program, "code", os.path.join(folder, "s.off")], check=True,
                                      capture_output=True, text=True).stdout.split()[0]
                began = time.perf_counter()
                ran = subprocess.run([program, "table", "get", "--code", code, "--search"],
                                     check=False, capture_output=True, text=True)
                times.append(time.perf_counter() - began)
                if ran.returncode == 0:
                    hexahedra.append(json.loads(ran.stdout)["hexahedra"])
                else:
                    misses += 1
    times.sort()
    print(quads, number, f"{100 * (number - misses) / number:.1f}", f"{statistics.median(times):.3f}",
          f"{times[int(0.95 * number)]:.3f}", f"{times[-1]:.3f}", f"{statistics.mean(hexahedra):.1f}",
          max(hexahedra), sep="\t")


main()
