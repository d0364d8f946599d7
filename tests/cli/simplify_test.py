#!/usr/bin/env python3
"""Claim. `simplify` writes a mesh with the boundary of the mesh given, quad by quad and its points bit for bit, and no
more hexahedra; a layer put around a mesh of the table goes away again; the same seed gives the same bytes;
with --keep-valid no more hexahedra are invalid than were;
what is no mesh of a ball is refused; a stop leaves a mesh.
Oracle. hex_files.py, which reads and writes files on its own; `hexatlas check`, which shares no code with
the exchange; the number of hexahedra before the layer was put on.
"""
import json
import os
import signal
import subprocess
import time

import hex_files
import program
import surfaces

KEYS = {"before", "after", "interior_vertices", "exchanges", "seconds", "min_scaled_jacobian", "mean_scaled_jacobian", "valid", "inverted",
        "histogram", "quality_before"}
INPUTS = ("two-cubes", "rhombic-dodecahedron", "trapezohedron-4", "schneiders-pyramid", "three-cubes-l")


def wrapped(points, cells):
    """The mesh with a layer inside of its boundary: boundary vertices doubled, a hexahedron for each quad."""
    quads = hex_files.boundary(cells)
    copy = {v: len(points) + i for i, v in enumerate(sorted({v for q in quads for v in q}))}
    inner = [tuple(copy.get(v, v) for v in cell) for cell in cells]
    layer = [tuple(copy[v] for v in quad) + tuple(quad) for quad in quads]
    return points + [points[v] for v in copy], inner + layer


def shuffled(points, cells):
    """Boundary points no longer first: all numbers reversed."""
    last = len(points) - 1
    return points[::-1], [tuple(last - v for v in cell) for cell in cells]


def vtk(points, cells):
    lines = ["# vtk DataFile Version 3.0", "mesh", "ASCII", "DATASET UNSTRUCTURED_GRID",
             f"POINTS {len(points)} double", *(" ".join(map(repr, p)) for p in points),
             f"CELLS {len(cells)} {9 * len(cells)}", *("8 " + " ".join(map(str, c)) for c in cells),
             f"CELL_TYPES {len(cells)}", *["12"] * len(cells)]
    return "\n".join(lines) + "\n"


def boundary_at_points(mesh):
    """The boundary quads as cycles of the bits of their points."""
    bits = hex_files.bits(mesh[0])
    return sorted(hex_files.least_first([bits[v] for v in quad]) for quad in hex_files.boundary(mesh[1]))


