#!/usr/bin/env python3
"""Meshes quad surfaces by the construction and judges the meshes; a line of result.tsv for each.

usage: measure.py PROGRAM random COUNT    so many random surfaces of 24 to 2000 quads
       measure.py PROGRAM scaling MOST    random surfaces of 100, 200, 500, ... MOST quads
       measure.py PROGRAM file FILE ...   surfaces of files, also with the default effort
"""
import json
import math
import os
import random
import subprocess
import sys
import tempfile

import random_quads

COLUMNS = ("name", "quads", "hexahedra", "per_quad", "seconds", "valid_effort_0", "valid_default",
           "judged", "remark")


def run(*arguments):
    done = subprocess.run(arguments, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr.strip().rsplit("\n", 1)[-1]


def mesh(program, surface, output, *options):
    """What --json says, or the reason for which there is no mesh."""
    code, out, err = run(program, "mesh", "hex", surface, "-o", output, "--method", "construction",
                         "--threads", "1", "--json", *options)
    if code == 0:
        return json.loads(out), ""
    return None, err.replace("hexatlas: ", "").replace(os.path.dirname(surface) + "/", "")


def line(program, name, surface, folder, with_default):
    output = os.path.join(folder, "out.vtk")
    said, reason = mesh(program, surface, output, "--effort", "0")
    if said is None:
        return name, "-", "-", "-", "-", "-", "-", "-", reason
    default = "-"
    if with_default:
        placed, _ = mesh(program, surface, os.path.join(folder, "default.vtk"))
        default = f"{placed['valid'] / placed['hexahedra']:.4f}"
    code, out, _ = run(program, "check", output, "--boundary", surface, "--json")
    judged = "accepted" if code == 0 and json.loads(out)["accepted"] else f"exit {code}"
    return (name, said["quads"], said["hexahedra"], f"{said['hexahedra_per_quad']:.3f}",
            f"{said['seconds']:.2f}", f"{said['valid'] / said['hexahedra']:.4f}", default, judged,
            "")


def random_surface(folder, quads, seed, inserted):
    path = os.path.join(folder, "random.obj")
    with open(path, "w", encoding="ascii") as file:
        subprocess.run([sys.executable, "-B", random_quads.__file__, str(quads), str(seed),
                        str(inserted)], stdout=file, check=True)
    return path


def surfaces(kind, number):
    """Quads, and the part of insertions, of the random surfaces; the first are the same for any
    number of them."""
    if kind == "scaling":
        sizes = [m * 10 ** e for e in range(2, 6) for m in (1, 2, 5)]
        return [(size, 0.3) for size in sizes if size <= number]
    result = []
    for seed in range(number):
        rng = random.Random(seed)
        quads = 2 * round(math.exp(rng.uniform(math.log(12), math.log(1000))))
        result.append((quads, round(rng.uniform(0.05, 0.9), 3)))
    return result


def main(program, kind, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        if kind == "file":
            for path in arguments:
                name = os.path.splitext(os.path.basename(path))[0]
                print(*line(program, name, path, folder, True), sep="\t", flush=True)
            return
        for seed, (quads, inserted) in enumerate(surfaces(kind, int(arguments[0]))):
            surface = random_surface(folder, quads, seed, inserted)
            print(*line(program, f"{kind}-{seed}-{inserted}", surface, folder, False), sep="\t",
                  flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        print(*COLUMNS, sep="\t")
    else:
        main(os.path.abspath(sys.argv[1]), *sys.argv[2:])
