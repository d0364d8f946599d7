#!/usr/bin/env python3
"""Claim. `check --hybrid` accepts a mesh of four shapes in each format, alone and with the
tetrahedral mesh whose boundary it must have; it says no (exit 1) with a law and a witness to others,
"undecided" (exit 4) where subdivision does not decide, and exit 3 to what is no mesh.
Oracle. The meshes of hybrid_files.py, of which everything is known by counting.
"""
import json

import program
from hybrid_files import CELLS, GIVEN, HEXAHEDRON, POINTS, PYRAMID, WRITERS, gmsh, medit, vtk


class CheckHybridTest(program.ProgramTest):
    def judge(self, code, *words_):
        return json.loads(self.expect(code, self.hexatlas("check", "--hybrid", "--json", *words_)).out)

    def test_accepts_each_format_with_its_boundary(self):
        for ending, written in WRITERS.items():
            with self.subTest(format=ending):
                self.write(f"good.{ending}", written(POINTS, CELLS))
                self.write(f"given.{ending}", written(POINTS, GIVEN))
                ran = self.expect(0, self.hexatlas("check", "--hybrid", f"good.{ending}"))
                self.assertEqual(
                    ran.out, f"good.{ending}: accepted: 1 tetrahedron, 1 hexahedron, 1 prism, 1 pyramid, all valid, "
                    "facet to facet; 12 points (0 in no cell); on the boundary 8 triangles and 6 quads (0 of them "
                    "warped), 0 singular edges\n")
                ran = self.expect(0, self.hexatlas("check", "--hybrid", f"good.{ending}", "--boundary",
                                                   f"given.{ending}"))
                self.assertIn(f"; its boundary is that of given.{ending}\n", ran.out)
                # The mesh of tetrahedra is a hybrid mesh, too.
                self.assertEqual(self.judge(0, f"given.{ending}")["boundary_triangles"], 20)

    def test_json(self):
        self.write("good.vtk", vtk(POINTS, CELLS))
        self.assertEqual(self.judge(0, "good.vtk"), {
            "accepted": True, "undecided": False, "law": "none", "reason": "", "points": 12, "unused_points": 0,
            "tetrahedra": 1, "hexahedra": 1, "prisms": 1, "pyramids": 1, "boundary_triangles": 8,
            "boundary_quads": 6, "warped_boundary_quads": 0, "singular_boundary_edges": 0})

    def test_says_no_with_the_law_and_a_witness(self):
        halves = [(4, 5, 6, 8), (4, 6, 7, 8)]  # of the bottom of the roof
        for law, cells in (("positive", [(4, 8, 7, 5, 9, 6)]), ("two-cells", [PYRAMID, PYRAMID, PYRAMID]),
                           ("diagonal", [HEXAHEDRON, *halves]), ("opposite-sides", [PYRAMID, PYRAMID]),
                           ("corners", [(0, 1, 2, 2)])):
            with self.subTest(law=law):
                self.write("bad.msh", gmsh(POINTS, cells))
                said = self.judge(1, "bad.msh")
                self.assertEqual((said["accepted"], said["law"]), (False, law))
                self.assertNotEqual(said["reason"], "")
                ran = self.expect(1, self.hexatlas("check", "--hybrid", "bad.msh"))
                self.assertEqual(ran.out, f"bad.msh: rejected: {law}: {said['reason']}\n")
        self.write("good.vtk", vtk(POINTS, CELLS))
        self.write("less.vtk", vtk(POINTS, GIVEN[:-1]))
        self.assertEqual(self.judge(1, "good.vtk", "--boundary", "less.vtk")["law"], "given-boundary")
        self.write("bad.vtk", vtk(POINTS, [*GIVEN[:-1], (1, 5, 10, 11)]))
        self.assertEqual(self.judge(1, "good.vtk", "--boundary", "bad.vtk")["law"], "given-mesh")

    def test_wedges_of_vtk_turn_the_other_way(self):
        self.write("mesh.vtk", vtk(POINTS, CELLS).replace("6 4 8 7 5 9 6", "6 4 7 8 5 6 9"))
        self.assertEqual(self.judge(1, "mesh.vtk")["law"], "positive")

    def test_says_undecided(self):
        points = [(x * (1 if z == 0 else -2), y * (1 if z == 0 else -2), z) for x, y, z in POINTS[:8]]
        self.write("mesh.mesh", medit(points, [HEXAHEDRON]))
        said = self.judge(4, "mesh.mesh")
        self.assertEqual((said["accepted"], said["undecided"], said["law"]), (False, True, "positive"))
        self.assertIn("mesh.mesh: undecided: positive: ",
                      self.expect(4, self.hexatlas("check", "--hybrid", "mesh.mesh")).out)

    def test_refuses_what_is_no_mesh(self):
        self.write("mesh.vtk", vtk(POINTS, CELLS))
        self.write("cut.vtk", vtk(POINTS, CELLS)[:-10])
        self.write("mesh.obj", "v 0 0 0\n")
        self.expect(3, self.hexatlas("check", "--hybrid", "cut.vtk"))
        self.expect(3, self.hexatlas("check", "--hybrid", "mesh.obj"))
        self.expect(3, self.hexatlas("check", "--hybrid", "missing.vtk"))
        self.expect(3, self.hexatlas("check", "--hybrid", "mesh.vtk", "--boundary", "mesh.vtk"))
        self.expect(2, self.hexatlas("check", "--hybrid", "--delaunay", "mesh.vtk"))
        self.expect(2, self.hexatlas("check", "--hybrid", "mesh.vtk", "--completeness", "mesh.vtk"))
        self.expect(3, self.hexatlas("check", "mesh.vtk"))


if __name__ == "__main__":
    program.main()
