#!/usr/bin/env bash
# Recomputes result.tsv and compares it with expected.tsv. usage: run.sh [path/to/hexatlas]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
hexatlas=$(realpath "${1:-../../build/release/hexatlas}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

count() { # CELL INTERIOR ROAD [OPTION]: a line; a road that proves nothing exits with 4
  local options=()
  [[ $3 == spheres ]] && options=(--through-spheres)
  { "$hexatlas" enum triangulations "$1" --interior "$2" "${options[@]}" --json 2>/dev/null || [[ $? == 4 ]]; } |
    python3 -c 'import json, sys
said = json.load(sys.stdin)
print("triangulations", said["cell"], said["interior"], sys.argv[1], said["classes"], said["labelled"], sep="\t")' "$3"
}

lists() { # KIND VERTICES
  "$hexatlas" enum "$1" --vertices "$2" --json |
    python3 -c 'import json, sys
said = json.load(sys.stdin)
kind = sys.argv[1]
number = said[kind] if isinstance(said[kind], int) else len(said[kind])
more = said["classes"] if kind == "polyhedra" else "-"
print(kind, "-", said["vertices"], "-", number, more, sep="\t")' "$1"
}

conditions() { # CATALOGUE NAME: one line per condition asked
  "$hexatlas" check "$1" --json | python3 -c 'import json, sys
said = json.load(sys.stdin)
assert said["accepted"], said["reason"]
for condition in ("embedded", "convex", "jacobian"):
    counts = said[condition]
    if sum(counts.values()):
        print(condition, sys.argv[1], "-", "-", counts["realizable"], counts["refuted"], sep="\t")' "$2"
}

{
  printf 'object\tcell\tinterior or vertices\troad\tclasses or realizable\tlabelled or refuted\n'
  for case in "tetrahedron 0" "tetrahedron 1" "tetrahedron 2" "tetrahedron 3" "pyramid 0" "pyramid 1" \
    "pyramid 2" "pyramid 3" "prism 0" "prism 1" "prism 2" "octahedron 0" "octahedron 1" "octahedron 2" \
    "hexahedron 0" "hexahedron 1"; do
    for road in direct spheres; do
      # shellcheck disable=SC2086
      count $case "$road"
    done
  done
  for n in 5 6 7 8 9; do lists spheres "$n"; done
  for n in 4 5 6 7 8; do lists balls "$n"; done
  for n in 4 5 6 7 8; do lists polyhedra "$n"; done
  "$hexatlas" reproduce hexahedron-174 -o "$work" >"$work/log" || { cat "$work/log" >&2; exit 1; }
  conditions "$work/hexahedron.hxc" hexahedron
  "$hexatlas" enum balls --vertices 8 -o "$work/balls.hxc" >/dev/null
  "$hexatlas" realize "$work/balls.hxc" --quick -o "$work/realized.hxc" >/dev/null
  conditions "$work/realized.hxc" balls-8
} >result.tsv
diff expected.tsv result.tsv
cmp "$work/hexahedron.html" contact-sheet.html
echo "as expected"
