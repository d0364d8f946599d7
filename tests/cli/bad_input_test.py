#!/usr/bin/env python3
"""Claim. Each defect of a surface file, in each format in which it can be written, ends with exit
3 and one line `file:line: reason`; nothing is printed, no file is made, and none is changed.
Oracle. The defects are put in here, by writers of the formats in surfaces.py; the line is that of
the damaged word.
"""
import os
import random

import program
import surfaces

BEFORE = b"what was there before\n"


def with_point(word):
    points, quads = surfaces.cube()
    points[5] = ("1", word, "1")
    return points, quads


def with_vertex(vertex):
    points, quads = surfaces.cube()
    quads[3][2] = vertex
    return points, quads


def with_quad(quad):
    points, quads = surfaces.cube()
    quads[3] = quad
    return points, quads


def two_components():
    points, quads = surfaces.cube()
    far = [tuple(str(int(x) + 5) for x in point) for point in points]
    return points + far, quads + [[v + 8 for v in quad] for quad in quads]


# name: (surface, what the reason must say, in lower case)
SHAPES = {
    "repeated vertex in a quad": (with_quad([1, 2, 6, 2]), ("repeated",)),
    "open": ((surfaces.cube()[0], surfaces.cube()[1][:5]), ("open",)),
    "quad given twice": (with_quad([0, 3, 2, 1]), ("edge", "quads")),
    "two components": (two_components(), ("2 components",)),
    "edge in four quads": (surfaces.two_cubes_sharing({0: 6, 1: 5}), ("4 quads", "manifold")),
    "two cubes at one vertex": (surfaces.two_cubes_sharing({0: 6}), ("point 6", "manifold")),
    "torus": (surfaces.grid_closed_up(3, 4, False), ("genus 1",)),
    "Klein bottle": (surfaces.grid_closed_up(3, 4, True), ("orient",)),
    "no quad": (([("0", "0", "0")], []), ("no quad",)),
}

# Per format, words with a count and what they are replaced by.
COUNTS = {
    "off": {"8 6 0": ["9 6 0", "7 6 0", "8 7 0", "8 5 0", "8 -6 0", "1099511627776 6 0"]},
    "vtk": {"POINTS 8": ["POINTS 9", "POINTS 7", "POINTS -8", "POINTS 1099511627776"],
            "CELLS 6 30": ["CELLS 7 30", "CELLS 6 31", "CELLS 5 25", "CELLS 6 1099511627776"],
            "CELL_TYPES 6": ["CELL_TYPES 5", "CELL_TYPES 7"]},
    "vtu": {'NumberOfPoints="8"': ['NumberOfPoints="9"', 'NumberOfPoints="7"', ""],
            'NumberOfCells="6"': ['NumberOfCells="7"', 'NumberOfCells="5"', ""],
            "4 8 12": ["4 7 12", "4 3 12", "4 99 12"]},
    "medit": {"Vertices\n8": ["Vertices\n9", "Vertices\n7", "Vertices\n1099511627776"],
              "Quadrilaterals\n6": ["Quadrilaterals\n7", "Quadrilaterals\n5"]},
    "msh 2.2": {"$Nodes\n8": ["$Nodes\n9", "$Nodes\n7", "$Nodes\n-8", "$Nodes\n1099511627776"],
                "$Elements\n6": ["$Elements\n7", "$Elements\n5"], "2.2 0": ["9.9 0", "2.2 7"]},
    "msh 4.1": {"1 8 1 8": ["1 9 1 8", "2 8 1 8"], "2 1 0 8": ["2 1 0 9", "2 1 0 7"],
                "1 6 1 6": ["1 7 1 6", "1 5 1 6"], "2 1 3 6": ["2 1 3 7", "2 1 99 6"]},
}


