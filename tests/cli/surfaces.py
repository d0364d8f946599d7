"""Quad surfaces and the text of their files, for the tests of the program.

A surface is (points, quads): points are triples of words, quads are lists of vertices from 0. A
vertex that is a word (str) is written as it stands, in formats that count from 1 as well, so that
damage can be put at any place of any format.
"""
import itertools
import math
import random

CUBE_POINTS = [("0", "0", "0"), ("1", "0", "0"), ("1", "1", "0"), ("0", "1", "0"),
               ("0", "0", "1"), ("1", "0", "1"), ("1", "1", "1"), ("0", "1", "1")]
CUBE_QUADS = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]


def cube():
    return list(CUBE_POINTS), [list(quad) for quad in CUBE_QUADS]


def of_cubes(cubes):
    """The surface of unit cubes at these places, from outside."""
    number, quads = {}, []
    for cube in sorted(cubes):
        for axis in range(3):
            for side in (0, 1):
                beyond = list(cube)
                beyond[axis] += 2 * side - 1
                if tuple(beyond) in cubes:
                    continue
                corners = []
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    place = list(cube)
                    place[axis] += side
                    place[(axis + 1) % 3] += a
                    place[(axis + 2) % 3] += b
                    corners.append(number.setdefault(tuple(place), len(number)))
                quads.append(corners if side else corners[::-1])
    return [tuple(map(str, place)) for place in number], quads


def block(*cubes):
    """The surface of a block of so many unit cubes along each axis, from outside."""
    return of_cubes(set(itertools.product(*map(range, cubes))))


def grid_cube(n):
    """The surface of n x n x n unit cubes, from outside; 6 n^2 quads."""
    return block(n, n, n)


def ball(n):
    """The surface of n x n x n cubes blown up to a round one."""
    points, quads = grid_cube(n)
    round_points = []
    for point in points:
        p = [math.tan((2 * float(x) / n - 1) * math.pi / 4) for x in point]
        round_points.append(tuple(repr(x / math.hypot(*p)) for x in p))
    return round_points, quads


