"""The records of a table (docs/formats/table.md), read without the program. Needs libzstd.so.1."""
import ctypes
import struct

ZSTD = ctypes.CDLL("libzstd.so.1")
ZSTD.ZSTD_compressBound.restype = ZSTD.ZSTD_compress.restype = ZSTD.ZSTD_decompress.restype = ctypes.c_size_t
ZSTD.ZSTD_compressBound.argtypes = [ctypes.c_size_t]


def unpacked(data, size):
    room = ctypes.create_string_buffer(size)
    done = ZSTD.ZSTD_decompress(room, ctypes.c_size_t(size), data, ctypes.c_size_t(len(data)))
    assert done == size, done
    return room.raw


def packed(data):
    size = ZSTD.ZSTD_compressBound(len(data))
    room = ctypes.create_string_buffer(size)
    done = ZSTD.ZSTD_compress(room, ctypes.c_size_t(size), data, ctypes.c_size_t(len(data)), 1)
    assert done <= size, done
    return room.raw[:done]


def read(data):
    """Per section its quads and its rows of the index; the payloads of all entries; the names."""
    entries, sections, blocks, names, per_block = struct.unpack_from("<QIIII", data, 24)
    _, directory, at = struct.unpack_from("<QQQ", data, 48)
    rows, payloads, named = [], [], []
    for s in range(sections):
        quads, key, _, count, first = struct.unpack_from("<IIQQQ", data, 128 + 32 * s)
        size = key + 8
        rows.append((quads, [data[first + size * i:first + size * (i + 1)] for i in range(count)]))
    for b in range(blocks):
        place, stored, size = struct.unpack_from("<QII", data, directory + 16 * b)
        block = unpacked(data[place:place + stored], size)
        count = min(per_block, entries - per_block * b)
        sizes, start = struct.unpack_from(f"<{count}I", block), 4 * count
        for size in sizes:
            payloads.append(block[start:start + size])
            start += size
    for _ in range(names):
        ordinal, size = struct.unpack_from("<IB", data, at)
        named.append((ordinal, data[at + 5:at + 5 + size]))
        at += 5 + size
    return rows, payloads, named
