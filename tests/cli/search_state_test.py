#!/usr/bin/env python3
"""Claim. A search that is saved as it goes loses nothing by being killed: taken up again it ends
with the same table. A stop is obeyed and said; a saved search that is damaged, or another one, is
refused in one line and left as it is.
Oracle. The search that nobody interrupted.
"""
import os
import random
import signal
import subprocess
import time

import program

OPTIONS = ("--max-quads", "10", "--width", "100", "--per-class", "10", "--max-hexahedra", "40",
           "--rounds", "2", "--growths", "5", "--collared", "2", "-j", "2")
SAVED = ("--state", "s.state", "--save-every", "0")
FOUND_ALL_OR_NOT = (0, 4)


class SearchState(program.ProgramTest):
    def build(self, name, *options):
        return self.hexatlas("table", "build", "-o", name, *OPTIONS, *options)

    def start(self, name, *options):
        return subprocess.Popen([program.PROGRAM, "table", "build", "-o", name, *OPTIONS, *options],
                                cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)

    def test_kills_lose_nothing(self):
        began = time.monotonic()
        self.assertIn(self.build("whole.hxt").code, FOUND_ALL_OR_NOT)
        whole = time.monotonic() - began
        draw = random.Random(1)
        saves = set()
        for _ in range(6):
            with self.start("killed.hxt", *SAVED) as search:
                time.sleep(draw.uniform(0.02, 0.5 * whole))
                search.kill()
            if os.path.exists(self.path("s.state")):
                saves.add(self.read("s.state"))
        self.assertGreater(len(saves), 1, "the search was killed before it saved anything new")
        self.assertIn(self.build("killed.hxt", *SAVED).code, FOUND_ALL_OR_NOT)
        self.assertEqual(self.read("killed.hxt"), self.read("whole.hxt"))
        finished = self.read("s.state")
        self.assertIn(self.build("again.hxt", *SAVED).code, FOUND_ALL_OR_NOT)
        self.assertEqual(self.read("again.hxt"), self.read("whole.hxt"))
        self.assertEqual(self.read("s.state"), finished)

    def test_stop_is_obeyed(self):
        for stop in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(stop=stop):
                name = f"{stop.name}.state"
                with self.start("a.hxt", "--state", name) as search:
                    time.sleep(0.2)
                    search.send_signal(stop)
                    said = search.stderr.read().decode()
                if search.returncode == 0:
                    self.skipTest("the search ended before the signal came")
                self.assertEqual(search.returncode, 4, said)
                self.assertIn("goes on from " + name, said)
                self.assertEqual([n for n in self.listing() if n.startswith("a.")], [])
                self.assertTrue(os.path.exists(self.path(name)))

    def test_table_so_far(self):
        with self.start("a.hxt", *SAVED) as search:
            while not os.path.exists(self.path("s.state")):
                time.sleep(0.01)
            search.kill()
        before = self.read("s.state")
        self.assertIn(self.build("far.hxt", "--state", "s.state", "--so-far").code, FOUND_ALL_OR_NOT)
        self.assertEqual(self.read("s.state"), before)
        self.expect(0, self.hexatlas("table", "check", "far.hxt"))
        self.assertEqual(self.expect(2, self.build("far.hxt", "--so-far")).out, "")
        self.expect_fault(self.build("far.hxt", "--state", "none.state", "--so-far"), "none.state")

    def test_what_is_no_saved_search_of_this_kind_is_refused(self):
        with self.start("a.hxt", *SAVED) as search:
            while not os.path.exists(self.path("s.state")):
                time.sleep(0.01)
            search.kill()
        good = self.read("s.state")
        half = len(good) // 2
        flipped = good[:half] + bytes([good[half] ^ 1]) + good[half + 1:]
        for bad in (b"", b"hexsrch1", good[:half], good + b"\0", flipped, b"x" * 100):
            self.write("bad.state", bad)
            self.expect_fault(self.build("b.hxt", "--state", "bad.state"), "bad.state")
            self.assertEqual(self.read("bad.state"), bad)
        self.expect_fault(self.build("b.hxt", "--state", "s.state", "--seed", "2"), "s.state")
        self.expect_fault(self.build("b.hxt", "--state", "s.state", "--widest", "22"), "s.state")
        self.assertEqual(self.read("s.state"), good)


if __name__ == "__main__":
    program.main()
