#!/usr/bin/env python3
"""Makes the meshes that blow_up makes larger, each judged by `hexatlas check`, boundary points first.

glued.mesh: Schneiders' pyramid from the octagonal spindle of the table and a hexahedron at each corner of the base.
spindle.mesh: the octagonal spindle of the table.
grid.mesh: a box of 10 x 10 x 10 hexahedra.

usage: starts.py PROGRAM FOLDER
"""
import os
import subprocess
import sys

INPUTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "2026-11-quad-balls", "inputs")


def read_obj(path):
    points, quads = [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append(tuple(float(word) for word in words[1:4]))
            elif words[:1] == ["f"]:
                quads.append([int(word) - 1 for word in words[1:5]])
    return points, quads


def write_obj(path, points, quads):
    with open(path, "w", encoding="ascii") as file:
        for point in points:
            file.write("v " + " ".join(repr(x) for x in point) + "\n")
        for quad in quads:
            file.write("f " + " ".join(str(v + 1) for v in quad) + "\n")


def read_mesh(path):
    """Points and hexahedra of a .mesh file of the program, in the order of corners of VTK."""
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    at, cells_at = words.index("Vertices"), words.index("Hexahedra")
    points = [tuple(float(word) for word in words[at + 2 + 4 * i:at + 5 + 4 * i])
              for i in range(int(words[at + 1]))]
    return points, [[int(word) - 1 for word in words[cells_at + 2 + 9 * i:cells_at + 10 + 9 * i]]
                    for i in range(int(words[cells_at + 1]))]


def write_mesh(path, points, cells):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(points)}\n")
        for point in points:
            file.write(" ".join(repr(float(x)) for x in point) + " 0\n")
        file.write(f"Hexahedra\n{len(cells)}\n")
        for cell in cells:
            file.write(" ".join(str(v + 1) for v in cell) + " 0\n")
        file.write("End\n")


class Maker:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def path(self, name):
        return os.path.join(self.folder, name)

    def run(self, *arguments):
        return subprocess.run([self.program, *arguments], cwd=self.folder, check=False,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)

    def keep(self, name, points, cells):
        write_mesh(self.path(name), points, cells)
        judged = self.run("check", name)
        if judged.returncode != 0:
            raise SystemExit(f"{name} is not accepted: {judged.stdout}")

    def filled(self, points, quads):
        """The table's mesh of the surface."""
        write_obj(self.path("surface.obj"), points, quads)
        if self.run("mesh", "hex", "surface.obj", "-o", "filled.mesh").returncode != 0:
            raise SystemExit("the table has no mesh of a surface")
        return read_mesh(self.path("filled.mesh"))

    def glued_pyramid(self):
        points, quads = read_obj(os.path.join(INPUTS, "schneiders-pyramid.obj"))
        base = min(point[2] for point in points)
        faces = {v: [q for q in quads if v in q] for v in range(len(points))}
        corners = [v for v in faces if len(faces[v]) == 3 and points[v][2] == base]
        centre = len(points)  # the vertex that the four hexahedra share inside
        cells, rest = [], [q for q in quads if not set(q) & set(corners)]
        for corner in corners:
            first = next(q for q in faces[corner] if all(points[v][2] == base for v in q))
            a, b, c, d = first[(i := first.index(corner)):] + first[:i]  # a is the corner
            up = next(q for q in faces[corner] if d in q and b not in q)
            side = next(q for q in faces[corner] if b in q and d not in q)
            edge = (set(up) & set(side) - {a}).pop()
            over_b = (set(side) - {a, b, edge}).pop()
            over_d = (set(up) - {a, d, edge}).pop()
            cells.append([a, d, c, b, edge, over_d, centre, over_b])  # the quads are from outside
            rest.append([edge, over_b, centre, over_d])
        inner = points + [(0.0, 0.0, base + 0.1)]
        used = sorted({v for q in rest for v in q})
        number = {v: i for i, v in enumerate(used)}
        inside_points, inside = self.filled([inner[v] for v in used],
                                            [[number[v] for v in q] for q in rest])
        new = {i: v for v, i in number.items()}
        for i in range(len(used), len(inside_points)):
            new[i] = len(inner)
            inner.append(inside_points[i])
        return inner, cells + [[new[v] for v in cell] for cell in inside]


def grid(n):
    points = [(float(x), float(y), float(z)) for z in range(n + 1) for y in range(n + 1) for x in range(n + 1)]
    at = lambda x, y, z: x + (n + 1) * (y + (n + 1) * z)
    cells = [[at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z),
              at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1), at(x, y + 1, z + 1)]
             for z in range(n) for y in range(n) for x in range(n)]
    return points, cells


def boundary_first(points, cells):
    """Numbers such that the points on the boundary of the box come first."""
    on_boundary = [any(x in (0.0, max(p[0] for p in points)) for x in point) for point in points]
    order = sorted(range(len(points)), key=lambda v: not on_boundary[v])
    number = {v: i for i, v in enumerate(order)}
    return [points[v] for v in order], [[number[v] for v in cell] for cell in cells]


def main():
    maker = Maker(os.path.abspath(sys.argv[1]), sys.argv[2])
    maker.keep("glued.mesh", *maker.glued_pyramid())
    maker.keep("spindle.mesh", *maker.filled(*read_obj(os.path.join(INPUTS, "trapezohedron-4.obj"))))
    maker.keep("grid.mesh", *boundary_first(*grid(10)))


if __name__ == "__main__":
    main()