class BadInput(program.ProgramTest):
    shares = 0

    def refuse(self, name, content, said=()):
        """Returns the line that was named."""
        self.write(name, content)
        ran = self.hexatlas("mesh", "hex", name, "-o", "made.vtk")
        line = self.expect_fault(ran, name)
        for word in said:
            self.assertIn(word, ran.err.lower())
        self.assertEqual(self.listing(), [name], ran)
        os.remove(self.path(name))
        return line

    def in_each_format(self, body):
        for key, (extension, writer, base, pentagons) in surfaces.FORMATS.items():
            with self.subTest(format=key):
                body("bad" + extension, writer, base, pentagons)

    def some(self, cases):
        """Under a sanitizer, those of one format are others than those of the next."""
        self.shares += 1
        return program.share_of(cases, self.shares, least=2)

    def expect_line_of(self, text, word, line):
        lines = [i + 1 for i, row in enumerate(text.split("\n")) if word in row.split()]
        self.assertEqual([line], lines)

    def test_surfaces_written_here_are_read(self):
        def body(name, writer, _base, _pentagons):
            self.write(name, writer(*surfaces.cube()))
            self.expect(0, self.hexatlas("mesh", "hex", name, "-o", "made.vtk"))
            self.expect(0, self.hexatlas("check", "made.vtk", "--boundary", name))
        self.in_each_format(body)

    def test_shapes_that_bound_no_ball(self):
        def body(name, writer, _base, _pentagons):
            for shape, (surface, said) in self.some(list(SHAPES.items())):
                with self.subTest(shape=shape):
                    self.refuse(name, writer(*surface), said)
        self.in_each_format(body)

    def test_lines_of_quads(self):
        # In these formats each quad has its line; the damaged one is quad 3.
        for shape, marker in (("repeated vertex in a quad", "2 3 7 3"),
                              ("quad given twice", "1 4 3 2")):
            text = surfaces.obj(*SHAPES[shape][0])
            lines = [i + 1 for i, row in enumerate(text.split("\n")) if row == "f " + marker]
            self.assertIn(self.refuse("bad.obj", text), lines)

    def test_vertices_outside_the_list(self):
        def body(name, writer, base, _pentagons):
            words = [str(2**31 + 3), str(2**32 + 3 + base), str(2**64 + 3 + base), "-77", "1.5",
                     "seven", "0x3", str(8 + base), "-1" if base == 0 else "0"]
            for word in self.some(words):
                with self.subTest(vertex=word):
                    text = writer(*with_vertex(word))
                    line = self.refuse(name, text)
                    if word not in words[-2:]:  # these stand in other lines, too
                        self.expect_line_of(text, word, line)
        self.in_each_format(body)

    def test_coordinates_that_are_no_numbers(self):
        def body(name, writer, _base, _pentagons):
            for word in self.some(("nan", "NaN", "inf", "-inf", "Infinity", "1e400", "-1e400", "1,5", "1.5x",
                                   "--1", "1e", "0x1p3")):
                with self.subTest(coordinate=word):
                    text = writer(*with_point(word))
                    line = self.refuse(name, text)
                    if "nan" not in word.lower() and "inf" not in word.lower():
                        self.expect_line_of(text, word, line)
                    elif not name.endswith(".vtu"):  # there, the line may be that of the array
                        self.expect_line_of(text, word, line)
        self.in_each_format(body)

    def test_facets_that_are_no_quads(self):
        def body(name, writer, _base, pentagons):
            self.refuse(name, writer(*with_quad([1, 2, 6])), ("triangle", "quad"))
            if pentagons:
                self.refuse(name, writer(*with_quad([1, 2, 6, 5, 0])), ("pentagon", "quad"))
        self.in_each_format(body)

    def test_cut_files(self):
        def body(name, writer, _base, _pentagons):
            text = writer(*surfaces.cube())
            for place in self.some([len(text) * tenth // 10 for tenth in range(10)] + [len(text) - 3]):
                with self.subTest(bytes=place):
                    self.refuse(name, text[:place])
        self.in_each_format(body)

    def test_counts_that_lie(self):
        for key, changes in COUNTS.items():
            extension, writer, _, _ = surfaces.FORMATS[key]
            text = writer(*surfaces.cube())
            for old, others in changes.items():
                for new in others:
                    with self.subTest(format=key, old=old, new=new):
                        self.assertEqual(text.count(old), 1)
                        self.refuse("bad" + extension, text.replace(old, new))

    def test_garbage(self):
        noise = random.Random(20).randbytes(2000)

        def body(name, _writer, _base, _pentagons):
            for content in self.some((b"", b"\n\n", noise, noise.replace(b"\n", b"") + b"\n", b"\0" * 512,
                                      "\u00e9t\u00e9\n")):
                self.refuse(name, content)
        self.in_each_format(body)

    def test_files_that_are_no_files(self):
        def body(name, _writer, _base, _pentagons):
            ran = self.hexatlas("mesh", "hex", name, "-o", "made.vtk")
            self.expect_fault(ran, name)
            self.assertIn("No such file", ran.err)
            self.assertEqual(self.listing(), [])
            os.mkdir(self.path(name))
            ran = self.hexatlas("mesh", "hex", name, "-o", "made.vtk")
            self.expect_fault(ran, name)
            self.assertIn("directory", ran.err)
            self.assertEqual(self.listing(), [name])
            os.rmdir(self.path(name))
        self.in_each_format(body)

    def test_an_existing_output_is_not_touched(self):
        self.write("made.vtk", BEFORE)
        os.utime(self.path("made.vtk"), (10**9, 10**9))
        for surface, _ in SHAPES.values():
            self.write("bad.obj", surfaces.obj(*surface))
            self.expect_fault(self.hexatlas("mesh", "hex", "bad.obj", "-o", "made.vtk"), "bad.obj")
            self.assertEqual(self.read("made.vtk"), BEFORE)
            self.assertEqual(os.stat(self.path("made.vtk")).st_mtime, 10**9)
            self.assertEqual(self.listing(), ["bad.obj", "made.vtk"])

    def test_code_refuses_as_mesh_hex_does(self):
        for shape, (surface, _) in SHAPES.items():
            with self.subTest(shape=shape):
                self.write("bad.off", surfaces.off(*surface))
                meshed = self.hexatlas("mesh", "hex", "bad.off", "-o", "made.vtk")
                coded = self.hexatlas("code", "bad.off")
                self.expect_fault(coded, "bad.off")
                self.assertEqual(coded.err, meshed.err)

    def test_standard_input_has_a_name(self):
        ran = self.hexatlas("mesh", "hex", "-", "-o", "made.vtk",
                            stdin=surfaces.obj(*with_vertex("99")).encode())
        self.assertEqual(12, self.expect_fault(ran, "standard input"))
        self.expect_fault(self.hexatlas("mesh", "hex", "-", "-o", "made.vtk"), "standard input")
        self.assertEqual(self.listing(), [])


class BadOutput(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", surfaces.obj(*surfaces.cube()))

    def refuse(self, output, **options):
        before = self.listing()
        ran = self.hexatlas("mesh", "hex", "cube.obj", "-o", output, **options)
        self.expect_fault(ran, output)
        self.assertEqual(self.listing(), before)

    def test_outputs_that_cannot_be_written(self):
        os.mkdir(self.path("folder.vtk"))
        for output in ("nowhere/made.vtk", "folder.vtk", "made.xyz", "made", "made.obj", "made.off",
                       "cube.obj/made.vtk", "made.vtk/"):
            with self.subTest(output=output):
                self.refuse(output)

    def test_permissions(self):
        options = {}
        if os.geteuid() == 0:  # who may write anywhere
            options = {"user": 65534, "group": 65534}
            os.chown(self.folder, 65534, 65534)
            try:
                self.expect(0, self.hexatlas("--version", **options))
            except OSError:
                self.skipTest("the program is out of reach of other users")
        os.mkdir(self.path("closed"), 0o555)
        self.write("made.vtk", BEFORE)
        os.chmod(self.path("made.vtk"), 0o444)
        for output in ("closed/made.vtk", "made.vtk"):
            self.refuse(output, **options)
        self.assertEqual(self.read("made.vtk"), BEFORE)
        self.write("a.manifest.json", BEFORE)
        os.chmod(self.path("a.manifest.json"), 0o444)
        for output, named in (("closed/a.hxt", "closed/a.hxt"), ("a.hxt", "a.manifest.json")):
            ran = self.hexatlas("table", "build", "-o", output, "--max-quads", "18", **options)
            self.expect_fault(ran, named)
        os.chmod(self.path("cube.obj"), 0)
        ran = self.hexatlas("mesh", "hex", "cube.obj", "-o", "new.vtk", **options)
        self.expect_fault(ran, "cube.obj")
        self.assertIn("Permission denied", ran.err)

    def test_long_work_is_not_begun_in_vain(self):
        """Each would take minutes or more, or has printed something, when it comes to write."""
        os.makedirs(self.path("result/hexahedron.html"))
        for command, output in (
                ("enum triangulations hexahedron --interior 3 -o", "nowhere/made.hxc"),
                ("enum triangulations hexahedron --completeness", "nowhere/made.hxl"),
                ("enum balls --vertices 9 -o", "nowhere/made.hxc"),
                ("realize hexahedron --convex -o", "cube.obj/made.hxc")):
            with self.subTest(command=command):
                self.expect_fault(self.hexatlas(*command.split(), output), output)
        ran = self.hexatlas("reproduce", "hexahedron-174", "-o", "result")
        self.expect_fault(ran, "result/hexahedron.html")
        self.expect_fault(self.hexatlas("reproduce", "hexahedron-174", "-o", "cube.obj"), "cube.obj")
        self.assertEqual(self.listing(), ["cube.obj", "result"])

    def test_full_device(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        os.symlink("/dev/full", self.path("full.vtk"))
        ran = self.expect(5, self.hexatlas("mesh", "hex", "cube.obj", "-o", "full.vtk"))
        self.assertEqual(ran.err.count("\n"), 1, ran)
        self.assertIn("full.vtk", ran.err)
        self.assertEqual(ran.out, "")


if __name__ == "__main__":
    program.main()
