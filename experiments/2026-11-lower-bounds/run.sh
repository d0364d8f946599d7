#!/usr/bin/env bash
# How far exhaustive searches get, with certificates; some fifteen minutes, with LONG=1 an hour more. Needs a release build and GNU time.
set -euo pipefail
cd "$(dirname "$0")"
program="${PROGRAM:-../../build/release/hexatlas}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# Nodes and seconds of a search; "-" for INTERIOR is no limit of its own. With "log" also its certificate.
search() {
  local boundary="$1" kind="$2" hexes="$3" interior="$4" log="${5:-}"
  local options=("$boundary" --max-hexes "$hexes" --threads 1)
  [[ "$kind" == ball ]] && options+=(--ball)
  [[ "$interior" == - ]] || options+=(--max-interior "$interior")
  /usr/bin/time --output="$work/time" --format=%U "$program" enum hexmeshes "${options[@]}" --json >"$work/counts"
  local records=- bytes=- checked=-
  if [[ "$log" == log ]]; then
    "$program" enum hexmeshes "${options[@]}" --certificate "$work/bound.hxb" --json >"$work/made"
    records="$(python3 -c 'import json,sys; print(json.load(sys.stdin)["records"])' <"$work/made")"
    bytes="$(stat -c %s "$work/bound.hxb")"
    /usr/bin/time --output="$work/checked" --format=%U "$program" check "$work/bound.hxb" >/dev/null
    checked="$(cat "$work/checked")"
  fi
  python3 -c '
import json, sys
with open(sys.argv[1], encoding="utf-8") as file:
    counts = json.load(file)
assert counts["exhaustive"] and counts["classes"] == 0
print(*sys.argv[2:6], counts["nodes"], *sys.argv[6:], sep="\t")
' "$work/counts" "$boundary" "$kind" "$hexes" "$interior" "$(cat "$work/time")" "$records" "$bytes" "$checked"
}

{
  printf 'boundary\tkind\tmax_hexes\tmax_interior\tnodes\tseconds\trecords\tbytes\tseconds_of_check\n'
  for hexes in 12 13 14 15 16 17 18 19; do search schneiders-pyramid ball "$hexes" - log; done
  for hexes in 12 13 14 15 16; do search schneiders-pyramid any "$hexes" - log; done
  for hexes in 16 17 18 19 20 21 22 23; do search octagonal-spindle ball "$hexes" - log; done
  for interior in 9 11 13; do search schneiders-pyramid ball 64 "$interior" log; done
  search schneiders-pyramid ball 64 15
  if [[ -n "${LONG:-}" ]]; then search schneiders-pyramid ball 64 18; fi
} >"$work/result.tsv"
mv "$work/result.tsv" result.tsv
{
  git -C ../.. describe --always --dirty --abbrev=12
  lscpu | sed -n 's/^Model name: *//p'
  nproc
} >provenance.txt
