#!/usr/bin/env bash
# Meshes and checks every input; writes result.tsv and provenance.txt beside this file.
# usage: [HEXATLAS=path/to/hexatlas] ./run.sh [folder for the meshes]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

hexatlas=${HEXATLAS:-../../build/release/hexatlas}
out=${1:-$(mktemp -d)}
mkdir -p "$out"
python3 generate.py --check >"$out/generate.log"

partial=$(mktemp "${PWD}/result.XXXXXX.tmp")
trap 'rm -f "$partial"' EXIT
printf 'name\tquads\thexahedra\tinterior_vertices\tmin_scaled_jacobian\tinverted\tchecked\n' >"$partial"
status=0
for input in inputs/*.obj; do
  name=$(basename "$input" .obj)
  row=$name$'\t'$(grep -c '^f ' "$input")
  mesh_status=0
  "$hexatlas" mesh hex "$input" -o "$out/$name.vtu" --json >"$out/$name.json" || mesh_status=$?
  if ((mesh_status != 0)); then
    printf '%s\t-\t-\t-\t-\texit %d\n' "$row" "$mesh_status" >>"$partial"
    status=1
    continue
  fi
  figures=$(python3 - "$out/$name.json" <<'PYTHON'
import json, sys
with open(sys.argv[1], encoding="utf-8") as file:
    summary = json.load(file)
keys = ("hexahedra", "interior_vertices", "min_scaled_jacobian", "inverted")
print("\t".join(f"{summary[k]:.4f}" if isinstance(summary[k], float) else str(summary[k]) for k in keys))
PYTHON
  )
  verdict=yes
  "$hexatlas" check "$out/$name.vtu" --boundary "$input" >"$out/$name.check" || verdict="exit $?"
  [[ $verdict == yes ]] || status=1
  printf '%s\t%s\t%s\n' "$row" "$figures" "$verdict" >>"$partial"
done

{
  "$hexatlas" --version
  printf 'commit %s\n' "$(git rev-parse HEAD 2>/dev/null || echo unknown)"
  printf 'machine %s\n' "$(uname -sm)"
} >provenance.txt
chmod 644 "$partial"
mv "$partial" result.tsv
trap - EXIT
cat result.tsv
exit "$status"
