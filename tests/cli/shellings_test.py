#!/usr/bin/env python3
"""Claim. `enum shellings` counts and lists the shellable hexahedral balls; the output does not depend on the
number of threads; a stopped run says what it has finished; bad arguments are refused.
Oracle. The counts of an independent program; docs/formats/shellings.md, read again here: each line is
replayed by sets, hexahedron by hexahedron; no two lines are isomorphic, by numbering all vertices anew
from each corner of each hexahedron. Codes of boundaries as the list gives them.
"""
import itertools
import json
import os
import signal
import subprocess
import time

import program

MESHES = [1, 1, 3, 12, 60, 441]
BOUNDARIES = [1, 1, 3, 12, 59, 421]
NEW = [1, 1, 3, 12, 57, 415]
EDGES = [(a, a | b) for a in range(8) for b in (1, 2, 4) if not a & b]
QUADS = [[v for v in range(8) if v >> axis & 1 == side] for axis in range(3) for side in (0, 1)]


def faces(cell):
    """Vertices, edges and quads, by number of vertices."""
    return {1: {frozenset((v,)) for v in cell},
            2: {frozenset((cell[a], cell[b])) for a, b in EDGES},
            4: {frozenset(cell[v] for v in quad) for quad in QUADS}}


def meet_strictly(a, b):
    common = frozenset(a) & frozenset(b)
    if not common:
        return True
    size = len(common)
    return size in (1, 2, 4) and common in faces(a)[size] and common in faces(b)[size]


def is_disc(quads, cell):
    """Whether quads of a cell are connected along edges and have Euler characteristic 1."""
    parts = {size: {f for f in faces(cell)[size] if any(f <= q for q in quads)} for size in (1, 2)}
    reached, todo = set(), list(quads)[:1]
    while todo:
        quad = todo.pop()
        reached.add(quad)
        todo += [q for q in quads if q not in reached and len(q & quad) == 2]
    return bool(quads) and reached == set(quads) and \
        len(parts[1]) - len(parts[2]) + len(quads) == 1


def fault(cells):
    """What keeps a list of cells from being a shelling under the strict rule."""
    uses = {}
    present = set()
    for i, cell in enumerate(cells):
        if len(set(cell)) != 8 or not all(meet_strictly(cell, other) for other in cells[:i]):
            return "strict rule"
        own = faces(cell)
        shared = {q for q in own[4] if q in uses}
        if i and not (is_disc(shared, cell) and is_disc(own[4] - shared, cell)):
            return "no patch"
        if any(f in present and not any(f <= q for q in shared) for size in (1, 2) for f in own[size]):
            return "meets in more"
        for quad in own[4]:
            uses[quad] = uses.get(quad, 0) + 1
        present |= own[1] | own[2]
    if max(uses.values()) > 2:
        return "three hexahedra at a quad"
    return ""


def form(cells):
    """Equal for isomorphic balls only: the least list of cells over all numberings that begin with a
    corner of a cell and its three edges in some order."""
    at_quad = {}
    for cell in cells:
        for axis, side in itertools.product(range(3), (0, 1)):
            quad = frozenset(cell[v] for v in range(8) if v >> axis & 1 == side)
            at_quad.setdefault(quad, []).append(cell)
    best = None
    for cell in cells:
        for corner, axes in itertools.product(range(8), itertools.permutations((1, 2, 4))):
            first = tuple(cell[corner ^ sum(axes[k] for k in range(3) if v >> k & 1)] for v in range(8))
            number, queue, met = {}, [first], {frozenset(first)}
            for turned in queue:
                for v in turned:
                    number.setdefault(v, len(number))
                for axis, side in itertools.product(range(3), (0, 1)):
                    near = [v for v in range(8) if v >> axis & 1 == side]
                    for other in at_quad[frozenset(turned[v] for v in near)]:
                        if frozenset(other) in met:
                            continue
                        met.add(frozenset(other))
                        place = [None] * 8
                        inside = frozenset(turned[v] for v in near)
                        for v in near:
                            c = other.index(turned[v])
                            place[v ^ 1 << axis] = turned[v]
                            place[v] = next(other[c ^ b] for b in (1, 2, 4)
                                            if other[c ^ b] not in inside)
                        queue.append(tuple(place))
            word = tuple(tuple(number[v] for v in turned) for turned in queue)
            if best is None or word < best:
                best = word
    return best


