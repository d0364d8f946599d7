#!/usr/bin/env python3
"""Claim. `--report` of `mesh hex`, `mesh boundary` and `mesh untangle` writes one page that is well-formed as HTML and
as XML, needs nothing else, and has the same bytes for the same input but for the line of the seconds. Its numbers are
those of `--json`, of the mesh written and of its sectors; its bars have the heights of these numbers; names of files
are escaped. A report that is the input or the mesh, or cannot be written, is refused before anything is done.
Oracle. The parsers of Python; `--json`; hex_files.py and the counts of this file, on the mesh written; the file of the
sectors.
"""
import collections
import html.parser
import json
import os
import re
import unittest
import xml.etree.ElementTree

import hex_files
import program
import surfaces

PYRAMID = os.path.join(program.INPUTS, "schneiders-pyramid.obj")
SECTORS = os.path.join(program.REPOSITORY, "tables", "data", "linear-bound.hxs")
VOID = {"meta", "link", "br", "img", "hr", "input"}


class Balanced(html.parser.HTMLParser):
    """Of each tag, whether it is closed in its turn; all attributes."""

    def __init__(self, text):
        super().__init__()
        self.open, self.attributes = [], []
        self.feed(text)
        self.close()
        assert not self.open, self.open

    def handle_starttag(self, tag, attrs):
        self.attributes.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.attributes.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag


class Page:
    def __init__(self, text):
        self.html = Balanced(text)
        self.root = xml.etree.ElementTree.fromstring(text)
        self.account = {row.find("dt").text: row.find("dd").text
                        for part in self.all("dl") for row in part.findall("div")}
        self.headings = [heading.text for heading in self.all("h2")]
        self.charts = self.all("svg")
        self.paragraphs = [p.text for p in self.all("p")]

    def all(self, tag):
        return list(self.root.iter(tag))

    def tables(self, caption):
        """Of each table of this caption, rows of head, number and share."""
        return [[["".join(cell.itertext()) for cell in row] for row in table.find("tbody")]
                for table in self.all("table") if table.find("caption").text == caption]

    def counts(self, caption, place=0):
        return [int(row[1]) for row in self.tables(caption)[place]]


def share(part, whole):
    """In percent; what is not nothing, or not all, is not said to be."""
    percent = f"{100 * part / whole:.1f} %"
    if part > 0 and 100 * part / whole < 0.1:
        return "< 0.1 %"
    return "> 99.9 %" if part < whole and 100 * part / whole > 99.9 else percent


