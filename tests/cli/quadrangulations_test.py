#!/usr/bin/env python3
"""Claim. `enum quadrangulations` counts and lists the quadrangulations of a class; the output does not
depend on the number of threads; shards add up; a stopped run claims nothing; bad arguments are refused.
Oracle. The published counts; the codes of the table, which the judge proves complete; planar_code, read again here as docs/formats/planar_code.md has it;
isomorphism by comparing codes of all flags of the lists of neighbours.
"""
import json
import os
import signal
import subprocess
import time

import program

HEADER = b">>planar_code<<"


def graphs(data):
    """Lists of neighbours, clockwise, from 0."""
    if not data.startswith(HEADER):
        raise ValueError("no header")
    at = len(HEADER)
    found = []
    while at < len(data):
        vertices = data[at]
        at += 1
        graph = []
        for _ in range(vertices):
            end = data.index(0, at)
            graph.append([w - 1 for w in data[at:end]])
            at = end + 1
        found.append(graph)
    return found


def code(graph):
    """The least list of numbers met by a walk, over all flags: equal for isomorphic maps only."""
    best = None
    for mirrored in (False, True):
        around = [g[::-1] for g in graph] if mirrored else graph
        for v, neighbours in enumerate(around):
            for w in neighbours:
                number, entry, word = {v: 0}, [(v, w)], []
                for a, first in entry:
                    at = around[a].index(first)
                    for b in around[a][at:] + around[a][:at]:
                        if b not in number:
                            number[b] = len(number)
                            entry.append((b, a))
                        word.append(number[b])
                    word.append(-1)
                if best is None or word < best:
                    best = word
    return tuple(best)


def is_simple_quadrangulation(graph):
    edges = {(v, w) for v, around in enumerate(graph) for w in around}
    if len(edges) != sum(map(len, graph)) or any((w, v) not in edges or v == w for v, w in edges):
        return False
    left = set(edges)
    while left:  # clockwise after the way back: the face on the left
        edge = start = next(iter(left))
        for _ in range(4):
            left.discard(edge)
            v, w = edge
            edge = (w, graph[w][(graph[w].index(v) + 1) % len(graph[w])])
        if edge != start:
            return False
    return len(edges) == 4 * (len(graph) - 2)


def mirrored(graph):
    """In planar_code, with the vertices counted from the last one."""
    around = [[len(graph) - w for w in reversed(neighbours)] for neighbours in reversed(graph)]
    return bytes([len(graph)]) + b"".join(bytes(neighbours) + b"\0" for neighbours in around)


