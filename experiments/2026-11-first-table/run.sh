#!/usr/bin/env bash
# Rebuilds the shipped table and fails if a count of hexahedra differs from expected.tsv.
set -euo pipefail
cd "$(dirname "$0")"
program="${HEXATLAS:-../../build/release/hexatlas}"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" table build -o "$folder/hexatlas.hxt" --max-quads 14 --also schneiders-pyramid
"$program" table check "$folder/hexatlas.hxt"
"$program" table info --json "$folder/hexatlas.hxt" | python3 -c '
import json, sys
for quads, row in json.load(sys.stdin)["by_quads"].items():
    print(quads, row["entries"], row["least"], row["greatest"], row["total"], sep="\t")
' >result.tsv
{
  git -C ../.. describe --always --dirty --abbrev=12
  "$program" --version
  lscpu | sed -n 's/^Model name: *//p'
} >provenance.txt
diff expected.tsv result.tsv
