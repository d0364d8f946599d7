#!/usr/bin/env python3
"""Claim. `table bounds` raises the lower bounds of a table and changes nothing else; it goes on from
what it wrote, says what was replaced, and a new search keeps the bounds of the tables that it begins
with. A claim that a mesh refutes is refused.
Oracle. docs/formats/table.md and census.md, read again in table_files.py; what is evident of one and
two hexahedra; `table check`.
"""
import json
import os
import signal
import struct
import subprocess
import time

import program
from table_files import QUICK, TableTest, signed

SHIPPED = os.path.join(program.REPOSITORY, "tables", "data", "hexatlas.hxt")
TWO_CUBES = bytes.fromhex("022972977f")


def with_bound(data, key, bound):
    data = bytearray(data)
    struct.pack_into("<H", data, data.index(key) + len(key) + 4, bound)
    return signed(data)


class Bounds(TableTest):
    def bounds(self, *options, code=0):
        ran = self.expect(code, self.hexatlas("table", "bounds", *options, "--json"))
        return json.loads(ran.out)

    def test_bounds_are_raised_and_nothing_else(self):
        said = self.bounds("small.hxt", "-o", "out.hxt", "--max-hexes", "5")
        self.assertEqual({key: said[key] for key in ("entries", "raised", "replaced",
                                                     "proven_smallest", "by_bound", "finished")},
                         {"entries": 2, "raised": 1, "replaced": 0, "proven_smallest": 2,
                          "by_bound": {"1": 1, "2": 1}, "finished": True})
        self.assertEqual(self.read("out.hxt"), with_bound(self.good, TWO_CUBES, 2))
        checked = json.loads(self.expect(0, self.hexatlas("table", "check", "out.hxt", "--json")).out)
        self.assertEqual([checked[key] for key in ("accepted", "claimed_bounds", "manifest", "census",
                                                   "complete_through")], [True, 1, True, True, 6])
        got = self.expect(0, self.hexatlas("table", "get", "--table", "out.hxt", "--name",
                                           "two-cubes"))
        self.assertEqual(json.loads(got.out)["lower_bound"], 2)
        before, after = (json.loads(self.expect(0, self.hexatlas(
            "table", "info", name, "--by", "quads", "--json")).out) for name in ("small.hxt",
                                                                                 "out.hxt"))
        self.assertEqual([row["sources"] for row in before["by_quads"].values()],
                         [row["sources"] for row in after["by_quads"].values()])

    def test_what_only_the_output_has_is_not_lost(self):
        cube = program.made_by("table", "build", "-o", "cube.hxt", *QUICK, "--max-hexahedra", "2")
        for name, data in cube.items():
            self.write(name, data)
        before = {name: self.read(name) for name in self.listing()}
        ran = self.hexatlas("table", "bounds", "cube.hxt", "-o", "small.hxt", "--max-hexes", "3")
        self.expect_fault(ran, "small.hxt")
        self.assertIn("1 mesh that TABLE lacks", ran.err)
        self.assertEqual({name: self.read(name) for name in self.listing()}, before)

    def test_a_table_may_follow_the_boundary(self):
        ran = self.expect(0, self.hexatlas("table", "bounds", "-o", "out.hxt", "--max-hexes", "3", "--only", "two-cubes",
                                           "--only", "cube", "small.hxt", "--json"))
        self.assertEqual(json.loads(ran.out)["entries"], 2)

    def test_goes_on_in_place_and_by_quads(self):
        said = self.bounds("small.hxt", "-o", "small.hxt", "--max-hexes", "9", "--max-quads", "6")
        self.assertEqual((said["raised"], said["by_bound"]), (0, {"1": 2}))
        for only, raised in (("cube", 0), ("q1:08a5df", 0), ("two-cubes", 1), ("q1:022972977f", 1)):
            said = self.bounds("small.hxt", "-o", f"{only[:2]}{only[-2:]}.hxt", "--max-hexes", "9", "--only", only)
            self.assertEqual(said["raised"], raised)
        for word in ("pyramid", "q1:088a577f"):
            self.expect_fault(self.hexatlas("table", "bounds", "small.hxt", "-o", "out.hxt",
                                            "--max-hexes", "9", "--only", word), word)
            self.assertNotIn("out.hxt", self.listing())
        self.assertEqual(self.read("small.hxt"), self.good)
        for raised in (1, 0):
            said = self.bounds("small.hxt", "-o", "small.hxt", "--max-hexes", "9", "-j", "2")
            self.assertEqual((said["raised"], said["by_bound"]), (raised, {"1": 1, "2": 1}))
        text = self.expect(0, self.hexatlas("table", "bounds", "small.hxt", "-o", "small.hxt",
                                            "--max-hexes", "9")).out
        self.assertIn("2 as small as their bounds\n", text)

    def test_what_is_too_large_for_a_search_is_not_finished(self):
        self.expect(0, self.hexatlas("table", "build", "-o", "eight.hxt", *QUICK[2:], "--max-quads", "8",
                                     "--max-hexahedra", "1", "--start-from", SHIPPED))
        self.write("eight.hxt", with_bound(self.read("eight.hxt"), bytes.fromhex("088a577f"), 29))
        os.remove(self.path("eight.manifest.json"))
        os.remove(self.path("eight.census.sqlite"))
        said = self.bounds("eight.hxt", "-o", "out.hxt", "--max-hexes", "40", "--only", "octagonal-spindle", code=4)
        self.assertEqual((said["raised"], said["finished"]), (0, False))
        said = self.bounds("eight.hxt", "-o", "out.hxt", "--max-hexes", "28", "--only", "octagonal-spindle")
        self.assertEqual((said["raised"], said["finished"]), (0, True))

    def test_a_new_search_keeps_bounds(self):
        self.bounds("small.hxt", "-o", "out.hxt", "--max-hexes", "2")
        build = ("table", "build", *QUICK, "--also", "two-cubes", "--max-hexahedra", "4")
        self.expect(0, self.hexatlas(*build, "-o", "next.hxt", "--start-from", "out.hxt"))
        said = json.loads(self.expect(0, self.hexatlas("table", "info", "next.hxt", "--by", "quads",
                                                       "--json")).out)
        self.assertEqual([(row["lower_bound"], row["proven_smallest"])
                          for row in said["by_quads"].values()], [(1, 1), (2, 1)])
        self.write("lie.hxt", with_bound(self.good, TWO_CUBES, 3))
        ran = self.hexatlas(*build, "-o", "other.hxt", "--start-from", "lie.hxt")
        self.expect(3, ran)
        self.assertIn("lie.hxt: claims that q1:022972977f has no mesh with fewer than 3 hexahedra; "
                      "one has 2", ran.err)
        self.assertNotIn("other.hxt", self.listing())

    def test_a_bound_that_is_false_is_refused(self):
        self.write("lie.hxt", with_bound(self.good, TWO_CUBES, 3))
        for only in ((), ("--only", "cube")):
            self.expect_fault(self.hexatlas("table", "bounds", "lie.hxt", "-o", "out.hxt",
                                            "--max-hexes", "4", *only), "lie.hxt")
        self.assertNotIn("out.hxt", self.listing())

    def build_a_table_with_the_spindle(self):
        self.expect(0, self.hexatlas("table", "build", "-o", "spindle.hxt", *QUICK,
                                     "--max-hexahedra", "1", "--also", "octagonal-spindle",
                                     "--start-from", SHIPPED))

    def test_the_same_command_goes_on_with_what_it_wrote(self):
        self.bounds("small.hxt", "-o", "out.hxt", "--max-hexes", "5")
        data = self.read("out.hxt")
        for words in (("--max-hexes", "1"), ("--max-hexes", "5", "--only", "cube")):
            ran = self.expect(0, self.hexatlas("table", "bounds", "small.hxt", "-o", "out.hxt", *words, "--json"))
            self.assertEqual(json.loads(ran.out)["raised"], 0)
            self.assertEqual(ran.err, "hexatlas: goes on with 1 boundary of out.hxt\n")
            self.assertEqual(self.read("out.hxt"), data)
        self.expect(0, self.hexatlas("table", "check", "out.hxt"))
        # A bound above the number of hexahedra known cannot be true.
        os.remove(self.path("out.census.sqlite"))
        self.write("out.hxt", with_bound(self.good, TWO_CUBES, 3))
        self.expect_fault(self.hexatlas("table", "bounds", "small.hxt", "-o", "out.hxt", "--max-hexes", "1"), "out.hxt")
        os.remove(self.path("out.manifest.json"))
        self.write("out.hxt", b"no table")
        self.bounds("small.hxt", "-o", "out.hxt", "--max-hexes", "5")
        self.assertEqual(self.read("out.hxt"), data)

    def test_a_stop_keeps_what_was_proven(self):
        self.build_a_table_with_the_spindle()
        words = ("table", "bounds", "spindle.hxt", "-o", "out.hxt", "--max-hexes", "40", "--json")
        with subprocess.Popen([program.PROGRAM, *words], cwd=self.folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
            program.wait_for_handler(running, signal.SIGINT)
            time.sleep(1)
            running.send_signal(signal.SIGINT)
            out, err = running.communicate(timeout=60)
            self.assertEqual(running.returncode, 4, err)
        said = json.loads(out)
        self.assertFalse(said["finished"])
        self.assertIn(b"goes on", err)
        self.assertGreater(max(map(int, said["by_bound"])), 5)
        self.expect(0, self.hexatlas("table", "check", "out.hxt"))

    def test_spent_nodes_are_told(self):
        self.build_a_table_with_the_spindle()
        words = ("table", "bounds", "spindle.hxt", "-o", "out.hxt", "--max-nodes", "2")
        ran = self.expect(4, self.hexatlas(*words, "--max-hexes", "40", "--json"))
        self.assertFalse(json.loads(ran.out)["finished"])
        self.assertRegex(ran.err, r"\Ahexatlas: for 1 boundary the search did not end: --max-nodes, [^\n]+\n\Z")
        ran = self.expect(0, self.hexatlas(*words, "--max-hexes", "9", "--json"))  # known of both
        self.assertTrue(json.loads(ran.out)["finished"])

    def test_bad_arguments(self):
        for words in (("small.hxt", "-o", "-", "--max-hexes", "3"),
                      ("small.hxt", "-o", "small.bak", "--max-hexes", "3"),
                      ("small.hxt", "-o", "out.hxt"),
                      ("small.hxt", "-o", "out.hxt", "--max-hexes", "0"),
                      ("small.hxt", "-o", "out.hxt", "--max-hexes", "65"),
                      ("small.hxt", "-o", "out.hxt", "--max-hexes", "3", "--max-nodes", "0")):
            self.expect(2, self.hexatlas("table", "bounds", *words))
        self.expect_fault(self.hexatlas("table", "bounds", "none.hxt", "-o", "out.hxt",
                                        "--max-hexes", "3"), "none.hxt")
        self.assertNotIn("out.hxt", self.listing())


if __name__ == "__main__":
    program.main()
