#!/usr/bin/env python3
"""Writes the quadrangulated balls of this experiment as Wavefront .obj files.

usage: generate.py [--check] [FOLDER]        default folder: inputs, beside this script

Each ball is made from named points and quads, put into coherent order by a breadth-first walk and
oriented by the sign of its volume, so that quads are counter-clockwise seen from outside.
With --check nothing is written: the bytes in FOLDER must be those that would be, and each file, read
again, must be a 3-connected quadrangulation of the sphere with outward orientation.

3-connected: a quadrangulation of the sphere is 3-connected exactly if each vertex has three or
more quads and no two quads share two vertices unless these are the ends of one common edge;
that is, all edges are distinct pairs, all diagonals are distinct pairs, and no pair is both.
"""
import collections
import itertools
import math
import pathlib
import sys

Ball = collections.namedtuple("Ball", "title points quads")


def cell_complex(title, cells, place=lambda p: p):
    """The boundary of a set of unit cubes given by their least corners; `place` moves each lattice point."""
    count = collections.Counter()
    for cell in cells:
        for axis, side in itertools.product(range(3), range(2)):
            u, v = [k for k in range(3) if k != axis]
            corners = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(cell)
                corner[axis] += side
                corner[u] += du
                corner[v] += dv
                corners.append(tuple(corner))
            count[tuple(corners)] += 1
    quads = sorted(quad for quad, times in count.items() if times == 1)
    lattice = sorted({corner for quad in quads for corner in quad}, key=lambda p: p[::-1])
    number = {corner: i for i, corner in enumerate(lattice)}
    return Ball(title, [place(p) for p in lattice], [tuple(number[c] for c in quad) for quad in quads])


def rhombic_dodecahedron():
    """The 12 planar rhombi of the polyhedron dual to the cuboctahedron: one per edge of the cube."""
    cube = list(itertools.product((-1.0, 1.0), repeat=3))
    tips = [tuple(2.0 * s if k == axis else 0.0 for k in range(3)) for axis in range(3) for s in (-1, 1)]
    quads = []
    for (i, a), (j, b) in itertools.combinations(enumerate(cube), 2):
        differ = [k for k in range(3) if a[k] != b[k]]
        if len(differ) != 1:
            continue
        s, t = [8 + 2 * k + (a[k] > 0) for k in range(3) if k != differ[0]]
        quads.append((i, s, j, t))
    return Ball("rhombic dodecahedron", cube + tips, quads)


def trapezohedron(sides, title):
    """Planar kites: a zigzag belt of 2n points at heights +-h and apices at +-H.

    The kite (apex, low, high, low) is planar if H = h (1 + cos(pi/n)) / (1 - cos(pi/n)).
    The belt has h = (1 - cos(pi/n)) / (1 + cos(pi/n)) and so the apices lie at +-1.
    """
    cosine = math.cos(math.pi / sides)
    height = (1 - cosine) / (1 + cosine)
    belt = [(math.cos(math.pi * i / sides), math.sin(math.pi * i / sides), height if i % 2 == 0 else -height)
            for i in range(2 * sides)]
    top, bottom = 2 * sides, 2 * sides + 1
    quads = []
    for i in range(2 * sides):
        before, after = (i - 1) % (2 * sides), (i + 1) % (2 * sides)
        quads.append((bottom if i % 2 == 0 else top, before, i, after))
    return Ball(title, belt + [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0)], quads)


def frustum():
    """A cube, tapered to the half and twisted by a twelfth of a half turn; bottom and top stay planar."""
    def place(point):
        x, y, z = point[0] - 0.5, point[1] - 0.5, point[2]
        angle, scale = math.pi / 12 * z, 1 - 0.5 * z
        return (scale * (x * math.cos(angle) - y * math.sin(angle)),
                scale * (x * math.sin(angle) + y * math.cos(angle)), z)
    return cell_complex("cube frustum, tapered and twisted", [(0, 0, 0)], place)


