#!/usr/bin/env bash
# What bounds the shipped table claims, and whether certificates of a sample of them are accepted.
# With --search it makes the bounds again, which takes an hour. Needs a release build.
set -euo pipefail
cd "$(dirname "$0")"
program="${HEXATLAS:-../../build/release/hexatlas}"
table=../../tables/data/hexatlas.hxt
if [[ "${1:-}" == --search ]]; then
  "$program" table bounds "$table" -o bounds.hxt --max-hexes 12
  "$program" table bounds bounds.hxt -o bounds.hxt --max-hexes 15 --max-quads 16
  "$program" table bounds bounds.hxt -o bounds.hxt --max-hexes 17 --max-quads 14
  "$program" table bounds bounds.hxt -o bounds.hxt --max-hexes 19 --only schneiders-pyramid
  "$program" table bounds bounds.hxt -o bounds.hxt --max-hexes 23 --only octagonal-spindle
fi
python3 -B bounds.py "$table" >result.tsv
python3 -B sample.py "$program" "$table" "${SAMPLE:-200}" >sample.tsv
{
  git -C ../.. describe --always --dirty --abbrev=12
  lscpu | sed -n 's/^Model name: *//p'
  nproc
} >provenance.txt
