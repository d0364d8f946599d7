#!/usr/bin/env bash
# Meshes of random surfaces, growing ones, and solids meshed by gmsh. Needs a release build and gmsh.
# RANDOM_SURFACES, LARGEST: how many random surfaces, and the largest of the growing ones; fewer give the
# first lines of the same table.
set -euo pipefail
cd "$(dirname "$0")"
program="$(realpath "${PROGRAM:-../../build/release/hexatlas}")"
random="${RANDOM_SURFACES:-1000}"
largest="${LARGEST:-100000}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
export PYTHONDONTWRITEBYTECODE=1

python3 ../2026-11-linear-bound/solids.py "$work"
for solid in "$work"/*.geo; do gmsh -2 -v 0 "$solid" -o "${solid%.geo}.msh" >/dev/null 2>&1 || true; done
{
  python3 measure.py
  python3 measure.py "$program" scaling "$largest"
  python3 measure.py "$program" file ../2026-11-quad-balls/inputs/*.obj "$work"/gmsh-*.msh
  python3 measure.py "$program" random "$random"
} >"$work/result.tsv"
mv "$work/result.tsv" result.tsv
python3 plot.py result.tsv >scaling.svg
{
  git -C ../.. describe --always --dirty --abbrev=12
  gmsh --version 2>&1 | sed 's/^/gmsh /'
  lscpu | sed -n 's/^Model name: *//p'
  nproc
} >provenance.txt
