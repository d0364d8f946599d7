#!/usr/bin/env python3
"""A line for each surface: what `hexatlas mesh hybrid --fill lattice` makes of it.

usage: measure.py HEXATLAS FOLDER > result.tsv    each mesh is judged by `hexatlas check --hybrid`.
"""
import glob
import json
import os
import subprocess
import sys

COLUMNS = ("surface", "spacing", "tetrahedra", "candidates", "candidates_per_second", "hexahedra",
           "prisms", "pyramids", "tetrahedra_left", "hex_volume", "hex_volume_not_conforming",
           "given_up", "new_points", "min_hex", "min_other", "seconds", "judged")


def run(*arguments):
    return subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False)


def line(program, surface, mesh):
    name = os.path.basename(surface)[:-len(".msh")]
    plain = run(program, "mesh", "hybrid", surface, "--fill", "lattice", "-o", mesh,
                "--no-conforming", "--json")
    if plain.returncode != 0:
        return [name] + [plain.stderr.strip()] + [""] * (len(COLUMNS) - 2)
    plain = json.loads(plain.stdout)
    made = json.loads(run(program, "mesh", "hybrid", surface, "--fill", "lattice", "-o", mesh,
                          "--json").stdout)
    judged = run(program, "check", "--hybrid", mesh).returncode
    least = made["min_scaled_jacobian"]
    others = [least[k] for k in ("prisms", "pyramids", "tetrahedra") if made["selected"][k] > 0]
    found = made["candidates"]["hexahedra"]
    return [name, "%.4g" % made["lattice"]["spacing"], made["tetrahedra"], found,
            "%.0f" % (found / made["search_seconds"]), *made["selected"].values(),
            "%.4f" % made["volume_fraction"]["hexahedra"],
            "%.4f" % plain["volume_fraction"]["hexahedra"], made["given_up"], made["new_points"],
            "%.3f" % least["hexahedra"], "%.4f" % min(others, default=1), "%.2f" % made["seconds"],
            "accepted" if judged == 0 else "REJECTED"]


def main():
    program, folder = sys.argv[1:]
    print("\t".join(COLUMNS))
    for surface in sorted(glob.glob(os.path.join(folder, "*.msh"))):
        mesh = surface[:-len(".msh")] + ".vtu"
        print("\t".join(str(word) for word in line(program, surface, mesh)), flush=True)


main()
