"""Runs the program in a folder of its own and keeps what it said."""
import os
import re
import subprocess
import sys
import tempfile
import time
import unittest

REPOSITORY = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
INPUTS = os.path.join(REPOSITORY, "experiments", "2026-11-quad-balls", "inputs")
PROGRAM = ""
SANITIZED = "HEXATLAS_SANITIZED" in os.environ


def made_by(*arguments):
    """Runs the program in an empty folder; the files that it leaves there, by name."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([PROGRAM, *arguments], cwd=folder, timeout=300, check=True,
                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        made = {}
        for name in sorted(os.listdir(folder)):
            with open(os.path.join(folder, name), "rb") as file:
                made[name] = file.read()
        return made


def share_of(cases, first=0, least=1):
    """An eighth of the cases of a long test under a sanitizer, as in tests/share.hpp, but at least `least`; else all."""
    step = max(1, min(8, len(cases) // least)) if SANITIZED else 1
    return cases[first % step::step]


LOOKED_FOR_LEAKS = set()


def leaks_once(arguments):
    """The environment in which AddressSanitizer looks for leaks at the first start of a command with
    these options only: it takes half of the time of a short run."""
    if not SANITIZED:
        return {}
    kind = (*arguments[:2], *sorted(a.split("=")[0] for a in arguments[2:] if a.startswith("-")))
    if kind not in LOOKED_FOR_LEAKS:
        LOOKED_FOR_LEAKS.add(kind)
        return {}
    return {"ASAN_OPTIONS": f"{os.environ.get('ASAN_OPTIONS', '')}:detect_leaks=0"}


def catches(process, number):
    """Whether the program has its handler of this signal by now."""
    with open(f"/proc/{process.pid}/status", encoding="utf-8") as file:
        caught = re.search(r"^SigCgt:\s*([0-9a-f]+)$", file.read(), re.MULTILINE)
    return int(caught.group(1), 16) >> (number - 1) & 1 == 1


def wait_for_handler(process, number):
    """Until the program has its handler of this signal, or has ended."""
    while process.poll() is None and not catches(process, number):
        time.sleep(0.002)


class Ran:
    def __init__(self, code, out, err):
        self.code, self.out, self.err = code, out, err

    def __repr__(self):
        return f"exit {self.code}\nstdout: {self.out[:2000]!r}\nstderr: {self.err[:2000]!r}"


class ProgramTest(unittest.TestCase):
    """Each test has an empty folder, in which the program runs."""

    maxDiff = None

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        data = content if isinstance(content, bytes) else content.encode()
        with open(self.path(name), "wb") as file:
            file.write(data)
        return name

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def listing(self):
        return sorted(os.listdir(self.folder))

    def hexatlas(self, *arguments, stdin=b"", env=None, **options):
        """Text of both streams unless they go elsewhere."""
        env = {**leaks_once(arguments), **(env or {})}
        options.setdefault("stdout", subprocess.PIPE)
        options.setdefault("stderr", subprocess.PIPE)
        options.setdefault("timeout", 300)
        done = subprocess.run([PROGRAM, *arguments], input=stdin, cwd=self.folder,
                              env={**os.environ, **env}, check=False, **options)
        return Ran(done.returncode, (done.stdout or b"").decode(errors="surrogateescape"),
                   (done.stderr or b"").decode(errors="surrogateescape"))

    def expect(self, code, ran):
        self.assertEqual(ran.code, code, ran)
        return ran

    def expect_fault(self, ran, named):
        """Exit 3, one line `named: reason` or `named:line: reason`; returns the line or 0."""
        self.expect(3, ran)
        self.assertEqual(ran.out, "", ran)
        found = re.fullmatch(re.escape(named) + r":(?:(\d+):)? ([^\n]{8,})\n", ran.err)
        self.assertTrue(found, ran)
        self.assertNotEqual(found.group(1), "0", ran)
        return int(found.group(1) or 0)


def main():
    """The path of the program is the first argument; the others are those of unittest."""
    global PROGRAM
    if len(sys.argv) < 2 or not os.access(sys.argv[1], os.X_OK):
        sys.exit(f"usage: {sys.argv[0]} path/to/hexatlas [unittest options]")
    PROGRAM = os.path.abspath(sys.argv[1])
    unittest.main(module="__main__", argv=[sys.argv[0], *sys.argv[2:]])
