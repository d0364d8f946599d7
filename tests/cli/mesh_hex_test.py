#!/usr/bin/env python3
"""Claim. `mesh hex` keeps the points and quads of a surface, bit for bit and up to rotation, in all
formats, for any numbering, order and placing of it; the judge accepts what it writes; the same
input gives the same bytes. Surfaces without a mesh, or not in the table, are told apart; the construction,
if asked, meshes them all, with at most 25 hexahedra per quad. (Zones and flips: mesh_peel_test.py.)
Oracle. hex_files.py and surfaces.py, which read and write files on their own; `hexatlas check`,
which shares no code with the mesher; the parity and 3-connectedness of the surfaces made here.
"""
import json
import os
import random
import re
import stat

import hex_files
import program
import surfaces

KEYS = {"outcome", "quads", "hexahedra", "interior_vertices", "min_scaled_jacobian", "mean_scaled_jacobian",
        "inverted", "valid", "histogram", "method", "hexahedra_per_quad", "peeled", "layers", "cavity_quads", "cavity_filled_by",
        "table_entry", "surface_meets_itself", "seconds"}
METHODS = ("auto", "table", "zones", "flips", "construction")
OUTPUTS = (".vtk", ".vtu", ".mesh", ".msh")


def floats(points):
    return [tuple(float(word) for word in point) for point in points]


def disguised(surface, rng):
    """The same surface: other numbers, other order, each quad begun elsewhere."""
    points, quads = surface
    number = list(range(len(points)))
    rng.shuffle(number)
    moved = [None] * len(points)
    for old, new in enumerate(number):
        moved[new] = points[old]
    turned = []
    for quad in quads:
        k = rng.randrange(4)
        turned.append([number[v] for v in quad[k:] + quad[:k]])
    rng.shuffle(turned)
    return moved, turned


class MeshTest(program.ProgramTest):
    def mesh(self, surface, *options, name="in.obj", output="out.vtk"):
        self.write(name, surfaces.FORMATS[name.split(".")[1]][1](*surface))
        return self.hexatlas("mesh", "hex", name, "-o", output, *options)

    def mesh_and_judge(self, surface, output, *options):
        ran = self.mesh(surface, "--json", *options, output=output)
        self.expect(0, ran)
        self.assertEqual(ran.out.count("\n"), 1)
        said = json.loads(ran.out)
        # Random points may make a surface meet itself, which is one note.
        meets = "(hexatlas: note: quads? [^\n]*, counted from 0, [^\n]*\n)" if said["surface_meets_itself"] else ""
        self.assertRegex(ran.err, rf"\A{meets}\Z")
        self.assertEqual(set(said), KEYS)
        self.assertEqual(said["outcome"], "meshed")
        self.assertEqual(said["quads"], len(surface[1]))
        self.expect_true_account(said)
        judged = self.expect(0, self.hexatlas("check", output, "--boundary", "in.obj", "--json"))
        self.assertEqual(judged.err, "")
        verdict = json.loads(judged.out)
        self.assertTrue(verdict["accepted"])
        for key in ("hexahedra", "interior_vertices"):
            self.assertEqual(verdict[key], said[key])
        self.assertEqual(verdict["boundary_quads"], said["quads"])
        self.assertEqual(sum(said["histogram"]), said["hexahedra"])
        self.assertAlmostEqual(said["hexahedra_per_quad"], said["hexahedra"] / said["quads"])
        self.assertLessEqual(said["valid"] + said["inverted"], said["hexahedra"])
        if output.endswith((".vtk", ".mesh")):
            reader = hex_files.read_vtk if output.endswith(".vtk") else hex_files.read_medit
            mesh = reader(self.read(output).decode())
            self.expect_mesh_of(surface, mesh)
            self.assertEqual(len(mesh[1]), said["hexahedra"])
        return said

    def expect_true_account(self, said):
        """Of what was peeled something is said where it was, and nothing elsewhere."""
        account = [said[key] for key in ("peeled", "layers", "cavity_quads", "cavity_filled_by")]
        if said["method"] in ("table", "construction"):
            self.assertEqual(account, [None] * 4)
            return
        self.assertIn(said["method"], ("zones", "flips"))
        self.assertIsNone(said["table_entry"])
        peeled, layers, cavity, filled_by = account
        self.assertGreaterEqual(peeled, layers * 6)
        self.assertLess(peeled, said["hexahedra"])
        self.assertTrue(cavity >= 6 and cavity % 2 == 0, cavity)
        self.assertIn(filled_by, ("table", "layer") if said["method"] == "zones" else ("table", "sectors"))
        if filled_by == "sectors":
            self.assertLessEqual(said["hexahedra"] - peeled, 25 * cavity)

    def expect_mesh_of(self, surface, mesh, turned=False):
        points, hexahedra = mesh
        given = floats(surface[0])
        self.assertEqual(hex_files.bits(points[:len(given)]), hex_files.bits(given))
        quads = [quad[::-1] if turned else quad for quad in surface[1]]
        self.assertEqual(hex_files.boundary(hexahedra),
                         sorted(hex_files.least_first(list(quad)) for quad in quads))


