#!/usr/bin/env python3
"""How far irregularity and the zones of a boundary account for the hexahedra of its mesh.

Least squares over the boundaries of a census with one number of quads each, by irregularity alone, by the number of
zones that do not cross themselves alone, and by both. Boundaries are decoded from their codes here (docs/formats/code.md),
not by the program. Prints tab-separated values: quads, boundaries, the three shares of the variance, and of the last
fit the constant and what a unit of irregularity and a simple zone add.

usage: zones.py CENSUS
"""
import sqlite3
import sys


def letters(code):
    for digit in code.removeprefix("q1:"):
        yield from divmod(int(digit, 16), 4)


def map_of(code):
    """The other end of each half-edge, and the one before it around its vertex."""
    twin, rotations, at, tree, opened = [], [[]], 0, [], []
    for letter in letters(code):
        half = len(twin)
        rotations[at].append(half)
        twin.append(None)
        if letter == 0:
            tree.append((at, half))
            rotations.append([])
            at = len(rotations) - 1
        elif letter == 2:
            opened.append(half)
        else:
            if letter == 1:
                at, other = tree.pop()
            else:
                other = opened.pop()
            twin[half], twin[other] = other, half
    before = [None] * len(twin)
    for rotation in rotations:
        for i, half in enumerate(rotation):
            before[half] = rotation[i - 1]
    return twin, before, [len(rotation) for rotation in rotations]


def features(code):
    """Irregularity, and the number of zones that do not cross themselves.

    A half-edge stands for the side of its quad that follows it around its vertex.
    """
    twin, before, degrees = map_of(code)
    sides = range(len(twin))
    left = set(sides)
    while left:  # the vertices of the other colour
        first = side = left.pop()
        degree = 1
        while (side := before[twin[side]]) != first:
            left.remove(side)
            degree += 1
        degrees.append(degree)
    parent = list(sides)

    def root(side):
        while parent[side] != side:
            parent[side] = side = parent[parent[side]]
        return side

    for half in sides:  # opposite sides of a quad
        parent[root(half)] = root(twin[half])
        parent[root(before[half])] = root(before[twin[half]])
    crossing = {root(half) for half in sides if root(half) == root(before[half])}
    return sum((degree - 4) ** 2 for degree in degrees), len({root(side) for side in sides} - crossing)


def solved(rows, right):
    """By elimination; the matrix is that of normal equations, of full rank."""
    rows = [row + [value] for row, value in zip(rows, right)]
    for i in range(len(rows)):
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for j in range(len(rows)):
            if j != i:
                rows[j] = [a - rows[j][i] * b for a, b in zip(rows[j], rows[i])]
    return [row[-1] for row in rows]


def fit(columns, values):
    """The coefficients, and the share of the variance that they account for."""
    columns = [[1.0] * len(values)] + columns
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    result = solved([[dot(a, b) for b in columns] for a in columns], [dot(a, values) for a in columns])
    mean = sum(values) / len(values)
    rest = sum((value - dot(result, row)) ** 2 for value, row in zip(values, zip(*columns)))
    return result, 1 - rest / sum((value - mean) ** 2 for value in values)


def main():
    census = sqlite3.connect(sys.argv[1])
    print("quads\tboundaries\tby irregularity\tby simple zones\tby both\tconstant\tunit\tzone")
    for quads in (14, 16, 18, 20):
        rows = census.execute("SELECT code, hexahedra FROM census WHERE quads = ?", (quads,)).fetchall()
        irregularity, simple = (list(map(float, column)) for column in zip(*(features(code) for code, _ in rows)))
        hexahedra = [float(value) for _, value in rows]
        by_one = [fit([column], hexahedra)[1] for column in (irregularity, simple)]
        both, share = fit([irregularity, simple], hexahedra)
        print(quads, len(rows), *(f"{x:.3f}" for x in (*by_one, share)), *(f"{x:.2f}" for x in both), sep="\t")


if __name__ == "__main__":
    main()
