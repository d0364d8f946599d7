#!/usr/bin/env bash
# Every check of the project; the last line is "N passed, N failed", N skipped may follow.
# usage: bash cmake/test.sh           [HEXATLAS_FAST=once|twice, default once] [HEXATLAS_TIDY=..., default all]
# HEXATLAS_FAST, the tests labelled fast:
#   once     under sanitizers, which see more
#   twice    in the release build as well; before a release
# HEXATLAS_TIDY:
#   all      clang-tidy without the static analyzer, which takes two thirds of its time
#   deep     with the static analyzer; before a release
#   changed  deep, but only on what changed since HEXATLAS_TIDY_BASE, default HEAD~1
#   off
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

results=$PWD/build/test-results
jobs=$(nproc)
rm -rf "$results"
mkdir -p "$results"

# AddressSanitizer spends a third of its time on the stack of each allocation and on keeping freed
# memory for long; what is used after it was freed mostly is so at once. An error's own stack is whole; for
# those of its memory, set ASAN_OPTIONS=malloc_context_size=30.
export ASAN_OPTIONS=${ASAN_OPTIONS:-malloc_context_size=1:quarantine_size_mb=1:thread_local_quarantine_size_kb=64}
# Several tests run at once: threads that wait must not keep a processor busy.
export OMP_WAIT_POLICY=${OMP_WAIT_POLICY:-passive}

# With the time since the beginning, so that one sees where it goes.
say() { printf '\n== %d:%02d %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"; }

# A step that fails outside a test program is one failed test of that name.
record() { # NAME failed|passed
  local outcome=
  [[ $2 == passed ]] || outcome='<failure message="see the output above"/>'
  printf '<testsuite name="steps"><testcase name="%s">%s</testcase></testsuite>\n' \
    "$1" "$outcome" >"$results/step-$1.xml"
}

# Runs at any exit, so that the last line is there whatever happened before.
reached_end=no
finish() {
  trap - EXIT
  [[ $reached_end == yes ]] || record not-all-steps-ran failed
  if ! command -v python3 >/dev/null; then
    printf '0 passed, 1 failed\n'
    exit 1
  fi
  say summary
  python3 cmake/junit_summary.py "$results" || exit 1
}
trap finish EXIT

step() { # NAME COMMAND...: runs it; a failure is recorded and returned
  local name=$1
  shift
  say "$name: $*"
  if "$@" >"$results/$name.log" 2>&1; then
    return 0
  fi
  tail -n 60 "$results/$name.log"
  record "$name" failed
  return 1
}

# ThreadSanitizer of clang 14 needs an address layout that recent kernels randomize too much.
fixed_layout() {
  if setarch "$(uname -m)" -R true 2>/dev/null; then
    setarch "$(uname -m)" -R "$@"
  else
    "$@"
  fi
}

# clang, clang-tidy and lld take an eighth less time with their memory in large pages.
in_large_pages=${GLIBC_TUNABLES:+$GLIBC_TUNABLES:}glibc.malloc.hugetlb=1

build() { # PRESET [TARGET...]
  local -x GLIBC_TUNABLES=$in_large_pages
  local preset=$1
  shift
  step "configure-$preset" cmake --preset "$preset" \
    -DHEXATLAS_TESTS=ON -DHEXATLAS_WERROR=ON || return 1
  step "build-$preset" fixed_layout cmake --build "build/$preset" --parallel "$jobs" \
    ${1:+--target "$@"}
}

run_tests() { # PRESET LABEL...
  local preset=$1 report="$results/ctest-$1.xml" labels
  shift
  labels="^($(IFS='|' && echo "$*"))\$"
  say "ctest $preset $labels"
  # One more than there are processors, since some wait for a disk or a browser.
  if fixed_layout ctest --test-dir "build/$preset" --parallel $((jobs + 1)) --timeout 900 \
    --output-on-failure --no-tests=error --output-junit "$report" --label-regex "$labels" \
    >"$results/ctest-$preset.log" 2>&1; then
    return 0
  fi
  tail -n 100 "$results/ctest-$preset.log"
  # Failed tests are in the report; anything else that stopped ctest is not.
  if [[ ! -s $report ]] || python3 cmake/junit_summary.py "$report" >/dev/null; then
    record "ctest-$preset" failed
  fi
}

# Tests in a sanitizer's build, which makes only what they run and must have all that release has. Programs of
# GoogleTest run as one test each there and report their tests themselves.
run_sanitized() { # PRESET LABEL...
  local preset=$1 label
  shift
  build "$preset" "${@/#/tests_}" || return 0
  for label in "$@"; do
    step "same-tests-$preset-$label" \
      diff "build/release/tests_$label.txt" "build/$preset/tests_$label.txt" || true
  done
  GTEST_OUTPUT=xml:$results/ run_tests "$preset" "$@"
}

# The libraries and the program: for `all` the units that build/release compiles, which are joined
# further, since most of the time goes into the headers; otherwise file by file.
own_sources() { # all|deep|changed
  local folders=(enum realize tables meshing cli)
  case $1 in
    all)
      sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' build/release/compile_commands.json |
        grep -E "^$PWD/(build/release/.*/Unity/unity_|($(IFS='|' && echo "${folders[*]}"))/).*[.]c(pp|xx)$" |
        grep -v "^$PWD/build/release/tests/" | sort
      ;;
    deep) find "${folders[@]}" -name '*.cpp' | sort ;;
    changed)
      git diff --name-only --diff-filter=d "${HEXATLAS_TIDY_BASE:-HEAD~1}" -- "${folders[@]/%//*.cpp}"
      ;;
  esac
}

