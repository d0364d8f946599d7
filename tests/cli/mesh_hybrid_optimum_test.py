#!/usr/bin/env python3
"""Claim. The cells that `mesh hybrid` chooses meet in common faces, and their weight, volume times 4 for
hexahedra, 2 for prisms, 1 for pyramids, is at most the greatest there is, at least 0.8 of it on Delaunay
meshes of at most 30 random points, and the greatest on lattices.
Oracle. The greatest weight of a set of candidates that meet pairwise in common faces, by CBC, a solver of
integer programs. Everything starts from the files; weights are integers; that cells meet in common faces is
decided face by face, not by edges and diagonals as in the program. Exit 77 if CBC is missing.
"""
import random
import shutil
import statistics
import subprocess
import sys

import program
from hybrid_files import kuhn, medit

FACES = {8: [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)],
         6: [(0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
         5: [(0, 1, 2, 3), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]}
FACTOR = {8: 4, 6: 2, 5: 1}
COLUMNS = {"Vertices": 3, "Tetrahedra": 4, "Hexahedra": 8, "Prisms": 6, "Pyramids": 5}
FROM_MEDIT = (0, 1, 3, 2, 4, 5, 7, 6)


def medit_sections(text):
    """Titles with rows of numbers."""
    words = text.split()
    at = words.index("Vertices")
    while words[at] != "End":
        title, count = words[at], int(words[at + 1])
        width = 1 + COLUMNS[title]
        at += 2 + count * width
        yield title, [words[i:i + width] for i in range(at - count * width, at, width)]


def six_volumes(points, cell):
    a, b, c = ([p - q for p, q in zip(points[v], points[cell[0]])] for v in cell[1:])
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]))


def edges_of(face):
    return {frozenset((v, face[i - 1])) for i, v in enumerate(face)}


class Cell:
    def __init__(self, vertices, inner=(), flat=(), weight=0):
        self.faces = [(frozenset(f), edges_of(f)) for f in
                      ([vertices[i] for i in local] for local in FACES[len(vertices)])]
        self.key = frozenset(vertices for vertices, _ in self.faces)
        self.vertices = frozenset(vertices)
        self.inner, self.flat, self.weight = frozenset(inner), frozenset(flat), weight


def meet_in_a_common_face(one, other):
    """In nothing, a vertex, an edge of both, or all of both with the same edges."""
    common = one[0] & other[0]
    if len(common) < 2:
        return True
    if len(common) == 2:
        return common in one[1] and common in other[1]
    return one == other


def are_compatible(one, other):
    if one.inner & other.inner or one.inner & other.flat or one.flat & other.inner:
        return False
    common = one.vertices & other.vertices
    if len(common) < 2:
        return True
    some, others = ([face for face in cell.faces if len(face[0] & common) > 1] for cell in (one, other))
    return all(meet_in_a_common_face(f, g) for f in some for g in others)


def ones(mask):
    while mask:
        yield (mask & -mask).bit_length() - 1
        mask &= mask - 1


def cliques(conflicts):
    """Sets of cells of which no two are compatible, such that each two such cells are in one."""
    left = list(conflicts)
    for i, row in enumerate(conflicts):
        while left[i]:
            clique, common = [i], row
            while common:
                best = max(ones(common & left[i] or common), key=lambda v: (conflicts[v] & common).bit_count())
                clique.append(best)
                common &= conflicts[best]
            mask = sum(1 << v for v in clique)
            for v in clique:
                left[v] &= ~mask
            yield clique


