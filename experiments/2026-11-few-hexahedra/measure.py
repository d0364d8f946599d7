#!/usr/bin/env python3
"""Meshes quad surfaces, each by several methods, and judges the meshes; a line of result.tsv for each.

usage: measure.py PROGRAM random COUNT    so many random surfaces of 24 to 2000 quads
       measure.py PROGRAM scaling MOST    random surfaces of 100, 200, 500, ... MOST quads
       measure.py PROGRAM file FILE ...   surfaces of files
       measure.py                         the heading
The surfaces are those of experiments/2026-11-linear-bound.
"""
import concurrent.futures
import json
import os
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..",
                                "2026-11-linear-bound"))
import measure as linear_bound  # noqa: E402  pylint: disable=import-self,wrong-import-position

COLUMNS = ("name", "quads", "way", "method", "hexahedra", "per_quad", "seconds", "valid",
           "min_scaled_jacobian", "judged", "ball", "peak_mb")
PLAIN = ("--effort", "0")
WAYS = {
    "random": {"auto": PLAIN},
    "scaling": {"flips": ("--method", "flips", *PLAIN),
                "construction": ("--method", "construction", *PLAIN)},
    "file": {"auto": (), "flips, 2 layers": ("--method", "flips", "--layers", "2"),
             "construction": ("--method", "construction")},
}


def run(*arguments):
    """Exit code, both outputs, and the peak of memory in MB."""
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True) as process:
        out, err = process.communicate()
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024
    return process.returncode, out, err.strip().rsplit("\n", 1)[-1], peak


def line(program, name, surface, way, options):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "out.vtk")
        code, out, err, peak = run(program, "mesh", "hex", surface, "-o", output, "--threads", "1",
                                   "--json", *options)
        if code != 0:
            reason = err.replace(os.path.dirname(surface) + "/", "").replace("hexatlas: ", "")
            return (name, "-", way, *["-"] * 6, f"exit {code}: {reason}", "-", "-")
        said = json.loads(out)
        code, out, _, _ = run(program, "check", output, "--boundary", surface, "--json")
        verdict = json.loads(out) if code in (0, 1, 4) else {}
        judged = "accepted" if code == 0 and verdict["accepted"] else f"exit {code}"
    return (name, said["quads"], way, said["method"], said["hexahedra"],
            f"{said['hexahedra_per_quad']:.3f}", f"{said['seconds']:.2f}",
            f"{said['valid'] / said['hexahedra']:.4f}", f"{said['min_scaled_jacobian']:.3f}",
            judged, verdict.get("ball_proof") or "-", peak)


def lines_of(job):
    program, kind, name, surface, quads = job
    with tempfile.TemporaryDirectory() as folder:
        if surface is None:
            surface = linear_bound.random_surface(folder, *quads)
        return [line(program, name, surface, way, options)
                for way, options in WAYS[kind].items()]


def jobs(program, kind, arguments):
    if kind == "file":
        for path in arguments:
            yield program, kind, os.path.splitext(os.path.basename(path))[0], path, None
        return
    for seed, (quads, inserted) in enumerate(linear_bound.surfaces(kind, int(arguments[0]))):
        yield program, kind, f"{kind}-{seed}-{inserted}", None, (quads, seed, inserted)


def main(program, kind, *arguments):
    # Peaks of memory are those of all children so far: one process for each surface.
    with concurrent.futures.ProcessPoolExecutor(os.cpu_count() if kind == "random" else 1,
                                                max_tasks_per_child=1) as pool:
        for lines in pool.map(lines_of, jobs(program, kind, arguments)):
            for entry in lines:
                print(*entry, sep="\t", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        print(*COLUMNS, sep="\t")
    else:
        main(os.path.abspath(sys.argv[1]), *sys.argv[2:])
