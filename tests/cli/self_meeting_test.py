#!/usr/bin/env python3
"""Claim. `mesh hex` says which quads of a surface meet outside what they share, or which one is
folded, in a note and in JSON, with their lines where they are known, and meshes it all the same.
Oracle. By hand: what the moved corner of a cube runs into, and boxes side by side.
"""
import json

import program
import surfaces
from mesh_hex_test import MeshTest


class SurfacesThatMeetThemselves(MeshTest):
    def expect_meeting(self, surface, pair, note, name="in.obj"):
        ran = self.expect(0, self.mesh(surface, "--json", "--effort", "0", name=name))
        self.assertEqual(json.loads(ran.out)["surface_meets_itself"], pair)
        self.assertRegex(ran.err, r"\Ahexatlas: note: " + note + r"[^\n]+\n\Z" if note else r"\A\Z")
        self.expect(0, self.hexatlas("check", "out.vtk", "--boundary", name))
        in_words = self.expect(0, self.mesh(surface, "--effort", "0", name=name))
        self.assertEqual(in_words.err, ran.err)

    def test_corner_of_a_cube(self):
        points, quads = surfaces.cube()

        def moved(*place):
            return points[:6] + [place] + points[7:], quads

        self.expect_meeting((points, quads), None, "")
        self.expect_meeting(moved("0.5", "0.5", "0.001"), None, "")
        # Down to the bottom, quad 0, in a corner of quad 1; lines: 8 points, then the quads.
        note = r"quads 0 \(line 9\) and 1 \(line 10\), counted from 0, meet outside what they share"
        for place in (("0.5", "0.5", "0"), ("0.5", "0.5", "-0.001"), ("0", "0", "0")):
            self.expect_meeting(moved(*place), [0, 1], note)
        # To the middle of the top, which is flat then, with a corner of 180 degrees, or above.
        note = r"quad 1 \(line 10\), counted from 0, is flat and not strictly convex"
        for place in (("0.5", "0.5", "1"), ("0.25", "0.25", "1"), ("1", "0", "1")):
            self.expect_meeting(moved(*place), [1, 1], note)
        self.expect_meeting(moved("0.5000000000000001", "0.5", "1"), None, "")

    def test_without_lines(self):
        points, quads = surfaces.cube()
        points[6] = ("0.5", "0.5", "0")
        self.expect_meeting((points, quads), [0, 1], "quads 0 .*and 1 .*, counted from 0, meet",
                            name="in.vtu")

    def test_boxes_that_touch(self):
        """Two cubes on a third, apart, with one edge of each in the same place."""
        points, quads = surfaces.grid_cube(3)
        cell = {tuple(map(int, p)): v for v, p in enumerate(points)}

        def raised(surface, x, y):
            """The top quad with least corner (x, y) becomes a box of height 1."""
            points, quads = list(surface[0]), [list(q) for q in surface[1]]
            ring = [cell[x, y, 3], cell[x + 1, y, 3], cell[x + 1, y + 1, 3], cell[x, y + 1, 3]]
            at = next(i for i, quad in enumerate(quads) if set(quad) == set(ring))
            top = [len(points) + i for i in range(4)]
            points += [(points[v][0], points[v][1], "4") for v in ring]
            quads[at] = top
            quads += [[ring[i], ring[(i + 1) % 4], top[(i + 1) % 4], top[i]] for i in range(4)]
            return points, quads

        one = raised((points, quads), 0, 0)
        self.expect_meeting(one, None, "")
        self.expect_meeting(raised(one, 2, 2), None, "")
        self.expect_meeting(raised(one, 2, 0), None, "")
        both = raised(one, 1, 1)
        tops = sorted(i for i, quad in enumerate(both[1]) if all(both[0][v][2] == "4" for v in quad))
        self.expect_meeting(both, tops, "quads ")


if __name__ == "__main__":
    program.main()
