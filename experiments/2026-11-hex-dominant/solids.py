#!/usr/bin/env python3
"""Surfaces of solids as gmsh meshes them, with triangles packed as halves of squares (2D algorithm 9).

usage: solids.py FOLDER     writes NAME-SIZE.msh for each solid and size, with the program gmsh 4.8.4.
"""
import os
import subprocess
import sys

SOLIDS = {
    "box": "Box(1) = {0,0,0, 1,1,1};",
    "cylinder": "Cylinder(1) = {0,0,0, 0,0,2, 0.5, 2*Pi};",
    "plate": "Box(1) = {0,0,0, 2,2,0.5}; Cylinder(2) = {1,1,-1, 0,0,3, 0.4, 2*Pi};"
             "BooleanDifference(3) = {Volume{1}; Delete;}{Volume{2}; Delete;};",
    "wedge": "Wedge(1) = {0,0,0, 2,1,0.2, 0};",
    "ell": "Box(1) = {0,0,0, 2,1,1}; Box(2) = {0,0,1, 1,1,1};"
           "BooleanUnion(3) = {Volume{1}; Delete;}{Volume{2}; Delete;};",
    "shaft": "Cylinder(1) = {0,0,0, 0,0,1, 0.7, 2*Pi}; Cylinder(2) = {0,0,1, 0,0,1, 0.4, 2*Pi};"
             "BooleanUnion(3) = {Volume{1}; Delete;}{Volume{2}; Delete;};",
    "elbow": "Torus(1) = {0,0,0, 1.2, 0.4, Pi/2};",
    "sphere": "Sphere(1) = {0,0,0, 1};",
    "torus": "Torus(1) = {0,0,0, 1, 0.4};",
}
SIZES = ("0.1", "0.05")


def main():
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    for name, text in SOLIDS.items():
        for size in SIZES:
            path = os.path.join(folder, f"{name}-{size}")
            with open(path + ".geo", "w", encoding="utf-8") as file:
                file.write('SetFactory("OpenCASCADE");\n' + text + "\n")
            done = subprocess.run(["gmsh", path + ".geo", "-2", "-algo", "pack", "-clmin", size,
                                   "-clmax", size, "-o", path + ".msh"],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
            if done.returncode != 0:
                print(f"gmsh fails at {name} {size}", file=sys.stderr)


main()
