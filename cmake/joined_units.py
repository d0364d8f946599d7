#!/usr/bin/env python3
"""Joins units that compile alike, for tools that spend most of their time on the headers of each.

usage: joined_units.py BUILD FOLDER <UNITS
UNITS are files of the database of the folder BUILD, one per line. Makes FOLDER anew, with files that
include up to twelve units each, all for the same processor, with the definitions and include folders of
all, and a database of these files. Prints a line for each of them: its path, then its units, with tabs
between. A unit unlike all others is a line by itself.

No two units of a target share a file: the names in their unnamed namespaces may collide.
"""
import collections
import json
import pathlib
import re
import shlex
import shutil
import sys

UNITS_EACH = 12
TARGET = re.compile(r"CMakeFiles/([^/]*)[.]dir/")
ALIKE = ("-std", "-m", "-fopenmp")  # by which what a unit says may differ
TOGETHER = ("-D", "-I", "-isystem")


def kept(arguments, prefixes):
    """The options that begin so, each with its value if that is an argument by itself."""
    return [(option, following) if option in ("-I", "-isystem") else (option,)
            for option, following in zip(arguments, arguments[1:] + [""]) if option.startswith(prefixes)]


def joined(path, units, commands):
    """Writes a file that includes the units; its entry in a database."""
    path.write_text("".join(f'// NOLINTNEXTLINE(bugprone-suspicious-include)\n#include "{u}"\n' for u in units))
    options = dict.fromkeys(o for u in units for o in kept(commands[u], ALIKE + TOGETHER))
    arguments = [argument for option in options for argument in option]
    return {"directory": str(path.parent), "file": str(path), "arguments": ["c++", *arguments, "-c", str(path)]}


def target_of(arguments):
    return TARGET.search(" ".join(arguments))[1]


def main():
    build, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    commands = {c["file"]: shlex.split(c["command"])
                for c in json.loads((build / "compile_commands.json").read_text())}
    groups = {}
    for unit in sys.stdin.read().splitlines():
        groups.setdefault(tuple(kept(commands[unit], ALIKE)), []).append((target_of(commands[unit]), unit))
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    entries = []
    for members in groups.values():
        most = max(collections.Counter(target for target, _ in members).values())
        files = max(most, -(-len(members) // UNITS_EACH))
        units = [unit for _, unit in sorted(members)]
        for own in (units[first::files] for first in range(files)):
            line = own
            if len(own) > 1:
                entries.append(joined(folder / f"joined_{len(entries)}.cpp", own, commands))
                line = [entries[-1]["file"], *own]
            print(*line, sep="\t")
    (folder / "compile_commands.json").write_text(json.dumps(entries, indent=1))


if __name__ == "__main__":
    main()
