#!/usr/bin/env python3
"""Kills a search at 50 random instants and takes it up again each time. Prints what was lost.

usage: kills.py PROGRAM FOLDER
"""
import os
import random
import subprocess
import sys
import time

SEARCH = ("--max-quads", "14", "--width", "20000", "--per-class", "20", "--max-hexahedra", "60",
          "--rounds", "2", "--symmetric", "3", "--symmetric-ball-width", "200", "--collared", "5")
SAVE_EVERY = 2
KILLS = 50


def build(program, folder, name, *options):
    return [program, "table", "build", "-o", os.path.join(folder, name), *SEARCH, *options]


def main():
    program, folder = os.path.abspath(sys.argv[1]), sys.argv[2]
    state = os.path.join(folder, "killed.state")
    saved = ("--state", state, "--save-every", str(SAVE_EVERY))
    draw = random.Random(1)
    lost, unreadable, kills = [], 0, 0
    while kills < KILLS:
        with subprocess.Popen(build(program, folder, "killed.hxt", *saved),
                              stderr=subprocess.PIPE) as search:
            began = time.time()
            time.sleep(draw.uniform(0.5, 8))
            if search.poll() is not None:  # finished, or the state was refused
                unreadable += search.returncode not in (0, 4)
                os.remove(state)
                continue
            search.kill()
            ended = time.time()
            kills += 1
        if os.path.exists(state):
            lost.append(ended - max(began, os.path.getmtime(state)))
    finished = subprocess.run(build(program, folder, "killed.hxt", *saved), check=False,
                              stdout=subprocess.DEVNULL)
    whole = subprocess.run(build(program, folder, "whole.hxt"), check=False,
                           stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "killed.hxt"), "rb") as a, \
            open(os.path.join(folder, "whole.hxt"), "rb") as b:
        same = a.read() == b.read()
    print("kills", kills, sep="\t")
    print("saved searches refused", unreadable, sep="\t")
    print("seconds between saves asked for", SAVE_EVERY, sep="\t")
    print("seconds of work lost at most", f"{max(lost):.1f}", sep="\t")
    print("table equals that of the uninterrupted search", same, sep="\t")
    sys.exit(0 if same and unreadable == 0 and finished.returncode == whole.returncode else 1)


main()
