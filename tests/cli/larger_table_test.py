#!/usr/bin/env python3
"""Claim. The larger table that comes with the program has a mesh of at most 72 hexahedra for every
3-connected quadrangulation with an even number of at most 22 quads. Of the meshes a sixteenth is judged, with each
commit another one: the table changes more rarely, and all of them, which takes two minutes, before a release.
Oracle. The judge, which shares no code with the search; the published numbers of quadrangulations
(OEIS A007022).
"""
import json
import os
import subprocess

import program

LARGER = os.path.join(program.REPOSITORY, "tables", "data", "hexatlas-22.hxt")
COUNTS = {"6": 1, "8": 1, "10": 3, "12": 11, "14": 58, "16": 451, "18": 4461, "20": 49957, "22": 598102}
SHARES = 16
LITERATURE = 72  # hexahedra: Verhetsel, Pellerin and Remacle 2019, for at most 20 quads


def share_of_commit():
    """From the number of commits: the next one has the next share. The first one without a history."""
    told = subprocess.run(["git", "rev-list", "--count", "HEAD"], cwd=program.REPOSITORY,
                          capture_output=True, text=True, check=False)
    return int(told.stdout) % SHARES if told.returncode == 0 else 0


class LargerTable(program.ProgramTest):
    def test_is_accepted_as_complete(self):
        share = f"{share_of_commit()}/{SHARES}"
        ran = self.expect(0, self.hexatlas("table", "check", LARGER, "--shard", share, timeout=850))
        self.assertRegex(ran.out, rf"share {share} accepted, 4\d{{4}} of 653045 meshes judged: ")
        self.assertIn("complete: all 3-connected quadrangulations with 6, 8, ..., 22 quads\n", ran.out)

    def test_knows_as_small_meshes_as_the_first_one(self):
        def numbers(*table):
            lines = self.expect(0, self.hexatlas("table", "list", *table)).out.splitlines()[1:]
            return {line.split("\t")[0]: int(line.split("\t")[2]) for line in lines}

        first, larger = numbers(), numbers(LARGER)
        self.assertEqual(len(first), 54943)
        self.assertEqual([code for code in first if larger[code] != first[code]], [])

    def test_is_what_a_search_asks(self):
        code = "q1:00888a20a0a2a5d75775f77dff"  # 26 quads
        words = ("table", "get", "--search", "--code", code)
        found = json.loads(self.expect(0, self.hexatlas(*words)).out)
        other = json.loads(self.expect(0, self.hexatlas(*words, "--table", LARGER)).out)
        self.assertTrue(found["searched"])
        self.assertTrue(os.path.samefile(other.pop("table"), LARGER))
        self.assertEqual(os.path.basename(found.pop("table")), os.path.basename(LARGER))
        self.assertEqual(found, other)

    def test_is_small(self):
        ran = self.expect(0, self.hexatlas("table", "info", LARGER, "--json"))
        by_quads = json.loads(ran.out)["by_quads"]
        self.assertEqual({quads: row["entries"] for quads, row in by_quads.items()}, COUNTS)
        for row in by_quads.values():
            self.assertLessEqual(row["greatest"], LITERATURE)


if __name__ == "__main__":
    program.main()
