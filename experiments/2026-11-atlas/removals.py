#!/usr/bin/env python3
"""Leaves records out of the shipped table, one at a time, and has the rest judged, which still claims to be complete.

The table is written anew with right digests (docs/formats/table.md), so that only the count can tell. Prints what was
accepted. Needs libzstd.so.1.

usage: removals.py PROGRAM TABLE FOLDER NUMBER
"""
import hashlib
import os
import random
import struct
import subprocess
import sys

from table_bytes import packed, read


def without(data, rows, payloads, names, gone):
    """The table without an entry, given by its ordinal."""
    per_block, = struct.unpack_from("<I", data, 44)
    left, sections, first = [], [], 0
    for quads, own in rows:
        kept = own[:gone - first] + own[gone - first + 1:] if 0 <= gone - first < len(own) else own
        first += len(own)
        left += [(quads, kept)] if kept else []
    payloads = payloads[:gone] + payloads[gone + 1:]
    named = [(ordinal - (ordinal > gone), name) for ordinal, name in names if ordinal != gone]
    index_at, ordinal = 128 + 32 * len(left), 0
    index = b""
    for quads, own in left:
        sections.append(struct.pack("<IIQQQ", quads, len(own[0]) - 8, ordinal, len(own), index_at + len(index)))
        ordinal += len(own)
        index += b"".join(own)
    blocks = []
    for start in range(0, len(payloads), per_block):
        some = payloads[start:start + per_block]
        plain = struct.pack(f"<{len(some)}I", *map(len, some)) + b"".join(some)
        blocks.append((packed(plain), len(plain)))
    directory_at = index_at + len(index)
    at = directory_at + 16 * len(blocks)
    directory = b""
    for block, size in blocks:
        directory += struct.pack("<QII", at, len(block), size)
        at += len(block)
    tail = b"".join(struct.pack("<IB", ordinal, len(name)) + name for ordinal, name in named)
    header = data[:16] + struct.pack("<QQIIIIQQQ", at + len(tail), len(payloads), len(left), len(blocks), len(named),
                                     per_block, index_at, directory_at, at) + data[72:96] + bytes(32)
    whole = bytearray(header + b"".join(sections) + index + directory + b"".join(b for b, _ in blocks) + tail)
    whole[96:128] = hashlib.sha256(whole).digest()
    return whole


def main():
    program, folder, number = os.path.abspath(sys.argv[1]), sys.argv[3], int(sys.argv[4])
    with open(sys.argv[2], "rb") as file:
        data = file.read()
    rows, payloads, names = read(data)
    path = os.path.join(folder, "less.hxt")

    def judged(gone):
        with open(path, "wb") as file:
            file.write(without(data, rows, payloads, names, gone))
        return subprocess.run([program, "table", "check", path], check=False, capture_output=True, text=True)

    # The writer of this script is right: with nothing left out, the judge accepts.
    whole = judged(len(payloads))
    assert whole.returncode == 0, whole
    draw = random.Random(1)
    last = len(payloads) - 1
    gone = ([0, 1, last - 1, last] + draw.sample(range(2, last - 1), max(0, number - 4)))[:number]
    refused, by_the_sum = 0, 0
    for ordinal in gone:
        ran = judged(ordinal)
        refused += ran.returncode == 1
        by_the_sum += "the rooted sum is" in ran.stdout + ran.stderr
    print("records left out, one at a time", number, sep="\t")
    print("refused", refused, sep="\t")
    print("refused since the rooted sum is short", by_the_sum, sep="\t")
    sys.exit(0 if refused == by_the_sum == number else 1)


main()