class Inputs(MeshTest):
    def test_all_inputs_in_all_formats(self):
        names = sorted(os.listdir(program.INPUTS))
        self.assertEqual(len(names), 11)
        for name in program.share_of(names, least=3):
            surface = surfaces.read_obj(os.path.join(program.INPUTS, name))
            for extension in OUTPUTS:
                with self.subTest(input=name, output=extension):
                    said = self.mesh_and_judge(surface, "out" + extension, "--effort", "0")
                    self.assertEqual(said["method"], "table")
                    code = self.expect(0, self.hexatlas("code", "in.obj", "--json"))
                    self.assertEqual(json.loads(code.out)["code"], said["table_entry"])

    def test_disguises(self):
        rng = random.Random(7)
        for i, name in enumerate(("cube", "two-cubes", "rhombic-dodecahedron", "three-cubes-l",
                                  "schneiders-pyramid")):
            original = surfaces.read_obj(os.path.join(program.INPUTS, name + ".obj"))
            counts = set()
            for k in program.share_of(range(6), i, least=2):  # one of them mirrored
                with self.subTest(input=name, disguise=k):
                    points, quads = disguised(original, rng)
                    if k % 2 == 1:  # a mirror image, its quads still from outside
                        points = [(p[0], p[1], repr(-float(p[2]))) for p in points]
                        quads = [quad[::-1] for quad in quads]
                    key = rng.choice(sorted(set(surfaces.FORMATS) - {"medit", "msh 2.2",
                                                                     "msh 4.1"}))
                    ran = self.expect(0, self.mesh((points, quads), "--json", "--effort", "0", name="in." + key))
                    self.assertEqual(ran.err, "")
                    counts.add((json.loads(ran.out)["hexahedra"], json.loads(ran.out)["table_entry"]))
                    self.expect_mesh_of((points, quads),
                                        hex_files.read_vtk(self.read("out.vtk").decode()))
                    judged = self.expect(0, self.hexatlas("check", "out.vtk", "--boundary", "in." + key, "--json"))
                    self.assertEqual(json.loads(judged.out)["valid_in_space"], json.loads(ran.out)["valid"])
            self.assertEqual(len(counts), 1)

    def test_stretched_surfaces(self):
        """Whether a hexahedron is valid does not depend on it."""
        points, quads = surfaces.read_obj(os.path.join(program.INPUTS, "schneiders-pyramid.obj"))
        for x, y in program.share_of(((100, 1), (1, 1e-5), (1e6, 1e3), (1, -0.01))):
            longer = [(repr(x * float(a)), repr(y * float(b) + x * float(a)), c) for a, b, c in points]
            said = self.mesh_and_judge((longer, [quad[::-1] for quad in quads] if y < 0 else quads), "out.vtk",
                                       "--effort", "1")
            self.assertEqual((said["valid"], said["hexahedra"]), (36, 36), (x, y))
        # Nor on a point in no quad, however far away.
        longer = [(repr(100 * float(a)), b, c) for a, b, c in points] + [("1e9", "-3e9", "2e9")]
        said = json.loads(self.expect(0, self.mesh((longer, quads), "--json", "--effort", "1")).out)
        self.assertEqual((said["valid"], said["hexahedra"]), (36, 36))

    def test_same_bytes_again(self):
        surface = surfaces.read_obj(os.path.join(program.INPUTS, "schneiders-pyramid.obj"))
        for extension in program.share_of(OUTPUTS):
            self.expect(0, self.mesh(surface, output="a" + extension))
            self.expect(0, self.mesh(surface, output="b" + extension))
            self.assertEqual(self.read("a" + extension), self.read("b" + extension))

    def test_standard_streams(self):
        surface = surfaces.read_obj(os.path.join(program.INPUTS, "two-cubes.obj"))
        self.expect(0, self.mesh(surface))
        for key in surfaces.FORMATS:
            text = surfaces.FORMATS[key][1](*surface).encode()
            ran = self.expect(0, self.hexatlas("mesh", "hex", "-", "-o", "-", stdin=text))
            self.assertEqual(ran.out.encode(), self.read("out.vtk"), key)
            self.assertIn("2 hexahedra", ran.err)
        ran = self.expect(0, self.hexatlas("mesh", "hex", "in.obj", "-o", "-", "--json"))
        self.assertEqual(ran.out.encode(), self.read("out.vtk"))
        self.assertEqual(json.loads(ran.err)["hexahedra"], 2)

    def test_the_input_is_not_overwritten(self):
        text = surfaces.vtk(*surfaces.cube()).encode()
        self.write("in.vtk", text)
        os.symlink("in.vtk", self.path("symbolic.vtk"))
        os.link(self.path("in.vtk"), self.path("hard.vtk"))
        before = self.listing()
        for output in ("in.vtk", "./in.vtk", self.path("in.vtk"), "symbolic.vtk", "hard.vtk"):
            for source, target in (("in.vtk", output), (output, "in.vtk")):
                ran = self.expect(2, self.hexatlas("mesh", "hex", source, "-o", target))
                self.assertEqual(ran.out, "")
                self.assertRegex(ran.err, r"\Ahexatlas: [^\n]*same file[^\n]*\n\Z")
                self.assertEqual(self.read("in.vtk"), text)
                self.assertEqual(self.listing(), before)

    def test_an_output_that_cannot_be_written_is_told_before_all_work(self):
        self.write("odd.obj", surfaces.obj(*surfaces.cube_with_cut_quad(1)))
        for name in ("missing.obj", "odd.obj"):
            for output in ("none/out.vtk", "out.stl", "."):
                self.expect_fault(self.hexatlas("mesh", "hex", name, "-o", output), output)
        self.assertEqual(self.listing(), ["odd.obj"])

    def test_help_says_where_words_go(self):
        self.assertIn("standard error", self.hexatlas("mesh", "hex", "--help").out)

    def test_an_existing_output_is_replaced_and_gets_the_mode_of_a_new_file(self):
        self.write("cube.obj", surfaces.obj(*surfaces.cube()))
        self.write("out.vtk", "before\n")
        os.symlink("out.vtk", self.path("link.vtk"))
        for mask, mode in ((0o022, 0o644), (0o077, 0o600), (0o002, 0o664)):
            for output in ("new.vtk", "link.vtk"):
                self.expect(0, self.hexatlas("mesh", "hex", "cube.obj", "-o", output, umask=mask))
            found = stat.S_IMODE(os.stat(self.path("new.vtk")).st_mode)
            self.assertEqual(oct(found), oct(mode))
            os.remove(self.path("new.vtk"))
        self.assertTrue(os.path.islink(self.path("link.vtk")))
        self.assertIn(b"POINTS", self.read("out.vtk"))


