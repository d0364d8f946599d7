#!/usr/bin/env python3
"""Claim. A search that is saved as it goes loses nothing by being killed: taken up again it ends
with the same table. A stop is obeyed and said; a saved search that is damaged, or another one, is
refused in one line and left as it is.
Oracle. The search that nobody interrupted: its table and, at its end, its saved search.
"""
import os
import random
import signal
import subprocess
import time

import program

TARGETS = ("--max-quads", "6", "--also", "two-cubes", "--also", "three-around-an-edge",
           "--also", "rhombic-dodecahedron", "--per-class", "10", "--growths", "5", "-j", "2",
           "--symmetric-ball-hexahedra", "8", "--symmetric-ball-width", "20")
ROUNDS = "1" if program.SANITIZED else "2"
OPTIONS = (*TARGETS, "--width", "50", "--max-hexahedra", "12", "--rounds", ROUNDS, "--symmetric", "2",
           "--symmetric-width", "20", "--symmetric-hexahedra", "12", "--collared", "2",
           "--collar-width", "50", "--cut", "2", "--cut-growths", "20", "--annealed", "1", "--anneal-starts", "3",
           "--anneal-rounds", "1", "--anneal-leaps", "1", "--anneal-faulty", "3",
           "--anneal-cut", "0" if program.SANITIZED else "2", "--anneal-transplant", "2")
ENDLESS = (*TARGETS, "--width", "200", "--max-hexahedra", "72", "--rounds", "1000")  # many minutes
SAVED = ("--state", "s.state", "--save-every", "0")
FOUND_ALL_OR_NOT = (0, 4)


def with_other(name, value):
    """The options with another value of one of them, or one more."""
    if name not in OPTIONS:
        return (*OPTIONS, name, value)
    at = OPTIONS.index(name) + 1
    return (*OPTIONS[:at], value, *OPTIONS[at + 1:])


class SearchState(program.ProgramTest):
    def build(self, name, *options):
        return self.hexatlas("table", "build", "-o", name, *OPTIONS, *options)

    def start(self, name, *options, search=OPTIONS):
        return subprocess.Popen([program.PROGRAM, "table", "build", "-o", name, *search, *options],
                                cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    def saved(self):
        """The bytes of s.state, if it is there."""
        return self.read("s.state") if os.path.exists(self.path("s.state")) else b""

    def kill_after_a_save(self, seconds=0.0):
        """So long after the first save of this run, if the search does not end before."""
        before = self.saved()
        with self.start("killed.hxt", *SAVED) as search:
            while search.poll() is None and self.saved() == before:
                time.sleep(0.002)
            time.sleep(seconds)
            search.kill()
        self.assertTrue(self.saved(), "the search saved nothing")
        return self.saved()

    def test_kills_lose_nothing(self):
        began = time.monotonic()
        self.assertIn(self.build("whole.hxt", "--state", "whole.state").code, FOUND_ALL_OR_NOT)
        whole = time.monotonic() - began
        draw = random.Random(1)
        saves = {self.kill_after_a_save(draw.uniform(0, 0.2 * whole)) for _ in range(3 if program.SANITIZED else 6)}
        self.assertGreater(len(saves), 1, "the search was killed before it saved anything new")
        self.assertIn(self.build("killed.hxt", *SAVED).code, FOUND_ALL_OR_NOT)
        self.assertEqual(self.read("killed.hxt"), self.read("whole.hxt"))
        finished = self.read("s.state")
        self.assertEqual(finished, self.read("whole.state"))
        self.assertIn(self.build("again.hxt", *SAVED).code, FOUND_ALL_OR_NOT)
        self.assertEqual(self.read("again.hxt"), self.read("whole.hxt"))
        self.assertEqual(self.read("s.state"), finished)

    def test_stop_is_obeyed(self):
        signal.signal(signal.SIGHUP, signal.SIG_DFL)  # nohup has it ignored
        for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(stop=stop):
                name = f"{stop.name}.state"
                with self.start("a.hxt", "--state", name, search=ENDLESS) as search:
                    program.wait_for_handler(search, stop)
                    time.sleep(0.1)
                    search.send_signal(stop)
                    said = search.stderr.read().decode()
                self.assertEqual(search.returncode, 4, said)
                self.assertIn("goes on from " + name, said)
                self.assertEqual([n for n in self.listing() if n.startswith("a.")], [])
                self.assertTrue(os.path.exists(self.path(name)))

    def test_a_save_that_fails_is_tried_again(self):
        os.mkdir(self.path("here"))
        with self.start("a.hxt", "--state", "here/s.state", "--save-every", "0", search=ENDLESS) as search:
            while search.poll() is None and not os.path.exists(self.path("here/s.state")):
                time.sleep(0.002)
            os.rename(self.path("here"), self.path("there"))
            first = search.stderr.readline().decode()
            os.rename(self.path("there"), self.path("here"))
            program.wait_for_handler(search, signal.SIGINT)
            search.send_signal(signal.SIGINT)
            said = search.stderr.read().decode()
        self.assertRegex(first, r"\Ahexatlas: note: this save failed, the work goes on: [^\n]*here/s\.state: cannot be [^\n]*\n\Z")
        self.assertEqual(search.returncode, 4, said)
        self.assertIn("goes on from here/s.state", said)
        self.assertTrue(os.path.exists(self.path("here/s.state")))

    def test_table_so_far(self):
        before = self.kill_after_a_save()
        self.assertIn(self.build("far.hxt", "--state", "s.state", "--so-far").code, FOUND_ALL_OR_NOT)
        self.assertEqual(self.read("s.state"), before)
        self.expect(0, self.hexatlas("table", "check", "far.hxt"))
        self.assertEqual(self.expect(2, self.build("far.hxt", "--so-far")).out, "")
        self.expect_fault(self.build("far.hxt", "--state", "none.state", "--so-far"), "none.state")

    def test_what_is_no_saved_search_of_this_kind_is_refused(self):
        good = self.kill_after_a_save()
        half = len(good) // 2
        flipped = good[:half] + bytes([good[half] ^ 1]) + good[half + 1:]
        for bad in (b"", b"hexsrch1", good[:half], good + b"\0", flipped, b"x" * 100):
            self.write("bad.state", bad)
            self.expect_fault(self.build("b.hxt", "--state", "bad.state"), "bad.state")
            self.assertEqual(self.read("bad.state"), bad)
        for option in ("--state", "--start-from"):
            self.expect_fault(self.build("b.hxt", option, "/dev/null"), "/dev/null")
        for name, value in (("--seed", "2"), ("--widest", "22"), ("--collar-hexahedra", "5"),
                            ("--collar-widest", "24"), ("--collar-width", "70"), ("--collar-narrow", "1"),
                            ("--anneal-starts", "2"), ("--anneal-rounds", "2"), ("--anneal-leaps", "2"),
                            ("--anneal-faulty", "2"), ("--anneal-cut", "3"), ("--anneal-transplant", "1"), ("--annealed", "2")):
            self.expect_fault(self.hexatlas("table", "build", "-o", "b.hxt", *with_other(name, value),
                                            "--state", "s.state"), "s.state")
        self.assertEqual(self.read("s.state"), good)


if __name__ == "__main__":
    program.main()