def read(text):
    """Number of hexahedra, and of each ball its code, order of its group and cells."""
    lines = text.decode("ascii").split("\n")
    word, version, hexes, count = lines[0].split(" ")
    if (word, version, lines[-1]) != ("shellings", "1", "") or len(lines) != int(count) + 2:
        raise ValueError("no header, or another number of lines")
    balls = []
    for line in lines[1:-1]:
        code, automorphisms, *vertices = line.split(" ")
        vertices = [int(v) for v in vertices]
        cells = [tuple(vertices[i:i + 8]) for i in range(0, len(vertices), 8)]
        balls.append((code, int(automorphisms), cells))
    return int(hexes), balls


class ShellingsTest(program.ProgramTest):
    def enum(self, *arguments, code=0):
        return self.expect(code, self.hexatlas("enum", "shellings", *arguments))

    def test_known_counts(self):
        rows = [{"hexes": h, "meshes": m, "boundaries": b, "new_boundaries": n}
                for h, (m, b, n) in enumerate(zip(MESHES, BOUNDARIES, NEW), 1)]
        for hexes in (1, 2, 6):
            self.assertEqual(json.loads(self.enum("--hexes", str(hexes), "--json").out), {
                "hexes": hexes, "meshes": MESHES[hexes - 1], "boundaries": BOUNDARIES[hexes - 1],
                "by_hexes": rows[:hexes], "exhaustive": True})
        text = self.enum("--hexes", "5").out
        self.assertIn("        5           60           59           57\n", text)
        self.assertIn("shellable balls of 5 hexahedra: 60 meshes; the search is exhaustive\n", text)
        self.assertIn("shellable balls of 1 hexahedron: 1 mesh;", self.enum("--hexes", "1").out)

    def test_list_is_one_shelling_of_each_class(self):
        for hexes in range(1, 6):
            self.enum("--hexes", str(hexes), "-o", "list")
            said, balls = read(self.read("list"))
            self.assertEqual((said, len(balls)), (hexes, MESHES[hexes - 1]))
            self.assertEqual(len({code for code, _, _ in balls}), BOUNDARIES[hexes - 1])
            for _, automorphisms, cells in balls:
                self.assertEqual(len(cells), hexes)
                vertices = list(itertools.chain(*cells))
                self.assertEqual(list(dict.fromkeys(vertices)), list(range(max(vertices) + 1)))
                self.assertEqual(fault(cells), "")
                self.assertEqual(48 * hexes % automorphisms, 0)
            self.assertEqual(len({form(cells) for _, _, cells in balls}), len(balls))

    def test_list_is_the_same_for_any_threads(self):
        lists = []
        for threads in ("1", "2", "3"):
            self.enum("--hexes", "6", "-o", "list", "-j", threads)
            lists.append(self.read("list"))
        self.assertEqual(lists[0], lists[1])
        self.assertEqual(lists[0], lists[2])

    def test_list_on_standard_output(self):
        self.enum("--hexes", "4", "-o", "list")
        ran = self.enum("--hexes", "4", "-o", "-", "--json")
        self.assertEqual(ran.out.encode(), self.read("list"))
        self.assertEqual(json.loads(ran.err)["meshes"], 12)

    def test_bad_input(self):
        for arguments in ((), ("--hexes", "0"), ("--hexes", "13"), ("--hexes", "x"),
                          ("--hexes", "3", "-j", "0"), ("--hexes", "3", "--memory", "0"),
                          ("--hexes", "3", "more")):
            with self.subTest(arguments=arguments):
                ran = self.enum(*arguments, code=2)
                self.assertEqual(ran.out, "")
                self.assertIn("`hexatlas enum shellings --help`", ran.err)
        self.assertEqual(self.listing(), [])
        missing = os.path.join("none", "list")
        self.expect_fault(self.hexatlas("enum", "shellings", "--hexes", "3", "-o", missing), missing)

    def test_a_stopped_run_says_what_is_finished(self):
        for arguments in (("--json",), ("-o", "list", "--json"), ()):
            running = subprocess.Popen(
                [program.PROGRAM, "enum", "shellings", "--hexes", "12", "-j", "1", *arguments],
                cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            time.sleep(1)
            running.send_signal(signal.SIGINT)
            out, err = running.communicate(timeout=60)
            self.assertEqual(running.returncode, 4, err)
            self.assertRegex(err, rb"\Ahexatlas: stopped; [^\n]+\n\Z")
            if "--json" not in arguments:
                self.assertNotIn(b"exhaustive", out)
                continue
            said = json.loads(out)
            self.assertEqual((said["hexes"], said["meshes"], said["boundaries"], said["exhaustive"]),
                             (12, None, None, False))
            finished = [row["meshes"] for row in said["by_hexes"]]
            self.assertGreater(len(finished), 3)
            self.assertEqual(finished[:6], MESHES[:len(finished)])
        self.assertEqual(self.listing(), [])


if __name__ == "__main__":
    program.main()
