#!/usr/bin/env bash
# Swept bodies and stacks of them, random ones and some with names. Needs a release build. BODIES: how many random ones of
# either kind; fewer give the first lines of the same table. FOLDER: of another experiment with a measure.py alike.
# usage: run.sh [FOLDER]
set -euo pipefail
cd "${1:-$(dirname "$0")}"
program="$(realpath "${PROGRAM:-../../build/release/hexatlas}")"
commit="$(git -C ../.. describe --always --dirty --abbrev=12)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
export PYTHONDONTWRITEBYTECODE=1

python3 measure.py "$program" "${BODIES:-60}" >"$work/result.tsv"
mv "$work/result.tsv" result.tsv
echo "$commit" >provenance.txt
