#!/usr/bin/env python3
"""Claim. `mesh delaunay` triangulates whatever finite points it is given, the same for any number of
threads and any order of the points; the independent judge accepts each of its meshes, in each format,
for exactly these points. Degenerate sets are exit 1, said plainly; what is no set of points is exit 3.
Oracle. `check --delaunay --points`; sets with a known number of tetrahedra.
"""
import json
import math
import random
import struct

import program

CHANCE = random.Random(20261122)


def binary(points):
    return b"".join(struct.pack("<3d", *p) for p in points)


def uniform(count):
    return [tuple(CHANCE.random() for _ in range(3)) for _ in range(count)]


def grid(side, step=1.0):
    return [(i * step, j * step, k * step)
            for i in range(side) for j in range(side) for k in range(side)]


def sphere(count):
    points = []
    while len(points) < count:
        x, y, z = (CHANCE.gauss(0, 1) for _ in range(3))
        size = math.sqrt(x * x + y * y + z * z)
        points.append((x / size, y / size, z / size))
    return points


def clusters(count):
    centres = uniform(20)
    return [tuple(c + 1e-7 * CHANCE.random() for c in centres[i % 20]) for i in range(count)]


def on_paraboloid(count):
    return [(x, y, x * x + y * y) for x, y, _ in uniform(count)]


def on_helix(count):
    return [(math.cos(t), math.sin(t), t / 10) for t in (i / 50 for i in range(count))]