class Coordinates(MeshTest):
    ODD = [("-0.0", "0", "0"), ("1e-300", "-1e-300", "5e-324"),
           ("1e300", "-1e300", "1.7976931348623157e308"), ("0.1", "0.30000000000000004", "1e-5"),
           ("4.9406564584124654e-324", "2.2250738585072011e-308", "-2.2250738585072014e-308"),
           ("123456789012345678", "9007199254740993", "-0"), ("+1", "1.", ".5"),
           ("1E+2", "1e02", "-.25e-3")]

    def test_odd_coordinates_survive(self):
        for name in ("in.obj", "in.off", "in.vtk", "in.vtu"):
            with self.subTest(input=name):
                surface = (self.ODD, surfaces.CUBE_QUADS)
                ran = self.expect(0, self.mesh(surface, "--json", name=name))
                json.loads(ran.out)
                mesh = hex_files.read_vtk(self.read("out.vtk").decode())
                self.assertEqual(hex_files.bits(mesh[0]), hex_files.bits(floats(self.ODD)))
                self.expect(0, self.hexatlas("check", "out.vtk", "--boundary", name))

    def test_scales(self):
        for name in program.share_of(("rhombic-dodecahedron", "schneiders-pyramid")):
            points, quads = surfaces.read_obj(os.path.join(program.INPUTS, name + ".obj"))
            for scale in program.share_of(("1e-320", "1e-300", "1e-100", "8e307", "1e300", "1e100"), least=2):
                with self.subTest(input=name, scale=scale):
                    scaled = [tuple(repr(float(x) * float(scale)) for x in p) for p in points]
                    ran = self.expect(0, self.mesh((scaled, quads), "--json"))
                    self.assertEqual(ran.err, "")
                    json.loads(ran.out)
                    self.expect_mesh_of((scaled, quads),
                                        hex_files.read_vtk(self.read("out.vtk").decode()))
                    self.expect(0, self.hexatlas("check", "out.vtk", "--boundary", "in.obj"))

    def test_all_points_in_one_place(self):
        points, quads = surfaces.read_obj(os.path.join(program.INPUTS, "rhombic-dodecahedron.obj"))
        for word in ("0", "-0.0", "1e308", "7"):
            ran = self.expect(0, self.mesh(([(word,) * 3] * len(points), quads), "--json"))
            said = json.loads(ran.out)
            # A corner with determinant 0 counts as inverted.
            self.assertEqual((said["valid"], said["inverted"]), (0, 4), ran)
            self.expect(0, self.hexatlas("check", "out.vtk", "--boundary", "in.obj"))

    def test_require_valid(self):
        points, quads = surfaces.cube()
        good = self.expect(0, self.mesh((points, quads), "--require-valid", "--json"))
        self.assertEqual(json.loads(good.out)["valid"], 1)
        twisted = [points[i] for i in (0, 1, 2, 3, 6, 7, 4, 5)]
        ran = self.expect(4, self.mesh((twisted, quads), "--require-valid", "--json",
                                       output="twisted.vtk"))
        self.assertEqual(json.loads(ran.out)["valid"], 0)
        self.assertRegex(ran.err, r"\Ahexatlas: note: quad 2 [^\n]+\nhexatlas: 1 hexahedron is not proven valid, of 1;[^\n]*\n\Z")
        self.expect(0, self.hexatlas("check", "twisted.vtk", "--boundary", "in.obj"))
        self.expect(0, self.mesh((twisted, quads)))
        self.assertEqual(self.read("out.vtk"), self.read("twisted.vtk"))


