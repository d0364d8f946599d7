#!/usr/bin/env bash
# Runs the benchmarks; result.tsv has the median of five repetitions of each, in its own unit.
set -euo pipefail
cd "$(dirname "$0")"
bench="${BENCH:-../../build/release/tests/enum/hexatlas_bench}"
"$bench" --benchmark_repetitions=5 --benchmark_report_aggregates_only=true \
  --benchmark_format=json 2>/dev/null | python3 -c '
import json, sys
print("benchmark", "median", "unit", "items_per_second", sep="\t")
for row in json.load(sys.stdin)["benchmarks"]:
    if row.get("aggregate_name") == "median":
        rate = row.get("items_per_second")
        print(row["run_name"], "%.3g" % row["real_time"], row["time_unit"],
              "" if rate is None else "%.3g" % rate, sep="\t")
' >result.tsv
{
  git -C ../.. describe --always --dirty --abbrev=12
  lscpu | sed -n 's/^Model name: *//p'
  nproc
} >provenance.txt
