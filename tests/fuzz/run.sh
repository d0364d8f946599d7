#!/bin/sh
# Runs each fuzz target over its corpus, one process at a time.
# usage: run.sh BUILD_DIRECTORY [RUNS_PER_TARGET] [SEED]
# The corpus of the repository is read only; new inputs go to BUILD_DIRECTORY/fuzz-corpus, findings
# to BUILD_DIRECTORY/fuzz-findings. Exits with 1 at the first finding.
set -eu
build=${1:?usage: run.sh BUILD_DIRECTORY [RUNS_PER_TARGET] [SEED]}
runs=${2:-1200000}
seed=${3:-1}
here=$(cd "$(dirname "$0")" && pwd)
for format in obj off vtk vtu medit gmsh xyz raw ply hxtet code judge table; do
  target=$(find "$build" -type f -name "fuzz_$format" -perm -u+x | head -n 1)
  [ -n "$target" ] || { echo "run.sh: fuzz_$format is not built in $build" >&2; exit 1; }
  mkdir -p "$build/fuzz-corpus/$format" "$build/fuzz-findings"
  echo "== $format: $runs runs, seed $seed"
  log=$build/fuzz-findings/$format.log
  dictionary=$here/dictionaries/$format.dict
  [ -f "$dictionary" ] || dictionary=/dev/null
  if nice "$target" "$build/fuzz-corpus/$format" "$here/corpus/$format" \
    -dict="$dictionary" -runs="$runs" -seed="$seed" -max_len=2048 \
    -timeout=10 -rss_limit_mb=1024 -malloc_limit_mb=256 -print_final_stats=1 \
    -artifact_prefix="$build/fuzz-findings/$format-" >"$log" 2>&1; then
    grep -E "number_of_executed_units|average_exec_per_sec|peak_rss_mb" "$log"
  else
    tail -n 40 "$log"
    exit 1
  fi
done
