#!/usr/bin/env python3
"""Draws the lines `scaling` of result.tsv: seconds, and hexahedra, by quads. usage: plot.py RESULT > SVG"""
import csv
import math
import sys

WIDTH, HEIGHT, LEFT, TOP, GAP = 320, 260, 60, 30, 110
COLOURS = {"flips": "#0072b2", "construction": "#d55e00"}


def panel(x0, title, lines, low, high):
    """One diagram with logarithmic axes; `lines` by method, points (quads, value)."""
    def x(quads):
        return x0 + (math.log10(quads) - 2) / 3 * WIDTH

    def y(value):
        return TOP + HEIGHT - (math.log10(value) - low) / (high - low) * HEIGHT

    out = [f'<text x="{x0 + WIDTH / 2}" y="{TOP - 12}" text-anchor="middle">{title}</text>',
           f'<rect x="{x0}" y="{TOP}" width="{WIDTH}" height="{HEIGHT}" fill="none" stroke="#888"/>']
    for e in range(2, 6):
        out.append(f'<text x="{x(10 ** e):.1f}" y="{TOP + HEIGHT + 18}" text-anchor="middle">'
                   f'{10 ** e:,}</text>')
    for e in range(low, high + 1):
        out.append(f'<path d="M{x0} {y(10 ** e):.1f}h{WIDTH}" stroke="#ddd"/>'
                   f'<text x="{x0 - 6}" y="{y(10 ** e) + 4:.1f}" text-anchor="end">'
                   f'{10 ** e:,}</text>')
    out.append(f'<text x="{x0 + WIDTH / 2}" y="{TOP + HEIGHT + 38}" text-anchor="middle">quads</text>')
    for number, (name, points) in enumerate(lines.items()):
        path = " ".join(f"{x(q):.1f},{y(v):.1f}" for q, v in points)
        out.append(f'<polyline points="{path}" fill="none" stroke="{COLOURS[name]}"'
                   ' stroke-width="2"/>')
        out += [f'<circle cx="{x(q):.1f}" cy="{y(v):.1f}" r="3.5" fill="{COLOURS[name]}"/>'
                for q, v in points]
        out.append(f'<text x="{x0 + 12}" y="{TOP + 20 + 18 * number}" fill="{COLOURS[name]}">'
                   f'{name}</text>')
    return out


def main(path):
    seconds, hexahedra = {}, {}
    with open(path, encoding="ascii") as file:
        for row in csv.DictReader(file, delimiter="\t"):
            if row["name"].startswith("scaling") and row["judged"] == "accepted":
                quads = int(row["quads"])
                seconds.setdefault(row["way"], []).append((quads, float(row["seconds"])))
                hexahedra.setdefault(row["way"], []).append((quads, int(row["hexahedra"])))
    second = LEFT + WIDTH + GAP
    width, height = second + WIDTH + 40, TOP + HEIGHT + 50
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}"'
          f' font-family="sans-serif" font-size="13"><rect width="100%" height="100%" fill="#fff"/>')
    print("\n".join(panel(LEFT, "seconds on one core, the judge's included", seconds, -2, 2)
                    + panel(second, "hexahedra", hexahedra, 2, 7)))
    print("</svg>")


if __name__ == "__main__":
    main(sys.argv[1])