class Simplify(program.ProgramTest):
    def table_mesh(self, name):
        self.expect(0, self.hexatlas("mesh", "hex", os.path.join(program.INPUTS, name + ".obj"), "-o",
                                     "table.vtk", "--effort", "0"))
        return hex_files.read_vtk(self.read("table.vtk").decode())

    def simplified(self, *options, code=0):
        ran = self.expect(code, self.hexatlas("simplify", "in.vtk", "-o", "out.vtk", "--json", *options))
        return json.loads(ran.out)

    def test_layers_go_away(self):
        for name in program.share_of(INPUTS, least=2):
            mesh = self.table_mesh(name)
            given = shuffled(*wrapped(*wrapped(*mesh)))
            self.write("in.vtk", vtk(*given))
            self.expect(0, self.hexatlas("check", "in.vtk"))
            for options in ((), ("--no-table", "--seed", "7")):
                with self.subTest(input=name, options=options):
                    said = self.simplified("--tries", "2000", "--effort", "0", *options)
                    self.assertEqual(set(said), KEYS)
                    self.assertEqual(said["before"], len(given[1]))
                    self.assertLessEqual(said["after"], len(mesh[1]))
                    made = hex_files.read_vtk(self.read("out.vtk").decode())
                    self.assertEqual(len(made[1]), said["after"])
                    self.assertEqual(boundary_at_points(made), boundary_at_points(given))
                    judged = self.expect(0, self.hexatlas("check", "out.vtk", "--json"))
                    self.assertEqual(json.loads(judged.out)["interior_vertices"], said["interior_vertices"])

    def test_no_more_invalid_hexahedra_if_asked(self):
        self.write("in.obj", surfaces.obj(*surfaces.grid_cube(3)))
        self.expect(0, self.hexatlas("mesh", "hex", "in.obj", "-o", "in.vtk", "--method", "flips", "--layers", "1",
                                     "--effort", "1"))
        options = ("--tries", "64", "--effort", "1")
        plain = self.simplified(*options)
        self.assertEqual(plain["quality_before"]["valid"], plain["before"])
        self.assertLess(plain["valid"], plain["after"])
        ran = self.expect(0, self.hexatlas("simplify", "in.vtk", "-o", "out.vtk", "--json", *options, "--keep-valid",
                                           "--require-valid"))
        self.assertRegex(ran.err, r": [1-9][0-9]* changes? taken back, [^\n]+; 64 tries of 64 made\n\Z")
        kept = json.loads(ran.out)
        self.assertEqual(kept["valid"], kept["after"])
        # A cube in a cube: one hexahedron is as valid as seven.
        cube = [(float(x), float(y), float(z)) for z in (0, 3) for y in (0, 3) for x in (0, 3)]
        inner = [tuple(1 + w / 3 for w in p) for p in cube]
        whole = (0, 1, 3, 2, 4, 5, 7, 6)
        _, cells = wrapped(cube, [whole])
        self.write("in.vtk", vtk(cube + inner, cells))
        kept = self.simplified(*options, "--keep-valid", "--require-valid")
        self.assertEqual((kept["before"], kept["quality_before"]["valid"], kept["after"], kept["valid"]), (7, 7, 1, 1))
        # Of layers without thickness no hexahedron is valid: each one less is welcome.
        self.write("in.vtk", vtk(*wrapped(*self.table_mesh("three-cubes-l"))))
        self.expect(0, self.hexatlas("check", "in.vtk"))
        kept = self.simplified(*options, "--keep-valid")
        self.assertLess(kept["after"], kept["before"])
        self.assertLessEqual(kept["after"] - kept["valid"], kept["before"] - kept["quality_before"]["valid"])
        self.expect(0, self.hexatlas("check", "out.vtk"))
        once = self.read("out.vtk")
        self.simplified(*options, "--keep-valid")
        self.assertEqual(self.read("out.vtk"), once)

    def test_same_bytes_again_and_in_all_formats(self):
        self.write("in.vtk", vtk(*wrapped(*self.table_mesh("three-cubes-l"))))
        first = self.simplified("--tries", "100")
        once = self.read("out.vtk")
        self.simplified("--tries", "100")
        self.assertEqual(self.read("out.vtk"), once)
        for name in ("out.vtu", "out.mesh", "out.msh"):
            ran = self.expect(0, self.hexatlas("simplify", "in.vtk", "-o", name, "--tries", "100"))
            self.assertIn(f"{name}: {first['after']} hexahedra, {first['before']} before; ", ran.out)
            self.expect(0, self.hexatlas("check", name))
        ran = self.expect(0, self.hexatlas("simplify", "-", "-o", "-", "--tries", "100", stdin=self.read("in.vtk")))
        self.assertEqual(ran.out.encode(), once)
        self.assertIn("hexahedra", ran.err)

    def test_a_mesh_that_stays_keeps_its_points(self):
        mesh = self.table_mesh("rhombic-dodecahedron")
        moved = [tuple(x + 0.125 for x in p) for p in mesh[0]]
        self.write("in.vtk", vtk(moved, mesh[1]))
        said = self.simplified("--tries", "50")
        self.assertEqual(said["before"], said["after"])
        made = hex_files.read_vtk(self.read("out.vtk").decode())
        self.assertEqual(hex_files.bits(made[0]), hex_files.bits(moved))

    def test_hexahedra_inside_out_are_turned_over(self):
        mesh = self.table_mesh("two-cubes")
        for points, cells in (mesh, wrapped(*mesh)):
            count = len(cells)
            for given, note in ((cells, ""), ([cell[4:] + cell[:4] for cell in cells],
                                              f"hexatlas: note: {count} of the {count} hexahedra of in.vtk were "
                                              "inside out and turned over\n")):
                self.write("in.vtk", vtk(points, given))
                ran = self.expect(0, self.hexatlas("simplify", "in.vtk", "-o", "out.vtk", "--json", "--tries", "500"))
                said = json.loads(ran.out)
                self.assertEqual((said["after"], said["valid"], said["inverted"]), (2, 2, 0))
                self.assertEqual(ran.err, note)

    def test_parts_spares_the_whole(self):
        self.write("in.vtk", vtk(*wrapped(*self.table_mesh("two-cubes"))))
        self.assertEqual(self.simplified()["after"], 2)
        self.assertGreater(self.simplified("--parts", "--cavity", "8")["after"], 2)

    def test_points_of_no_hexahedron_are_left_out(self):
        points, cells = self.table_mesh("two-cubes")
        lonely = [(9.0, 9.0, 9.0), *points[:5], (8.0, 8.0, 8.0), *points[5:]]
        number = [v + (1 if v < 5 else 2) for v in range(len(points))]
        self.write("in.vtk", vtk(lonely, [[number[v] for v in cell] for cell in cells]))
        ran = self.expect(0, self.hexatlas("simplify", "in.vtk", "-o", "out.vtk"))
        self.assertIn("note: 2 points of in.vtk in no hexahedron, left out", ran.err)
        made = hex_files.read_vtk(self.read("out.vtk").decode())
        self.assertEqual((len(made[0]), len(made[1])), (12, 2))

    def test_bad_input(self):
        mesh = self.table_mesh("two-cubes")
        for cells in (mesh[1] + mesh[1][:1], [mesh[1][0], mesh[1][1][4:] + mesh[1][1][:4]]):
            self.write("in.vtk", vtk(mesh[0], cells))
            self.expect_fault(self.hexatlas("simplify", "in.vtk", "-o", "out.vtk"), "in.vtk")
        self.write("in.vtk", vtk(*mesh).replace("CELLS 2 18", "CELLS 2 17"))
        self.expect_fault(self.hexatlas("simplify", "in.vtk", "-o", "out.vtk"), "in.vtk")
        self.write("cube.obj", surfaces.obj(*surfaces.cube()))
        self.expect_fault(self.hexatlas("simplify", "cube.obj", "-o", "out.vtk"), "cube.obj")
        self.expect_fault(self.hexatlas("simplify", "none.vtk", "-o", "out.vtk"), "none.vtk")
        self.write("in.vtk", vtk(*mesh))
        self.expect_fault(self.hexatlas("simplify", "in.vtk", "-o", "out.obj"), "out.obj")
        self.expect_fault(self.hexatlas("simplify", "in.vtk", "-o", "out.vtk", "--table", "in.vtk"), "in.vtk")
        self.assertNotIn("out.vtk", self.listing())

    def test_usage(self):
        self.write("in.vtk", vtk(*self.table_mesh("two-cubes")))
        os.symlink("in.vtk", self.path("link.vtk"))
        before = self.read("in.vtk")
        for output in ("in.vtk", "./in.vtk", "link.vtk"):
            ran = self.expect(2, self.hexatlas("simplify", "in.vtk", "-o", output))
            self.assertRegex(ran.err, r"\Ahexatlas: [^\n]*same file[^\n]*\n\Z")
            self.assertEqual(self.read("in.vtk"), before)
        for options in (("--cavity", "27"), ("--cavity", "5"), ("--seed", "-1"), ("--uphill", "21"),
                        ("--no-table", "--table", "x.hxt")):
            self.expect(2, self.hexatlas("simplify", "in.vtk", "-o", "out.vtk", *options))

    def test_a_stop_leaves_a_mesh(self):
        self.write("in.vtk", vtk(*wrapped(*self.table_mesh("schneiders-pyramid"))))
        for options in (("--parts",), ("--parts", "--keep-valid", "--effort", "0")):
            with subprocess.Popen([program.PROGRAM, "simplify", "in.vtk", "-o", "out.vtk", "--json", "--tries",
                                   "1000000000", *options], cwd=self.folder, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
                program.wait_for_handler(running, signal.SIGINT)
                time.sleep(0.5)
                running.send_signal(signal.SIGINT)
                out, err = running.communicate(timeout=120)
            self.assertEqual(running.returncode, 4, err)
            self.assertIn(b"stopped", err)
            self.assertEqual(set(json.loads(out)), KEYS)
            self.expect(0, self.hexatlas("check", "out.vtk"))


if __name__ == "__main__":
    program.main()
