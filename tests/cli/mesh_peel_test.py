#!/usr/bin/env python3
"""Claim. `mesh hex` gives the surface of a block its structured mesh, by zones, that of a shaft its layers, and that of a body with recesses the
hexahedra around them; what zones leave too much of is refused
by `--method zones` in a sentence, and meshed by flips; `--layers` puts layers below all of the surface. The judge
accepts all of it, the account is true, and the bytes are the same for any number of threads and any formats read.
Oracle. `hexatlas check`, which shares no code with the mesher; counts of a block by formula; hex_files.py.
"""
import collections
import itertools
import json
import os
import random

import hex_files
import program
import surfaces
from mesh_hex_test import MeshTest, disguised

BLOCKS = ((3, 3, 3), (5, 4, 3), (7, 3, 1), (4, 4, 4))
QUADS = 28 if program.SANITIZED else 40  # more than any boundary of the table has


class Zones(MeshTest):
    def expect_structured(self, said, cubes):
        self.assertEqual(said["method"], "zones")
        self.assertEqual(said["hexahedra"], cubes[0] * cubes[1] * cubes[2])
        self.assertEqual(said["interior_vertices"], (cubes[0] - 1) * (cubes[1] - 1) * (cubes[2] - 1))
        self.assertEqual((said["layers"], said["cavity_filled_by"]), (0, "table"))

    def test_blocks(self):
        for cubes in program.share_of(BLOCKS):
            for method in ("auto", "zones"):
                with self.subTest(cubes=cubes, method=method):
                    said = self.mesh_and_judge(surfaces.block(*cubes), "out.vtk", "--effort", "0",
                                              "--method", method)
                    self.expect_structured(said, cubes)
                    # Unit cubes, but for the rounding of the places found.
                    self.assertAlmostEqual(said["min_scaled_jacobian"], 1, places=6)
                    self.assertEqual((said["valid"], said["inverted"]), (said["hexahedra"], 0))

    def test_disguised_blocks(self):
        rng = random.Random(11)
        for cubes in program.share_of([cubes for cubes in BLOCKS for _ in range(3)]):
            said = self.mesh_and_judge(disguised(surfaces.block(*cubes), rng), "out.mesh", "--effort", "0")
            self.expect_structured(said, cubes)

    def test_the_spacing_of_a_surface_goes_on_inside(self):
        levels = (0, 0.001, 0.01, 0.2, 0.9, 1)
        points, quads = surfaces.block(5, 4, 3)
        graded = [tuple(str(levels[round(float(x))]) for x in p) for p in points]
        said = self.mesh_and_judge((graded, quads), "out.vtk")
        self.assertEqual(said["valid"], 60)
        for p in hex_files.read_vtk(self.read("out.vtk").decode())[0]:
            for x in p:
                self.assertLess(min(abs(x - level) for level in levels), 1e-7)

    def test_words_for_people(self):
        ran = self.expect(0, self.mesh(surfaces.grid_cube(3), "--effort", "0"))
        self.assertIn("\n26 hexahedra zone by zone, the rest of 6 quads filled by the table; "
                      "0.50 hexahedra per quad\n", ran.out)
        self.assertNotIn("not all", ran.out)
        points, quads = surfaces.grid_cube(3)
        ran = self.expect(0, self.mesh(([points[0]] * len(points), quads), "--effort", "0", "--method", "zones"))
        self.assertTrue(ran.out.endswith(
            "\nnot all hexahedra are valid; more may be with `--layers 1`, `--method auto`, a larger `--effort`, or "
            "smaller and more even quads\n"), ran.out)

    def test_shafts(self):
        for core, *steps in program.share_of(((1, (1, 1)), (1, (1, 3)), (2, (3, 4)), (2, (2, 2), (1, 3)),
                                              (3, (1, 2), (3, 2), (2, 1)), (2, (2, 1), (1, 2), (3, 1)))):
            with self.subTest(core=core, steps=steps):
                surface, of_layers = surfaces.shaft(core, *steps)
                said = self.mesh_and_judge(surface, "out.vtk")
                self.assertEqual((said["method"], said["cavity_filled_by"]), ("zones", "layer"))
                self.assertEqual(said["hexahedra"], sum(of_layers))
                self.assertEqual(said["valid"], said["hexahedra"])
                self.assertGreater(said["min_scaled_jacobian"], 0.5)

    def test_bodies_with_a_gap(self):
        # Of which zones by their number of hexahedra alone go through the gap.
        square = {(x, y, 0) for x in range(3) for y in range(3)}
        for gap in ({(1, 1, 0), (1, 2, 0)}, {(1, 2, 0)}):
            for method in ("auto", "zones"):
                said = self.mesh_and_judge(surfaces.of_cubes(square - gap), "out.vtk", "--method", method)
                self.assertEqual((said["method"], said["hexahedra"], said["valid"]),
                                 ("zones", 9 - len(gap), 9 - len(gap)))

    def test_recesses(self):
        block = set(itertools.product(range(6), range(6), range(5)))
        pockets = {(x, y, z) for x, y, z in block if x in (1, 2) and y == 1 and z > 1 or 1 <= x <= 4 and y >= 3 and z == 4}
        bodies = [(surfaces.of_cubes(block - pockets), len(block - pockets)),
                  surfaces.blind_hole(2, 4, 4, (2, 1)), surfaces.blind_hole(2, 3, 5, (2, 2), (0, 2))]
        for surface, hexahedra in program.share_of(bodies):
            said = self.mesh_and_judge(surface, "out.vtk")
            self.assertEqual((said["method"], said["hexahedra"], said["valid"]), ("zones", hexahedra, hexahedra))
            self.assertGreater(said["min_scaled_jacobian"], 0.5)

    def test_oblique_cylinders(self):
        for tangent in (0.5, 1.9):
            (points, quads), of_layers = surfaces.shaft(2, (1, 2))
            sheared = [(repr(float(x) + tangent * float(z)), y, z) for x, y, z in points]
            said = self.mesh_and_judge((sheared, quads), "out.vtk")
            self.assertEqual((said["hexahedra"], said["valid"], said["cavity_filled_by"]),
                             (sum(of_layers), sum(of_layers), "layer"))

    def test_smooth_bodies_have_a_layer_where_that_is_much_better(self):
        for n, layers in program.share_of(((2, 0), (5, 1))):
            said = self.mesh_and_judge(surfaces.ball(n), "out.vtk")
            self.assertEqual((said["method"], said["layers"]), ("zones", layers))
            self.assertEqual(said["hexahedra"], n ** 3 + layers * 6 * n ** 2)
            self.assertEqual(said["valid"], said["hexahedra"])
            self.assertGreater(said["min_scaled_jacobian"], 0.7 if layers else 0.3)

    def test_layers_below_a_shaft(self):
        surface, of_layers = surfaces.shaft(2, (2, 2), (1, 2))
        for layers in (1, 2):
            ran = self.expect(0, self.mesh(surface, "--layers", str(layers)))
            quads = len(surface[1])
            taken = sum(of_layers[1:]) + layers * quads
            self.assertIn(f"\n{taken} hexahedra in {layers} layer{'s' * (layers - 1)} and zone by zone, the rest of "
                          "48 quads filled by one layer; ", ran.out)
            self.assertIn(f" {taken + of_layers[0]} of {taken + of_layers[0]} hexahedra proven valid", ran.out)

    def test_words_for_one_layer(self):
        surface, _ = surfaces.shaft(2, (1, 3))
        ran = self.expect(0, self.mesh(surface))
        self.assertIn("\n24 hexahedra zone by zone, the rest of 32 quads filled by one layer; 0.75 hexahedra per quad\n",
                      ran.out)

    def test_where_zones_do_not_suffice(self):
        for surface in program.share_of((surfaces.trapezohedron(31), surfaces.random_surface(80, 5))):
            quads = len(surface[1])
            ran = self.expect(4, self.mesh(surface, "--method", "zones", "--effort", "0"))
            self.assertEqual(ran.out, "")
            self.assertRegex(ran.err, rf"\Ahexatlas: in\.obj: what zones leave of the boundary of {quads} quads is not in "
                                      r"[^\n]+; `--method auto` meshes it all the same\n\Z")
            said = json.loads(self.expect(4, self.mesh(surface, "--method", "zones", "--json")).out)
            self.assertEqual((said["outcome"], said["quads"]), ("not_in_table", quads))
            self.assertEqual(ran.err, f"hexatlas: in.obj: {said['reason']}\n")
            self.assertEqual(self.listing(), ["in.obj"])
            self.assertEqual(self.mesh_and_judge(surface, "out.vtk", "--effort", "0")["method"], "flips")
            os.remove(self.path("out.vtk"))


