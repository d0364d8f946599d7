#!/usr/bin/env bash
# Places the vertices of the meshes of 2026-11-quad-balls, of all meshes of the table with at most 8
# hexahedra, and of grids of 300,000; writes result.tsv, small.tsv and provenance.txt.
# usage: [HEXATLAS=path/to/hexatlas] ./run.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
program=$(realpath "${HEXATLAS:-../../build/release/hexatlas}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -B measure.py "$program" ../2026-11-quad-balls/inputs "$folder" >"$folder/result.tsv"
python3 -B small.py "$program" ../../tables/data/hexatlas "$folder" >"$folder/small.tsv"
mv "$folder/result.tsv" "$folder/small.tsv" .
{
  "$program" --version
  git -C ../.. describe --always --dirty --abbrev=12
  lscpu | sed -n 's/^Model name: *//p'
} >provenance.txt