class Orientation(MeshTest):
    def one_note(self, ran, *words):
        self.assertRegex(ran.err, r"\Ahexatlas: note: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, ran.err)

    def test_some_quads_turned_over(self):
        points, quads = surfaces.cube()
        for turned in ([0], [5], [1, 3]):
            damaged = [quad[::-1] if i in turned else quad for i, quad in enumerate(quads)]
            ran = self.expect(0, self.mesh((points, damaged)))
            self.one_note(ran, "1 quad " if len(turned) == 1 else "2 quads ", "orientation")
            self.expect_mesh_of((points, quads), hex_files.read_vtk(self.read("out.vtk").decode()))
            judged = self.expect(0, self.hexatlas("check", "out.vtk", "--boundary", "in.obj"))
            self.one_note(judged, "in.obj", "orientation")

    def test_all_quads_inwards(self):
        points, quads = surfaces.cube()
        surface = points, [quad[::-1] for quad in quads]
        ran = self.expect(0, self.mesh(surface))
        self.one_note(ran, "inwards")
        self.expect_mesh_of(surface, hex_files.read_vtk(self.read("out.vtk").decode()), turned=True)
        judged = self.expect(0, self.hexatlas("check", "out.vtk", "--boundary", "in.obj"))
        self.one_note(judged, "in.obj", "other way")

    def test_points_in_no_quad(self):
        points, quads = surfaces.cube()
        many = [("9", "9", "9")] + points + [("-7", "1e300", "0")]
        surface = many, [[v + 1 for v in quad] for quad in quads]
        for name in ("in.obj", "in.off", "in.vtk", "in.vtu"):
            ran = self.expect(0, self.mesh(surface, name=name))
            self.one_note(ran, "2 points")
            self.expect_mesh_of(surface, hex_files.read_vtk(self.read("out.vtk").decode()))
            self.expect(0, self.hexatlas("check", "out.vtk", "--boundary", name))


class NoMesh(MeshTest):
    def answer(self, code, surface, *words, method="auto"):
        ran = self.expect(code, self.mesh(surface, "--method", method))
        self.assertEqual(ran.out, "")
        self.assertRegex(ran.err, r"\Ahexatlas: in\.obj: [^\n]+\n\Z")
        for word in words:
            self.assertIn(word, ran.err)
        self.assertEqual(self.listing(), ["in.obj"])
        self.expect_object(code, surface, ran.err, method)
        return ran.err

    def expect_object(self, code, surface, sentence, method):
        """--json adds an object that says the same; with -o - on standard error."""
        ran = self.expect(code, self.mesh(surface, "--json", "--method", method))
        self.assertEqual(ran.err, sentence)
        self.assertEqual(ran.out.count("\n"), 1)
        said = json.loads(ran.out)
        self.assertEqual(list(said), ["outcome", "quads", "reason", "code"])
        self.assertEqual(said["outcome"], {1: "impossible", 4: "not_in_table"}[code])
        self.assertEqual(said["quads"], len(surface[1]))
        self.assertEqual(sentence, f"hexatlas: in.obj: {said['reason']}\n")
        found = re.search(r"q1:[0-9a-f]+", sentence)
        self.assertEqual(said["code"], found.group(0) if found else None)
        other = self.expect(code, self.mesh(surface, "--json", "--method", method, output="-"))
        self.assertEqual((other.out, other.err), ("", sentence + ran.out))
        self.assertEqual(self.listing(), ["in.obj"])

    def test_odd_number_of_quads(self):
        for method in METHODS:
            self.answer(1, surfaces.cube_with_cut_quad(1), "7 quads", "odd", method=method)

    def test_two_quads(self):
        points, _ = surfaces.cube()
        self.answer(1, (points[:4], [[0, 1, 2, 3], [3, 2, 1, 0]]), "2 quads")
        # It has a code all the same.
        code = self.expect(0, self.hexatlas("code", "in.obj", "--json"))
        self.assertEqual(json.loads(code.out)["quads"], 2)

    def test_not_three_connected(self):
        # Two quads with two edges in common; two quads with two opposite vertices in common.
        self.answer(1, surfaces.cube_with_cut_quad(2), "3-connected", "4-6")
        for method in METHODS:
            self.answer(1, surfaces.four_lenses(), "3-connected", "0-1", method=method)

    def test_not_in_the_table(self):
        said = self.answer(4, surfaces.grid_cube(3), "54 quads", "table", method="table")
        code = self.expect(0, self.hexatlas("code", "in.obj")).out.split()[0]
        self.assertRegex(code, r"\Aq1:[0-9a-f]{54}\Z")
        self.assertIn(code, said)

    def test_too_large_for_codes(self):
        said = self.answer(4, surfaces.grid_cube(4), "96 quads", method="table")
        self.assertFalse(re.search("q1:|code", said), said)
        self.expect_fault(self.hexatlas("code", "in.obj"), "in.obj")


SECTORS = os.path.join(program.REPOSITORY, "tables", "data", "linear-bound.hxs")


class Construction(MeshTest):
    def construct(self, surface, output, *options):
        said = self.mesh_and_judge(surface, output, "--effort", "0", "--method", "construction", *options)
        self.assertEqual(said["method"], "construction")
        self.assertIsNone(said["table_entry"])
        self.assertLessEqual(said["hexahedra"], 25 * said["quads"])
        self.assertGreaterEqual(said["hexahedra"], 15 * said["quads"])
        return said

    def test_what_is_not_in_the_table_is_meshed(self):
        for surface in (surfaces.grid_cube(3), surfaces.trapezohedron(31), surfaces.grid_cube(4)):
            self.construct(surface, "out.vtk")

    def test_disguises(self):
        rng = random.Random(3)
        for _ in range(3):
            self.construct(disguised(surfaces.grid_cube(3), rng), "out.mesh")

    def test_small_surfaces_if_asked(self):
        for name in program.share_of(sorted(os.listdir(program.INPUTS)), least=3):
            surface = surfaces.read_obj(os.path.join(program.INPUTS, name))
            made = self.construct(surface, "made.vtu")
            listed = self.mesh_and_judge(surface, "listed.vtk", "--method", "table", "--effort", "0")
            self.assertEqual(listed["method"], "table")
            self.assertLess(listed["hexahedra"], made["hexahedra"])

    def test_same_bytes_again(self):
        for output in ("a.vtk", "b.vtk"):
            self.construct(surfaces.grid_cube(3), output)
        self.assertEqual(self.read("a.vtk"), self.read("b.vtk"))

    def test_words_for_people(self):
        ran = self.expect(0, self.mesh(surfaces.grid_cube(3), "--effort", "0", "--method", "construction"))
        self.assertRegex(ran.out, r"by the linear construction; [0-9]+\.[0-9]{2} hexahedra per quad\n")
        self.assertNotIn("table", ran.out)

    def test_sectors_named(self):
        with open(SECTORS, encoding="ascii") as file:
            text = file.read()
        self.write("same.hxs", text)
        surface = surfaces.grid_cube(3)
        self.construct(surface, "a.vtk")
        self.construct(surface, "b.vtk", "--sectors", "same.hxs")
        self.assertEqual(self.read("a.vtk"), self.read("b.vtk"))
        # Only the last sector has no scars: 25 hexahedra for each quad.
        self.write("last.hxs", "hexatlas sectors 1\n" + text[text.rindex("sector 50 "):])
        made = self.construct(surface, "c.vtk", "--sectors", "last.hxs")
        self.assertEqual(made["hexahedra"], 25 * 54)

    def test_sectors_missing_or_damaged(self):
        with open(SECTORS, encoding="ascii") as file:
            lines = file.read().splitlines(keepends=True)
        damages = {"empty.hxs": ([], 1), "header.hxs": (["hexatlas sectors 2\n"] + lines[1:], 1),
                   "short.hxs": (lines[:-1], len(lines)), "word.hxs": (lines[:2] + ["x\n"], 3),
                   "law.hxs": (lines[:3] + lines[2:3] + lines[4:], 32),
                   "scars.hxs": (lines[:32], 0)}
        surface = surfaces.grid_cube(3)
        for i, (name, (text, line)) in enumerate(damages.items()):
            self.write(name, "".join(text))
            for method in program.share_of(("auto", "flips", "construction"), i):
                with self.subTest(damage=name, method=method):
                    ran = self.mesh(surface, "--method", method, "--sectors", name)
                    self.assertEqual(self.expect_fault(ran, name), line)
        for missing in ("missing.hxs", "."):
            self.expect_fault(self.mesh(surface, "--sectors", missing), missing)
        # They are not read if only the table is asked, or zones.
        for method in ("table", "zones"):
            self.expect(0, self.mesh(surfaces.cube(), "--method", method, "--sectors", "law.hxs"))
        self.assertEqual(self.listing(), sorted(["in.obj", "out.vtk", *damages]))

    def test_methods_have_names(self):
        ran = self.expect(2, self.mesh(surfaces.cube(), "--method", "best"))
        self.assertIn("--method", ran.err)
        self.assertEqual(self.listing(), ["in.obj"])

    def test_require_valid(self):
        ran = self.mesh(surfaces.grid_cube(3), "--require-valid", "--json", "--effort", "0", "--method", "construction")
        said = json.loads(ran.out)
        self.expect(0 if said["valid"] == said["hexahedra"] else 4, ran)
        self.expect(0, self.hexatlas("check", "out.vtk", "--boundary", "in.obj"))


if __name__ == "__main__":
    program.main()
