#!/usr/bin/env python3
"""Claim. Where `mesh hex` runs out of memory, at whatever stage and with however many threads, it
exits with 5 and one line, and leaves neither output nor temporary file; with a little more, it
makes the mesh that it makes without limit. A file that may not get as large as it would leaves none, with exit code 5.
Oracle. The exit codes of docs/architecture/README.md; limits on the address space (RLIMIT_AS), from
one that the start of the program needs to one that is enough; limits on files (RLIMIT_FSIZE).
"""
import os
import random
import resource
import unittest

import program
import surfaces

MIB = 1 << 20


@unittest.skipIf(program.SANITIZED, "the OpenMP of that build keeps a file in memory that counts")
class LargeFiles(program.ProgramTest):
    """A limit on the size of files is an error of writing."""

    def test_a_file_that_gets_too_large(self):
        for words in (("table", "list", "-o", "out.tsv"),
                      ("table", "build", "-o", "out.hxt", "--max-quads", "6", "--width", "10")):
            ran = self.expect(5, self.hexatlas(*words, preexec_fn=lambda: resource.setrlimit(
                resource.RLIMIT_FSIZE, (16, 16))))
            self.assertRegex(ran.err, r"\Ahexatlas: [^\n]+\n\Z")
            self.assertEqual(self.listing(), [])


@unittest.skipIf(program.SANITIZED, "that build reserves terabytes of addresses")
class OutOfMemory(program.ProgramTest):
    def limited(self, mib, *arguments):
        return self.hexatlas(*arguments, preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_AS, (mib * MIB, mib * MIB)))

    def needed_to_start(self):
        for mib in range(32, 513, 4):
            if self.limited(mib, "--version").code == 0:
                return mib
        return self.fail("the program does not start within 512 MiB")

    def expect_end(self, mib, *options):
        """Whether the memory was enough."""
        ran = self.limited(mib, "mesh", "hex", "in.obj", "-o", "out.vtk", *options)
        if ran.code == 0:
            self.assertEqual(self.listing(), ["in.obj", "out.vtk"])
            os.remove(self.path("out.vtk"))
            return True
        with self.subTest(mib=mib, options=options):
            self.expect(5, ran)
            self.assertEqual(ran.out, "")
            self.assertRegex(ran.err, r"\Ahexatlas: ([^\n]+: )?[^\n:]*(out of|allocate) memory\n\Z")
            self.assertEqual(self.listing(), ["in.obj"])
        return False

    def test_large_surface(self):
        """20,184 quads: reading, laws, construction, places, judge and writing fail in turn."""
        start = self.needed_to_start()
        self.write("in.obj", surfaces.obj(*surfaces.grid_cube(58)))
        failed = 0
        for more in (2, 6, 12, 24, 40, 60, 90, 130, 190, 320):
            if self.expect_end(start + more, "--threads", "2"):
                break
            failed += 1
        self.assertGreaterEqual(failed, 6)

    def test_a_mesh_without_its_report(self):
        """Either both files are there or none."""
        start = self.needed_to_start()
        self.write("in.obj", surfaces.obj(*surfaces.grid_cube(30)))
        self.expect(0, self.hexatlas("mesh", "hex", "in.obj", "-o", "in.vtk", "--effort", "0"))
        codes = []
        for more in range(0, 60, 4):
            ran = self.limited(start + more, "mesh", "untangle", "in.vtk", "-o", "out.vtk", "--report", "out.html",
                               "--effort", "0", "--threads", "1")
            codes.append(ran.code)
            there = [name for name in self.listing() if name.startswith("out")]
            self.assertEqual((ran.code, there), (0, ["out.html", "out.vtk"]) if ran.code == 0 else (5, []))
            for name in there:
                os.remove(self.path(name))
        self.assertIn(5, codes)
        self.assertIn(0, codes)

    def test_threads_and_exact_numbers(self):
        """600 quads, and places for 10,000 hexahedra by many threads, each with a stack."""
        start = self.needed_to_start()
        points, quads = surfaces.grid_cube(10)
        rng = random.Random(3)  # places for a block are known at once
        points = [tuple(repr(float(x) + rng.uniform(-0.25, 0.25)) for x in point) for point in points]
        self.write("in.obj", surfaces.obj(points, quads))
        enough = [self.expect_end(start + more, "--threads", "12", "--effort", "1")
                  for more in (1, 8, 12, 20, 50, 80, 100, 120, 140)]
        self.assertFalse(enough[0])


if __name__ == "__main__":
    program.main()