class Rings:
    """Quads around an axis: a square of core x core in the middle, then rings; at heights from 0 on."""

    def __init__(self, core):
        self.core = core
        self.corners = [(i, 0) for i in range(core)] + [(core, i) for i in range(core)]
        self.corners += [(core - i, core) for i in range(core)] + [(0, core - i) for i in range(core)]
        self.number, self.quads = {}, []

    def surface(self):
        return list(self.number), self.quads

    def quads_within(self, rings):
        return self.core * self.core + rings * len(self.corners)

    def point(self, ring, i, j, z):
        x, y = 2 * i / self.core - 1, 2 * j / self.core - 1
        scale = ring / math.hypot(x, y) if ring > 0 else 0.4
        return self.number.setdefault((repr(scale * x), repr(scale * y), str(z)), len(self.number))

    def at(self, ring, t, z):
        return self.point(ring, *self.corners[t % len(self.corners)], z)

    def end(self, inner, outer, z, is_top):
        """Between two rings, or with the square if `inner` is -1."""
        cells = []
        if inner < 0:
            cells = [[self.point(0, i + a, j + b, z) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                     for i in range(self.core) for j in range(self.core)]
        for ring in range(max(inner, 0), outer):
            cells += [[self.at(ring, t, z), self.at(ring + 1, t, z), self.at(ring + 1, t + 1, z),
                       self.at(ring, t + 1, z)] for t in range(len(self.corners))]
        self.quads.extend(cell if is_top else cell[::-1] for cell in cells)

    def wall(self, ring, z, is_outside=True):
        """Up to the next height."""
        cells = [[self.at(ring, t, z), self.at(ring, t + 1, z), self.at(ring, t + 1, z + 1),
                  self.at(ring, t, z + 1)] for t in range(len(self.corners))]
        self.quads.extend(cell if is_outside else cell[::-1] for cell in cells)


def shaft(core, *steps):
    """Cylinders on each other, each of steps so many rings thick around a square of core x core quads, and so many
    layers high; with the number of quads of each layer."""
    rings = Rings(core)
    before, top, of_layers = -1, 0, []
    for radius, layers in steps:
        rings.end(min(before, radius), max(before, radius), top, before > radius)
        for z in range(top, top + layers):
            rings.wall(radius, z)
        of_layers += [rings.quads_within(radius)] * layers
        before, top = radius, top + layers
    rings.end(-1, before, top, True)
    return rings.surface(), of_layers


def blind_hole(core, radius, height, *holes):
    """A cylinder with holes around its axis from above, each of holes (radius, depth) narrower and from the floor of
    the one before; with the number of its hexahedra in layers."""
    rings = Rings(core)
    rings.end(-1, radius, 0, False)
    for z in range(height):
        rings.wall(radius, z)
    hexahedra, before, top = height * rings.quads_within(radius), radius, height
    for hole, depth in holes:
        rings.end(hole, before, top, True)
        for z in range(top - depth, top):
            rings.wall(hole, z, is_outside=False)
        hexahedra -= depth * rings.quads_within(hole)
        before, top = hole, top - depth
    rings.end(-1, before, top, True)
    return rings.surface(), hexahedra


def trapezohedron(k):
    """Two vertices of degree k and a zigzag around the equator: 2k quads."""
    def at(i, z):
        return repr(math.cos(math.pi * i / k)), repr(math.sin(math.pi * i / k)), z

    points = [at(i, "0.1" if i % 2 == 0 else "-0.1") for i in range(2 * k)]
    points += [("0", "0", "1"), ("0", "0", "-1")]
    quads = []
    for i in range(0, 2 * k, 2):
        quads.append([2 * k, i, i + 1, (i + 2) % (2 * k)])
        quads.append([2 * k + 1, (i + 3) % (2 * k), (i + 2) % (2 * k), i + 1])
    return points, quads


def random_surface(count, seed):
    """So many quads, from those of 2 x 2 x 2 cubes by splits of vertices, which keep it 3-connected: a vertex becomes
    two, opposite in a new quad whose other two corners were its neighbours, not in one quad before."""
    rng = random.Random(seed)
    points, quads = grid_cube(2)
    points = [tuple(float(x) - 1 for x in point) for point in points]
    while len(quads) < count:
        v = rng.randrange(len(points))
        after = {quad[(quad.index(v) + 1) % 4]: quad for quad in quads if v in quad}
        ring = [min(after)]
        while len(ring) < len(after):
            quad = after[ring[-1]]
            ring.append(quad[(quad.index(v) + 3) % 4])
        if len(ring) < 4:
            continue
        turn, moved = rng.randrange(len(ring)), rng.randint(2, len(ring) - 2)
        ring = ring[turn:] + ring[:turn]
        a, b = ring[0], ring[moved]
        if any(a in quad and b in quad and v not in quad for quad in quads):
            continue
        sides = [after[u] for u in ring[:moved]]
        middle = [sum(points[u][k] for quad in sides for u in quad) / (4 * moved) for k in range(3)]
        w = len(points)
        points.append(tuple(0.7 * x + 0.3 * y for x, y in zip(points[v], middle)))
        for quad in sides:
            quad[quad.index(v)] = w
        quads.append([v, a, w, b])
    return [tuple(map(repr, point)) for point in points], quads


def two_cubes_sharing(shared):
    """Two closed cube surfaces; vertex v of the second is vertex shared[v] of the first."""
    points, quads = cube()
    name = {}
    for v in range(8):
        if v in shared:
            name[v] = shared[v]
        else:
            name[v] = len(points)
            points.append(tuple(str(int(x) + 5) for x in CUBE_POINTS[v]))
    return points, quads + [[name[v] for v in quad] for quad in CUBE_QUADS]


def grid_closed_up(rows, columns, twisted):
    """A torus, or a Klein bottle if twisted."""
    def vertex(i, j):
        wrapped = i >= rows and twisted
        return (i % rows) * columns + ((-j if wrapped else j) % columns)

    points = [(str(i), str(j), str(i * j)) for i in range(rows) for j in range(columns)]
    quads = [[vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)]
             for i in range(rows) for j in range(columns)]
    return points, quads


def cube_with_cut_quad(cuts):
    """A cube whose top is cut into cuts + 1 quads, by vertices on a diagonal, of degree 2."""
    points, quads = cube()
    a, b, c, d = quads.pop(1)
    ways = [b]
    for i in range(cuts):
        ways.append(len(points))
        t = (i + 1) / (cuts + 1)
        points.append((repr(1 - t), repr(t), "1"))
    ways.append(d)
    quads += [[a, ways[i], c, ways[i + 1]] for i in range(cuts + 1)]
    return points, quads


def four_lenses():
    """Vertices 0 and 1 joined by four paths of two edges; between them two quads and, as
    alternatives to quads, two cubes without their bottoms. All degrees are at least 3."""
    points = [("0", "0", "-1"), ("0", "0", "1")]
    middle = []
    for k in range(4):
        angle = math.pi * k / 2
        middle.append(len(points))
        points.append((repr(math.cos(angle)), repr(math.sin(angle)), "0"))
    quads = []
    for k in range(4):
        rim = [0, middle[k], 1, middle[(k + 1) % 4]]
        if k % 2 == 0:
            quads.append(rim)
            continue
        top = []
        bisector = math.pi * (k + 0.5) / 2
        outwards = (math.cos(bisector), math.sin(bisector), 0.0)
        for v in rim:
            top.append(len(points))
            points.append(tuple(repr(float(x) / 2 + y) for x, y in zip(points[v], outwards)))
        quads.append(top)
        quads += [[rim[i], rim[(i + 1) % 4], top[(i + 1) % 4], top[i]] for i in range(4)]
    return points, [quad[::-1] for quad in quads]


