#!/usr/bin/env bash
# Needs gmsh 4.8.4 and a release build.   usage: run.sh [HEXATLAS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
program=$(realpath "${1:-../../build/release/hexatlas}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
python3 solids.py "$scratch"
python3 measure.py "$program" "$scratch" >result.tsv
