#!/usr/bin/env python3
"""Claim. `view` writes one page that needs no other file and no network, with the same bytes for the same mesh and
options; the data in it are those of the mesh; its picture has the size asked for and shows something; options put the
page into the state that they name; wrong use, bad files and a missing, failing or endless browser have their exit
codes, and leave no file. In Chromium, if there is one, the page draws as many cells and facets as there are.
Oracle. hex_files.py and the grids of this file, of which everything is known by counting; a reader of PNG written
here; Chromium itself, which says what the page has become.
"""
import base64
import html.parser
import json
import math
import os
import re
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import unittest
import zlib

import hybrid_files
import program
import surfaces

CHROMIUM = shutil.which(os.environ.get("CHROMIUM") or "chromium") or shutil.which("google-chrome")
SOFTWARE = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


def grid(n, place=lambda *at: at):
    """n x n x n cubes, in VTK's order of corners."""
    def number(x, y, z):
        return x + (n + 1) * (y + (n + 1) * z)

    points = [place(x, y, z) for z in range(n + 1) for y in range(n + 1) for x in range(n + 1)]
    bottom = ((0, 0), (1, 0), (1, 1), (0, 1))
    cells = [[number(x + i, y + j, z + k) for k in (0, 1) for i, j in bottom]
             for z in range(n) for y in range(n) for x in range(n)]
    return points, cells


def vtk(points, cells):
    lines = ["# vtk DataFile Version 3.0", "mesh", "ASCII", "DATASET UNSTRUCTURED_GRID",
             f"POINTS {len(points)} double", *(" ".join(map(repr, p)) for p in points),
             f"CELLS {len(cells)} {9 * len(cells)}", *("8 " + " ".join(map(str, c)) for c in cells),
             f"CELL_TYPES {len(cells)}", *["12"] * len(cells)]
    return "\n".join(lines) + "\n"


