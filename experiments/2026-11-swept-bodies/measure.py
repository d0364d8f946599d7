#!/usr/bin/env python3
"""Meshes the surfaces of shafts, unions of boxes and balls; a line of result.tsv for each.

usage: measure.py PROGRAM COUNT    COUNT random shafts and COUNT random unions of boxes
"""
import collections
import itertools
import json
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "cli"))
import surfaces  # noqa: E402  pylint: disable=wrong-import-position

COLUMNS = ("name", "quads", "layers_hexahedra", "method", "hexahedra", "valid", "min_scaled_jacobian",
           "mean_scaled_jacobian", "rest")


def random_shaft(seed):
    rng = random.Random(seed)
    core, steps = rng.randint(1, 3), []
    for _ in range(rng.randint(2, 7)):
        steps.append((rng.choice([k for k in (1, 2, 3, 4) if not steps or k != steps[-1][0]]), rng.randint(1, 3)))
    surface, of_layers = surfaces.shaft(core, *steps)
    return surface, sum(of_layers)


def is_sphere(surface):
    points, quads = surface
    edges = collections.Counter(frozenset((quad[i], quad[i - 1])) for quad in quads for i in range(4))
    return set(edges.values()) == {2} and len(points) - len(edges) + len(quads) == 2


def body_of(cubes):
    """The surface and the number of these cubes; None unless it is a sphere of some size."""
    surface = surfaces.of_cubes(cubes)
    return (surface, len(cubes)) if is_sphere(surface) and len(surface[1]) >= 24 else None


def random_union(seed):
    """Of two to five boxes of one to five cubes along each axis, each at a cube of the others; None unless a sphere."""
    rng, cubes = random.Random(seed), set()
    for _ in range(rng.randint(2, 5)):
        at = rng.choice(sorted(cubes)) if cubes and rng.random() < 0.9 else (0, 0, 0)
        size = [rng.randint(1, 5) for _ in range(3)]
        low = [at[k] - rng.randint(0, size[k] - 1) for k in range(3)]
        cubes |= {(low[0] + x, low[1] + y, low[2] + z)
                  for x in range(size[0]) for y in range(size[1]) for z in range(size[2])}
    return body_of(cubes)


def random_bodies(name, make, count):
    """The first so many seeds that give a body."""
    made = ((seed, make(seed)) for seed in itertools.count())
    for seed, body in itertools.islice(((seed, body) for seed, body in made if body), count):
        yield f"{name} {seed}", *body


def bodies(count):
    """Names, surfaces, and the hexahedra of the body made of layers."""
    for name, core, steps in (("cylinder", 2, ((3, 4),)), ("two radii", 2, ((3, 2), (1, 3))),
                              ("flange", 2, ((1, 2), (3, 2), (1, 2))), ("spool", 2, ((3, 2), (1, 2), (3, 2)))):
        surface, of_layers = surfaces.shaft(core, *steps)
        yield name, surface, sum(of_layers)
    for n in (3, 5, 10, 20):
        yield f"ball {n}", surfaces.ball(n), n ** 3
    yield from random_bodies("shaft", random_shaft, count)
    yield from random_bodies("boxes", random_union, count)


def line(program, name, surface, hexahedra):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "in.obj")
        with open(path, "w", encoding="utf-8") as file:
            file.write(surfaces.obj(*surface))
        ran = subprocess.run([program, "mesh", "hex", path, "-o", os.path.join(folder, "out.vtk"), "--json"],
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True)
    said = json.loads(ran.stdout)
    return (name, said["quads"], hexahedra, said["method"], said["hexahedra"], said["valid"],
            f"{said['min_scaled_jacobian']:.3f}", f"{said['mean_scaled_jacobian']:.3f}", said["cavity_filled_by"])


def main(bodies_of):
    program, count = sys.argv[1], int(sys.argv[2])
    print(*COLUMNS, sep="\t")
    for body in bodies_of(count):
        print(*line(program, *body), sep="\t", flush=True)


if __name__ == "__main__":
    main(bodies)
