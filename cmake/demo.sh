#!/usr/bin/env bash
# From a clone to a hexahedral mesh: installs what is missing, builds the program, meshes
# Schneiders' pyramid, and has the mesh checked by code that shares nothing with the mesher.
# usage: bash cmake/demo.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash cmake/packages.sh build

log=$(mktemp)
trap 'rm -f "$log"' EXIT
quietly() {
  printf 'demo: %s\n' "$1"
  shift
  "$@" >"$log" 2>&1 || {
    tail -n 60 "$log" >&2
    printf 'demo: failed: %s\n' "$*" >&2
    exit 1
  }
}

# The folder of the tests' own release build: neither build repeats the work of the other.
quietly 'configuring' cmake --preset release -DHEXATLAS_TESTS=OFF
quietly 'building, some minutes at the first time' cmake --build build/release --parallel "$(nproc)"

boundary=experiments/2026-11-quad-balls/inputs/schneiders-pyramid.obj
mesh=build/schneiders-pyramid.vtu
printf 'demo: meshing %s\n' "$boundary"
build/release/hexatlas mesh hex "$boundary" -o "$mesh"
printf 'demo: checking %s\n' "$mesh"
build/release/hexatlas check "$mesh" --boundary "$boundary"
printf 'demo: made the program build/release/hexatlas and the mesh %s (open it in ParaView)\n' "$mesh"
