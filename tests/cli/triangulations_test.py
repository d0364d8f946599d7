#!/usr/bin/env python3
"""Claim. `enum` counts and writes triangulations, spheres, balls and polyhedra; `realize` answers with
certificates; `check` judges them; limited runs and a stopped `reproduce` claim nothing; bad
input is refused in one line.
Oracle. The numbers of the literature; docs/formats/catalogue.md, read again here; determinants of Python
integers; every subset of tetrahedra of the prism.
"""
import hashlib
import itertools
import json
import os
import signal
import subprocess

import program
import surfaces

HEXAHEDRON = {"5": 1, "6": 5, "7": 5, "8": 7, "9": 13, "10": 20, "11": 35, "12": 30, "13": 28,
              "14": 19, "15": 11}
PRISM = [[0, 2, 1], [3, 4, 5], [0, 1, 4, 3], [1, 2, 5, 4], [0, 3, 5, 2]]
PRISM_POINTS = [("0", "0", "0"), ("1", "0", "0"), ("0", "1", "0"), ("0", "0", "1"), ("1", "0", "1"),
                ("0", "1", "1")]


def is_shellable(tetrahedra, done=()):
    if len(done) == len(tetrahedra):
        return True
    for t in tetrahedra:
        if t in done:
            continue
        if done:
            faces = lambda s: {frozenset(f) for n in (1, 2, 3) for f in itertools.combinations(s, n)}
            common = faces(t) & set().union(*(faces(s) for s in done))
            triangles = [f for f in common if len(f) == 3]
            if not triangles or set().union(*(faces(f) for f in triangles)) != common:
                continue
        if is_shellable(tetrahedra, (*done, t)):
            return True
    return False


def prism_triangulations():
    """All of them: each triangle in one or two tetrahedra, those in one being the ends and the quads cut
    by a diagonal each, and a ball because there is a shelling (each ball on six vertices has one)."""
    quads = [frozenset(q) for q in PRISM if len(q) == 4]
    candidates = [frozenset(t) for t in itertools.combinations(range(6), 4)
                  if frozenset(t) not in quads]
    ends = [frozenset(t) for t in PRISM if len(t) == 3]
    boundaries = set()
    for cuts in itertools.product((0, 1), repeat=3):
        triangles = list(ends)
        for cut, q in zip(cuts, [q for q in PRISM if len(q) == 4]):
            triangles += [frozenset(q[(cut + i) % 4] for i in (0, 1, 2)),
                          frozenset(q[(cut + i) % 4] for i in (2, 3, 4))]
        boundaries.add(frozenset(triangles))
    found = set()
    for size in range(1, 8):
        for chosen in itertools.combinations(candidates, size):
            count = {}
            for t in chosen:
                for v in t:
                    count[t - {v}] = count.get(t - {v}, 0) + 1
            if max(count.values()) > 2:
                continue
            if frozenset(t for t, n in count.items() if n == 1) in boundaries and is_shellable(chosen):
                found.add(frozenset(chosen))
    return found


def determinant(points, a, b, c, d):
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (
        [points[v][i] - points[a][i] for i in range(3)] for v in (b, c, d))
    return ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)


def signed(text):
    """The lines before the last with the digest that belongs to them."""
    body = "".join(line + "\n" for line in text.splitlines() if not line.startswith("end "))
    return body + "end " + hashlib.sha256(body.encode()).hexdigest() + "\n"


