#!/usr/bin/env python3
"""Writes gmsh-NAME.geo for each solid into a folder: OpenCASCADE solids of genus 0. gmsh -2 then
recombines triangles to quads and cuts all cells into quads. usage: solids.py FOLDER"""
import os
import sys

# name: (volumes, edge length before the cut into quads)
SOLIDS = {
    "box": ("Box(1) = {0, 0, 0, 3, 2, 1};", 0.5),
    "sphere": ("Sphere(1) = {0, 0, 0, 1};", 0.4),
    "cylinder": ("Cylinder(1) = {0, 0, 0, 0, 0, 2, 1};", 0.5),
    "cone": ("Cone(1) = {0, 0, 0, 0, 0, 2, 1, 0};", 0.4),
    "frustum": ("Cone(1) = {0, 0, 0, 0, 0, 2, 1, 0.5};", 0.4),
    "wedge": ("Wedge(1) = {0, 0, 0, 2, 1, 1, 0.5};", 0.4),
    "ellipsoid": ("Sphere(1) = {0, 0, 0, 1}; Dilate {{0, 0, 0}, {2, 1, 0.5}} { Volume{1}; }", 0.5),
    "blind-hole": ("Box(1) = {0, 0, 0, 2, 2, 2}; Cylinder(2) = {1, 1, 1, 0, 0, 2, 0.5};"
                   " BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }", 0.4),
    "l-shape": ("Box(1) = {0, 0, 0, 2, 2, 1}; Box(2) = {1, 1, -1, 2, 2, 3};"
                " BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }", 0.4),
    "two-boxes": ("Box(1) = {0, 0, 0, 2, 2, 1}; Box(2) = {1, 1, 0.5, 2, 2, 1};"
                  " BooleanUnion{ Volume{1}; Delete; }{ Volume{2}; Delete; }", 0.5),
    "rounded-box": ("Box(1) = {0, 0, 0, 2, 2, 1}; Fillet{1}{1, 3, 5, 7}{0.25}", 0.4),
    "box-and-sphere": ("Box(1) = {0, 0, 0, 2, 2, 2}; Sphere(2) = {2, 2, 2, 0.8};"
                       " BooleanUnion{ Volume{1}; Delete; }{ Volume{2}; Delete; }", 0.5),
    "notched-box": ("Box(1) = {0, 0, 0, 2, 2, 2}; Sphere(2) = {2, 2, 2, 1};"
                    " BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }", 0.5),
    "crossed-cylinders": ("Cylinder(1) = {-1.5, 0, 0, 3, 0, 0, 0.5};"
                          " Cylinder(2) = {0, -1.5, 0, 0, 3, 0, 0.4};"
                          " BooleanUnion{ Volume{1}; Delete; }{ Volume{2}; Delete; }", 0.35),
}

MESHING = """
Mesh.CharacteristicLengthMin = {size}; Mesh.CharacteristicLengthMax = {size};
Mesh.CharacteristicLengthFromCurvature = 0; Mesh.RandomSeed = 1;
Mesh.Algorithm = 6; Mesh.RecombineAll = 1; Mesh.RecombinationAlgorithm = 1;
Mesh.SubdivisionAlgorithm = 1; Mesh.MshFileVersion = 2.2;
"""


def main(folder):
    for name, (solid, size) in SOLIDS.items():
        with open(os.path.join(folder, "gmsh-" + name + ".geo"), "w", encoding="ascii") as file:
            file.write('SetFactory("OpenCASCADE");\n' + solid + MESHING.format(size=size))


if __name__ == "__main__":
    main(sys.argv[1])