class OptimumTest(program.ProgramTest):
    def succeeds(self, *arguments):
        return self.expect(0, self.hexatlas(*arguments))

    def candidates(self, name, quality, points, tetrahedra):
        self.succeeds("mesh", "hybrid", name, "--count", "--quality", quality, "--candidates", "list.txt")
        cells = []
        for line in self.read("list.txt").decode().split("\n")[1:-1]:
            shape, *words = line.split()
            n = {"h": 8, "p": 6, "y": 5}[shape]
            inside, flat = int(words[n + 1]), int(words[n + 2])
            numbers = [int(w) for w in words[n + 3:]]
            self.assertEqual(len(numbers), inside + flat)
            volume = sum(abs(six_volumes(points, tetrahedra[t])) for t in numbers[:inside])
            cells.append(Cell([int(w) for w in words[:n]], numbers[:inside], numbers[inside:], FACTOR[n] * volume))
        self.assertEqual(len({c.key for c in cells}), len(cells))
        return cells

    def chosen(self, name, quality):
        self.succeeds("mesh", "hybrid", name, "--no-conforming", "--quality", quality, "-o", "chosen.mesh")
        keys = []
        for title, rows in medit_sections(self.read("chosen.mesh").decode()):
            if COLUMNS[title] < 5:
                continue
            for row in rows:
                cell = [int(w) - 1 for w in row[:-1]]
                keys.append(Cell([cell[i] for i in FROM_MEDIT] if len(cell) == 8 else cell).key)
        return keys

    def greatest_weight(self, cells, conflicts):
        """By CBC; what it chooses is tested here, so that only its word for `greatest` is taken."""
        names = [f"c{i}" for i in range(len(cells))]
        lines = ["Maximize", " weight:"] + [f" + {c.weight} {n}" for c, n in zip(cells, names)] + ["Subject To"]
        for clique in cliques(conflicts):
            lines += [" " + "\n + ".join(names[i] for i in clique) + " <= 1"]
        self.write("program.lp", "\n".join(lines + ["Binary", *names, "End", ""]))
        subprocess.run(["cbc", "program.lp", "ratioGap", "0", "allowableGap", "0.5", "solve", "solution", "solution.txt"],
                       cwd=self.folder, timeout=300, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        first, *rows = self.read("solution.txt").decode().split("\n")[:-1]
        self.assertTrue(first.startswith("Optimal"), first)
        best = [int(r.split()[1][1:]) for r in rows if float(r.split()[2]) > 0.5]
        self.expect_independent(best, conflicts)
        return sum(cells[i].weight for i in best)

    def expect_independent(self, names, conflicts):
        mask = sum(1 << i for i in names)
        self.assertEqual([i for i in names if conflicts[i] & mask], [])

    def share_of_the_greatest(self, name, quality="0.1"):
        """The weight chosen, divided by the greatest."""
        sections = dict(medit_sections(self.read(name).decode()))
        points = [tuple(int(float(w)) for w in row[:3]) for row in sections["Vertices"]]
        tetrahedra = [[int(w) - 1 for w in row[:4]] for row in sections["Tetrahedra"]]
        cells = self.candidates(name, quality, points, tetrahedra)
        place = {c.key: i for i, c in enumerate(cells)}
        conflicts = [0] * len(cells)
        for i, one in enumerate(cells):
            for j in range(i):
                if not are_compatible(one, cells[j]):
                    conflicts[i] |= 1 << j
                    conflicts[j] |= 1 << i
        ours = [place[key] for key in self.chosen(name, quality)]
        self.expect_independent(ours, conflicts)
        weight = sum(cells[i].weight for i in ours)
        greatest = self.greatest_weight(cells, conflicts)
        self.assertLessEqual(weight, greatest)
        return weight / greatest if greatest else 1

    def test_lattices(self):
        for n in (1, 2):
            points, cells = kuhn(n)
            name = self.write("lattice.mesh", medit([tuple(round(n * x) for x in p) for p in points], cells))
            self.assertEqual(self.share_of_the_greatest(name), 1)

    def test_random_points(self):
        """The least and the mean share of some meshes, as measured, rounded down."""
        chance = random.Random(20261122)
        for count, meshes, least, mean in ((10, 8, 1, 1), (15, 8, 0.98, 0.99), (20, 8, 0.83, 0.96), (25, 8, 0.86, 0.94),
                                           (30, 4, 0.9, 0.95)):
            shares = []
            for _ in range(meshes):
                points = [(p // 10 ** 6, p // 1000 % 1000, p % 1000) for p in chance.sample(range(10 ** 9), count)]
                self.write("points.xyz", "".join("%d %d %d\n" % p for p in points))
                self.succeeds("mesh", "delaunay", "points.xyz", "-o", "tetrahedra.mesh")
                shares.append(self.share_of_the_greatest("tetrahedra.mesh"))
            self.assertGreaterEqual(min(shares), least, shares)
            self.assertGreaterEqual(statistics.mean(shares), mean, shares)


if __name__ == "__main__":
    if shutil.which("cbc") is None:
        sys.exit(77)
    program.main()