class Flips(MeshTest):
    def flip(self, surface, output, *options):
        said = self.mesh_and_judge(surface, output, "--effort", "0", *options)
        self.assertEqual(said["method"], "flips")
        return said

    def test_random_surfaces(self):
        for count in program.share_of((60, 160)):
            for seed in program.share_of(range(2)):
                with self.subTest(quads=count, seed=seed):
                    said = self.flip(surfaces.random_surface(count, seed), "out.vtk", "--method", "flips")
                    self.assertLess(said["hexahedra"], 16 * count)

    def test_is_what_auto_takes_where_zones_do_not_suffice(self):
        surface = surfaces.random_surface(QUADS, 3)
        self.flip(surface, "auto.vtk")
        self.flip(surface, "flips.vtk", "--method", "flips")
        self.assertEqual(self.read("auto.vtk"), self.read("flips.vtk"))

    def test_auto_takes_the_better_of_zones_and_flips(self):
        taken = set()
        for quads, seed in ((26, 2), (28, 0)):
            surface = surfaces.random_surface(quads, seed)
            not_valid = {}
            for method in ("zones", "flips", "auto"):
                said = self.mesh_and_judge(surface, f"{method}.vtk", "--method", method, "--effort", "0",
                                           "--tries", "2")
                not_valid[method] = said["hexahedra"] - said["valid"]
            better = "zones" if not_valid["zones"] <= not_valid["flips"] else "flips"
            self.assertEqual((said["method"], self.read("auto.vtk")), (better, self.read(f"{better}.vtk")))
            taken.add(better)
        self.assertEqual(taken, {"zones", "flips"})

    def test_same_bytes_for_any_number_of_threads(self):
        surface = surfaces.random_surface(QUADS, 1)
        for threads in ("1", "2", "5"):
            self.flip(surface, threads + ".vtk", "--threads", threads, "--method", "flips")
        self.assertEqual(self.read("1.vtk"), self.read("2.vtk"))
        self.assertEqual(self.read("1.vtk"), self.read("5.vtk"))

    def test_small_surfaces_if_asked(self):
        for surface in program.share_of((surfaces.trapezohedron(5), surfaces.cube(), surfaces.block(2, 1, 1),
                                         surfaces.grid_cube(2))):
            self.flip(surface, "out.mesh", "--method", "flips")

    def test_layers(self):
        for surface in program.share_of((surfaces.random_surface(QUADS, 2), surfaces.grid_cube(2),
                                         surfaces.trapezohedron(20))):
            for layers in (1, 2):
                said = self.flip(surface, "out.vtk", "--method", "flips", "--layers", str(layers))
                self.assertGreaterEqual(said["layers"], layers)
                self.assertGreaterEqual(said["peeled"], layers * said["quads"])
                self.expect_a_hexahedron_below_each_quad(surface)

    def expect_a_hexahedron_below_each_quad(self, surface):
        """And no other one at the boundary."""
        given = len(surface[0])
        _, hexahedra = hex_files.read_vtk(self.read("out.vtk").decode())
        below = collections.Counter(frozenset(v for v in cell if v < given) for cell in hexahedra)
        del below[frozenset()]
        self.assertEqual(below, collections.Counter(map(frozenset, surface[1])))

    def test_layers_are_a_number(self):
        for layers in ("-1", "101", "some"):
            self.assertIn("--layers", self.expect(2, self.mesh(surfaces.cube(), "--layers", layers)).err)

    def test_words_for_people(self):
        for surface, filled_by in program.share_of(((surfaces.trapezohedron(31), "sectors"), (surfaces.random_surface(40, 0), None))):
            said = self.flip(surface, "out.vtk")
            ran = self.expect(0, self.mesh(surface, "--effort", "0"))
            words = (f"\n{said['peeled']} hexahedr{'on' if said['peeled'] == 1 else 'a'} taken off in {said['layers']} "
                     f"layer{'' if said['layers'] == 1 else 's'} and by flips, the rest of {said['cavity_quads']} quads "
                     f"filled by {'the table' if said['cavity_filled_by'] == 'table' else 'sectors'}; "
                     f"{said['hexahedra_per_quad']:.2f} hexahedra per quad\n")
            self.assertIn(words, ran.out)
            if filled_by:
                self.assertEqual(said["cavity_filled_by"], filled_by)


if __name__ == "__main__":
    program.main()
