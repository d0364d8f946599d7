#!/usr/bin/env python3
"""Claim. `enum hexmeshes` finds all meshes of a boundary within limits; what it lists obeys the rules;
threads, shards, a kill and a saved search change nothing; certificates are judged; bad arguments are
refused. Oracle. The known fillings: one and seven hexahedra for the cube, two for two cubes glued; the
rules of a mesh, read here from its quads.
"""
import collections
import hashlib
import itertools
import json
import signal
import subprocess
import time

import program
import surfaces

PYRAMID = "q1:02228a2a5777df7f"
CUBE_QUADS = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
SURFACE = "OFF\n8 6 0\n" + "".join(f"{v & 1} {v >> 1 & 1} {v >> 2}\n" for v in range(8)) + "".join(
    "4 " + " ".join(map(str, quad)) + "\n"
    for quad in [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)])


def kinds(cell):
    """The kind of each pair of vertices: how many coordinates differ."""
    return {frozenset((cell[a], cell[b])): bin(a ^ b).count("1")
            for a, b in itertools.combinations(range(8), 2)}


class Hexmeshes(program.ProgramTest):
    def run_json(self, *arguments, code=0):
        ran = self.hexatlas("enum", "hexmeshes", *arguments, "--json")
        self.assertEqual(ran.code, code, ran)
        return json.loads(ran.out)

    def start(self, *arguments):
        return subprocess.Popen([program.PROGRAM, "enum", "hexmeshes", *arguments], cwd=self.folder,
                                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)

    def saved(self):
        """The bytes of the saved search, if it is there."""
        return self.read("saved") if "saved" in self.listing() else b""

    def expect_mesh(self, mesh):
        quads = collections.Counter(frozenset(cell[i] for i in quad)
                                    for cell in mesh["cells"] for quad in CUBE_QUADS)
        self.assertLessEqual(max(quads.values()), 2)
        self.assertEqual({q for q, n in quads.items() if n == 1},
                         {frozenset(q) for q in mesh["boundary"]})
        kind = {}
        for cell in mesh["cells"]:
            self.assertEqual(len(set(cell)), 8)
            for pair, of in kinds(cell).items():
                self.assertEqual(kind.setdefault(pair, of), of)

    def test_lists_meshes(self):
        found = self.run_json("two-cubes", "--max-hexes", "8", "--ball", "-o", "found.jsonl")
        self.assertEqual(found["by_hexes"], {"2": {"classes": 1, "labelled": 1, "balls": 1},
                                             "6": {"classes": 1, "labelled": 1, "balls": 1},
                                             "8": {"classes": 1, "labelled": 2, "balls": 1}})
        self.assertTrue(found["exhaustive"] and found["finished"])
        lines = self.read("found.jsonl").decode().splitlines()
        self.assertEqual(len(lines), 3)
        for line in lines:
            self.expect_mesh(json.loads(line))

    def test_takes_names_codes_and_surfaces(self):
        self.write("cube.off", SURFACE)
        counts = [self.run_json(boundary, "--max-hexes", "7")
                  for boundary in ("cube", "q1:08a5df", "cube.off")]
        self.assertEqual(counts[0]["classes"], 2)
        self.assertEqual(counts[0], counts[1])
        self.assertEqual(counts[0], counts[2])

    def test_first_stops_early(self):
        found = self.run_json("cube", "--max-hexes", "7", "--first")
        self.assertEqual(found["classes"], 1)

    def test_first_of_several_is_not_all(self):
        limits = ("two-cubes", "--max-hexes", "8", "--ball")
        found = self.run_json(*limits, "--first")
        self.assertEqual((found["classes"], found["exhaustive"], found["finished"]), (1, False, False))
        text = self.expect(0, self.hexatlas("enum", "hexmeshes", *limits, "--first")).out
        self.assertIn(": at least 1 class; ", text)
        self.assertNotIn("exhaustive", text)
        only = self.run_json("two-cubes", "--max-hexes", "5", "--ball", "--first")
        self.assertEqual(only["classes"], 1)

    def test_a_share_is_not_all(self):
        limits = ("two-cubes", "--max-hexes", "8", "--ball", "--shard", "2/3")
        found = self.run_json(*limits)
        self.assertEqual((found["exhaustive"], found["finished"]), (False, True))
        text = self.expect(0, self.hexatlas("enum", "hexmeshes", *limits)).out
        self.assertIn("part 2/3: ", text)
        self.assertTrue(text.endswith("; that part is exhausted\n"), text)

    def test_threads_and_shards_change_nothing(self):
        whole = self.run_json(PYRAMID, "--max-hexes", "12", "--ball", "-j", "1")
        self.assertEqual(self.run_json(PYRAMID, "--max-hexes", "12", "--ball", "-j", "2"), whole)
        for parts in (2, 3, 7):
            shards = [self.run_json(PYRAMID, "--max-hexes", "12", "--ball", "--shard",
                                    f"{part}/{parts}") for part in range(parts)]
            self.assertEqual(sum(shard["nodes"] for shard in shards), whole["nodes"])
            self.assertGreater(min(shard["nodes"] for shard in shards), 0)

    def test_a_killed_search_goes_on(self):
        arguments = (PYRAMID, "--max-hexes", "17", "--ball", "-j", "1")
        whole = self.run_json(*arguments)
        saved = (*arguments, "--state", "saved", "--save-every", "0")
        seen = set()
        for _ in range(3):
            with self.start(*saved) as search:
                before = self.saved()
                while search.poll() is None and self.saved() == before:
                    time.sleep(0.002)
                search.kill()
            seen.add(self.saved())
        self.assertEqual(len(seen), 3, "a search was killed before it saved anything new")
        cut = self.run_json(*saved, "--max-nodes", "200000", code=4)
        self.assertLess(cut["nodes"], whole["nodes"])
        self.assertEqual(self.run_json(*saved), whole)
        self.assertEqual(self.run_json(*saved), whole)  # nothing is left to do
        self.hexatlas_fails(3, "enum", "hexmeshes", PYRAMID, "--max-hexes", "14", "--ball",
                            "--state", "saved")

    def test_a_saved_search_with_other_meshes_is_refused(self):
        words = ("two-cubes", "--max-hexes", "4", "--ball", "--state", "saved")
        self.run_json(*words)
        lines = self.read("saved").decode().splitlines(keepends=True)
        at = next(i for i, line in enumerate(lines) if line.startswith("mesh "))
        vertices, automorphisms, *others = lines[at].split()[1:]
        for changed in ([vertices, "0", *others], [vertices, "7", *others], ["11", automorphisms, *others],
                        [vertices, automorphisms, *others[:-1], vertices]):
            text = "".join([*lines[:at], " ".join(["mesh", *changed]) + "\n", *lines[at + 1:-1]])
            self.write("saved", text + f"sha256 {hashlib.sha256(text.encode()).hexdigest()}\n")
            self.hexatlas_fails(3, "enum", "hexmeshes", *words)
        self.hexatlas_fails(3, "enum", "hexmeshes", *words[:-1], "/dev/null")
        text = "".join([*lines[:-1], "root 8\n"])  # one more than said
        self.write("saved", text + f"sha256 {hashlib.sha256(text.encode()).hexdigest()}\n")
        self.hexatlas_fails(3, "enum", "hexmeshes", *words)

    def test_a_stopped_search_claims_nothing(self):
        with self.start(PYRAMID, "--max-hexes", "22", "--json") as search:
            program.wait_for_handler(search, signal.SIGINT)
            search.send_signal(signal.SIGINT)
            out, _ = search.communicate(timeout=60)
            self.assertEqual(search.returncode, 4)
        self.assertFalse(json.loads(out)["exhaustive"])

    def test_estimates(self):
        whole = self.run_json(PYRAMID, "--max-hexes", "15", "--ball")
        about = self.run_json(PYRAMID, "--max-hexes", "15", "--ball", "--estimate", "20000")
        self.assertLess(abs(about["nodes"] - whole["nodes"]), 6 * about["standard_error"])
        self.assertFalse(about["exact"])

    def test_certificates(self):
        made = self.run_json("octagonal-spindle", "--max-hexes", "15", "--ball", "--certificate",
                             "bound.hxb")
        self.assertGreater(made["records"], 100)
        one = self.read("bound.hxb")
        self.run_json("octagonal-spindle", "--max-hexes", "15", "--ball", "--certificate",
                      "bound.hxb", "-j", "2")
        self.assertEqual(self.read("bound.hxb"), one)
        ran = self.hexatlas("enum", "hexmeshes", "two-cubes", "--max-hexes", "2", "--certificate",
                            "no.hxb")
        self.assertEqual(ran.code, 1, ran)
        self.assertNotIn("no.hxb", self.listing())

    def test_a_certificate_on_standard_output(self):
        words = ("enum", "hexmeshes", "two-cubes", "--max-hexes", "1", "--ball", "--certificate")
        ran = self.hexatlas(*words, "a.hxb")
        raw = subprocess.run([program.PROGRAM, *words, "-"], cwd=self.folder, capture_output=True, check=True)
        self.assertEqual(raw.stdout, self.read("a.hxb"))
        self.assertEqual(raw.stderr.decode(), ran.out.replace("a.hxb", "-"))
        ran = self.expect(1, self.hexatlas("enum", "hexmeshes", "two-cubes", "--max-hexes", "2", "--ball",
                                           "--certificate", "b.hxb", "--json"))
        self.assertEqual(json.loads(ran.out)["outcome"], "has_mesh")

    def hexatlas_fails(self, code, *arguments):
        ran = self.hexatlas(*arguments)
        self.assertEqual(ran.code, code, ran)
        self.assertEqual(ran.out, "")
        self.assertEqual(len(ran.err.splitlines()), 1, ran)

    def test_boundaries_without_a_mesh(self):
        for code, said in (("q1:088a65f7f", "odd"), ("q1:2aaa7fff", "3-connected")):
            for words in (("enum", "hexmeshes", code, "--max-hexes", "2"), ("mesh", "boundary", code, "-o", "a.vtk")):
                ran = self.expect(1, self.hexatlas(*words))
                self.assertRegex(ran.err, r"\Ahexatlas: " + code + r": no hexahedral mesh exists: [^\n]+\n\Z")
                self.assertIn(said, ran.err)
                self.assertEqual((ran.out, self.listing()), ("", []))
                told = json.loads(self.expect(1, self.hexatlas(*words, "--json")).out)
                self.assertEqual(told["outcome"], "impossible")

    def test_bad_arguments(self):
        for arguments in ((), ("cube",), ("cube", "--max-hexes", "0"), ("cube", "--max-hexes", "65"),
                          ("cube", "--max-hexes", "3", "--shard", "3/3"),
                          ("cube", "--max-hexes", "3", "--estimate", "1"),
                          ("cube", "--max-hexes", "3", "--save-every", "5"),
                          ("cube", "--max-hexes", "3", "--seed", "5"),
                          ("cube", "--max-hexes", "3", "--state", "-"),
                          ("cube", "--max-hexes", "3", "--first", "--estimate", "9"),
                          ("two-cubes", "--max-hexes", "1", "--first", "--certificate", "a.hxb"),
                          ("cube", "--max-hexes", "3", "--estimate", "9", "--state", "s")):
            self.hexatlas_fails(2, "enum", "hexmeshes", *arguments)
        self.write("in.obj", surfaces.obj(*surfaces.cube()))
        given = self.read("in.obj")
        for arguments in (("in.obj", "-o", "in.obj"), ("in.obj", "--certificate", "./in.obj"), ("in.obj", "--state", "in.obj"),
                          ("cube", "-o", "both", "--state", "both")):
            self.hexatlas_fails(2, "enum", "hexmeshes", *arguments, "--max-hexes", "3")
        self.assertEqual(self.read("in.obj"), given)
        for outputs in (("-o", "in.obj"), ("-o", "both", "--completeness", self.path("both"))):
            self.hexatlas_fails(2, "enum", "triangulations", "in.obj", *outputs)
        self.write("odd.off", "OFF\n1 0 0\n0 0 0\n")
        self.write("saved", "hexatlas-search 1\n")
        for arguments in (("nowhere",), ("odd.off",), ("q1:00",), ("cube", "--state", "saved"),
                          ("octagonal-spindle", "-o", "no/such/folder")):
            self.hexatlas_fails(3, "enum", "hexmeshes", *arguments, "--max-hexes", "3")
        self.hexatlas_fails(3, "enum", "hexmeshes", "cube", "--max-hexes", "60")


if __name__ == "__main__":
    program.main()