class Elements(html.parser.HTMLParser):
    """All tags of a page, and the texts of the scripts that have a name."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.data, self.name = [], {}, None
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        self.name = dict(attrs).get("id") if tag == "script" else None

    def handle_endtag(self, tag):
        self.name = None

    def handle_data(self, data):
        if self.name:
            self.data[self.name] = self.data.get(self.name, "") + data

    def about(self):
        return json.loads(self.data["data-about"])

    def numbers(self, name, kind):
        data = base64.b64decode(self.data["data-" + name], validate=True)
        return [number for number, in struct.iter_unpack("<" + kind, data)]


def pixels(png):
    """Width, height and the rows of a PNG of 8-bit RGB or RGBA without interlace."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n", png[:8]
    at, data, header = 8, b"", None
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + size]
        assert zlib.crc32(kind + body) == struct.unpack(">I", png[at + 8 + size:at + 12 + size])[0]
        header = struct.unpack(">IIBBBBB", body) if kind == b"IHDR" else header
        data += body if kind == b"IDAT" else b""
        at += 12 + size
    width, height, depth, colour, _, _, interlace = header
    assert depth == 8 and colour in (2, 6) and interlace == 0, header
    step = 3 if colour == 2 else 4
    raw, rows, before = zlib.decompress(data), [], bytes(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        before = unfiltered(raw[start], bytearray(raw[start + 1:start + 1 + width * step]), before, step)
        rows.append([bytes(before[x:x + 3]) for x in range(0, width * step, step)])
    return width, height, rows


def unfiltered(kind, row, above, step):
    for i in range(len(row) if kind else 0):
        left = row[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        up = above[i]
        nearest = min((left, up, corner), key=lambda x: abs(left + up - corner - x))
        row[i] = (row[i] + (left, up, (left + up) // 2, nearest)[kind - 1]) & 255
    return bytes(row)


class Pages(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("grid.vtk", vtk(*grid(3)))

    def page(self, *options, mesh="grid.vtk"):
        self.expect(0, self.hexatlas("view", mesh, "-o", "page.html", *options))
        return Elements(self.read("page.html").decode())

    def test_what_it_says(self):
        ran = self.expect(0, self.hexatlas("view", "grid.vtk", "-o", "page.html"))
        self.assertEqual(ran.out, "page.html: 27 hexahedra in 2 layers, 64 vertices (8 interior), "
                                  "36 singular edges (0 interior)\n")
        self.assertEqual(ran.err, "")

    def test_same_bytes_and_streams(self):
        self.page("--slice", "x=0.3")
        once = self.read("page.html")
        self.page("--slice", "x=0.3")
        self.assertEqual(self.read("page.html"), once)
        streamed = self.expect(0, self.hexatlas("view", "-", "-o", "-", stdin=self.read("grid.vtk")))
        self.assertIn("27 hexahedra", streamed.err)
        self.assertEqual(Elements(streamed.out).about()["name"], "standard input")

    def test_nothing_is_fetched(self):
        page = self.page()
        for tag, attributes in page.tags:
            self.assertNotIn(tag, ("link", "img", "iframe", "base", "object", "embed"))
            for name in ("src", "href", "srcset", "action", "xlink:href"):
                self.assertNotIn(name, attributes, tag)
        policy = [a["content"] for t, a in page.tags if t == "meta" and "http-equiv" in a]
        self.assertEqual(len(policy), 1)
        self.assertRegex(policy[0], r"\Adefault-src 'none'; ")
        self.assertNotIn("http", policy[0])
        text = self.read("page.html").decode()
        self.assertEqual(set(re.findall(r"https?://[^\s\"'`)]+", text)),
                         {"http://www.w3.org/1999/xhtml", "http://www.w3.org/2000/svg"})  # names of languages
        self.assertNotRegex(text, r"@import|url\(\s*['\"]?(?!data:)[a-z]+:")
        self.assertIn("Permission is hereby granted, free of charge", text)

    def test_data_are_those_of_the_mesh(self):
        points, cells = grid(3, lambda x, y, z: (10.0 + 2 * x, float(y), z - 5.0))
        self.write("long.vtk", vtk(points, cells))
        page = self.page(mesh="long.vtk")
        about = page.about()
        self.assertEqual((about["centre"], about["scale"]), ([13.0, 1.5, -3.5], 3.0))
        held = page.numbers("points", "f")
        for i, point in enumerate(points):
            for k in range(3):
                self.assertAlmostEqual(about["centre"][k] + 3 * held[3 * i + k], point[k], places=5)
        swap = (0, 1, 3, 2, 4, 5, 7, 6)  # from the order of VTK to x + 2y + 4z
        self.assertEqual(page.numbers("cells", "I"), [cell[i] for cell in cells for i in swap])
        self.assertEqual(page.numbers("layers", "I"), [1 if i == 13 else 0 for i in range(27)])
        self.assertEqual(page.numbers("jacobians", "f"), [1.0] * 27)
        self.assertEqual(page.numbers("status", "B"), [0] * 27)
        self.assertEqual(page.numbers("neighbours", "I").count(0xFFFFFFFF), 54)
        edges = page.numbers("edges", "I")
        self.assertEqual((len(edges), edges[2::4], edges[3::4]), (4 * 36, [1] * 36, [1] * 36))
        self.assertEqual(about["counts"], {"hexahedra": 27, "vertices": 64, "interior": 8, "valid": 27,
                                           "inverted": 0, "undecided": 0})

    def test_inverted_ones_are_told(self):
        points, cells = grid(1)
        self.write("one.vtk", vtk(points, [cells[0][4:] + cells[0][:4]]))  # upside down
        page = self.page(mesh="one.vtk")
        self.assertEqual(page.numbers("status", "B"), [4 + 1])
        self.assertEqual(page.numbers("jacobians", "f"), [-1.0])

    def test_coordinates_of_any_size(self):
        for scale in (1e-300, 1e300):
            self.write("far.vtk", vtk(*grid(1, lambda *at, s=scale: tuple(s * (x - 0.5) for x in at))))
            held = self.page(mesh="far.vtk").numbers("points", "f")
            self.assertEqual(sorted(set(held)), [-1.0, 1.0])

    def test_options_are_the_first_state(self):
        state = self.page("--slice", "z=0.25", "--flip", "--explode", "0.5", "--shrink", "0.1", "--peel", "1",
                          "--colour", "layer", "--camera", "10,-20.5", "--singular", "boundary").about()["state"]
        self.assertEqual(state["slice"], {"on": True, "axis": "z", "at": 0.25, "flip": True, "normal": [1, 0, 0]})
        self.assertEqual([state[k] for k in ("explode", "shrink", "peel", "colour", "camera", "singular")],
                         [0.5, 0.1, 1, "layer", [10, -20.5], {"interior": False, "boundary": True}])

    def test_a_name_cannot_end_the_script(self):
        name = "<!--<script><b>&.vtk"
        os.rename(self.path("grid.vtk"), self.path(name))
        page = self.page(mesh=name)
        self.assertEqual(page.about()["name"], name)
        self.assertNotIn("b", [tag for tag, _ in page.tags])

    def test_surfaces(self):
        self.write("cube.obj", surfaces.obj(*surfaces.cube()))
        ran = self.expect(0, self.hexatlas("view", "cube.obj", "-o", "page.html"))
        self.assertEqual(ran.out, "page.html: 6 quads, 0 triangles, 8 vertices, 0 edges not in two facets\n")
        self.write("two.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n")
        ran = self.expect(0, self.hexatlas("view", "two.off", "-o", "page.html"))
        self.assertEqual(ran.out, "page.html: 0 quads, 2 triangles, 4 vertices, 4 edges not in two facets\n")
        for option in ("jacobian", "layer"):
            self.expect(2, self.hexatlas("view", "cube.obj", "-o", "other.html", "--colour", option))
        self.assertNotIn("other.html", self.listing())


    def test_hybrid_meshes(self):
        self.write("four.vtk", hybrid_files.vtk(hybrid_files.POINTS, hybrid_files.CELLS))
        page = self.page(mesh="four.vtk")
        ran = self.expect(0, self.hexatlas("view", "four.vtk", "-o", "page.html"))
        self.assertEqual(ran.out, "page.html: 1 tetrahedron, 1 hexahedron, 1 prism, 1 pyramid in 1 layer, "
                                  "12 vertices (0 interior)\n")
        self.assertEqual(page.numbers("shapes", "B"), [0, 1, 2, 3])
        self.assertEqual(page.numbers("cells", "I"), [
            1, 10, 5, 11, 11, 11, 11, 11, 0, 1, 3, 2, 4, 5, 7, 6, 4, 7, 8, 5, 6, 9, 9, 9, 1, 2, 6, 5, 10, 10, 10, 10])
        self.assertEqual(page.about()["state"]["colour"], "shape")
        self.assertEqual(self.page("--colour", "layer", mesh="four.vtk").about()["state"]["colour"], "layer")
        for options in (("--colour", "jacobian"), ("--singular", "all"), ("--peel", "1")):
            self.expect(2, self.hexatlas("view", "four.vtk", "-o", "other.html", *options))
        self.expect(2, self.hexatlas("view", "grid.vtk", "-o", "other.html", "--colour", "shape"))
        self.assertNotIn("other.html", self.listing())
        # Tetrahedra alone are a hybrid mesh.
        self.write("given.vtk", hybrid_files.vtk(hybrid_files.POINTS, hybrid_files.GIVEN))
        self.assertEqual(self.page(mesh="given.vtk").about()["counts"]["tetrahedra"], 12)


class Refusals(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("grid.vtk", vtk(*grid(2)))
        self.before = self.listing()

    def tearDown(self):
        self.assertEqual(self.listing(), self.before)
        super().tearDown()

    def test_files_have_the_endings_of_their_formats(self):
        for options in (("-o", "page.png"), ("--png", "picture.html"), ("-o", "page")):
            ran = self.expect(2, self.hexatlas("view", "grid.vtk", *options))
            self.assertIn("does not end in ", ran.err)

    def test_usage(self):
        before = self.read("grid.vtk")
        for options in ((), ("-o", "grid.vtk"), ("--png", "./grid.vtk"), ("-o", "a", "--png", "a"),
                        *(("-o", "a.html", *words) for words in (
                            ("--slice", "w=0.5"), ("--slice", "x=1.5"), ("--slice", "x=nan"), ("--slice", "0.5"),
                            ("--flip",), ("--explode", "-1"), ("--shrink", "1"), ("--peel", "-1"), ("--peel", "1"),
                            ("--colour", "red"), ("--camera", "10"), ("--camera", "10,91"), ("--size", "800"),
                            ("--size", "800x1"), ("--size", "800.5x600"), ("--size", "9000x600"), ("--timeout", "0"),
                            ("--singular", "some")))):
            with self.subTest(options=options):
                ran = self.expect(2, self.hexatlas("view", "grid.vtk", *options))
                self.assertRegex(ran.err, r"\Ahexatlas: [^\n]+ See `hexatlas view --help`\.\n\Z")
        self.assertEqual(self.read("grid.vtk"), before)

    def test_bad_files(self):
        self.expect_fault(self.hexatlas("view", "none.vtk", "-o", "page.html"), "none.vtk")
        self.expect_fault(self.hexatlas("view", "grid.stl", "-o", "page.html"), "grid.stl")
        self.expect_fault(self.hexatlas("view", "grid.vtk", "-o", "no/page.html"), "no/page.html")
        with tempfile.TemporaryDirectory() as folder:
            broken = os.path.join(folder, "broken.vtk")
            with open(broken, "w", encoding="utf-8") as file:
                file.write(vtk(*grid(2)).replace("CELLS 8 72", "CELLS 8 71"))
            self.expect_fault(self.hexatlas("view", broken, "-o", "page.html"), broken)

    def browser(self, folder, script):
        path = os.path.join(folder, "browser")
        with open(path, "w", encoding="utf-8") as file:
            file.write("#!/bin/sh\n" + script)
        os.chmod(path, 0o755)
        return path

    def failing(self, named, *options, path=None):
        with tempfile.TemporaryDirectory() as temporary:
            env = {"CHROMIUM": named, "TMPDIR": temporary}
            ran = self.expect(5, self.hexatlas("view", "grid.vtk", "--png", "a.png", "-o", "a.html", *options,
                                               env=dict(env, **({"PATH": path} if path else {}))))
            self.assertEqual(os.listdir(temporary), [])
        self.assertRegex(ran.err, r"\Ahexatlas: [^\n]+\n\Z")
        return ran.err

    def test_no_browser(self):
        with tempfile.TemporaryDirectory() as empty:
            said = self.failing("", path=empty)
            self.assertIn("apt-get install chromium", said)
            self.assertIn("cannot be run", self.failing(os.path.join(empty, "browser")))

    def test_browsers_that_fail(self):
        with tempfile.TemporaryDirectory() as folder:
            for script, word in (("echo no display >&2; exit 3\n", "no display"), ("exit 0\n", "said nothing"),
                                 ('echo \'"hexatlas: failed\'\n', "WebGL"), ("kill -9 $$\n", "137"),
                                 ('echo \'"hexatlas: drawn 8 8"\'\n', "no picture")):
                self.assertIn(word, self.failing(self.browser(folder, script)))

    def test_a_browser_without_end_is_stopped_with_its_children(self):
        with tempfile.TemporaryDirectory() as folder:
            mark = os.path.join(folder, "alive")
            endless = self.browser(folder, f"(while :; do date +%N >{mark}; sleep 0.1; done) &\nsleep 100\n")
            self.assertIn("within 1 s", self.failing(endless, "--timeout", "1"))
            size = os.stat(mark).st_mtime_ns
            time.sleep(0.5)
            self.assertEqual(os.stat(mark).st_mtime_ns, size)

    def test_a_stop_leaves_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            env = dict(os.environ, CHROMIUM=self.browser(folder, "sleep 100\n"), TMPDIR=folder)
            with subprocess.Popen([program.PROGRAM, "view", "grid.vtk", "--png", "a.png"], cwd=self.folder, env=env,
                                  stdin=subprocess.DEVNULL, stderr=subprocess.PIPE) as running:
                program.wait_for_handler(running, signal.SIGTERM)
                running.send_signal(signal.SIGTERM)
                said = running.communicate(timeout=60)[1]
            self.assertEqual(running.returncode, 4, said)
            self.assertEqual(os.listdir(folder), ["browser"])


@unittest.skipUnless(CHROMIUM, "there is no Chromium")
@unittest.skipIf(program.SANITIZED, "the browser runs the same page of the other build")
class InBrowser(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("grid.vtk", vtk(*grid(4, lambda x, y, z: (x + 0.3 * math.sin(y), float(y), float(z)))))

    def drawn(self, *options, mesh="grid.vtk", flags=SOFTWARE):
        """The attributes that the page has given itself."""
        self.expect(0, self.hexatlas("view", mesh, "-o", "page.html", *options))
        root = ["--no-sandbox"] if os.geteuid() == 0 else []
        with tempfile.TemporaryDirectory() as profile:
            done = subprocess.run(
                [CHROMIUM, "--headless", *root, *flags, "--disable-quic", "--no-first-run", "--disable-sync",
                 "--disable-background-networking", "--disable-component-update", "--disable-dev-shm-usage",
                 f"--user-data-dir={profile}", "--virtual-time-budget=5000", "--dump-dom",
                 "file://" + self.path("page.html")],
                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=120, check=True)
        page = Elements(done.stdout.decode())
        self.text = done.stdout.decode()
        found = next(attributes for tag, attributes in page.tags if tag == "html")
        return {name[5:]: value for name, value in found.items() if name.startswith("data-")}

    def test_cells_and_facets(self):
        for options, shown, facets in (((), 64, 96), (("--peel", "1", "--shrink", "0.2"), 8, 48),
                                       (("--slice", "z=0.25", "--flip"), 48, 80)):
            with self.subTest(options=options):
                self.assertEqual(self.drawn(*options), {"hexatlas": "drawn", "cells": "64", "shown": str(shown),
                                                        "facets": str(facets)})
        self.assertIn("<title>grid.vtk: hexatlas</title>", self.text)
        self.assertIn("48 of 64 hexahedra shown", self.text)

    def test_a_surface(self):
        self.write("cube.obj", surfaces.obj(*surfaces.cube()))
        self.assertEqual(self.drawn(mesh="cube.obj"),
                         {"hexatlas": "drawn", "cells": "6", "shown": "6", "facets": "6"})

    def test_a_hybrid_mesh(self):
        self.write("four.vtk", hybrid_files.vtk(hybrid_files.POINTS, hybrid_files.CELLS))
        for options, shown, facets in (((), 4, 14), (("--explode", "0.5"), 4, 20),
                                       (("--slice", "x=0.5"), 2, 9)):
            with self.subTest(options=options):
                self.assertEqual(self.drawn(*options, mesh="four.vtk"),
                                 {"hexatlas": "drawn", "cells": "4", "shown": str(shown), "facets": str(facets)})
        self.assertIn("2 of 4 cells shown", self.text)

    def test_without_webgl_it_says_so(self):
        self.assertEqual(self.drawn(flags=["--disable-3d-apis"]), {"hexatlas": "failed"})
        self.assertIn("WebGL 2, which this browser does not offer", self.text)

    def test_pictures(self):
        for options, size in ((("--size", "500x300"), (500, 300)),
                              (("--size", "320x240", "--colour", "none", "--slice", "x=0.5"), (320, 240))):
            with tempfile.TemporaryDirectory(prefix="a # b%") as temporary:
                ran = self.expect(0, self.hexatlas("view", "grid.vtk", "--png", "picture.png", *options,
                                                   env={"TMPDIR": temporary, "CHROMIUM": CHROMIUM}))
                self.assertEqual(os.listdir(temporary), [])
            self.assertIn("picture.png: 64 hexahedra", ran.out)
            width, height, rows = pixels(self.read("picture.png"))
            self.assertEqual((width, height), size)
            colours = {colour for row in rows for colour in row}
            self.assertGreater(len(colours), 50)
            white = sum(colour == b"\xff\xff\xff" for row in rows for colour in row)
            self.assertLess(white, 0.85 * width * height)  # the mesh fills much of it
            self.assertGreater(white, 0.1 * width * height)
            self.assertEqual({row[-1] for row in rows}, {b"\xff\xff\xff"})  # and is not cut off


if __name__ == "__main__":
    program.main()
