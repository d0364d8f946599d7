#!/usr/bin/env python3
"""Claim. What README.md shows of the program is what the program prints.
Oracle. The program: each command of a block `console` is run, in a folder in which experiments/ is
that of the repository, and its output compared. `--update` as last argument writes the outputs into
README.md. A command of a verb that this build lacks is skipped, which is said, and its output left
as it is. Of the demo, the two commands that use the program are run. One command judges the table
that comes with the program as a whole, which no other test here does: it takes long.
"""
import os
import re
import shlex
import subprocess
import sys

import program

README = os.path.join(program.REPOSITORY, "README.md")
BLOCK = re.compile(r"(?<=^```console\n)(.*?)(?=^```$)", re.MULTILINE | re.DOTALL)
LACKING = re.compile(r"hexatlas: this program was built without [^\n]+\n")
UPDATE = "--update" in sys.argv

BOUNDARY = "experiments/2026-11-quad-balls/inputs/schneiders-pyramid.obj"
MESH = "build/schneiders-pyramid.vtu"
DEMO = [
    "demo: configuring\ndemo: building, some minutes at the first time\n"
    f"demo: meshing {BOUNDARY}\n",
    f"hexatlas mesh hex {BOUNDARY} -o {MESH}",
    f"demo: checking {MESH}\n",
    f"hexatlas check {MESH} --boundary {BOUNDARY}",
    f"demo: made the program build/release/hexatlas and the mesh {MESH} (open it in ParaView)\n",
]


class Readme(program.ProgramTest):
    def setUp(self):
        super().setUp()
        for folder in ("experiments", "tables"):
            os.symlink(os.path.join(program.REPOSITORY, folder), self.path(folder))
        os.mkdir(self.path("build"))

    def output(self, command):
        if command == "bash cmake/demo.sh":
            return "".join(self.output(part) if part.startswith("hexatlas ") else part
                           for part in DEMO)
        words = shlex.split(command)
        self.assertEqual(words[0], "hexatlas", command)
        ran = self.hexatlas(*words[1:], stderr=subprocess.STDOUT)
        text = ran.out.replace(os.path.dirname(program.PROGRAM), "build/release")
        return re.sub(r'"seconds":[0-9.e-]+', '"seconds":0.01', text)

    def refreshed(self, block):
        """The block with the outputs of its commands."""
        fresh = ""
        for shown in re.split(r"^(?=\$ )", block.group(1), flags=re.MULTILINE)[1:]:
            command = shown[2:].split("\n")[0]
            output = self.output(command)
            if LACKING.fullmatch(output):
                with self.subTest(command=command):
                    self.skipTest(output.strip())
            else:
                shown = f"$ {command}\n{output}"
            fresh += shown
        return fresh

    def test_outputs(self):
        with open(README, encoding="utf-8") as file:
            text = file.read()
        self.assertGreater(len(BLOCK.findall(text)), 3)
        fresh = BLOCK.sub(self.refreshed, text)
        self.assertRegex(fresh, r"\n\$ hexatlas table check\n[^\n]+: accepted: [^\n]+; "
                                r"as its manifest says; as its census says\n")
        if UPDATE:
            with open(README, "w", encoding="utf-8") as file:
                file.write(fresh)
        else:
            self.assertEqual(text, fresh, "run this test with --update")

    def test_the_demo_shown_is_the_demo(self):
        with open(os.path.join(program.REPOSITORY, "cmake", "demo.sh"), encoding="utf-8") as file:
            script = file.read()
        for word in (BOUNDARY, MESH, "configuring", "building, some minutes at the first time",
                     "demo: meshing", "demo: checking", "open it in ParaView"):
            self.assertIn(word, script)

    def test_links_lead_to_files(self):
        with open(README, encoding="utf-8") as file:
            text = file.read()
        for target in re.findall(r"\]\(([^)#]+)\)", text):
            if not target.startswith("http"):
                self.assertTrue(os.path.exists(os.path.join(program.REPOSITORY, target)), target)


if __name__ == "__main__":
    if UPDATE:
        sys.argv.remove("--update")
    program.main()