def interior_valences(hexahedra):
    """By the definition: VTK's corners, where i and i + 4 are above each other."""
    edges, facets, vertices = collections.Counter(), collections.Counter(), collections.Counter()
    sides = ((0, 1, 2, 3), (4, 5, 6, 7), *((i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i in range(4)))
    for cell in hexahedra:
        vertices.update(cell)
        facets.update(frozenset(cell[i] for i in side) for side in sides)
        edges.update({frozenset((cell[side[i]], cell[side[i - 1]])) for side in sides for i in range(4)})
    free = [facet for facet, times in facets.items() if times == 1]
    outer = {v for facet in free for v in facet}
    inner_edges = collections.Counter(times for edge, times in edges.items()
                                      if not any(edge <= facet for facet in free))
    inner_vertices = collections.Counter(times for v, times in vertices.items() if v not in outer)
    return sorted(inner_edges.items()), sorted(inner_vertices.items())


class Reports(program.ProgramTest):
    def page(self, name="page.html"):
        return Page(self.read(name).decode())

    def report(self, *arguments):
        """A page, and what --json says."""
        ran = self.expect(0, self.hexatlas("mesh", *arguments, "-o", "out.vtk", "--report", "page.html", "--json"))
        return self.page(), json.loads(ran.out)

    def expect_quality(self, page, said, place=0):
        self.assertEqual(page.counts("Scaled Jacobian", place), said["histogram"])
        valid, faulty, inverted, undecided = page.counts("Validity", place)
        self.assertEqual((valid, inverted), (said["valid"], said["inverted"]))
        self.assertEqual(valid + faulty + undecided, sum(said["histogram"]))
        for caption in ("Scaled Jacobian", "Validity"):
            for _, count, part in page.tables(caption)[place]:
                self.assertEqual(part, share(int(count), sum(said["histogram"])))
        words = f"minimum {said['min_scaled_jacobian']:.4f}, mean {said['mean_scaled_jacobian']:.4f}."
        self.assertIn("Scaled Jacobian: " + words, page.paragraphs)
        self.expect_bars(page.charts[place], said)

    def expect_bars(self, chart, said):
        """Their heights are as the numbers, on one base; the numbers stand above them."""
        bars, bottoms = collections.defaultdict(lambda: [0.0, 0.0]), collections.defaultdict(float)
        for bar in chart.findall("rect"):
            if bar.get("width") == "10":  # of the key
                continue
            at, height = int((float(bar.get("x")) - 66) / 64.4), float(bar.get("height"))
            bars[at][bar.get("class") == "inverted"] += height
            bottoms[at] = max(bottoms[at], float(bar.get("y")) + height)
        self.assertEqual({round(bottom, 1) for bottom in bottoms.values()}, {236.0})
        unit = 206 / max(said["histogram"])
        for at, count in enumerate(said["histogram"]):
            self.assertAlmostEqual(sum(bars[at]), unit * count, delta=0.02)
        self.assertAlmostEqual(bars[0][1], unit * said["inverted"], delta=0.02)
        written = [text.text for text in chart.findall("text") if text.get("class") == "count"]
        self.assertEqual(written, [str(count) for count in said["histogram"] if count])
        labels = [text.text for text in chart.findall("text") if text.get("class") == "label"]
        for word in ("scaled Jacobian", "hexahedra", "below 0.1", "0.1\u20130.2", "0.9\u20131"):
            self.assertIn(word, labels)
        self.assertEqual("inverted" in labels, said["inverted"] > 0)
        names = {part.get("id") for part in chart}
        self.assertLessEqual(set(chart.get("aria-labelledby").split()), names)

    def expect_valences(self, page):
        edges, vertices = interior_valences(hex_files.read_vtk(self.read("out.vtk").decode())[1])
        for caption, counted in (("Interior edges by valence", edges), ("Interior vertices", vertices)):
            rows = page.tables(caption)[0]
            whole = sum(count for _, count in counted)
            self.assertEqual(rows, [[str(around), str(count), share(count, whole)] for around, count in counted])
        singular = sum(count for valence, count in edges if valence != 4)
        self.assertIn(f"{singular} of {sum(count for _, count in edges)} interior edges are singular: "
                      "their valence is not 4.", page.paragraphs)


class OfSurfaces(Reports):
    def expect_account(self, page, said, **more):
        expected = {"surface": "schneiders-pyramid.obj", "quads": str(said["quads"]), "points": "18",
                    "hexahedra": str(said["hexahedra"]), "interior vertices": str(said["interior_vertices"]),
                    "hexahedra per quad": f"{said['hexahedra_per_quad']:.2f}", "mesh written": "out.vtk",
                    "seconds": f"{said['seconds']:.2f}", "verdict": "accepted",
                    "minimum scaled Jacobian": f"{said['min_scaled_jacobian']:.4f}",
                    "mean scaled Jacobian": f"{said['mean_scaled_jacobian']:.4f}",
                    "not proven valid": str(said["hexahedra"] - said["valid"]), **more}
        self.assertEqual({key: page.account.get(key) for key in expected}, expected)

    def test_from_the_table(self):
        page, said = self.report("hex", PYRAMID, "--effort", "0")
        self.expect_account(page, said, **{"method": "look-up in the table", "table entry": said["table_entry"],
                                           "ball": "proven by a shelling"})
        self.assertNotIn("proven bound", page.account)
        self.expect_quality(page, said)
        self.expect_valences(page)
        self.assertGreater(said["inverted"], 0)

    def test_by_the_construction(self):
        page, said = self.report("hex", PYRAMID, "--method", "construction", "--effort", "0")
        self.expect_account(page, said, **{"method": "linear construction by sectors",
                                           "proven bound": "25 hexahedra per quad: 400 here"})
        self.assertNotIn("table entry", page.account)
        self.expect_quality(page, said)
        self.expect_valences(page)
        with open(SECTORS, encoding="ascii") as file:
            sizes = [int(size) for size in re.findall(r"^sector (\d+)", file.read(), re.MULTILINE)]
        times = [int(re.fullmatch(r"used (\d+) times?", page.account[f"sector of {size} hexahedra"]).group(1))
                 for size in sizes]
        self.assertEqual(sum(times), said["quads"] // 2)
        self.assertEqual(sum(map(int.__mul__, times, sizes)), said["hexahedra"])

    def expect_peeled(self, page, said, method):
        expected = {"method": method, "hexahedra taken off": str(said["peeled"]),
                    "layers among them": str(said["layers"]), "quads of the rest": str(said["cavity_quads"]),
                    "the rest filled by": {"table": "the table", "layer": "one layer", "sectors": "sectors"}[said["cavity_filled_by"]]}
        self.assertEqual({key: page.account.get(key) for key in expected}, expected)
        self.assertNotIn("table entry", page.account)
        self.assertEqual("proven bound for the rest" in page.account, said["cavity_filled_by"] == "sectors")
        self.expect_quality(page, said)
        self.expect_valences(page)

    def test_by_zones(self):
        self.write("grid.obj", surfaces.obj(*surfaces.grid_cube(3)))
        page, said = self.report("hex", "grid.obj", "--effort", "0")
        self.expect_peeled(page, said, "peeling by zones")

    def test_by_flips(self):
        self.write("random.obj", surfaces.obj(*surfaces.random_surface(60, 1)))
        page, said = self.report("hex", "random.obj", "--effort", "0", "--method", "flips", "--layers", "1")
        self.expect_peeled(page, said, "peeling by flips")
        self.assertGreaterEqual(said["layers"], 1)

    def test_by_flips_and_sectors(self):
        self.write("trapezohedron.obj", surfaces.obj(*surfaces.trapezohedron(31)))
        page, said = self.report("hex", "trapezohedron.obj", "--effort", "0", "--method", "flips", "--layers", "1")
        self.expect_peeled(page, said, "peeling by flips")
        self.assertEqual(said["cavity_filled_by"], "sectors")
        used = {int(found.group(1)): int(times.split()[1]) for key, times in page.account.items()
                if (found := re.fullmatch(r"sector of (\d+) hexahedra", key))}
        self.assertEqual(sum(used.values()), said["cavity_quads"] // 2)
        self.assertEqual(sum(size * times for size, times in used.items()), said["hexahedra"] - said["peeled"])

    def test_one_of_many(self):
        self.write("grid.obj", surfaces.obj(*surfaces.grid_cube(8)))
        page, said = self.report("hex", "grid.obj", "--effort", "0", "--method", "construction")
        self.expect_quality(page, said)
        self.expect_valences(page)
        self.assertEqual(page.tables("Interior vertices")[0][-1][1:], ["1", "< 0.1 %"])  # the apex

    def test_one_hexahedron(self):
        self.write("cube.obj", surfaces.obj(*surfaces.cube()))
        page, said = self.report("hex", "cube.obj")
        self.expect_quality(page, said)
        self.assertEqual(page.tables("Interior edges by valence"), [])
        self.assertIn("No edge is interior.", page.paragraphs)

    def test_notes(self):
        points, quads = surfaces.cube()
        self.write("in.obj", surfaces.obj([("9", "9", "9")] + points,
                                          [[v + 1 for v in (quad[::-1] if i == 2 else quad)]
                                           for i, quad in enumerate(quads)]))
        ran = self.expect(0, self.hexatlas("mesh", "hex", "in.obj", "-o", "out.vtk", "--report", "page.html"))
        notes = [row.find("dd").text for row in self.page().root.iter("div")
                 if row.find("dt") is not None and row.find("dt").text == "note"]
        self.assertEqual(len(notes), 2)
        self.assertEqual(ran.err, "".join(f"hexatlas: note: {note}\n" for note in notes))

    def test_written_all_the_same_if_not_valid(self):
        points, quads = surfaces.cube()
        self.write("in.obj", surfaces.obj([points[i] for i in (0, 1, 2, 3, 6, 7, 4, 5)], quads))
        self.expect(4, self.hexatlas("mesh", "hex", "in.obj", "-o", "out.vtk", "--report", "page.html",
                                     "--require-valid"))
        self.assertEqual(self.page().account["not proven valid"], "1")

    def test_no_mesh_no_page(self):
        self.write("in.obj", surfaces.obj(*surfaces.cube_with_cut_quad(1)))
        self.expect(1, self.hexatlas("mesh", "hex", "in.obj", "-o", "out.vtk", "--report", "page.html"))
        self.assertEqual(self.listing(), ["in.obj"])


class OfOthers(Reports):
    def test_boundary(self):
        page, said = self.report("boundary", "schneiders-pyramid", "--effort", "0")
        expected = {"boundary": "a convex polyhedron whose edges touch a sphere", "quads": "16",
                    "table entry": said["code"], "hexahedra": str(said["hexahedra"]), "verdict": "accepted",
                    "interior vertices": str(said["interior_vertices"]), "seconds": f"{said['seconds']:.2f}"}
        self.assertEqual({key: page.account.get(key) for key in expected}, expected)
        self.expect_quality(page, said)
        self.expect_valences(page)

    def test_untangle(self):
        self.expect(0, self.hexatlas("mesh", "hex", PYRAMID, "-o", "in.vtk", "--effort", "0"))
        page, said = self.report("untangle", "in.vtk", "--effort", "1")
        self.assertEqual(page.account["free vertices"], str(said["free_vertices"]))
        self.assertEqual(page.account["minimum scaled Jacobian"], f"{said['after']['min_scaled_jacobian']:.4f}")
        self.assertEqual(page.headings[2:4], ["Quality before", "Quality after"])
        for place, when in enumerate(("before", "after")):
            self.expect_quality(page, said[when], place)
        self.expect_valences(page)
        names = [part.get("id") for part in page.root.iter() if part.get("id")]
        self.assertEqual(len(names), len(set(names)))


class Manners(Reports):
    def test_nothing_is_fetched_or_run(self):
        page, _ = self.report("hex", PYRAMID, "--effort", "0")
        for tag, attributes in page.html.attributes:
            self.assertNotIn(tag, ("script", "link", "img", "iframe", "base", "object", "embed", "a"))
            self.assertFalse({"src", "href", "srcset", "action", "style"} & set(attributes), tag)
            self.assertFalse([name for name in attributes if name.startswith("on")], tag)
        self.assertNotRegex(self.read("page.html").decode(), r"https?:|@import|url\(")
        policies = [a["content"] for t, a in page.html.attributes if t == "meta" and "http-equiv" in a]
        self.assertEqual(policies, ["default-src 'none'; style-src 'unsafe-inline'"])
        self.assertIn("prefers-color-scheme: dark", self.read("page.html").decode())

    def test_same_bytes_but_for_the_seconds(self):
        once, again = (re.sub(rb"\n[^\n]*<dt>seconds</dt>[^\n]*\n", b"\n", self.read("page.html"))
                       for _ in range(2) if self.report("hex", PYRAMID))
        self.assertEqual(once, again)
        self.assertLess(len(once), len(self.read("page.html")))

    def test_names_are_escaped(self):
        text = surfaces.obj(*surfaces.cube())
        for given, shown in (("<b>&\"'x.obj", None), ("&lt;.obj", None), ("</title><script>.obj", None),
                             ("\u00fcn\u00ef\u4e2d.obj", None), ("line\nfeed\x01.obj", "line\ufffdfeed\ufffd.obj"),
                             (os.fsdecode(b"byte\xff.obj"), "byte\ufffd.obj")):
            with self.subTest(name=given):
                given, shown = given.replace("/", "-"), (shown or given).replace("/", "-")
                self.write(given, text)
                page, _ = self.report("hex", given)
                self.assertEqual(page.account["surface"], shown)
                self.assertEqual(page.all("h1")[0].text, shown)
                self.assertEqual(page.all("title")[0].text, shown + ": hexahedral mesh")
                self.assertFalse([tag for tag, _ in page.html.attributes if tag in ("b", "script")])

    def test_standard_streams(self):
        with open(PYRAMID, "rb") as file:
            text = file.read()
        ran = self.expect(0, self.hexatlas("mesh", "hex", "-", "-o", "out.vtk", "--report", "-", "--effort", "0",
                                           stdin=text))
        self.assertEqual(Page(ran.out).account["surface"], "standard input")
        self.assertIn("36 hexahedra", ran.err)
        ran = self.expect(0, self.hexatlas("mesh", "hex", PYRAMID, "-o", "-", "--report", "page.html", "--effort", "0"))
        self.assertEqual(ran.out.encode(), self.read("out.vtk"))
        self.assertEqual(self.page().account["mesh written"], "standard output")


class Refusals(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("in.vtk", surfaces.vtk(*surfaces.cube()))
        self.expect(0, self.hexatlas("mesh", "hex", "in.vtk", "-o", "mesh.vtk"))
        self.write("out.vtk", "as it was\n")
        os.symlink("out.vtk", self.path("symbolic.vtk"))
        os.link(self.path("out.vtk"), self.path("hard.vtk"))
        os.mkdir(self.path("folder"))
        self.verbs = (("hex", "in.vtk"), ("boundary", "in.vtk"), ("untangle", "mesh.vtk"))
        self.before = [(name, self.read(name)) for name in self.listing() if name != "folder"]

    def expect_untouched(self):
        self.assertEqual([(name, self.read(name)) for name in self.listing() if name != "folder"], self.before)
        self.assertEqual(os.listdir(self.path("folder")), [])

    def test_the_report_is_no_other_file(self):
        for verb, given in self.verbs:
            pairs = [("out.vtk", "./" + given), ("new.vtk", given), ("-", "-"), (given, "page.html")]
            pairs += [("out.vtk", name) for name in ("out.vtk", "./out.vtk", "symbolic.vtk", "hard.vtk")]
            pairs += [("new.vtk", name) for name in ("new.vtk", "folder/../new.vtk", self.path("new.vtk"))]
            for output, report in pairs:
                with self.subTest(verb=verb, output=output, report=report):
                    ran = self.expect(2, self.hexatlas("mesh", verb, given, "-o", output, "--report", report))
                    self.assertEqual(ran.out, "")
                    self.assertRegex(ran.err, r"\Ahexatlas: [A-Z]* ?[^\n]*--(report|output) are the same file\. "
                                              rf"See `hexatlas mesh {verb} --help`\.\n\Z")
                    self.expect_untouched()

    def test_an_output_that_cannot_be_written_is_told_before_all_work(self):
        os.symlink("nothing", self.path("folder/link"))
        for verb, _ in self.verbs:
            for output, report, named in (("new.vtk", "none/page.html", "none/page.html"),
                                          ("new.vtk", "folder", "folder"), ("new.vtk", "folder/link", "folder/link"),
                                          ("none/new.vtk", "page.html", "none/new.vtk"),
                                          ("new.stl", "page.html", "new.stl")):
                with self.subTest(verb=verb, output=output, report=report):
                    ran = self.hexatlas("mesh", verb, "missing.vtk", "-o", output, "--report", report)
                    self.assertEqual(program.ProgramTest.expect_fault(self, ran, named), 0)
        os.remove(self.path("folder/link"))
        self.expect_untouched()

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_that_is_not_writable(self):
        os.chmod(self.path("folder"), 0o555)
        self.expect_fault(self.hexatlas("mesh", "hex", "in.vtk", "-o", "new.vtk", "--report", "folder/page.html"),
                          "folder/page.html")
        self.expect_untouched()


if __name__ == "__main__":
    program.main()