# The units of a joined one are looked at one by one if something is found, which is theirs to answer for:
# unnamed namespaces that collide, or headers that do, are no fault of theirs.
tidy_unit() { # UNIT, or JOINED<tab>UNIT<tab>UNIT...
  local units unit failed=0
  IFS=$'\t' read -ra units <<<"$1"
  if ((${#units[@]} > 1)); then
    run_tidy build/joined "${units[0]}" >/dev/null 2>&1 && return
    echo "${units[0]}: its units one by one"
    units=("${units[@]:1}")
  fi
  for unit in "${units[@]}"; do run_tidy "$tidy_commands" "$unit" || failed=1; done
  return $failed
}

run_tidy() { # FOLDER FILE
  clang-tidy --quiet --extra-arg=-Wno-unknown-warning-option --checks="$tidy_checks" -p "$1" "$2"
}

tidy() { # all|deep|changed
  local units
  local -x GLIBC_TUNABLES=$in_large_pages
  export tidy_commands=build/release tidy_checks='-clang-analyzer-*'
  export -f tidy_unit run_tidy
  units=$(own_sources "$1") || return 1
  if [[ $1 == all ]]; then
    units=$(python3 cmake/joined_units.py build/release build/joined <<<"$units") || return 1
  else
    tidy_commands=build/apart tidy_checks=
    cmake --preset release -B build/apart -DHEXATLAS_UNITY=OFF || return 1
  fi
  # shellcheck disable=SC2016  # for the inner shell
  xargs --no-run-if-empty --delimiter='\n' --max-procs="$jobs" --max-args=1 \
    bash -c 'tidy_unit "$1"' - <<<"$units"
}

step packages bash cmake/packages.sh compile-tests
# The larger part, which is needed to run tests only, comes while they are compiled.
bash cmake/packages.sh test >"$results/packages-test.log" 2>&1 &
rest_of_packages=$!
released=(source whole program threads long)
[[ ${HEXATLAS_FAST:-once} == once ]] || released+=(fast)
build release hexatlas hexatlas_bench "${released[@]/#/tests_}" && is_built=yes || is_built=no
if ! wait "$rest_of_packages"; then
  cat "$results/packages-test.log"
  record packages-test failed
  exit 1
fi

if [[ $is_built == yes ]]; then
  if step headers cmake --build build/release --parallel "$jobs" \
    --target all_verify_interface_header_sets; then
    record headers passed
  fi
  run_tests release "${released[@]}"
  if [[ ${HEXATLAS_TIDY:-all} != off ]] && step clang-tidy tidy "${HEXATLAS_TIDY:-all}"; then
    record clang-tidy passed
  fi
fi
run_sanitized asan fast program
run_sanitized tsan threads
reached_end=yes
