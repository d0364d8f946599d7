#!/usr/bin/env python3
"""Meshes the surfaces of bodies with recesses; a line of result.tsv for each.

usage: measure.py PROGRAM COUNT    COUNT random cylinders with blind holes and COUNT random blocks with pockets
"""
import itertools
import os
import random
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "2026-11-swept-bodies"), os.path.join(HERE, "..", "..", "tests", "cli")]
import measure as swept  # noqa: E402  pylint: disable=wrong-import-position
import surfaces  # noqa: E402  pylint: disable=wrong-import-position


def box(low, high):
    return set(itertools.product(*(range(a, b) for a, b in zip(low, high))))


def named():
    block = box((0, 0, 0), (6, 6, 6))
    for name, cubes in (("pocket", block - box((2, 2, 4), (4, 4, 6))),
                        ("pocket in a pocket", block - box((1, 1, 4), (5, 5, 6)) - box((2, 2, 2), (4, 4, 4))),
                        ("two sides", block - box((1, 1, 4), (3, 5, 6)) - box((1, 1, 0), (5, 5, 2))),
                        ("undercut", block - box((2, 2, 3), (4, 4, 6)) - box((1, 1, 3), (5, 5, 4))),
                        ("column", block - box((1, 1, 3), (5, 5, 6)) | box((2, 2, 3), (4, 4, 6)))):
        yield name, surfaces.of_cubes(cubes), len(cubes)


def random_hole(seed):
    """A cylinder with one to three blind holes, each from the floor of the one before; a ring at least between them."""
    rng = random.Random(seed)
    radius, height = rng.randint(2, 5), rng.randint(3, 9)
    holes, within, left = [], radius, height - 1
    while len(holes) < 3 and within > 0 and left > 0 and (not holes or rng.random() < 0.6):
        within, depth = rng.randint(0, within - 1), rng.randint(1, left)
        holes.append((within, depth))
        left -= depth
    return surfaces.blind_hole(rng.randint(1, 3), radius, height, *holes)


def random_pockets(seed):
    """A block of four to eight cubes along each axis, less one to four boxes from any side; None unless a sphere."""
    rng = random.Random(seed)
    size = [rng.randint(4, 8) for _ in range(3)]
    cubes = box((0, 0, 0), size)
    for _ in range(rng.randint(1, 4)):
        low, high = [0, 0, 0], [0, 0, 0]
        deep, is_from_above = rng.randrange(3), rng.random() < 0.5
        for k in range(3):
            width = rng.randint(1, size[k] - (1 if k == deep else 2))
            low[k] = rng.randint(1, size[k] - 1 - width) if k != deep else size[k] - width if is_from_above else 0
            high[k] = low[k] + width
        cubes -= box(low, high)
    return swept.body_of(cubes)


def bodies(count):
    """Names, surfaces, and the hexahedra of the body made of layers."""
    yield from named()
    yield from swept.random_bodies("holes", random_hole, count)
    yield from swept.random_bodies("pockets", random_pockets, count)


if __name__ == "__main__":
    swept.main(bodies)
