#!/usr/bin/env python3
"""Claim. The program behaves as others do on a command line: help and version, wrong usage with
exit 2 and one line that names the nearest word, exit 5 where output cannot be written, silence on
a broken pipe, progress on terminals only, any name of a file, any locale.
Oracle. The conventions of POSIX and the exit codes of docs/architecture/README.md.
"""
import json
import os
import pty
import shutil
import signal
import subprocess

import program
import surfaces
from table_files import TableTest

VERBS = (["mesh", "hex"], ["view"], ["check"], ["code"], ["table", "info"], ["table", "get"],
         ["table", "check"], ["table", "build"])
BUILD = ("table", "build", "-o", "a.hxt", "--max-quads", "6", "--max-hexahedra", "3", "--width", "50", "--rounds", "1", "--collared", "0",
         "--symmetric-ball-hexahedra", "0")


class Help(TableTest):
    def test_help_has_an_example(self):
        for verb in program.share_of(([], ["mesh"], ["table"], *VERBS)):
            with self.subTest(verb=verb):
                ran = self.expect(0, self.hexatlas(*verb, "--help"))
                self.assertEqual(ran.err, "")
                self.assertIn("Example", ran.out)
                self.assertIn("hexatlas", ran.out)
                self.assertEqual(self.hexatlas(*verb, "-h").out, ran.out)

    def test_help_names_all_verbs_and_exit_codes(self):
        out = self.hexatlas("--help").out
        for word in ("mesh", "check", "code", "table", "0 ", "1 ", "2 ", "3 ", "4 ", "5 "):
            self.assertIn(word, out)

    def test_examples_are_accepted(self):
        """By a copy of the program that has the small table for its own: one reads a whole table."""
        copy = shutil.copy(program.PROGRAM, self.path("hexatlas"))
        os.mkdir(self.path("tables"))
        self.write(os.path.join("tables", "hexatlas.hxt"), self.good)
        for verb in VERBS:
            text = self.hexatlas(*verb, "--help").out
            example = text[text.index("Example"):].split("\n")[1].split()
            self.assertEqual(example[:1 + len(verb)], ["hexatlas", *verb])
            if verb != ["table", "build"]:
                self.assertNotEqual(2, self.hexatlas(*example[1:], executable=copy).code, example)

    def test_version(self):
        ran = self.expect(0, self.hexatlas("--version"))
        self.assertRegex(ran.out, r"\Ahexatlas \d+\.\d+\.\d+\n\Z")


class Usage(program.ProgramTest):
    def wrong(self, *arguments, said=()):
        with self.subTest(arguments=arguments):
            ran = self.expect(2, self.hexatlas(*arguments))
            self.assertEqual(ran.out, "")
            self.assertRegex(ran.err, r"\Ahexatlas: [^\n]+[.?] See `hexatlas[^`\n]* --help`\.\n\Z")
            for word in said:
                self.assertIn(word, ran.err)
            self.assertEqual(self.listing(), [])

    def test_verb_missing(self):
        self.wrong(said=("mesh, simplify, view, check, code, table",))
        self.wrong("mesh", said=("hex", "`hexatlas mesh --help`"))
        self.wrong("table", said=("build", "info", "get", "check"))

    def test_unknown_words(self):
        self.wrong("mehs", said=("`mehs`", "did you mean `mesh`?"))
        self.wrong("chekc", "a.vtk", said=("did you mean `check`?",))
        self.wrong("mesh", "hx", said=("did you mean `hex`?",))
        self.wrong("table", "biuld", said=("did you mean `build`?",))
        self.wrong("mesh", "hx", "--help", said=("did you mean `hex`?",))
        self.wrong("--help", "biuld", said=("`biuld` is unknown to `hexatlas`",))
        self.wrong("qqqqqqqqqq", said=("`qqqqqqqqqq` is unknown to `hexatlas`.",))
        self.wrong("mesh", "hex", "a.obj", "--otput", "b.vtk", said=("did you mean `--output`?",))
        self.wrong("mesh", "hex", "a.obj", "-o", "b.vtk", "--jsn", said=("did you mean `--json`?",))
        self.wrong("mesh", "hex", "a.obj", "-o", "b.vtk", "-x", said=("`-x`",))
        self.wrong("check", "a.vtk", "--bondary=b.obj", said=("did you mean `--boundary`?",))
        self.wrong("--nope", said=("`--nope`",))

    def test_words_missing_or_too_many(self):
        self.wrong("mesh", "hex", said=("INPUT",))
        self.wrong("mesh", "hex", "a.obj", said=("--output",))
        self.wrong("mesh", "hex", "a.obj", "-o", said=("--output",))
        self.wrong("mesh", "hex", "a.obj", "b.obj", "-o", "b.vtk", said=("`b.obj`",))
        self.wrong("check", said=("FILE",))
        self.wrong("check", "a.vtk", "--boundary", said=("--boundary",))
        self.wrong("code", said=("FILE",))
        self.wrong("table", "get", said=("--name", "--code"))
        self.wrong("table", "get", "--name", "cube", "--code", "q1:08a5df", said=("--code",))
        self.wrong("table", "build", said=("--output",))

    def test_numbers_are_decimal(self):
        for word in ("010", "10", "+10"):
            ran = self.expect(0, self.hexatlas("enum", "quadrangulations", "--quads", word, "--count"))
            self.assertIn("with 10 quads", ran.out)
        for word in ("0x8", "08a", "0b1000", "0 8"):
            self.wrong("enum", "quadrangulations", "--quads", word, said=("--quads", word))
        self.wrong("enum", "hexmeshes", "cube", "--max-hexes", "3", "--estimate", "10", "--seed", "-1", said=("--seed",))

    def test_an_empty_value_is_not_taken_for_none(self):
        for words in (("check", "a.vtk", "--boundary"), ("check", "a.hxc", "--completeness"),
                      ("check", "--delaunay", "a.vtu", "--points"), ("enum", "triangulations", "prism", "-o"),
                      ("enum", "hexmeshes", "cube", "--max-hexes", "1", "--certificate"),
                      ("mesh", "hex", "a.obj", "-o", "b.vtu", "--report"), ("realize", "prism", "-o"),
                      ("table", "get", "--name", "cube", "--table"), ("table", "check"), ("table", "info")):
            self.wrong(*words, "", said=("empty",))

    def test_numbers_of_things_are_digits(self):
        for number in ("-1", "-5", "0", "18446744073709551616", "1x", "+1", " 1"):
            for words in (("enum", "hexmeshes", "cube", "--max-hexes", "1"), ("enum", "triangulations", "prism"),
                          ("table", "bounds", "a.hxt", "-o", "b.hxt", "--max-hexes", "1")):
                self.wrong(*words, "--max-nodes", number, said=("2^64 - 1",))
        self.wrong("table", "list", "--at-least", "-1", said=("--at-least",))


