#!/usr/bin/env bash
# Makes starting meshes, simplifies them in several ways, and writes result.tsv.
set -euo pipefail
cd "$(dirname "$0")"
build="${HEXATLAS_BUILD:-../../build/release}"
program="$build/hexatlas"
blow_up="$build/tests/meshing/meshing_simplify_blow_up"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -B starts.py "$program" "$folder"

# simplify NAME MESH OPTIONS: one row
simplify() {
  "$program" simplify "$folder/$2" -o "$folder/out.mesh" --json "${@:3}" |
    python3 -c '
import json, sys
said = json.load(sys.stdin)
print(sys.argv[1], sys.argv[2], said["before"], said["after"], said["exchanges"], "%.1f" % said["seconds"], sep="\t")
' "$1" "${*:3}"
  "$program" check "$folder/out.mesh" >/dev/null
}

# ways NAME MESH: the ways to simplify it
ways() {
  simplify "$1" "$2" --uphill 4 --tries 40000
  simplify "$1" "$2" --uphill 4 --tries 40000 --parts
  simplify "$1" "$2" --uphill 4 --tries 40000 --parts --cavity 14
  simplify "$1" "$2" --uphill 4 --tries 40000 --parts --no-table
}

{
  printf 'start\toptions\tbefore\tafter\texchanges\tseconds\n'
  ways "pyramid, glued" glued.mesh
  for seed in 1 2 3; do
    "$blow_up" "$folder/glued.mesh" "$folder/start.mesh" 88 "$seed" 0
    ways "pyramid, wrapped, seed $seed" start.mesh
  done
  for seed in 1 2 3; do
    "$blow_up" "$folder/glued.mesh" "$folder/start.mesh" 88 "$seed" 300
    ways "pyramid, wrapped and mixed, seed $seed" start.mesh
  done
  for seed in 1 2; do
    "$blow_up" "$folder/spindle.mesh" "$folder/start.mesh" 88 "$seed" 300
    ways "spindle, wrapped and mixed, seed $seed" start.mesh
  done
  "$blow_up" "$folder/grid.mesh" "$folder/start.mesh" 10000 1 0
  simplify "box of 1000, wrapped" start.mesh --tries 200000
} >result.tsv
{
  git -C ../.. describe --always --dirty --abbrev=12
  "$program" --version
  lscpu | sed -n 's/^Model name: *//p'
} >provenance.txt
