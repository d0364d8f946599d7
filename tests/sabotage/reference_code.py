#!/usr/bin/env python3
"""Compares the judge's canonical codes with a second reading of docs/formats/code.md.

Quadrangulations are random: cubes glued to quads and quads cut by vertices of degree 2, with random
labels, order and orientation. The walk here goes along permutations of corners, not along sides.
usage: reference_code.py PROGRAM    PROGRAM reads one quadrangulation per line ("a b c d a b c d ..")
                                    and prints its code.
       reference_code.py --print    prints the codes of one and of two stacked cubes
"""
import random
import subprocess
import sys

CUBE = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def word(quads, start, step, degree_of):
    """The word of the flag at corner `start` = (quad, place), read in direction `step` (+1 or -1)."""
    turn = {}
    at_edge = {}
    for q, quad in enumerate(quads):
        for i in range(4):
            at_edge.setdefault((quad[i], quad[(i + step) % 4]), (q, i))
    for q, quad in enumerate(quads):
        for i in range(4):
            # v in (v, a, w, b): the next quad has b where this one has a
            turn[q, i] = at_edge[quad[i], quad[(i - step) % 4]]
    q, i = start
    reached, state, letters = {quads[q][i]}, {}, []
    for _ in range(2 * len(quads)):
        w = quads[q][(i + 2) % 4]
        if q not in state:
            state[q] = "open" if w in reached else "tree"
            letters.append("2" if w in reached else "0")
            move = w not in reached
            reached.add(w)
        else:
            move = state[q] == "tree"
            letters.append("1" if move else "3")
        if move:
            i = (i + 2) % 4
        q, i = turn[q, i]
    return "".join(letters)


def code(quads):
    degree = {}
    for quad in quads:
        for v in quad:
            degree[v] = degree.get(v, 0) + 1
    flags = [(tuple(degree[quad[(i + step * k) % 4]] for k in range(4)), (q, i), step)
             for q, quad in enumerate(quads) for i in range(4) for step in (1, -1)]
    best = max(degrees for degrees, _, _ in flags)
    least = min(word(quads, start, step, degree) for degrees, start, step in flags if degrees == best)
    digits = [int(least[k]) * 4 + int(least[k + 1]) for k in range(0, len(least), 2)]
    return "q1:" + "".join(f"{digit:x}" for digit in digits)


def glue_cube(quads, at):
    """Replaces a quad by the five other quads of a cube."""
    a = quads.pop(at)
    t = [len(quads) + 3 + k for k in range(4)]  # n + 2 vertices before
    quads += [(a[k], a[(k + 1) % 4], t[(k + 1) % 4], t[k]) for k in range(4)] + [tuple(t)]


def cut(quads, at):
    a, b, c, d = quads.pop(at)
    v = len(quads) + 3
    quads += [(a, b, c, v), (a, v, c, d)]


def random_quads(rng):
    quads = list(CUBE)
    for _ in range(rng.randrange(1, 5)):
        rng.choice([glue_cube, glue_cube, cut])(quads, rng.randrange(len(quads)))
    labels = list(range(len(quads) + 2))
    rng.shuffle(labels)
    rng.shuffle(quads)
    quads = [tuple(labels[v] for v in quad) for quad in quads]
    return [quad[::-1] for quad in quads] if rng.random() < 0.5 else quads


def main():
    if sys.argv[1:] == ["--print"]:
        two = list(CUBE)
        glue_cube(two, 1)
        print(code(CUBE), code(two))
        return 0
    rng = random.Random(1)
    samples = [list(CUBE)] + [random_quads(rng) for _ in range(40)]
    lines = "".join(" ".join(str(v) for quad in quads for v in quad) + "\n" for quads in samples)
    answer = subprocess.run([sys.argv[1]], input=lines, capture_output=True, text=True, check=True)
    expected = [code(quads) for quads in samples]
    found = answer.stdout.split()
    wrong = [pair for pair in zip(expected, found) if pair[0] != pair[1]]
    print(f"{len(samples)} quadrangulations, {len(set(expected))} classes, {len(wrong)} wrong codes")
    return 0 if not wrong and len(found) == len(expected) and len(set(expected)) > 20 else 1


if __name__ == "__main__":
    sys.exit(main())
