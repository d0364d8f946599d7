"""Claim. The objects that the program prints have the keys that docs/formats/json.md lists, and no others.
Oracle. The tables of that page, read here."""
import json
import os
import re

import program
import surfaces
from table_files import TableTest

PAGE = os.path.join(program.REPOSITORY, "docs", "formats", "json.md")
DATA = os.path.join(program.REPOSITORY, "tables", "data")
PYRAMID = os.path.join(program.INPUTS, "schneiders-pyramid.obj")
SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"
# Objects whose keys are data, and those that may be null.
MAPS = ("by_quads", "by_tetrahedra", "by_hexes", "by_bound", "classes", "names", "distribution", "sources")
OR_NULL = ("literature",)

# By section: exit code and command. Later ones use the files of earlier ones.
MESHES = [
    ("mesh hex", 0, ["mesh", "hex", PYRAMID, "-o", "pyramid.vtk"]),
    ("mesh hex", 1, ["mesh", "hex", "odd.obj", "-o", "none.vtk"]),
    ("mesh boundary", 0, ["mesh", "boundary", "cube", "-o", "cube.vtk"]),
    ("mesh boundary", 1, ["mesh", "boundary", "odd.obj", "-o", "none.vtk"]),
    ("mesh boundary", 4, ["mesh", "boundary", "octagonal-spindle", "-o", "none.vtk", "--table", "small.hxt"]),
    ("mesh untangle", 0, ["mesh", "untangle", "pyramid.vtk", "-o", "untangled.vtk", "--effort", "0"]),
    ("mesh delaunay", 0, ["mesh", "delaunay", "points.xyz", "-o", "points.vtu"]),
    ("mesh delaunay", 1, ["mesh", "delaunay", "plane.xyz"]),
    ("mesh hybrid", 0, ["mesh", "hybrid", "box.obj", "--fill", "lattice", "-o", "box.vtu"]),
    ("mesh quads", 0, ["mesh", "quads", "square.obj", "-o", "square.off"]),
    ("simplify", 0, ["simplify", "cube.vtk", "-o", "simple.vtk"]),
    ("check", 0, ["check", "pyramid.vtk"]),
    ("check --hybrid", 0, ["check", "--hybrid", "box.vtu"]),
    ("check --delaunay", 0, ["check", "--delaunay", "points.vtu"]),
    ("code", 0, ["code", PYRAMID]),
]
TABLES = [
    ("table info", 0, ["table", "info", "small.hxt"]),
    ("table info --by quads", 0, ["table", "info", "small.hxt", "--by", "quads"]),
    ("table info --by quads", 0, ["table", "info", "bare.hxt", "--by", "quads"]),
    ("table get", 0, ["table", "get", "--name", "cube"]),
    ("table check", 0, ["table", "check", "small.hxt", "--shard", "0/1"]),
    ("table bounds", 0, ["table", "bounds", "small.hxt", "-o", "bounds.hxt", "--max-hexes", "2"]),
]
ENUMERATIONS = [
    ("enum quadrangulations", 0, ["enum", "quadrangulations", "--quads", "10", "--shard", "0/2"]),
    ("enum triangulations", 0, ["enum", "triangulations", "prism"]),
    ("enum polyhedra", 0, ["enum", "polyhedra", "--vertices", "5"]),
    ("enum spheres", 0, ["enum", "spheres", "--vertices", "5"]),
    ("enum balls", 0, ["enum", "balls", "--vertices", "5"]),
    ("enum hexmeshes", 0, ["enum", "hexmeshes", "cube", "--max-hexes", "2"]),
    ("enum hexmeshes", 1, ["enum", "hexmeshes", "q1:088a65f7f", "--max-hexes", "2"]),
    ("enum hexmeshes --certificate", 1,
     ["enum", "hexmeshes", "cube", "--max-hexes", "1", "--certificate", "cube.hxb"]),
    ("enum hexmeshes --certificate", 0,
     ["enum", "hexmeshes", "two-cubes", "--max-hexes", "1", "--ball", "--certificate", "two.hxb"]),
    ("enum hexmeshes --estimate", 0, ["enum", "hexmeshes", "cube", "--max-hexes", "2", "--estimate", "10"]),
    ("enum shellings", 0, ["enum", "shellings", "--hexes", "3"]),
    ("realize", 0, ["realize", "prism"]),
    ("check of a catalogue", 0, ["check", os.path.join(DATA, "prism.hxc")]),
    ("check of a bound", 0, ["check", "two.hxb"]),
    ("check of sectors", 0, ["check", os.path.join(DATA, "linear-bound.hxs")]),
]


def documented():
    """The keys of each section of the page."""
    keys = {}
    with open(PAGE, encoding="utf-8") as file:
        for line in file:
            if line.startswith("## "):
                section = keys.setdefault(line[3:].strip(), set())
            elif line.startswith("| `"):
                section.update(re.findall("`([^`]+)`", line.split(" | ")[0]))
    return keys


def keys_of(value, name="", own=""):
    """The paths of all that is in a value called `name`, the last key of which is `own`."""
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return set().union(*(keys_of(each, name + "[]") for each in value))
    if not isinstance(value, dict):
        return {name}
    found = {name} if own in OR_NULL else set()
    for key, inner in value.items():
        shown = "*" if own in MAPS else key
        found |= keys_of(inner, f"{name}.{shown}" if name else shown, key)
    return found


class JsonTest(TableTest):
    def expect_documented(self, cases, optional=()):
        found = {}
        for section, code, words in cases:
            words = words if section == "table get" else words + ["--json"]
            ran = self.expect(code, self.hexatlas(*words))
            found.setdefault(section, set()).update(keys_of(json.loads(ran.out)))
        keys = documented()
        for section, some in found.items():
            self.assertEqual(some | {key for key in optional if key in keys[section]}, keys[section], section)
        return set(found)

    def test_sections(self):
        """Each has a case."""
        self.assertEqual({case[0] for case in MESHES + TABLES + ENUMERATIONS}, set(documented()))

    def test_meshes(self):
        self.write("odd.obj", surfaces.obj(*surfaces.cube_with_cut_quad(1)))
        self.write("points.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n")
        self.write("plane.xyz", "0 0 0\n1 0 0\n0 1 0\n")
        self.write("square.obj", SQUARE)
        points, quads = surfaces.block(2, 2, 2)
        self.write("box.obj", surfaces.obj(points, [half for a, b, c, d in quads
                                                    for half in ([a, b, c], [a, c, d])]))
        self.expect_documented(MESHES)

    def test_tables(self):
        self.write("bare.hxt", self.read("small.hxt"))
        self.expect_documented(TABLES)

    def test_enumerations(self):
        # Of the hexahedron, which takes long, only.
        self.expect_documented(ENUMERATIONS, optional=["proven_complete"])


if __name__ == "__main__":
    program.main()
