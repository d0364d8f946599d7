#!/usr/bin/env bash
# Times of Delaunay kernels side by side: rounds of one process each, all programs in turn.
# Needs a release build and Debian's libcgal-dev libtbb-dev libtet1.5-dev libgmsh-dev libgmp-dev libmpfr-dev.
# BUILD: the release build; ROUNDS: how often; SIZES: numbers of points.
set -euo pipefail
cd "$(dirname "$0")"
build="$(realpath "${BUILD:-../../build/release}")"
rounds="${ROUNDS:-5}"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

flags=(-std=c++20 -O3 -march=native -DNDEBUG -I../..)
g++ "${flags[@]}" hexatlas.cpp -o "$work/hexatlas" "$build/meshing/libmeshing_delaunay.a" \
  "$build/realize/librealize_exact.a" "$build/enum/libenum_parallel.a" -lgmpxx -lgmp -fopenmp
g++ "${flags[@]}" cgal.cpp -o "$work/cgal" -lgmp -lmpfr
g++ "${flags[@]}" -DPARALLEL -DCGAL_LINKED_WITH_TBB cgal.cpp -o "$work/cgal-parallel" -ltbb -ltbbmalloc -lgmp -lmpfr
g++ "${flags[@]}" -DTETLIBRARY tetgen.cpp -o "$work/tetgen" -ltet
g++ "${flags[@]}" hxt.cpp -o "$work/hxt" -lgmsh

{
  printf 'program\tkind\tpoints\tthreads\ttetrahedra\twall\tprocessor\tbytes_per_tetrahedron\n'
  for size in ${SIZES:-100000 1000000 5000000}; do
    for ((i = 0; i < rounds; ++i)); do
      for run in "hexatlas 1" "cgal 1" "hxt 1" "tetgen 1" "hexatlas 2" "cgal-parallel 2" "hxt 2"; do
        read -r program threads <<<"$run"
        "$work/$program" uniform "$size" "$threads"
      done
    done
  done
  for kind in clusters sphere paraboloid duplicates grid; do
    for ((i = 0; i < rounds; ++i)); do
      "$work/hexatlas" uniform 1000000 1
      "$work/hexatlas" "$kind" 1000000 1
      "$work/cgal" "$kind" 1000000 1
    done
  done
} >"$work/result.tsv"
mv "$work/result.tsv" result.tsv
python3 summary.py result.tsv
{
  git -C ../.. describe --always --dirty --abbrev=12
  dpkg-query -W libcgal-dev libtet1.5 libgmsh4.8 libtbb12
  lscpu | sed -n 's/^Model name: *//p'
  nproc
} >provenance.txt
