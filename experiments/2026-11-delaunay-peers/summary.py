"""Medians of result.tsv, and ratios to CGAL on one thread."""
import collections
import statistics
import sys


def main():
    runs = collections.defaultdict(list)
    for line in open(sys.argv[1]).read().splitlines()[1:]:
        program, kind, points, threads, _, wall, processor, size = line.split("\t")
        runs[kind, int(points), program, int(threads)].append((float(wall), float(processor), float(size)))
    medians = {key: [statistics.median(column) for column in zip(*values)] for key, values in runs.items()}
    print(f"{'kind':12}{'points':>9} {'program':14}{'threads':>7}{'wall':>9}{'cpu':>9}{'us/point':>9}{'to CGAL':>9}{'bytes':>7}")
    for (kind, points, program, threads), (wall, processor, size) in sorted(medians.items()):
        peer = medians.get((kind, points, "cgal", 1))
        ratio = f"{wall / peer[0]:9.2f}" if peer else " " * 9
        print(f"{kind:12}{points:9} {program:14}{threads:7}{wall:9.3f}{processor:9.3f}{1e6 * wall / points:9.2f}{ratio}{size:7.1f}")


main()
