#!/usr/bin/env python3
"""Claim. The larger table that comes with the program has a valid mesh of at most 72 hexahedra for
every 3-connected quadrangulation with an even number of at most 22 quads.
Oracle. The judge, which shares no code with the search; the published numbers of quadrangulations
(OEIS A007022).
"""
import json
import os

import program

LARGER = os.path.join(program.REPOSITORY, "tables", "data", "hexatlas-22.hxt")
COUNTS = {"6": 1, "8": 1, "10": 3, "12": 11, "14": 58, "16": 451, "18": 4461, "20": 49957, "22": 598102}
LITERATURE = 72  # hexahedra: Verhetsel, Pellerin and Remacle 2019, for at most 20 quads


class LargerTable(program.ProgramTest):
    def test_is_accepted_as_complete(self):
        ran = self.expect(0, self.hexatlas("table", "check", LARGER, timeout=850))
        self.assertIn("accepted: 653045 meshes", ran.out)
        self.assertIn("complete: all 3-connected quadrangulations with 6, 8, ..., 22 quads\n", ran.out)

    def test_is_small(self):
        ran = self.expect(0, self.hexatlas("table", "info", LARGER, "--json"))
        by_quads = json.loads(ran.out)["by_quads"]
        self.assertEqual({quads: row["entries"] for quads, row in by_quads.items()}, COUNTS)
        for row in by_quads.values():
            self.assertLessEqual(row["greatest"], LITERATURE)


if __name__ == "__main__":
    program.main()