def schneiders_pyramid():
    """Square base cut into 2 x 2, each side into 3 by the midpoints of its edges and its centroid."""
    apex = (0.0, 0.0, 2.0)
    base = [(-1.0, -1.0, 0.0), (1.0, -1.0, 0.0), (1.0, 1.0, 0.0), (-1.0, 1.0, 0.0)]

    def mean(*points):
        return tuple(sum(p[k] for p in points) / len(points) for k in range(3))

    points = base + [apex]                                                    # 0-3, 4
    points += [mean(base[i], base[(i + 1) % 4]) for i in range(4)]            # 5-8 on base edges
    points += [mean(base[i], apex) for i in range(4)]                         # 9-12 on side edges
    points += [mean(base[i], base[(i + 1) % 4], apex) for i in range(4)]      # 13-16 centroids of sides
    points += [(0.0, 0.0, 0.0)]                                               # 17 centre of the base
    quads = []
    for i in range(4):
        j, before = (i + 1) % 4, (i - 1) % 4
        quads += [(i, 5 + i, 13 + i, 9 + i), (j, 9 + j, 13 + i, 5 + i), (4, 9 + i, 13 + i, 9 + j),
                  (i, 5 + before, 17, 5 + i)]
    return Ball("Schneiders' pyramid", points, quads)


def balls():
    return {
        "cube": cell_complex("cube", [(0, 0, 0)]),
        "two-cubes": cell_complex("two cubes, one on the other", [(0, 0, 0), (0, 0, 1)]),
        "three-cubes-row": cell_complex("three cubes in a row", [(0, 0, 0), (0, 0, 1), (0, 0, 2)]),
        "three-cubes-l": cell_complex("three cubes in an L", [(0, 0, 0), (1, 0, 0), (0, 0, 1)]),
        "rhombic-dodecahedron": rhombic_dodecahedron(),
        "trapezohedron-4": trapezohedron(4, "trapezohedron with 4 sides, the octagonal spindle"),
        "trapezohedron-5": trapezohedron(5, "trapezohedron with 5 sides"),
        "trapezohedron-6": trapezohedron(6, "trapezohedron with 6 sides"),
        "trapezohedron-7": trapezohedron(7, "trapezohedron with 7 sides"),
        "frustum": frustum(),
        "schneiders-pyramid": schneiders_pyramid(),
    }


def sides_of(quad):
    return [(quad[i], quad[(i + 1) % 4]) for i in range(4)]


def volume(points, quads):
    """Of the solid inside; the saddle of a bent quad is replaced by the mean of its two triangulations."""
    def six_times(a, b, c):
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
    total = 0.0
    for quad in quads:
        a, b, c, d = (points[v] for v in quad)
        total += six_times(a, b, c) + six_times(a, c, d) + six_times(a, b, d) + six_times(b, c, d)
    return total / 12


def oriented(ball):
    """The same ball with coherent quads, counter-clockwise seen from outside."""
    at_edge = collections.defaultdict(list)
    for i, quad in enumerate(ball.quads):
        for side in sides_of(quad):
            at_edge[frozenset(side)].append(i)
    done = {0: ball.quads[0]}
    waiting = [0]
    for i in waiting:
        for a, b in sides_of(done[i]):
            for j in at_edge[frozenset((a, b))]:
                if j not in done:
                    quad = ball.quads[j]
                    done[j] = quad[::-1] if (a, b) in sides_of(quad) else quad
                    waiting.append(j)
    quads = [done[i] for i in range(len(ball.quads))]
    if volume(ball.points, quads) < 0:
        quads = [quad[::-1] for quad in quads]
    return ball._replace(quads=[rotated(quad) for quad in quads])


def rotated(quad):
    least = quad.index(min(quad))
    return quad[least:] + quad[:least]


def text(ball):
    lines = [f"# {ball.title}: {len(ball.quads)} quads, {len(ball.points)} vertices"]
    # + 0.0 turns a rounded -0 into 0; ten decimals hide the last bits of the C library's sine.
    lines += ["v " + " ".join(f"{round(c, 10) + 0.0:.10g}" for c in point) for point in ball.points]
    lines += ["f " + " ".join(str(v + 1) for v in quad) for quad in ball.quads]
    return "\n".join(lines) + "\n"


def parsed(content):
    rows = [line.split() for line in content.splitlines() if line[0] != "#"]
    points = [tuple(map(float, row[1:])) for row in rows if row[0] == "v"]
    return points, [tuple(int(v) - 1 for v in row[1:]) for row in rows if row[0] == "f"]