def with_duplicates(count):
    points = uniform(count)
    return points + [CHANCE.choice(points) for _ in range(count // 9)]


def of_all_sizes(count):
    return [tuple(CHANCE.choice((-1, 1)) * 10.0 ** CHANCE.uniform(-300, 300) for _ in range(3))
            for _ in range(count)]


class MeshDelaunayTest(program.ProgramTest):
    def meshed(self, points, *more, output="out.hxtet"):
        self.write("points.bin", binary(points))
        ran = self.expect(0, self.hexatlas("mesh", "delaunay", "points.bin", "-o", output, "--json",
                                           *more))
        return json.loads(ran.out)

    def judged(self, mesh="out.hxtet"):
        ran = self.hexatlas("check", "--delaunay", mesh, "--points", "points.bin")
        self.expect(0, ran)
        self.assertIn("accepted", ran.out)

    def test_every_kind_of_input_is_meshed_and_accepted(self):
        for name, points in program.share_of((
                ("uniform", uniform(5000 if program.SANITIZED else 20000)), ("clusters", clusters(5000)),
                ("sphere", sphere(3000)), ("paraboloid", on_paraboloid(3000)), ("duplicates", with_duplicates(3000)),
                ("grid", grid(10 if program.SANITIZED else 20)), ("grid of tenths", grid(12, 0.1)),
                ("helix", on_helix(300)), ("all sizes", of_all_sizes(300)),
                ("smallest", [tuple(5e-324 * x for x in p) for p in grid(4)]),
                ("largest", [tuple(1e307 * x - 1e307 for x in p) for p in grid(4)]),
                ("plane and a point", [(x, y, 0.0) for x, y, _ in grid(6)] + [(1.0, 1.0, 1.0)]),
                ("four", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])), least=6):
            with self.subTest(kind=name):
                account = self.meshed(points)
                self.assertEqual(account["points"], len(points))
                self.assertEqual(account["duplicates"], len(points) - len(set(points)))
                self.judged()

    def test_weights(self):
        half = uniform(3000)
        all_but_four = [p + (0.0,) for p in half] + [
            (-9.0, -9.0, -9.0, 1e6), (99.0, -9.0, -9.0, 1e6), (-9.0, 99.0, -9.0, 1e6), (-9.0, -9.0, 99.0, 1e6)]
        for name, points in program.share_of((
                ("random", [p + (0.01 * CHANCE.random(),) for p in uniform(5000 if program.SANITIZED else 20000)]),
                ("few heavy", [p + (CHANCE.random() < 0.01,) for p in uniform(3000)]),
                ("none hidden", [p + (-3.5,) for p in half]),
                ("negative", [p + (-CHANCE.random(),) for p in half]),
                ("lattice", [p + (float(CHANCE.randrange(3)),) for p in grid(15)]),
                ("flat", [p + (p[0] ** 2 + p[1] ** 2 + p[2] ** 2,) for p in grid(8)]),
                ("nearly flat", [p + (p[0] ** 2 + p[1] ** 2 + p[2] ** 2,) for p in grid(8, 0.1)]),
                ("same places", [p + (float(CHANCE.randrange(3)),) for p in grid(9) + grid(9)]),
                ("all sizes", [p + (10.0 ** CHANCE.uniform(-300, 300),) for p in of_all_sizes(200)]),
                ("all but four", all_but_four)), first=1, least=5):
            with self.subTest(kind=name):
                self.write("points.bin", b"".join(struct.pack("<4d", *p) for p in points))
                meshes = []
                for threads in ("1", "3"):
                    ran = self.expect(0, self.hexatlas("mesh", "delaunay", "points.bin", "--weights", "-j", threads,
                                                       "-o", "out.hxtet", "--json"))
                    meshes.append(self.read("out.hxtet"))
                self.assertEqual(meshes[0], meshes[1])
                account = json.loads(ran.out)
                judged = json.loads(self.expect(0, self.hexatlas(
                    "check", "--delaunay", "out.hxtet", "--points", "points.bin", "--weights", "--json")).out)
                for key in ("points", "duplicates", "hidden", "tetrahedra"):
                    self.assertEqual(judged[key], account[key])
                if name == "none hidden":
                    self.meshed(half)
                    self.assertEqual(self.read("out.hxtet"), meshes[0])
                if name == "all but four":
                    self.assertEqual((account["hidden"], account["tetrahedra"]), (3000, 1))
        text = "".join("%r %r %r %r\n" % p for p in all_but_four)
        self.write("points.xyz", text)
        ran = self.expect(0, self.hexatlas("mesh", "delaunay", "points.xyz", "--weights"))
        self.assertIn("counted: 1 tetrahedron of 3004 points, 0 duplicates, 3000 hidden", ran.out)

    def test_what_has_no_weights(self):
        self.write("points.xyz", "0 0 0 1\n1 0 0\n")
        ran = self.expect(3, self.hexatlas("mesh", "delaunay", "points.xyz", "--weights"))
        self.assertIn("points.xyz:2: ", ran.err)
        self.assertIn("x y z weight", ran.err)
        self.write("points.xyz", "0 0 0 1\n1 0 0 inf\n")
        self.expect(3, self.hexatlas("mesh", "delaunay", "points.xyz", "--weights"))
        self.write("points.bin", binary([(1, 2, 3)] * 3))
        ran = self.expect(3, self.hexatlas("mesh", "delaunay", "points.bin", "--weights"))
        self.assertIn("32", ran.err)
        self.write("points.bin", struct.pack("<4d", 1, 2, 3, float("nan")))
        ran = self.expect(3, self.hexatlas("mesh", "delaunay", "points.bin", "--weights"))
        self.assertIn("weight", ran.err)
        self.write("points.obj", "v 0 0 0 1\n")
        ran = self.expect(3, self.hexatlas("mesh", "delaunay", "points.obj", "--weights"))
        self.assertIn("(known: .xyz .bin)", ran.err)

    def test_a_lattice_has_six_tetrahedra_in_each_cube(self):
        self.assertEqual(self.meshed(grid(50))["tetrahedra"], 6 * 49 ** 3)

    def test_a_tetrahedron_for_each_pair_of_edges_of_two_skew_lines(self):
        points = [(float(i), 0.0, 0.0) for i in range(100)] + [(0.0, float(i), 1.0) for i in range(80)]
        self.assertEqual(self.meshed(points)["tetrahedra"], 99 * 79)

    def test_threads_and_order_do_not_matter(self):
        points = uniform(10000 if program.SANITIZED else 30000) + [(p[0] / 19, p[1] / 19, p[2] / 19) for p in grid(20)]
        account = self.meshed(points, "-j", "1")
        self.assertEqual(account["threads"], 1)
        one = self.read("out.hxtet")
        for threads in ("2", "3"):
            self.meshed(points, "-j", threads)
            self.assertEqual(self.read("out.hxtet"), one)
        numbers = list(range(len(points)))
        CHANCE.shuffle(numbers)
        self.meshed([points[i] for i in numbers])
        self.assertEqual(self.placed_cells(self.read("out.hxtet")), self.placed_cells(one))

    @staticmethod
    def placed_cells(content):
        points, cells = struct.unpack_from("<2Q", content, 8)
        place = [struct.unpack_from("<3d", content, 24 + 24 * i) for i in range(points)]
        start = 24 + 24 * points
        return {frozenset(place[v] for v in struct.unpack_from("<4I", content, start + 16 * i))
                for i in range(cells)}

    def test_each_format_is_accepted(self):
        points = uniform(200)
        for name in ("out.vtk", "out.vtu", "out.mesh", "out.msh", "out.hxtet"):
            with self.subTest(file=name):
                self.meshed(points, output=name)
                self.judged(name)

    def test_points_of_any_file(self):
        text = "".join("%r %r %r\n" % p for p in grid(3))
        self.write("points.xyz", "# a lattice\n" + text)
        self.write("points.obj", "".join("v " + line + "\n" for line in text.splitlines()))
        self.write("points.ply", "ply\nformat ascii 1.0\nelement vertex 27\nproperty double x\n"
                                 "property double y\nproperty double z\nend_header\n" + text)
        for name in ("points.xyz", "points.obj", "points.ply"):
            ran = self.expect(0, self.hexatlas("mesh", "delaunay", name, "--json"))
            self.assertEqual(json.loads(ran.out)["tetrahedra"], 48)

    def test_degenerate_sets_are_said_plainly(self):
        for points, words in (([], "there are no points"), ([(1, 2, 3)], "the only point is at one place"),
                              ([(1, 2, 3)] * 1000, "all points are at one place"),
                              ([(0, 0, 0), (1, 1, 1)], "all points are on a line"),
                              ([(i / 10, i / 10, i / 10) for i in range(50)], "all points are on a line"),
                              ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], "all points are in a plane"),
                              ([(x, y, x + y) for x, y, _ in grid(10)], "all points are in a plane")):
            with self.subTest(words=words):
                self.write("points.bin", binary(points))
                ran = self.expect(1, self.hexatlas("mesh", "delaunay", "points.bin", "-o", "out.vtu"))
                self.assertIn(words, ran.err)
                self.assertEqual(self.listing(), ["points.bin"])

    def test_what_is_no_set_of_points(self):
        self.write("points.xyz", "0 0 0\n1 nan 0\n")
        ran = self.expect(3, self.hexatlas("mesh", "delaunay", "points.xyz", "-o", "out.vtu"))
        self.assertIn("points.xyz:2: ", ran.err)
        self.write("cut.bin", b"\0" * 25)
        self.expect(3, self.hexatlas("mesh", "delaunay", "cut.bin"))
        self.expect(3, self.hexatlas("mesh", "delaunay", "missing.xyz"))

    def test_more_points_than_there_is_room_for_are_refused_at_once(self):
        with open(self.path("many.bin"), "wb") as file:
            file.truncate(24 * 2 ** 31)  # one point, 2^31 times, in a file without blocks
        self.expect(3, self.hexatlas("mesh", "delaunay", "many.bin"))
        self.write("many.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 2147483648\n"
                               "property double x\nproperty double y\nproperty double z\nend_header\n")
        self.expect(3, self.hexatlas("mesh", "delaunay", "many.ply"))

    def test_the_output_is_not_the_input(self):
        self.write("points.vtk", "")
        self.expect(2, self.hexatlas("mesh", "delaunay", "points.vtk", "-o", "points.vtk"))


if __name__ == "__main__":
    program.main()
