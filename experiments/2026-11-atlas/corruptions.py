#!/usr/bin/env python3
"""Damages the shipped table in 10,000 ways and has each one judged. Prints what was accepted.

Most are found by the digest alone; SEALED of them get a right digest, so that the laws must find them.
Of these a change of a lower bound is no damage but another claim, which nothing in the table proves, and
another compression of the same records is none either: a few bits of Zstandard mean nothing.

usage: corruptions.py PROGRAM TABLE FOLDER
"""
import hashlib
import os
import random
import subprocess
import sys

from table_bytes import read

NUMBER, SEALED = 10_000, 40
DIGEST = slice(96, 128)


def flip(data, draw):
    for _ in range(draw.randint(1, 4)):
        data[draw.randrange(len(data))] ^= 1 << draw.randrange(8)


def cut(data, draw):
    del data[draw.randrange(len(data)):]


def drop(data, draw):
    at = draw.randrange(len(data))
    del data[at:at + draw.randint(1, 100)]


def repeat(data, draw):
    at = draw.randrange(len(data))
    data[at:at] = data[at:at + draw.randint(1, 100)]


def exchange(data, draw):
    a, b = sorted(draw.sample(range(len(data) - 64), 2))
    data[a:a + 16], data[b:b + 16] = data[b:b + 16], data[a:a + 16]


def sealed_change(data, draw):
    data[draw.randrange(128, len(data))] ^= 1 << draw.randrange(8)
    data[DIGEST] = bytes(32)
    data[DIGEST] = hashlib.sha256(data).digest()


def lower_bounds(data):
    """The places of the bytes that claim lower bounds (docs/formats/table.md)."""
    number = lambda at, size: int.from_bytes(data[at:at + size], "little")
    places, at = set(), number(48, 8)
    for section in range(number(32, 4)):
        key = (number(128 + 32 * section, 4) + 1) // 2
        for _ in range(number(128 + 32 * section + 16, 8)):
            places.update((at + key + 4, at + key + 5))
            at += key + 8
    return places


def main():
    program, folder = os.path.abspath(sys.argv[1]), sys.argv[3]
    with open(sys.argv[2], "rb") as file:
        good = file.read()
    draw = random.Random(1)
    path = os.path.join(folder, "damaged.hxt")
    made, claims, same, accepted, crashed = {}, 0, 0, 0, 0
    bounds = lower_bounds(good)
    while sum(made.values()) < NUMBER:
        change = sealed_change if made.get("sealed_change", 0) < SEALED else draw.choice(
            (flip, cut, drop, repeat, exchange))
        data = bytearray(good)
        change(data, draw)
        if data == good:
            continue
        made[change.__name__] = made.get(change.__name__, 0) + 1
        with open(path, "wb") as file:
            file.write(data)
        ran = subprocess.run([program, "table", "check", path], check=False, capture_output=True)
        if ran.returncode == 0:
            changed = {i for i, (a, b) in enumerate(zip(data, good)) if a != b and i not in range(96, 128)}
            is_claim = change is sealed_change and changed <= bounds
            is_same = change is sealed_change and not is_claim and read(bytes(data)) == read(good)
            claims += is_claim
            same += is_same
            accepted += not is_claim and not is_same
        crashed += ran.returncode not in (0, 1, 3)
    for kind, count in made.items():
        print(kind, count, sep="\t")
    print("accepted", accepted, sep="\t")
    print("accepted as another claim of a lower bound", claims, sep="\t")
    print("accepted as another compression of the same records", same, sep="\t")
    print("ended otherwise than with a verdict", crashed, sep="\t")
    sys.exit(1 if accepted or crashed else 0)


main()