class TriangulationsTest(program.ProgramTest):
    def counts(self, *arguments, code=0):
        ran = self.expect(code, self.hexatlas("enum", "triangulations", *arguments, "--json"))
        return json.loads(ran.out)

    def test_hexahedron(self):
        said = self.counts("hexahedron")
        self.assertEqual(list(said)[:5],
                         ["cell", "interior", "classes", "labelled", "by_tetrahedra"])
        self.assertEqual((said["cell"], said["interior"], said["classes"]), ("hexahedron", 0, 174))
        self.assertTrue(said["exhaustive"])
        self.assertEqual({n: c["classes"] for n, c in said["by_tetrahedra"].items()}, HEXAHEDRON)
        self.assertEqual(sum(c["labelled"] for c in said["by_tetrahedra"].values()),
                         said["labelled"])
        more = self.counts("hexahedron", "--boundary-tetrahedra", "--count")
        self.assertGreater(more["classes"], said["classes"])

    def test_other_cells(self):
        for cell, interior, classes in (("tetrahedron", 1, 1), ("pyramid", 0, 1), ("pyramid", 1, 4),
                                        ("prism", 0, 2), ("prism", 1, 32), ("octahedron", 1, 10)):
            said = self.counts(cell, "--interior", str(interior))
            self.assertEqual(said["classes"], classes, cell)
        self.assertEqual(self.counts("prism")["labelled"], len(prism_triangulations()))

    def test_a_surface_file_is_a_cell(self):
        for name, points, facets in (("prism.obj", PRISM_POINTS, PRISM),
                                     ("turned.off", PRISM_POINTS, [f[::-1] for f in PRISM])):
            text = surfaces.obj(points, facets) if name.endswith("obj") else (
                f"OFF\n{len(points)} {len(facets)} 0\n"
                + "".join(" ".join(p) + "\n" for p in points)
                + "".join(f"{len(f)} " + " ".join(map(str, f)) + "\n" for f in facets))
            self.write(name, text)
            said = self.counts(name)
            self.assertEqual((said["classes"], said["labelled"]), (2, 12))

    def test_catalogue_is_as_documented_and_the_same_for_any_threads(self):
        files = []
        for threads in ("1", "2"):
            name = f"prism{threads}.hxc"
            self.expect(0, self.hexatlas("enum", "triangulations", "prism", "-o", name, "-j",
                                         threads))
            files.append(self.read(name).decode())
        self.assertEqual(files[0], files[1])
        self.assertEqual(files[0], signed(files[0]))
        lines = files[0].splitlines()
        self.assertEqual(lines[0], "hexatlas catalogue 1")
        found = set()
        for line in lines:
            if line.startswith("class "):
                found.add(frozenset(frozenset(map(int, t)) for t in line.split()[3:]))
        self.assertEqual(len(found), 2)
        self.assertLessEqual(found, prism_triangulations())
        self.expect(0, self.hexatlas("check", "prism1.hxc"))
        out = self.expect(0, self.hexatlas("enum", "triangulations", "prism", "-o", "-"))
        self.assertEqual(out.out, files[0])

    def test_a_file_named_like_a_cell_is_not_that_cell(self):
        points, quads = surfaces.cube()  # a cube, but not in our numbering
        self.write("hexahedron.obj", surfaces.obj(points, quads))
        self.expect(0, self.hexatlas("enum", "triangulations", "hexahedron.obj", "-o", "a.hxc"))
        self.expect(0, self.hexatlas("check", "a.hxc"))
        self.expect_fault(self.hexatlas("realize", "a.hxc", "--jacobian"), "a.hxc")
        self.expect_fault(self.hexatlas("enum", "triangulations", "hexahedron.obj",
                                        "--completeness", "a.hxl"), "hexahedron.obj")

    def test_a_limited_run_claims_nothing(self):
        said = self.counts("hexahedron", "--max-nodes", "500", code=4)
        self.assertFalse(said["exhaustive"])
        self.assertLess(said["classes"], 174)
        self.assertLessEqual(said["nodes"], 500)
        ran = self.hexatlas("enum", "triangulations", "hexahedron", "--max-nodes", "500", "-o",
                            "part.hxc")
        self.expect(4, ran)
        self.assertIn("at least", ran.out)
        self.assertIn("\nexhaustive no\n", self.read("part.hxc").decode())
        self.expect(0, self.hexatlas("check", "part.hxc"))

    def test_the_second_road(self):
        for cell, interior in (("hexahedron", 0), ("prism", 1), ("octahedron", 1), ("pyramid", 2)):
            first = self.counts(cell, "--interior", str(interior))
            second = self.counts(cell, "--interior", str(interior), "--through-spheres", code=4)
            for key in ("classes", "labelled", "by_tetrahedra"):
                self.assertEqual(second[key], first[key], cell)
            self.assertFalse(second["exhaustive"])
        self.expect_fault(self.hexatlas("enum", "triangulations", "hexahedron", "--interior", "2",
                                        "--through-spheres"), "hexahedron")

    def test_completeness_of_the_174(self):
        self.expect(0, self.hexatlas("enum", "triangulations", "hexahedron", "-o", "h.hxc",
                                     "--completeness", "h.hxl"))
        self.expect(0, self.hexatlas("check", "h.hxc", "--completeness", "h.hxl"))
        lines = self.read("h.hxc").decode().splitlines(keepends=True)
        last = next(i for i, line in enumerate(lines) if line.startswith("class 174 "))
        size = 48 // int(lines[last].split()[2])
        del lines[last]
        text = "".join(lines).replace("classes 174", "classes 173")
        self.write("less.hxc", signed(text.replace("labelled 6966", f"labelled {6966 - size}")))
        self.expect(0, self.hexatlas("check", "less.hxc"))
        self.expect(1, self.hexatlas("check", "less.hxc", "--completeness", "h.hxl"))
        self.expect_fault(self.hexatlas("enum", "triangulations", "prism", "--completeness", "x"),
                          "prism")

    def test_bad_surfaces(self):
        cube_points, cube_quads = surfaces.cube()
        torus = surfaces.grid_closed_up(3, 3, False)
        cases = {"open.obj": (cube_points, cube_quads[:-1]),
                 "twice.obj": (cube_points, cube_quads + cube_quads[:1]),
                 "large.obj": surfaces.grid_cube(2),
                 "torus.obj": torus,
                 "repeated.obj": (cube_points, [[0, 0, 1, 2]] + cube_quads[1:])}
        for name, (points, facets) in cases.items():
            self.write(name, surfaces.obj(points, facets))
            self.expect_fault(self.hexatlas("enum", "triangulations", name), name)
        self.write("pentagon.obj", surfaces.obj(PRISM_POINTS, [[0, 1, 2, 3, 4]] + PRISM))
        self.expect_fault(self.hexatlas("enum", "triangulations", "pentagon.obj"), "pentagon.obj")
        self.expect_fault(self.hexatlas("enum", "triangulations", "cuboid"), "cuboid")
        self.expect_fault(self.hexatlas("enum", "triangulations", "nothing.obj"), "nothing.obj")
        self.expect(2, self.hexatlas("enum", "triangulations", "prism", "--interior", "-1"))
        self.expect(2, self.hexatlas("enum", "triangulations", "prism", "--count", "-o", "x.hxc"))
        self.assertEqual([f for f in self.listing() if f.endswith("hxc")], [])

    def test_spheres_balls_polyhedra(self):
        for vertices, spheres in ((5, 1), (6, 2), (7, 5), (8, 39)):
            said = json.loads(self.expect(0, self.hexatlas(
                "enum", "spheres", "--vertices", str(vertices), "--json")).out)
            self.assertEqual(said["spheres"], spheres)
        for vertices, number in ((4, 1), (5, 3), (6, 12), (7, 167)):
            said = json.loads(self.expect(0, self.hexatlas(
                "enum", "balls", "--vertices", str(vertices), "--json", "-o", "balls.hxc")).out)
            self.assertEqual(said["balls"], number)
            self.expect(0, self.hexatlas("check", "balls.hxc"))
        for vertices, number in ((4, 1), (5, 2), (6, 6), (7, 28)):
            said = json.loads(self.expect(0, self.hexatlas(
                "enum", "polyhedra", "--vertices", str(vertices), "--json")).out)
            self.assertEqual(len(said["polyhedra"]), number)
        self.expect(2, self.hexatlas("enum", "spheres", "--vertices", "11"))
        balls = self.expect(0, self.hexatlas("enum", "balls", "--vertices", "5", "-o", "balls.hxc"))
        for more, said in (((), balls.out), (("--json",), '"balls":3')):
            ran = self.expect(0, self.hexatlas("enum", "balls", "--vertices", "5", "-o", "-", *more))
            self.assertEqual(ran.out.encode(errors="surrogateescape"), self.read("balls.hxc"))
            self.assertIn(said, ran.err)


