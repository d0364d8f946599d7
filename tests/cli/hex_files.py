"""Readers of hexahedral .vtk and .mesh files, written for the tests from the formats' descriptions.

A mesh is (points, hexahedra): points are triples of floats, hexahedra have VTK's order of corners:
the bottom as a cycle, then the top, corner i + 4 above corner i.
"""
import struct


def read_vtk(text):
    words = text.split()
    points, at = [], words.index("POINTS")
    count = int(words[at + 1])
    numbers = [float(word) for word in words[at + 3:at + 3 + 3 * count]]
    points = [tuple(numbers[3 * i:3 * i + 3]) for i in range(count)]
    at = words.index("CELLS")
    cells = int(words[at + 1])
    rows = [int(word) for word in words[at + 3:at + 3 + 9 * cells]]
    if int(words[at + 2]) != 9 * cells or any(rows[9 * i] != 8 for i in range(cells)):
        raise ValueError("cells other than hexahedra")
    at = words.index("CELL_TYPES")
    if words[at + 2:at + 2 + cells] != ["12"] * cells:
        raise ValueError("types other than 12")
    return points, [tuple(rows[9 * i + 1:9 * i + 9]) for i in range(cells)]


def read_medit(text):
    words = text.split()
    at = words.index("Vertices")
    count = int(words[at + 1])
    points = [tuple(float(word) for word in words[at + 2 + 4 * i:at + 5 + 4 * i])
              for i in range(count)]
    at = words.index("Hexahedra")
    count = int(words[at + 1])
    return points, [tuple(int(word) - 1 for word in words[at + 2 + 9 * i:at + 10 + 9 * i])
                    for i in range(count)]


FACETS = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def least_first(cycle):
    at = cycle.index(min(cycle))
    return tuple(cycle[at:] + cycle[:at])


def boundary(hexahedra):
    """Facets in one hexahedron only, from outside, as sorted cycles."""
    seen = {}
    for cell in hexahedra:
        for facet in FACETS:
            cycle = [cell[i] for i in facet]
            seen.setdefault(frozenset(cycle), []).append(least_first(cycle))
    return sorted(cycles[0] for cycles in seen.values() if len(cycles) == 1)


def bits(points):
    return [struct.pack("<3d", *point) for point in points]