def read_obj(path):
    points, quads = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append(tuple(words[1:4]))
            elif words[:1] == ["f"]:
                quads.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    return points, quads


# Writers, one for each format of surfaces.

def _number(vertex, base):
    return vertex if isinstance(vertex, str) else str(vertex + base)


def _cells(quads, base):
    return [" ".join(_number(v, base) for v in quad) for quad in quads]


def _rows(points):
    return "".join(" ".join(point) + "\n" for point in points)


def obj(points, quads):
    return ("".join("v " + " ".join(point) + "\n" for point in points) +
            "".join("f " + cell + "\n" for cell in _cells(quads, 1)))


def off(points, quads):
    cells = "".join(f"{len(quad)} {cell}\n" for quad, cell in zip(quads, _cells(quads, 0)))
    return f"OFF\n{len(points)} {len(quads)} 0\n" + _rows(points) + cells


VTK_TYPE = {3: 5, 4: 9, 5: 7}


def vtk(points, quads):
    cells = "".join(f"{len(quad)} {cell}\n" for quad, cell in zip(quads, _cells(quads, 0)))
    size = sum(len(quad) + 1 for quad in quads)
    types = "".join(f"{VTK_TYPE[len(quad)]}\n" for quad in quads)
    return ("# vtk DataFile Version 3.0\nsurface\nASCII\nDATASET UNSTRUCTURED_GRID\n"
            f"POINTS {len(points)} double\n{_rows(points)}CELLS {len(quads)} {size}\n{cells}"
            f"CELL_TYPES {len(quads)}\n{types}")


def vtu(points, quads):
    offsets, end = [], 0
    for quad in quads:
        end += len(quad)
        offsets.append(str(end))
    types = " ".join(str(VTK_TYPE[len(quad)]) for quad in quads)

    def array(kind, name, text, components=""):
        return (f'<DataArray type="{kind}" Name="{name}"{components} format="ascii">\n{text}\n'
                "</DataArray>\n")

    return ('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">\n'
            "<UnstructuredGrid>\n"
            f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(quads)}">\n<Points>\n' +
            array("Float64", "Points", _rows(points).rstrip("\n"), ' NumberOfComponents="3"') +
            "</Points>\n<Cells>\n" + array("Int64", "connectivity", "\n".join(_cells(quads, 0))) +
            array("Int64", "offsets", " ".join(offsets)) + array("UInt8", "types", types) +
            "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


def medit(points, quads):
    text = "MeshVersionFormatted 2\nDimension 3\n"
    text += f"Vertices\n{len(points)}\n" + "".join(" ".join(p) + " 0\n" for p in points)
    for keyword, corners in (("Triangles", 3), ("Quadrilaterals", 4)):
        cells = _cells([quad for quad in quads if len(quad) == corners], 1)
        if cells:
            text += f"{keyword}\n{len(cells)}\n" + "".join(cell + " 0\n" for cell in cells)
    return text + "End\n"


GMSH_TYPE = {3: 2, 4: 3}


def msh2(points, quads):
    nodes = "".join(f"{i + 1} {' '.join(p)}\n" for i, p in enumerate(points))
    elements = "".join(f"{i + 1} {GMSH_TYPE[len(quad)]} 2 0 1 {cell}\n"
                       for i, (quad, cell) in enumerate(zip(quads, _cells(quads, 1))))
    return (f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(points)}\n{nodes}$EndNodes\n"
            f"$Elements\n{len(quads)}\n{elements}$EndElements\n")


def msh4(points, quads):
    tags = "".join(f"{i + 1}\n" for i in range(len(points)))
    blocks = [(GMSH_TYPE[n], [q for q in quads if len(q) == n]) for n in (3, 4)]
    blocks = [(kind, cells) for kind, cells in blocks if cells]
    elements, tag = "", 0
    for kind, cells in blocks:
        elements += f"2 1 {kind} {len(cells)}\n"
        for cell in _cells(cells, 1):
            tag += 1
            elements += f"{tag} {cell}\n"
    return ("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
            f"$Nodes\n1 {len(points)} 1 {len(points)}\n2 1 0 {len(points)}\n{tags}{_rows(points)}"
            f"$EndNodes\n$Elements\n{len(blocks)} {tag} 1 {tag}\n{elements}$EndElements\n")


# name of the format: (extension, writer, number of the first vertex, knows pentagons)
FORMATS = {
    "obj": (".obj", obj, 1, True),
    "off": (".off", off, 0, True),
    "vtk": (".vtk", vtk, 0, True),
    "vtu": (".vtu", vtu, 0, True),
    "medit": (".mesh", medit, 1, False),
    "msh 2.2": (".msh", msh2, 1, False),
    "msh 4.1": (".msh", msh4, 1, False),
}