def link_is_circle(vertex, quads):
    """In a coherent quad mesh: going round the vertex from quad to quad meets all its quads."""
    next_of = {}
    for quad in quads:
        if vertex in quad:
            i = quad.index(vertex)
            next_of[quad[(i + 1) % 4]] = quad[i - 1]
    first = at = next(iter(next_of))
    for steps in range(1, len(next_of) + 1):
        at = next_of.get(at)
        if at == first or at is None:
            return at == first and steps == len(next_of)
    return False


def defects(points, quads):
    """The laws that the ball breaks, in words."""
    directed = collections.Counter(side for quad in quads for side in sides_of(quad))
    edges = {frozenset(side) for side in directed}
    diagonals = collections.Counter(frozenset(quad[i::2]) for quad in quads for i in (0, 1))
    if len(set(points)) != len(points):
        yield "two vertices at one place"
    if {v for quad in quads for v in quad} != set(range(len(points))):
        yield "a vertex without quads"
    if any(len(set(quad)) != 4 for quad in quads):
        yield "a quad with a repeated vertex"
    if any(times != 1 or (b, a) not in directed for (a, b), times in directed.items()):
        yield "not closed and coherent"
    elif not all(link_is_circle(v, quads) for v in range(len(points))):
        yield "the link of a vertex is not a circle"
    if len(points) - len(edges) + len(quads) != 2:
        yield "Euler characteristic is not 2"
    if len(reached(quads)) != len(points):
        yield "not connected"
    if len(edges) != 2 * len(quads) or max(diagonals.values()) > 1 or edges & set(diagonals):
        yield "not 3-connected: two quads share two vertices that are not one common edge"
    if min(collections.Counter(v for quad in quads for v in quad).values()) < 3:
        yield "not 3-connected: a vertex with two quads"
    if volume(points, quads) <= 0:
        yield "not counter-clockwise from outside"
    if len(quads) % 2:
        yield "an odd number of quads"


def reached(quads):
    neighbours = collections.defaultdict(set)
    for a, b in (side for quad in quads for side in sides_of(quad)):
        neighbours[a].add(b)
        neighbours[b].add(a)
    seen, waiting = {quads[0][0]}, [quads[0][0]]
    for v in waiting:
        new = neighbours[v] - seen
        seen |= new
        waiting += new
    return seen


def bend(points, quads):
    """The greatest distance of a fourth corner from the plane of three, relative to a diagonal."""
    worst = 0.0
    for quad in quads:
        a, b, c, d = (points[v] for v in quad)
        ab, ac, ad = ([p[k] - a[k] for k in range(3)] for p in (b, c, d))
        normal = (ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0])
        height = abs(sum(n * e for n, e in zip(normal, ad))) / math.hypot(*normal)
        worst = max(worst, height / math.hypot(*ac))
    return worst


def check(folder, contents):
    found = sorted(path.stem for path in folder.glob("*.obj"))
    failures = [f"{folder}: has {found}, expected {sorted(contents)}"] if found != sorted(contents) else []
    for name, content in contents.items():
        path = folder / f"{name}.obj"
        if not path.is_file():
            continue
        stored = path.read_text(encoding="ascii")
        if stored != content:
            failures.append(f"{path}: not what generate.py writes")
        points, quads = parsed(stored)
        failures += [f"{path}: {defect}" for defect in defects(points, quads)]
        print(f"{name}: {len(quads)} quads, {len(points)} vertices, bend {bend(points, quads):.3f}")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


def main(arguments):
    checking = "--check" in arguments
    folders = [a for a in arguments if a != "--check"]
    if len(folders) > 1 or any(a.startswith("-") for a in folders):
        print(__doc__, file=sys.stderr)
        return 2
    folder = pathlib.Path(folders[0]) if folders else pathlib.Path(__file__).resolve().parent / "inputs"
    contents = {name: text(oriented(ball)) for name, ball in balls().items()}
    if checking:
        return check(folder, contents)
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in contents.items():
        (folder / f"{name}.obj").write_text(content, encoding="ascii")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