class ReproduceTest(program.ProgramTest):
    def test_a_stop_is_no_refutation(self):
        os.mkdir(self.path("out"))
        good = self.write("out/hexahedron.hxc", b"what was there")
        for stop in (signal.SIGINT, signal.SIGTERM):
            with subprocess.Popen([program.PROGRAM, "reproduce", "hexahedron-174", "-o", "out"], cwd=self.folder,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
                program.wait_for_handler(running, stop)
                running.send_signal(stop)
                out, err = running.communicate(timeout=300)
            self.assertEqual(running.returncode, 4, out)
            self.assertNotIn(b"FAIL", out)
            self.assertTrue(err.endswith(b"hexatlas: stopped; whether hexahedron-174 is reproduced is open, and nothing is "
                                         b"written\n"), err)
            self.assertEqual(os.listdir(self.path("out")), ["hexahedron.hxc"])
            self.assertEqual(self.read(good), b"what was there")


class RealizeTest(program.ProgramTest):
    def test_coordinates_are_those_of_the_class(self):
        said = json.loads(self.expect(0, self.hexatlas("realize", "prism", "-o", "prism.hxc",
                                                       "--json")).out)
        self.assertEqual({k: said[k] for k in ("classes", "realizable", "refuted", "open")},
                         {"classes": 2, "realizable": 2, "refuted": 0, "open": 0})
        self.expect(0, self.hexatlas("check", "prism.hxc"))
        tetrahedra = []
        for line in self.read("prism.hxc").decode().splitlines():
            words = line.split()
            if words[0] == "class":
                tetrahedra = [tuple(map(int, t)) for t in words[3:]]
            if words[:2] == ["embedded", "points"]:
                flat = list(map(int, words[2:]))
                points = [flat[i:i + 3] for i in range(0, len(flat), 3)]
                self.assertEqual(len(points), 6)
                for t in tetrahedra:
                    self.assertNotEqual(determinant(points, *t), 0)

    def test_a_false_catalogue_is_refused(self):
        self.expect(0, self.hexatlas("enum", "triangulations", "pyramid", "-o", "a.hxc"))
        text = self.read("a.hxc").decode()
        for old, new in (("\nend ", "\nembedded refuted\nqed\nend "),
                         ("\nend ", "\nembedded points " + " ".join(["0"] * 15) + "\nend "),
                         ("symmetries 8", "symmetries 9"),
                         ("\nend ", "\nclass 2 4 0124 0234\nend ")):
            self.assertIn(old, text)
            self.write("false.hxc", signed(text.replace(old, new)))
            self.expect_fault(self.hexatlas("realize", "false.hxc"), "false.hxc")

    def test_answers_that_are_not_judged_are_no_answers(self):
        """A ring of four prisms is no ball, which the judge does not find out: what is said of it may be false."""
        self.hexatlas("enum", "triangulations", "pyramid", "-o", "a.hxc")
        head = self.read("a.hxc").decode().splitlines()[:2]
        ring = []
        for i in range(4):
            a, b = [3 * i + k for k in range(3)], [(3 * i + 3 + k) % 12 for k in range(3)]
            ring += [(a[0], a[1], a[2], b[2]), (a[0], a[1], b[1], b[2]), (a[0], b[0], b[1], b[2])]
        words = ["".join(f"{v:x}" for v in sorted(t)) for t in sorted(ring, key=lambda t: sum(1 << v for v in t))]
        for answer in ("points " + " ".join(["1"] * 36), "refuted\nqed"):
            lines = [*head, "kind balls", "name ring", "vertices 12", "interior 0", "classes 1", "exhaustive no",
                     "class 1 7 unshelled " + " ".join(words), "embedded " + answer, "end "]
            self.write("ring.hxc", signed("\n".join(lines)))
            self.assertIn("undecided", self.expect(4, self.hexatlas("check", "ring.hxc")).out)
            ran = self.expect(4, self.hexatlas("realize", "ring.hxc", "-o", "more.hxc"))
            self.assertIn("ring.hxc: undecided: ", ran.err)
            self.assertEqual(ran.out, "")
        self.assertNotIn("more.hxc", self.listing())

    def test_one_class(self):
        ran = self.expect(0, self.hexatlas("realize", "hexahedron:1", "--jacobian", "--json"))
        self.assertEqual(json.loads(ran.out)["realizable"], 1)
        self.expect_fault(self.hexatlas("realize", "hexahedron:175"), "hexahedron:175")
        self.expect_fault(self.hexatlas("realize", "prism", "--jacobian"), "prism")
        self.expect(2, self.hexatlas("realize", "prism", "--jacobian", "--convex"))

    def test_an_answer_of_no_comes_with_a_proof(self):
        # The last class has 15 tetrahedra; three such classes cannot be realized.
        self.expect(0, self.hexatlas("enum", "triangulations", "hexahedron", "-o", "all.hxc"))
        refuted = 0
        for number in range(164, 175):
            ran = self.hexatlas("realize", f"hexahedron:{number}", "-o", "one.hxc")
            if ran.code == 1:
                refuted += 1
                text = self.read("one.hxc").decode()
                self.assertIn("\nembedded refuted\n", text)
                self.expect(0, self.hexatlas("check", "one.hxc"))
                lines = text.splitlines(keepends=True)
                lemmas = [i for i, line in enumerate(lines) if line.startswith("l ")]
                del lines[lemmas[len(lemmas) // 2]]
                self.write("damaged.hxc", signed("".join(lines)))
                self.expect(1, self.hexatlas("check", "damaged.hxc"))
            else:
                self.expect(0, ran)
        self.assertEqual(refuted, 3)

    def test_the_jacobian_is_refuted_by_the_edge_lemma(self):
        """Signs alone leave this class open; a final polynomial with terms of edges decides it."""
        ran = self.expect(1, self.hexatlas("realize", "hexahedron:109", "--jacobian", "--json",
                                           "-o", "one.hxc"))
        self.assertEqual(json.loads(ran.out)["refuted"], 1)
        text = self.read("one.hxc").decode()
        found = [line for line in text.splitlines() if line.startswith("f ") and " e " in line]
        self.assertEqual(len(found), 1)
        self.expect(0, self.hexatlas("check", "one.hxc"))
        # An inequality turned round, or a weight changed, does not cancel any more.
        for damaged in (found[0][:-1] + ("2" if found[0][-1] == "1" else "1"), found[0] + " 1 0 0 6 1 1"):
            self.write("bad.hxc", signed(text.replace(found[0], damaged)))
            self.expect(1, self.hexatlas("check", "bad.hxc"))
        # The same proof proves nothing where no Jacobian is asked for.
        self.write("other.hxc", signed(text.replace("jacobian refuted", "embedded refuted")))
        self.assertIn(self.hexatlas("check", "other.hxc").code, (1, 3))

    def test_answers_of_a_catalogue_are_kept(self):
        self.expect(0, self.hexatlas("realize", "pyramid", "-o", "a.hxc"))
        self.expect(0, self.hexatlas("realize", "a.hxc", "--convex", "-o", "b.hxc", "-j", "1"))
        self.expect(0, self.hexatlas("realize", "a.hxc", "--convex", "-o", "c.hxc", "-j", "2"))
        self.assertEqual(self.read("b.hxc"), self.read("c.hxc"))
        text = self.read("b.hxc").decode()
        self.assertIn("embedded points", text)
        self.assertIn("convex points", text)
        self.write("wrong.hxc", text.replace("embedded points ", "embedded points 9", 1))
        self.expect_fault(self.hexatlas("realize", "wrong.hxc"), "wrong.hxc")


if __name__ == "__main__":
    program.main()
