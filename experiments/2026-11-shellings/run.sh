#!/usr/bin/env bash
# Counts of shellable balls with time and memory of each number of hexahedra; minutes.
# Needs a release build and GNU time.
set -euo pipefail
cd "$(dirname "$0")"
program="${PROGRAM:-../../build/release/hexatlas}"
most="${MOST:-10}"
: >measured.tmp
trap 'rm -f measured.tmp counts.tmp' EXIT
for ((hexes = 1; hexes <= most; ++hexes)); do
  /usr/bin/time --append --output=measured.tmp --format="$hexes %e %M" \
    "$program" enum shellings --hexes "$hexes" --threads 2 --json >counts.tmp
done
python3 - >result.tsv <<'END'
import json
with open("counts.tmp", encoding="utf-8") as file:
    counts = json.load(file)
assert counts["exhaustive"]
with open("measured.tmp", encoding="utf-8") as file:
    measured = {int(h): (s, int(kib) // 1024) for h, s, kib in map(str.split, file)}
print("hexahedra", "meshes", "boundaries", "new_boundaries", "seconds", "MiB", sep="\t")
for row in counts["by_hexes"]:
    print(row["hexes"], row["meshes"], row["boundaries"], row["new_boundaries"],
          *measured[row["hexes"]], sep="\t")
END
{
  git -C ../.. describe --always --dirty --abbrev=12
  lscpu | sed -n 's/^Model name: *//p'
  nproc
} >provenance.txt