class Streams(TableTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", surfaces.obj(*surfaces.cube()))
        self.expect(0, self.hexatlas("mesh", "hex", "cube.obj", "-o", "cube.vtk"))
        self.printing = (["--help"], ["--version"], ["check", "--help"],
                         ["table", "info", "small.hxt"],
                         ["mesh", "hex", "cube.obj", "-o", "made.vtu"], ["code", "cube.obj"],
                         ["mesh", "hex", "cube.obj", "-o", "-"], ["check", "cube.vtk"],
                         ["mesh", "hex", "cube.obj", "-o", "made.vtu", "--json"],
                         ["table", "get", "--table", "small.hxt", "--name", "cube"],
                         ["table", "check", "small.hxt"], [*BUILD])

    def with_closed(self, redirection, *arguments):
        return self.expect_done(["sh", "-c", f'exec "$0" "$@" {redirection}', program.PROGRAM,
                                 *arguments])

    def expect_done(self, words):
        done = subprocess.run(words, cwd=self.folder, stdin=subprocess.DEVNULL, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        return program.Ran(done.returncode, done.stdout.decode(), done.stderr.decode())

    def test_full_or_closed_standard_output(self):
        for redirection in (">/dev/full", ">&-"):
            for words in self.printing:
                with self.subTest(arguments=words, redirection=redirection):
                    ran = self.expect(5, self.with_closed(redirection, *words))
                    self.assertRegex(ran.err, r"(\A|\n)hexatlas: standard output: [^\n]+\n\Z")
        # What was made before the words were refused is whole.
        self.expect(0, self.hexatlas("check", "made.vtu", "--boundary", "cube.obj"))
        self.expect(0, self.hexatlas("table", "check", "a.hxt"))

    def test_closed_standard_input_and_error(self):
        for redirection in ("<&-", "2>&-", "<&- 2>&-", "2>/dev/full"):
            ran = self.with_closed(redirection, "mesh", "hex", "cube.obj", "-o", "made.vtk")
            self.expect(0, ran)
            self.assertEqual(self.read("made.vtk"), self.read("cube.vtk"))
            ran = self.with_closed(redirection, "mesh", "hex", "none.obj", "-o", "none.vtk")
            self.expect(3, ran)
        self.expect(3, self.with_closed("<&-", "mesh", "hex", "-", "-o", "none.vtk"))
        self.assertNotIn("none.vtk", self.listing())

    def test_broken_pipe(self):
        for words in self.printing:
            with self.subTest(arguments=words):
                reader, writer = os.pipe()
                os.close(reader)
                ran = self.hexatlas(*words, stdout=writer)
                os.close(writer)
                self.assertEqual(ran.code, -signal.SIGPIPE)
                if "-" not in words:
                    self.assertEqual(ran.err, "")

    def test_progress_is_for_terminals(self):
        ran = self.expect(0, self.hexatlas(*BUILD))
        self.assertEqual(ran.err, "")
        self.assertNotIn("\r", ran.out)
        try:
            terminal, line = pty.openpty()
        except OSError as error:
            self.skipTest(f"no pseudo-terminal here: {error}")
        ran = self.expect(0, self.hexatlas(*BUILD, stderr=line))
        os.close(line)
        shown = os.read(terminal, 65536).decode()
        os.close(terminal)
        self.assertIn(" of ", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"), shown)
        self.assertNotIn("\n", shown)


class Surroundings(TableTest):
    def setUp(self):
        super().setUp()
        self.text = surfaces.obj(*surfaces.cube())

    def test_names_of_files(self):
        folders = ("a folder", "\u00fcn\u00ef/\u4e2d\u6587", "quo'te\"$HOME;*", "back\\slash", "dot.vtk",
                   "-dash", os.fsdecode(b"byte\xff"))
        for folder in program.share_of(folders, 2):
            with self.subTest(folder=folder):
                os.makedirs(self.path(folder))
                name = os.path.join(".", folder, "in put.obj")
                output = os.path.join(".", folder, "out put.vtk")
                self.write(name, self.text)
                ran = self.expect(0, self.hexatlas("mesh", "hex", name, "-o", output))
                self.assertTrue(ran.out.startswith(output + ": "), ran)
                self.expect(0, self.hexatlas("check", output, "--boundary", name, "--json"))
                self.expect(0, self.hexatlas("code", name, "--json"))
                self.expect_fault(self.hexatlas("code", name + "x"), name + "x")
                table = os.path.join(".", folder, "t.hxt")
                self.write(table, self.good)
                self.expect(0, self.hexatlas("table", "check", table))
                said = self.expect(0, self.hexatlas("table", "info", table, "--json"))
                json.loads(said.out.encode(errors="surrogateescape").decode())

    def test_a_table_is_built_at_any_place(self):
        os.mkdir(self.path("\u00fcn\u00ef code"))
        table = os.path.join("\u00fcn\u00ef code", "my table.hxt")
        self.expect(0, self.hexatlas(*[table if word == "a.hxt" else word for word in BUILD]))
        ran = self.expect(0, self.hexatlas("table", "check", table))
        self.assertIn("as its manifest says", ran.out)

    def test_names_that_begin_with_a_dash(self):
        self.write("-in.obj", self.text)
        ran = self.expect(0, self.hexatlas("mesh", "hex", "-o", "out.vtk", "--", "-in.obj"))
        self.assertEqual(ran.err, "")

    def test_locale_with_decimal_comma(self):
        self.write("in.obj", self.text.replace("v 0 0 0", "v 0.125 0.1 -0.25"))
        self.expect(0, self.hexatlas("mesh", "hex", "in.obj", "-o", "a.vtk", env={"LC_ALL": "C"}))
        env = {"LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}
        if shutil.which("localedef"):
            name = "de_DE.ISO-8859-1"  # made in a fifth of the time that UTF-8 takes
            made = subprocess.run(["localedef", "-i", "de_DE", "-f", "ISO-8859-1",
                                   self.path(name)], check=False,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if made.returncode == 0:
                env = {"LC_ALL": name, "LANG": name, "LOCPATH": self.folder}
        for output in ("b.vtk", "b.vtu"):
            ran = self.expect(0, self.hexatlas("mesh", "hex", "in.obj", "-o", output, env=env))
            self.assertRegex(ran.out, r"minimum -?\d\.\d{4},")
            self.expect(0, self.hexatlas("check", output, "--boundary", "in.obj", env=env))
        self.assertEqual(self.read("a.vtk"), self.read("b.vtk"))

    def test_the_working_folder_and_environment_do_not_matter(self):
        self.write("in.obj", self.text)
        ran = self.expect(0, self.hexatlas("mesh", "hex", "in.obj", "-o", "-"))
        bare = subprocess.run([program.PROGRAM, "mesh", "hex", self.path("in.obj"), "-o", "-"],
                              cwd="/", env={}, check=True, timeout=60, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL)
        self.assertEqual(bare.stdout.decode(), ran.out)

    def test_without_its_table_the_program_says_so(self):
        shutil.copy(program.PROGRAM, self.path("alone"))
        self.write("in.obj", self.text)
        ran = subprocess.run([self.path("alone"), "mesh", "hex", "in.obj", "-o", "a.vtk"],
                             cwd=self.folder, check=False, timeout=60, stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE)
        self.assertEqual(ran.returncode, 3)
        self.assertIn(b"--table", ran.stderr)
        self.assertEqual(ran.stderr.count(b"\n"), 1)


if __name__ == "__main__":
    program.main()
