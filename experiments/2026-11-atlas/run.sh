#!/usr/bin/env bash
# Measures the shipped table: what it holds, how long the judge and queries take, what kills cost.
# With --search it repeats the search first, which takes hours and 16 GiB.
set -euo pipefail
cd "$(dirname "$0")"
program="${HEXATLAS:-../../build/release/hexatlas}"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if [[ "${1:-}" == --search ]]; then
  plain=(--symmetric 0) # the runs before symmetric collars
  "$program" table build -o hexatlas.hxt --state hexatlas.state "${plain[@]}"
  "$program" table build -o hexatlas-22.hxt --max-quads 22 --start-from hexatlas.state \
    --rounds 1 --max-hexahedra 1 --cut 2000 --cuts-each 4 --collared 0 "${plain[@]}"
  "$program" table build -o hexatlas-again.hxt --start-from hexatlas-22.hxt --rounds 1 --width 60000 \
    --per-class 30 --cut 60 --cuts-each 12 --cut-growths 2000 --cut-interior 7 --cut-uphill 6 --collared 0 \
    "${plain[@]}"
  "$program" table build -o hexatlas-wide.hxt --state wide.state --start-from hexatlas-again.hxt \
    --width 900000 --per-class 200 --max-hexahedra 50 --rounds 1 --cut 0 --collared 0 --growths 1 \
    "${plain[@]}"
  "$program" table build -o hexatlas-wider.hxt --start-from wide.state --width 900000 --per-class 200 \
    --max-hexahedra 50 --rounds 1 --cut 60 --cuts-each 6 --cut-growths 600 --cut-interior 6 --cut-uphill 6 \
    "${plain[@]}" --growths 8 --collared 1 --collar-hexahedra 32 --collar-widest 30 --collar-width 100000 --collar-narrow 3
  wide=(--width 900000 --per-class 200 --seed 20261124 --rounds 1 --cut 0 --collar-widest 30 --collar-narrow 3)
  "$program" table build -o hexatlas-third.hxt --state third.state --start-from hexatlas-wider.hxt "${wide[@]}" \
    "${plain[@]}" --max-hexahedra 50 --growths 4 --collared 9 --collar-hexahedra 32 --collar-width 100000
  "$program" table build -o hexatlas-deep.hxt --state deep.state --start-from third.state "${wide[@]}" \
    "${plain[@]}" --max-hexahedra 1 --growths 0 --collared 8 --collar-hexahedra 36 --collar-width 300000
  "$program" table build -o hexatlas-last.hxt --start-from deep.state hexatlas-third.hxt "${wide[@]}" \
    "${plain[@]}" --max-hexahedra 1 --growths 12 --collared 0
  "$program" table build -o hexatlas-symmetric.hxt --state symmetric.state --start-from deep.state hexatlas-last.hxt \
    "${wide[@]}" --max-hexahedra 1 --growths 0 --collared 0 --symmetric 330 --symmetric-hexahedra 44 \
    --symmetric-width 3000 --symmetric-widest 36
  "$program" table build -o hexatlas-final.hxt --start-from symmetric.state hexatlas-symmetric.hxt "${wide[@]}" \
    --max-hexahedra 1 --growths 12 --collared 0 --symmetric 1 --symmetric-hexahedra 52 --symmetric-width 200000 \
    --symmetric-widest 40
fi
"$program" table info --by quads --json | python3 -c '
import json, sys
print("quads", "meshes", "least", "mean", "median", "most", sep="\t")
for quads, row in json.load(sys.stdin)["by_quads"].items():
    print(quads, row["entries"], row["least"], "%.2f" % row["mean"], row["median"],
          row["greatest"], sep="\t")
' >result.tsv
"$program" table info --by quads --svg hexahedra.svg >/dev/null
{
  TIMEFORMAT=$'table check, seconds on one core\t%U'
  time taskset -c 0 "$program" table check >/dev/null
} 2>check.tsv
{
  printf 'quads\tqueries\tper cent filled\tmedian s\t95 %% s\tmost s\tmean hexahedra\tmost\n'
  python3 -B queries.py "$program" 22 500
  python3 -B queries.py "$program" 24 500
} >queries.tsv
python3 -B kills.py "$program" "$folder" >kills.tsv
python3 -B corruptions.py "$program" ../../tables/data/hexatlas.hxt "$folder" >corruptions.tsv
python3 -B removals.py "$program" ../../tables/data/hexatlas.hxt "$folder" "${REMOVALS:-8}" >removals.tsv
{
  git -C ../.. describe --always --dirty --abbrev=12
  "$program" --version
  lscpu | sed -n 's/^Model name: *//p'
} >provenance.txt
