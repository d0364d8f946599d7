#!/usr/bin/env python3
"""A random 3-connected quadrangulation of the sphere, as an OBJ file on standard output.

usage: random_quads.py QUADS SEED INSERTED

Grown from the cube, without double edges and without two quads that share two opposite vertices.
With probability INSERTED a quad is replaced by a smaller one and four around it; else a vertex is
split along two of its edges into two of degree 3 or more, with a new quad between them. Points lie
on the unit sphere: those of a new vertex are means of their neighbours; then all are drawn towards
their neighbours a few times. Quads may fold over.
"""
import math
import random
import sys


def pair(a, b):
    return (a, b) if a < b else (b, a)


class Sphere:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.points = [[x / 3 ** 0.5 for x in p] for p in
                       ((-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1),
                        (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1))]
        self.quads, self.left_of, self.opposite = [], {}, set()
        for quad in ([0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6],
                     [3, 0, 4, 7]):
            self.put(len(self.quads), quad)

    def put(self, place, quad):
        if place == len(self.quads):
            self.quads.append(None)
        self.quads[place] = quad
        for i in range(4):
            self.left_of[quad[i - 1], quad[i]] = place
        for i in range(2):
            assert pair(quad[i], quad[i + 2]) not in self.opposite
            self.opposite.add(pair(quad[i], quad[i + 2]))

    def take(self, place):
        quad = self.quads[place]
        for i in range(4):
            del self.left_of[quad[i - 1], quad[i]]
        for i in range(2):
            self.opposite.remove(pair(quad[i], quad[i + 2]))

    def new_point(self, weights):
        point = [sum(w * self.points[v][k] for v, w in weights) for k in range(3)]
        length = math.hypot(*point) or 1
        self.points.append([x / length for x in point])
        return len(self.points) - 1

    def insert_into(self, place):
        outer = self.quads[place]
        self.take(place)
        inner = [self.new_point([(v, 2 if v == at else 1) for v in outer]) for at in outer]
        self.put(place, inner)
        for i in range(4):
            self.put(len(self.quads), [outer[i - 1], outer[i], inner[i], inner[i - 1]])

    def around(self, v, first):
        """Neighbours of v, counter-clockwise, each with the quad left of the edge to it."""
        place, result = first, []
        while not result or place != first:
            quad = self.quads[place]
            at = quad.index(v)
            result.append((quad[(at + 1) % 4], place))
            place = self.left_of[v, quad[at - 1]]
        return result

    def split(self, v, place):
        ring = self.around(v, place)
        if len(ring) < 4:
            return
        start, moved = self.random.randrange(len(ring)), self.random.randrange(2, len(ring) - 1)
        ring = ring[start:] + ring[:start]
        a, b = ring[0][0], ring[moved][0]
        if pair(a, b) in self.opposite:
            return
        w = self.new_point([(v, moved + 1)] + [(u, 1) for u, _ in ring[:moved + 1]])
        for _, quad in ring[:moved]:
            self.take(quad)
        for _, quad in ring[:moved]:
            self.put(quad, [w if u == v else u for u in self.quads[quad]])
        self.put(len(self.quads), [v, a, w, b])

    def grow(self, quads, inserted):
        while len(self.quads) < quads:
            place = self.random.randrange(len(self.quads))
            if self.random.random() < inserted:
                if len(self.quads) + 4 <= quads:
                    self.insert_into(place)
            else:
                self.split(self.random.choice(self.quads[place]), place)

    def smooth(self, rounds):
        for _ in range(rounds):
            sums = [list(p) for p in self.points]
            for a, b in self.left_of:
                for k in range(3):
                    sums[a][k] += self.points[b][k]
            self.points = [[x / (math.hypot(*s) or 1) for x in s] for s in sums]


def main(quads, seed, inserted):
    sphere = Sphere(seed)
    sphere.grow(quads, inserted)
    sphere.smooth(3)
    assert len(sphere.points) == len(sphere.quads) + 2 == quads + 2
    assert len(sphere.left_of) == 4 * quads and len(sphere.opposite) == 2 * quads
    print("\n".join("v " + " ".join(map(repr, p)) for p in sphere.points))
    print("\n".join("f " + " ".join(str(v + 1) for v in q) for q in sphere.quads))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]))