class QuadrangulationsTest(program.ProgramTest):
    def enum(self, *arguments, code=0):
        return self.expect(code, self.hexatlas("enum", "quadrangulations", *arguments))

    def counts(self, *arguments):
        return json.loads(self.enum(*arguments, "--json").out)

    def test_published_counts(self):
        self.assertEqual(self.counts("--quads", "14"), {
            "quads": 14, "class": "3-connected", "count": 58, "orientation_preserving": 92,
            "rooted_sum": 3700, "exhaustive": True})
        for name, quads, count in (("3-connected", 18, 4461), ("min-degree-3", 18, 5146),
                                   ("simple", 12, 15882), ("simple", 2, 1), ("3-connected", 5, 0)):
            said = self.counts("--quads", str(quads), "--class", name, "--count")
            self.assertEqual((said["class"], said["count"]), (name, count))
        text = self.enum("--quads", "12", "--class", "min-degree-3").out
        self.assertIn("min-degree-3 quadrangulations of the sphere with 12 quads: 12\n", text)
        self.assertIn("exhaustive", text)

    def test_a_stop_leaves_what_was_there(self):
        self.write("list", "before")
        for output, words in (("list", "stopped; nothing is written"), ("-", "stopped; the list is not whole")):
            with subprocess.Popen([program.PROGRAM, "enum", "quadrangulations", "--quads", "26", "-o", output],
                                  cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as running:
                program.wait_for_handler(running, signal.SIGTERM)
                running.send_signal(signal.SIGTERM)
                said = running.communicate(timeout=120)[1].decode()
            self.assertEqual((running.returncode, said), (4, f"hexatlas: {words}\n"))
        self.assertEqual((self.listing(), self.read("list")), (["list"], b"before"))

    def test_list_is_planar_code_and_the_same_for_any_threads(self):
        for name, quads, count in (("3-connected", 13, 18), ("min-degree-3", 12, 12),
                                   ("simple", 8, 62)):
            lists = []
            for threads in ("1", "2", "3"):
                self.enum("--quads", str(quads), "--class", name, "-o", "list", "-j", threads)
                lists.append(self.read("list"))
            self.assertEqual(lists[0], lists[1])
            self.assertEqual(lists[0], lists[2])
            found = graphs(lists[0])
            for graph in found:
                self.assertEqual(len(graph), quads + 2)
                self.assertTrue(is_simple_quadrangulation(graph))
                self.assertGreaterEqual(min(map(len, graph)), 2 if name == "simple" else 3)
            self.assertEqual(len(found), count)
            self.assertEqual(len(set(map(code, found))), count)

    def test_list_of_codes(self):
        expected = self.expect(0, self.hexatlas("table", "list")).out.splitlines()[1:]
        expected = [row.split("\t")[0] for row in expected]
        found = []
        for quads in ("6", "8", "10", "12", "14"):
            self.expect(0, self.hexatlas("enum", "quadrangulations", "--quads", quads, "--codes", "-o", "list.txt"))
            found += self.read("list.txt").decode().splitlines()
        self.assertEqual(len(found), 1 + 1 + 3 + 11 + 58)
        self.assertEqual(sorted(found), sorted(expected[:len(found)]))
        simple = self.expect(0, self.hexatlas("enum", "quadrangulations", "--quads", "7", "--class", "simple", "--codes",
                                              "-o", "-")).out.splitlines()
        self.assertEqual((len(simple), len(set(simple))), (18, 18))
        self.expect(2, self.hexatlas("enum", "quadrangulations", "--quads", "6", "--codes"))

    def test_lists_are_read_again(self):
        for name, quads in (("3-connected", 14), ("min-degree-3", 12), ("simple", 7)):
            where = ("--quads", str(quads), "--class", name, "-o", "-")
            expected = self.enum(*where, "--codes").out.splitlines()
            self.enum(*where[:-1], "list")
            self.assertEqual(self.expect(0, self.hexatlas("code", "list")).out.splitlines(), expected)
            ran = self.hexatlas("code", "-", "--json", stdin=self.read("list"))
            said = [json.loads(line) for line in self.expect(0, ran).out.splitlines()]
            self.assertEqual([row["code"] for row in said], expected)
            if name != "simple":
                self.assertEqual({row["three_connected"] for row in said}, {True} if name == "3-connected" else {True, False})
            self.assertEqual(self.counts(*where[:-2])["rooted_sum"],
                             sum(8 * row["quads"] // row["automorphisms"] for row in said))
            # Mirror images with other names, in reversed order and without the header.
            self.write("again.planar_code", b"".join(map(mirrored, reversed(graphs(self.read("list"))))))
            self.assertEqual(self.expect(0, self.hexatlas("code", "again.planar_code")).out.splitlines(), expected[::-1])
        self.write("empty", HEADER)
        self.assertEqual(self.expect(0, self.hexatlas("code", "empty")).out, "")

    def test_a_list_of_one_is_a_boundary(self):
        self.enum("--quads", "8", "-o", "one")
        for arguments in (("mesh", "boundary", "one", "-o", "a.vtu"), ("enum", "hexmeshes", "one", "--max-hexes", "1")):
            told = json.loads(self.expect(0, self.hexatlas(*arguments, "--json")).out)
            self.assertEqual(told["code" if arguments[0] == "mesh" else "boundary"], "q1:088a577f")
        self.enum("--quads", "10", "-o", "three")
        ran = self.hexatlas("mesh", "boundary", "three", "-o", "b.vtu")
        self.expect_fault(ran, "three")
        self.assertIn("has 3 quadrangulations", ran.err)

    def test_lists_that_are_damaged_are_refused(self):
        self.enum("--quads", "10", "-o", "list")
        whole = self.read("list")
        for name, data, words in (("cut", whole[:-1], "graph 3: the file ends inside this graph"),
                                  ("changed", whole[:-2] + b"\x0d\0", "graph 3: vertex 12 has the neighbour 13"),
                                  ("y.planar_code", bytes([67]), "graph 1: the number of vertices"),
                                  ("x.planar_code", b"\4\2\3\4\0\1\4\3\0\1\2\4\0\1\3\2\0", "graph 1: ")):
            self.write(name, data)
            ran = self.hexatlas("code", name)
            self.expect_fault(ran, name)
            self.assertIn(f"{name}: {words}", ran.err)

    def test_list_on_standard_output(self):
        self.enum("--quads", "10", "-o", "list")
        with open(self.path("out"), "wb") as out:
            ran = self.hexatlas("enum", "quadrangulations", "--quads", "10", "-o", "-", "--json",
                                stdout=out)
        self.expect(0, ran)
        self.assertEqual(self.read("out"), self.read("list"))
        self.assertEqual(json.loads(ran.err)["count"], 3)

    def test_shards_add_up(self):
        quads = "15" if program.SANITIZED else "17"
        whole = self.counts("--quads", quads)
        self.enum("--quads", "12", "-o", "whole")
        for parts in (2, 3, 7):
            said = [self.counts("--quads", quads, "--shard", f"{r}/{parts}") for r in range(parts)]
            for key in ("count", "orientation_preserving", "rooted_sum"):
                self.assertEqual(sum(s[key] for s in said), whole[key])
            self.assertEqual([s["shard"] for s in said], [f"{r}/{parts}" for r in range(parts)])
            self.assertFalse(any(s["exhaustive"] for s in said))
            found = []
            for r in range(parts):
                self.enum("--quads", "12", "--shard", f"{r}/{parts}", "-o", "part")
                found += graphs(self.read("part"))
            self.assertEqual(sorted(map(code, found)), sorted(map(code, graphs(self.read("whole")))))
        self.assertTrue(self.counts("--quads", quads, "--shard", "0/1")["exhaustive"])
        self.assertNotIn("exhaustive", self.enum("--quads", "12", "--shard", "0/2").out)

    def test_wrong_usage(self):
        for arguments in ((), ("--quads", "1"), ("--quads", "65"), ("--quads", "x"),
                          ("--quads", "8", "--class", "cubic"), ("--quads", "8", "--shard", "2/2"),
                          ("--quads", "8", "--shard", "-1/2"), ("--quads", "8", "--shard", "1"),
                          ("--quads", "8", "--shard", "1/2/3"), ("--quads", "8", "--shard", "0/0"),
                          ("--quads", "8", "--shard", ""), ("--quads", "8", "-j", "0"),
                          ("--quads", "8", "--count", "-o", "list"), ("--quads", "8", "more")):
            with self.subTest(arguments=arguments):
                ran = self.enum(*arguments, code=2)
                self.assertEqual(ran.out, "")
                self.assertIn("`hexatlas enum quadrangulations --help`", ran.err)
        self.assertEqual(self.listing(), [])
        self.expect_fault(self.hexatlas("enum", "quadrangulations", "--quads", "8", "-o",
                                        os.path.join("none", "list")), os.path.join("none", "list"))

    def test_a_stopped_run_claims_nothing(self):
        for arguments in ((), ("--json",), ("-o", "list")):
            running = subprocess.Popen(
                [program.PROGRAM, "enum", "quadrangulations", "--quads", "40", "-j", "2", *arguments],
                cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            time.sleep(0.5)
            running.send_signal(signal.SIGINT)
            out, err = running.communicate(timeout=60)
            self.assertEqual((running.returncode, out), (4, b""), err)
            self.assertRegex(err, rb"\Ahexatlas: stopped; [^\n]+\n\Z")
        self.assertEqual(self.listing(), [])


if __name__ == "__main__":
    program.main()
