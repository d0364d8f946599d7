#!/usr/bin/env bash
# Measures the shipped table: what it holds, how long the judge and queries take, what kills cost.
# With --search it repeats the search first, which takes hours and 16 GiB.
set -euo pipefail
cd "$(dirname "$0")"
program="${HEXATLAS:-../../build/release/hexatlas}"
commit=$(git -C ../.. describe --always --dirty --abbrev=12) # before the results change
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if [[ "${1:-}" == --search ]]; then
  build() { "$program" table build --anneal-symmetric 0 "$@"; } # all this was before annealing that keeps an involution
  plain=(--symmetric 0 --anneal-faulty 0 --anneal-cut 0 --anneal-transplant 0) # the runs before symmetric collars, and before beginnings with faults
  build -o hexatlas.hxt --state hexatlas.state "${plain[@]}"
  build -o hexatlas-22.hxt --max-quads 22 --start-from hexatlas.state \
    --rounds 1 --max-hexahedra 1 --cut 2000 --cuts-each 4 --collared 0 "${plain[@]}"
  build -o hexatlas-again.hxt --start-from hexatlas-22.hxt --rounds 1 --width 60000 \
    --per-class 30 --cut 60 --cuts-each 12 --cut-growths 2000 --cut-interior 7 --cut-uphill 6 --collared 0 \
    "${plain[@]}"
  build -o hexatlas-wide.hxt --state wide.state --start-from hexatlas-again.hxt \
    --width 900000 --per-class 200 --max-hexahedra 50 --rounds 1 --cut 0 --collared 0 --growths 1 \
    "${plain[@]}"
  build -o hexatlas-wider.hxt --start-from wide.state --width 900000 --per-class 200 \
    --max-hexahedra 50 --rounds 1 --cut 60 --cuts-each 6 --cut-growths 600 --cut-interior 6 --cut-uphill 6 \
    "${plain[@]}" --growths 8 --collared 1 --collar-hexahedra 32 --collar-widest 30 --collar-width 100000 --collar-narrow 3
  wide=(--width 900000 --per-class 200 --seed 20261124 --rounds 1 --cut 0 --collar-widest 30 --collar-narrow 3)
  build -o hexatlas-third.hxt --state third.state --start-from hexatlas-wider.hxt "${wide[@]}" \
    "${plain[@]}" --max-hexahedra 50 --growths 4 --collared 9 --collar-hexahedra 32 --collar-width 100000
  build -o hexatlas-deep.hxt --state deep.state --start-from third.state "${wide[@]}" \
    "${plain[@]}" --max-hexahedra 1 --growths 0 --collared 8 --collar-hexahedra 36 --collar-width 300000
  build -o hexatlas-last.hxt --start-from deep.state hexatlas-third.hxt "${wide[@]}" \
    "${plain[@]}" --max-hexahedra 1 --growths 12 --collared 0
  build -o hexatlas-symmetric.hxt --state symmetric.state --start-from deep.state hexatlas-last.hxt \
    "${wide[@]}" --max-hexahedra 1 --growths 0 --collared 0 --symmetric 330 --symmetric-hexahedra 44 \
    --symmetric-width 3000 --symmetric-widest 36
  build -o hexatlas-final.hxt --state final.state --start-from symmetric.state hexatlas-symmetric.hxt "${wide[@]}" \
    --max-hexahedra 1 --growths 12 --collared 0 --symmetric 1 --symmetric-hexahedra 52 --symmetric-width 200000 \
    --symmetric-widest 40
  more=(--width 900000 --per-class 200 --seed 20261124 --rounds 1 --collar-widest 26 --collar-hexahedra 14 "${plain[@]}")
  build -o hexatlas-swept.hxt --state swept.state --start-from final.state hexatlas-final.hxt \
    "${more[@]}" --cut 0 --max-hexahedra 54 --growths 4 --collared 0
  build -o hexatlas-collared.hxt --state collared.state --start-from swept.state hexatlas-swept.hxt \
    "${more[@]}" --cut 0 --max-hexahedra 1 --growths 0 --collared 1574 --collar-width 3000
  build -o hexatlas-exchanged.hxt --start-from collared.state hexatlas-collared.hxt \
    "${more[@]}" --cut 12 --cuts-each 8 --cut-growths 20000 --cut-interior 6 --cut-uphill 8 --max-hexahedra 1 \
    --growths 0 --collared 0
  build -o hexatlas-twice.hxt --state twice.state --start-from collared.state hexatlas-collared.hxt \
    "${more[@]}" --cut 0 --max-hexahedra 52 --growths 4 --collared 1500 --collar-width 5000
  build -o hexatlas-long.hxt --state long.state --start-from twice.state hexatlas-exchanged.hxt \
    "${more[@]}" --cut 1030 --cuts-each 1 --cut-growths 3000 --cut-interior 2 --cut-uphill 6 --max-hexahedra 1 \
    --growths 0 --collared 0
  build -o hexatlas-end.hxt --state end.state --start-from long.state hexatlas-long.hxt \
    "${more[@]}" --cut 3 --cuts-each 8 --cut-growths 20000 --cut-interior 6 --cut-uphill 8 --max-hexahedra 54 \
    --growths 4 --collared 0
  # A sweep whose targets have 22 quads, too, then annealing. Its rounds were of eight walks once; of two, as today, they are four
  # times as many.
  none=(--cut 0 --symmetric 0 --collared 0 --growths 0 --rounds 1 --anneal-faulty 0 --anneal-cut 0 --anneal-transplant 0)
  again=(--width 900000 --per-class 200 --seed 20261124 "${none[@]}")
  build -o swept-22.hxt --state swept-22.state --max-quads 22 --start-from hexatlas-end.hxt "${again[@]}" \
    --max-hexahedra 58
  build -o annealed.hxt --state annealed.state --start-from swept-22.state "${again[@]}" --max-hexahedra 1 \
    --annealed 40 --anneal-rounds 240
  build -o annealed-long.hxt --start-from annealed.state "${again[@]}" --max-hexahedra 1 --annealed 3 --anneal-rounds 18000
  build -o hexatlas-annealed.hxt --start-from annealed-long.hxt hexatlas-end.hxt --width 1 --per-class 1 "${none[@]}" \
    --max-hexahedra 1
  # Another sweep; then annealing that begins with many meshes: for the two largest, then with more for the largest.
  fresh=(--width 900000 --per-class 200 --seed 20261125 --growths 0 --cut 0 --symmetric 0 --collared 0 --rounds 1)
  thick=(--collar-hexahedra 30 --collar-widest 30 --collar-narrow 3 --symmetric-hexahedra 58 --anneal-rounds 240 --anneal-faulty 0 --anneal-cut 0 --anneal-transplant 0)
  build -o fresh.hxt --state fresh.state --start-from hexatlas-annealed.hxt "${fresh[@]}" --max-hexahedra 58
  build -o two.hxt --state two.state --start-from fresh.state fresh.hxt "${fresh[@]}" "${thick[@]}" \
    --max-hexahedra 1 --annealed 2 --anneal-starts 60 --symmetric-width 6000 --symmetric-widest 40 --collar-width 3000
  build -o one.hxt --start-from two.state two.hxt "${fresh[@]}" "${thick[@]}" --max-hexahedra 1 \
    --annealed 1 --anneal-starts 160 --symmetric-width 4000 --symmetric-widest 38 --collar-width 500
  build -o hexatlas-begun.hxt --start-from hexatlas-annealed.hxt one.hxt --width 1 --per-class 1 "${none[@]}" \
    --max-hexahedra 1
  # 22 quads anew: the trapezohedron; flips within 22 quads; then collars and cuts for what is missing.
  known=(--width 900000 --per-class 200 --seed 20261124 --rounds 1 --max-hexahedra 1 --growths 0)
  build -o trapezohedron-22.hxt --state 22.state --also q1:0888888888a55555dfffff \
    --start-from swept.state "${known[@]}" --cut 0 --collared 0 --symmetric 1 --symmetric-hexahedra 56 \
    --symmetric-width 200000 --symmetric-widest 40
  build -o known-22.hxt --max-quads 22 --start-from 22.state "${known[@]}" --cut 0 --collared 0 "${plain[@]}"
  build -o flips-22.hxt --max-quads 22 --start-from known-22.hxt --width 1500000 --per-class 20 \
    --widest 22 --seed 20261124 --rounds 1 --max-hexahedra 62 --growths 0 --cut 0 --collared 0 "${plain[@]}"
  build -o collared-22.hxt --state collared-22.state --max-quads 22 --start-from twice.state \
    trapezohedron-22.hxt flips-22.hxt "${known[@]}" --cut 0 "${plain[@]}" --collared 1 --collar-hexahedra 6 \
    --collar-width 100 --collar-widest 24
  build -o further-22.hxt --state further-22.state --max-quads 22 --start-from collared-22.state \
    "${known[@]}" --cut 0 "${plain[@]}" --collared 15480 --collar-hexahedra 9 --collar-width 800 --collar-widest 24
  build -o cut-22.hxt --state cut-22.state --max-quads 22 --start-from further-22.state "${known[@]}" \
    "${plain[@]}" --cut 8890 --cuts-each 1 --cut-growths 300 --collared 100 --collar-hexahedra 12 --collar-width 2000 \
    --collar-widest 26
  build -o largest-22.hxt --state largest-22.state --max-quads 22 --start-from cut-22.state "${known[@]}" \
    "${plain[@]}" --cut 250 --cuts-each 2 --cut-growths 1000 --cut-interior 2 --cut-uphill 6 --collared 1500 \
    --collar-hexahedra 10 --collar-width 1000 --collar-widest 26
  build -o one-22.hxt --max-quads 6 --also q1:00888a66977f88a9777fff --start-from largest-22.state \
    "${known[@]}" --cut 1 --cuts-each 4 --cut-growths 5000 --cut-uphill 6 --symmetric 1 --symmetric-hexahedra 36 \
    --symmetric-width 3000 --symmetric-widest 36 --collared 1 --collar-hexahedra 18 --collar-width 10000 --collar-widest 28
  build -o hexatlas-22-anew.hxt --max-quads 22 --start-from largest-22.state one-22.hxt "${known[@]}" \
    "${plain[@]}" --cut 0 --collared 0
  # 22 quads as one file, from the table of 20 of today: a sweep, flips within 22 quads, collars, cuts, a sweep again.
  six=(--seed 20261126 --rounds 1 --growths 0)
  broad=(--width 900000 --per-class 200 --max-quads 22 "${six[@]}")
  build -o swept-22.hxt --state swept-22.state --start-from hexatlas-begun.hxt "${broad[@]}" "${plain[@]}" \
    --max-hexahedra 58 --cut 0 --collared 0
  build -o flips-22.hxt --max-quads 22 --start-from swept-22.hxt --width 1500000 --per-class 20 --widest 22 \
    "${six[@]}" "${plain[@]}" --max-hexahedra 62 --cut 0 --collared 0
  build -o collared-22.hxt --state collared-22.state --start-from swept-22.state flips-22.hxt "${broad[@]}" \
    "${plain[@]}" --max-hexahedra 1 --cut 0 --collared 1 --collar-hexahedra 6 --collar-width 100 --collar-widest 24
  build -o further-22.hxt --state further-22.state --start-from collared-22.state "${broad[@]}" "${plain[@]}" \
    --max-hexahedra 1 --cut 0 --collared 20000 --collar-hexahedra 9 --collar-width 800 --collar-widest 24
  build -o cut-22.hxt --state cut-22.state --start-from further-22.state "${broad[@]}" "${plain[@]}" \
    --max-hexahedra 1 --cut 8900 --cuts-each 1 --collared 100 --collar-hexahedra 12 --collar-width 2000 --collar-widest 26
  build -o largest-22.hxt --state largest-22.state --start-from cut-22.state "${broad[@]}" \
    --max-hexahedra 1 --cut 1200 --cuts-each 1 --cut-growths 1000 --cut-interior 2 --cut-uphill 6 --symmetric 1 \
    --symmetric-hexahedra 56 --symmetric-width 30000 --symmetric-widest 40 --collared 0
  build -o annealed-22.hxt --start-from largest-22.state "${broad[@]}" "${plain[@]}" --max-hexahedra 1 --cut 0 \
    --collared 0 --annealed 20 --anneal-starts 4 --anneal-rounds 160 --collar-hexahedra 14 --collar-width 1500 \
    --collar-widest 28 --collar-narrow 3 --symmetric-hexahedra 50 --symmetric-width 1000 --symmetric-widest 38
  build -o again-22.hxt --state again-22.state --start-from annealed-22.hxt hexatlas-begun.hxt "${broad[@]}" "${plain[@]}" \
    --max-hexahedra 64 --cut 0 --collared 0
  last=(--width 1 --per-class 1 "${six[@]}" "${plain[@]}" --max-hexahedra 1 --cut 0 --collared 0)
  build -o hexatlas-now.hxt --start-from hexatlas-begun.hxt again-22.hxt "${last[@]}"
  build -o hexatlas-22.hxt --max-quads 22 --start-from hexatlas-now.hxt again-22.hxt "${last[@]}"
  # A wider sweep and annealing of many, in a contest that went on with the promising meshes; each was stopped, after 8 and after 33
  # minutes, and the table made of what it had saved; the second one went on then for 100 minutes.
  beginnings=(--collar-widest 28 --collar-narrow 3 --symmetric-hexahedra 50 --symmetric-widest 38)
  many=(--anneal-rounds 160 --anneal-leaps 0 "${beginnings[@]}")
  quiet=(--rounds 1 --growths 0 --cut 0 --collared 0 "${plain[@]}")
  build -o contest.hxt --start-from again-22.state hexatlas-now.hxt --width 900000 --per-class 200 --seed 20261126 \
    --max-hexahedra 1 "${quiet[@]}" "${many[@]}" --annealed 142 --anneal-starts 8 --collar-hexahedra 24 --collar-width 1500 --symmetric-width 1000
  wider=(--width 2200000 --per-class 200 --seed 20261127 "${quiet[@]}")
  build -o wide.hxt --state wide.state --start-from hexatlas-now.hxt again-22.hxt "${wider[@]}" --memory 14 --max-hexahedra 56
  build -o all.hxt --state all.state --start-from wide.state contest.hxt wide.hxt "${wider[@]}" --max-hexahedra 1 "${many[@]}" \
    --annealed 860 --anneal-starts 6 --collar-hexahedra 22 --collar-width 1000 --symmetric-width 800
  build -o hexatlas-earlier.hxt --start-from hexatlas-now.hxt all.hxt "${last[@]/20261126/20261127}"
  build -o all2.hxt --start-from all.state contest.hxt wide.hxt "${wider[@]}" --max-hexahedra 1
  build -o hexatlas-many.hxt --start-from hexatlas-earlier.hxt all2.hxt "${last[@]/20261126/20261127}"
  # Another sweep of this width.
  build -o swept.hxt --state swept.state --start-from hexatlas-many.hxt hexatlas-22.hxt \
    "${wider[@]/20261127/20261128}" --memory 14 --max-hexahedra 56
  build -o hexatlas-broad.hxt --start-from hexatlas-many.hxt swept.hxt "${last[@]/20261126/20261128}"
  # Annealing that begins in each dual class; stopped after 137 boundaries, and the table made of what it had saved; gone on with for 80
  # more, then for 140 of 51 hexahedra by a program that passed over the others.
  build -o all.hxt --state classes.state --start-from swept.state swept.hxt "${wider[@]/20261127/20261128}" \
    --max-hexahedra 1 "${many[@]}" --annealed 700 --anneal-starts 8 --collar-hexahedra 22 --collar-width 1000 --symmetric-width 800
  build -o hexatlas-classes.hxt --start-from hexatlas-broad.hxt all.hxt "${last[@]/20261126/20261128}"
  # Three times another sweep, then leaps: for a part of these boundaries by a trial program; with shorter walks, those of 52 and more by a
  # trial program, those of 51 by one that passed over the others; by one that leapt for so many seconds instead of so many times.
  leap_from() { # TABLE SEED BOUNDARIES COLLAR-WIDTH SYMMETRIC-WIDTH RESULT
    local swept="swept-$2.state" options=("${wider[@]/20261127/$2}")
    build -o swept.hxt --state "$swept" --start-from "$1" hexatlas-22.hxt "${options[@]}" --memory 14 --max-hexahedra 56
    build -o leapt.hxt --state "leapt-$2.state" --start-from "$swept" swept.hxt "${options[@]}" --max-hexahedra 1 \
      "${beginnings[@]}" --annealed "$3" --collar-hexahedra 22 --collar-width "$4" --symmetric-width "$5"
    build -o "$6" --start-from "$1" leapt.hxt "${last[@]/20261126/$2}"
  }
  leap_from hexatlas-classes.hxt 20261201 520 1000 800 hexatlas-leapt.hxt
  leap_from hexatlas-leapt.hxt 20261202 500 1000 800 hexatlas-more.hxt
  leap_from hexatlas-more.hxt 20261203 430 500 300 hexatlas-leapt-more.hxt
  # Four times another sweep, then annealing that begins with faults: from the second time on those of faulty cuts, too, from the third
  # time on with boundaries of up to 26 quads. By trial programs that tried several prices and drew beginnings anew after each smaller
  # mesh. The third and the fourth sweep had 12 GiB and were cut short after 52 and 49 hexahedra.
  faulty_from() { # TABLE SEED BOUNDARIES CUT RESULT WIDEST [OPTIONS OF THE COLLARS]
    local swept="swept-$2.state" options=(--width "${fronts:-2200000}" --per-class "${each:-200}" --widest "$6" --seed "$2" --rounds 1 --growths 0 --cut 0 --collared 0
      --symmetric 0 --irregular "${preferring:-0}")
    build -o swept.hxt --state "$swept" --start-from "$1" hexatlas-22.hxt "${options[@]}" --memory "${memory:-14}" --max-hexahedra "${most:-56}"
    build -o faulty.hxt --start-from "$swept" swept.hxt "${options[@]}" --max-hexahedra 1 --annealed "$3" --anneal-starts 1 \
      --anneal-leaps 0 --anneal-faulty 400 --anneal-cut "$4" --anneal-transplant 0 "${@:7}"
    build -o "$5" --start-from "$1" swept.hxt faulty.hxt "${last[@]/20261126/$2}"
  }
  narrow=(--collar-hexahedra 10 --collar-width 10000)
  all_there_are=(--collar-hexahedra 14 --collar-width 60000)
  faulty_from hexatlas-leapt-more.hxt 20261204 400 0 hexatlas-faulty.hxt 24 "${narrow[@]}"
  faulty_from hexatlas-faulty.hxt 20261205 87 400 hexatlas-cut.hxt 24 "${narrow[@]}"
  faulty_from hexatlas-cut.hxt 20261206 60 400 hexatlas-26.hxt 26 "${all_there_are[@]}"
  faulty_from hexatlas-26.hxt 20261208 24 400 hexatlas-again-26.hxt 26 "${all_there_are[@]}"
  # Three with longer boundaries. They had 1,000,000 to 1,200,000 fronts per level, 60 to 100 per class and 18 or 19 GiB; the last two were cut short
  # after 45 and 42 hexahedra. The last step leapt, too.
  wide_symmetric=(--collar-hexahedra 16 --collar-width 100000 --symmetric-hexahedra 40 --symmetric-widest 40)
  faulty_from hexatlas-again-26.hxt 20261210 23 400 hexatlas-28.hxt 28 "${wide_symmetric[@]}" --collar-widest 28
  faulty_from hexatlas-28.hxt 20261211 14 400 hexatlas-30.hxt 30 "${wide_symmetric[@]}" --collar-widest 30
  faulty_from hexatlas-30.hxt 20261212 11 400 hexatlas-again-28.hxt 28 "${wide_symmetric[@]}" --collar-widest 28
  # Three that prefer irregular boundaries. They had 900,000, 1,300,000 and 1,400,000 fronts per level, 40, 20 and 20 per class, and ended after
  # 47 hexahedra; in the last one a unit counted as one scar and a half.
  irregular=("${wide_symmetric[@]}" --collar-widest 30)
  preferring=1 faulty_from hexatlas-again-28.hxt 20261216 10 400 hexatlas-irregular.hxt 28 "${irregular[@]}"
  preferring=3 faulty_from hexatlas-irregular.hxt 20261217 10 400 hexatlas-more-irregular.hxt 30 "${irregular[@]}"
  preferring=2 faulty_from hexatlas-more-irregular.hxt 20261218 9 400 hexatlas-most-irregular.hxt 30 "${irregular[@]}"
  preferring=2 faulty_from hexatlas-most-irregular.hxt 20261220 9 400 hexatlas-irregular-30.hxt 30 "${irregular[@]}"
  # With more fronts of shorter boundaries. No collars followed but for the nine above 50.
  memory=17 most=47
  fronts=4000000 each=20 preferring=2 faulty_from hexatlas-irregular-30.hxt 20261223 9 400 hexatlas-wide-28.hxt 28 "${irregular[@]}"
  fronts=4000000 each=20 preferring=4 faulty_from hexatlas-wide-28.hxt 20261224 9 400 hexatlas-more-28.hxt 28 "${irregular[@]}"
  fronts=4500000 each=20 preferring=3 faulty_from hexatlas-more-28.hxt 20261226 9 400 hexatlas-wide-26.hxt 26 "${irregular[@]}"
  fronts=6000000 each=40 preferring=1 faulty_from hexatlas-wide-26.hxt 20261227 9 400 hexatlas-wide-24.hxt 24 "${irregular[@]}"
  fronts=9000000 each=200 preferring=1 faulty_from hexatlas-wide-24.hxt 20261228 9 400 hexatlas-more-24.hxt 24 "${irregular[@]}"
  fronts=8000000 each=400 preferring=1 faulty_from hexatlas-more-24.hxt 20261230 9 400 hexatlas-wide-22.hxt 22 "${irregular[@]}"
  fronts=9000000 each=1000 preferring=0 faulty_from hexatlas-wide-22.hxt 20270101 9 400 hexatlas-more-22.hxt 22 "${irregular[@]}"
  # Symmetric balls: for all boundaries that have an involution, then, with more of them, for the nine above 50. Then a sweep.
  symmetric=(--width 1 --per-class 1 --max-hexahedra 1 --rounds 1 --growths 0 --cut 0 --collared 0 --symmetric-narrow 0
    --symmetric-widest 36 --symmetric-ball-widest 36 --symmetric-ball-hexahedra 30)
  build -o symmetric-all.hxt --start-from hexatlas-more-22.hxt "${symmetric[@]}" --seed 20270104 \
    --symmetric 3400 --symmetric-hexahedra 10 --symmetric-width 100 --symmetric-ball-width 40000
  build -o symmetric-nine.hxt --start-from hexatlas-more-22.hxt "${symmetric[@]}" --seed 1 \
    --symmetric 9 --symmetric-hexahedra 26 --symmetric-width 20000 --symmetric-ball-width 100000
  build -o swept.hxt --start-from hexatlas-more-22.hxt symmetric-nine.hxt symmetric-all.hxt "${quiet[@]}" \
    --width 6000000 --per-class 60 --seed 20270105 --memory 17 --max-hexahedra 47
  build -o hexatlas-symmetric-balls.hxt --start-from hexatlas-more-22.hxt symmetric-nine.hxt symmetric-all.hxt swept.hxt \
    "${last[@]/20261126/20270105}"
  # And one that prefers boundaries with few simple zones.
  build -o swept.hxt --start-from hexatlas-symmetric-balls.hxt "${quiet[@]}" --width 3500000 --per-class 20 --widest 26 \
    --irregular 1 --simple-zones 30 --seed 20270201 --memory 16 --max-hexahedra 50
  build -o hexatlas-simple.hxt --start-from hexatlas-symmetric-balls.hxt swept.hxt "${last[@]/20261126/20270201}"
  # A shorter one from another seed, wide collars that go by promise for those above 50, and annealing from these.
  build -o swept.hxt --start-from hexatlas-simple.hxt --rounds 1 --growths 0 --cut 0 --symmetric 0 --width 1000000 --per-class 20 --widest 26 \
    --irregular 1 --simple-zones 30 --seed 20270401 --memory 14 --max-hexahedra 45 --collared 140 --collar-widest 34 --collar-narrow 12 \
    --collar-hexahedra 26 --collar-width 3000 --guided 2 --annealed 8 --anneal-starts 1 --anneal-faulty 300 --anneal-cut 0 --anneal-transplant 0 \
    --symmetric-hexahedra 1 --symmetric-ball-hexahedra 0
  build -o hexatlas-wide-collars.hxt --start-from hexatlas-simple.hxt swept.hxt "${last[@]/20261126/20270401}"
  # Transplants, with the balls of such a sweep from another seed: for those with 50 hexahedra and more, then for those with 47 and more (stopped after 27 CPU minutes).
  only_transplants=(--anneal-starts 1 --anneal-faulty 0 --anneal-cut 0 --anneal-leaps 0)
  transplants=(--width 1000000 --per-class 20 --widest 26 --irregular 1 --simple-zones 30 --seed 20270501 --memory 12 --rounds 1 --growths 0 --cut 0
    --symmetric 0 --symmetric-ball-hexahedra 0 --collared 0 "${only_transplants[@]}")
  build -o swept.hxt --state swept.state --start-from hexatlas-wide-collars.hxt "${transplants[@]}" --max-hexahedra 45
  build -o fifty.hxt --start-from swept.state hexatlas-wide-collars.hxt "${transplants[@]}" --max-hexahedra 1 \
    --annealed 141 --anneal-transplant 60
  build -o transplanted.hxt --start-from swept.state fifty.hxt "${transplants[@]}" --max-hexahedra 1 \
    --annealed 900 --anneal-transplant 24
  build -o hexatlas-transplants.hxt --start-from hexatlas-wide-collars.hxt transplanted.hxt "${last[@]/20261126/20270501}"
  # The same once more, for those with 46 and more (stopped after some 25 CPU minutes).
  more_transplants=("${transplants[@]/20270501/20270601}")
  build -o swept.hxt --state swept.state --start-from hexatlas-transplants.hxt "${more_transplants[@]}" --max-hexahedra 45
  build -o transplanted.hxt --start-from swept.state swept.hxt "${more_transplants[@]}" --max-hexahedra 1 --annealed 1185 --anneal-transplant 24
  build -o hexatlas-more-transplants.hxt --start-from hexatlas-transplants.hxt transplanted.hxt "${last[@]/20261126/20270602}"
  # 22 quads as one file anew: two sweeps from both tables of the day, the second with exchange, then transplants for the largest.
  anew=(--max-quads 22 --per-class 20 --irregular 1 --rounds 1 --cut 0 --symmetric 0 --symmetric-ball-hexahedra 0 --memory 16)
  build -o swept-22.hxt --start-from hexatlas-more-transplants.hxt hexatlas-22.hxt "${anew[@]}" --width 3000000 --widest 24 \
    --max-hexahedra 45 --seed 20270701 --growths 0 --collared 0
  build -o swept-26.hxt --start-from hexatlas-more-transplants.hxt swept-22.hxt "${anew[@]}" --width 1000000 --widest 26 --simple-zones 30 \
    --max-hexahedra 54 --seed 20270702 --growths 3 --collared 0 --annealed 120 "${only_transplants[@]}" --anneal-transplant 20
  build -o hexatlas.hxt --start-from hexatlas-more-transplants.hxt swept-26.hxt "${last[@]/20261126/20270702}"
  build -o hexatlas-22.hxt --max-quads 22 --start-from hexatlas.hxt swept-26.hxt "${last[@]/20261126/20270702}"
  # Another one of 24 quads, with collars for the largest; dates.py has dated the census of the table of that day.
  build -o collared-24.hxt --start-from hexatlas.hxt hexatlas-22.hxt "${anew[@]}" --width 2500000 --widest 24 --max-hexahedra 54 \
    --seed 20270801 --growths 0 --collared 40000 --collar-hexahedra 9 --collar-width 600 --collar-widest 24
  build -o hexatlas-now.hxt --start-from hexatlas.hxt collared-24.hxt "${last[@]/20261126/20270801}"
  build -o hexatlas-22-now.hxt --max-quads 22 --start-from hexatlas-now.hxt hexatlas-22.hxt collared-24.hxt "${last[@]/20261126/20270801}"
  # What the larger table has smaller.
  build -o hexatlas-both.hxt --start-from hexatlas-now.hxt hexatlas-22-now.hxt "${last[@]/20261126/20270803}"
  # Transplants once more, for those with 44 and more (stopped after 24 minutes), then a sweep for 22 quads with exchange and collars.
  yet=("${transplants[@]/20270501/20270901}")
  yet=("${yet[@]/1000000/1500000}")
  build -o swept.hxt --state swept.state --start-from hexatlas-both.hxt "${yet[@]}" --max-hexahedra 45
  build -o transplanted.hxt --start-from swept.state swept.hxt "${yet[@]}" --max-hexahedra 1 --annealed 3419 --anneal-transplant 24
  build -o swept-22.hxt --start-from transplanted.hxt hexatlas-22-now.hxt "${anew[@]}" --width 2500000 --widest 24 --simple-zones 30 \
    --max-hexahedra 54 --seed 20270902 --growths 1 --collared 20000 --collar-hexahedra 9 --collar-width 600 --collar-widest 24
  build -o hexatlas-later.hxt --start-from hexatlas-both.hxt transplanted.hxt swept-22.hxt "${last[@]/20261126/20270902}"
  build -o hexatlas-22-later.hxt --max-quads 22 --start-from hexatlas-later.hxt hexatlas-22-now.hxt swept-22.hxt "${last[@]/20261126/20270902}"
  # What the larger table has smaller, in both.
  build -o hexatlas.hxt --start-from hexatlas-later.hxt hexatlas-22-later.hxt "${last[@]/20261126/20270902}"
  build -o hexatlas-22.hxt --max-quads 22 --start-from hexatlas.hxt hexatlas-22-later.hxt "${last[@]/20261126/20270902}"
fi
"$program" table info --by quads --json | python3 -c '
import json, sys
print("quads", "meshes", "least", "mean", "median", "most", sep="\t")
for quads, row in json.load(sys.stdin)["by_quads"].items():
    print(quads, row["entries"], row["least"], "%.2f" % row["mean"], row["median"],
          row["greatest"], sep="\t")
' >result.tsv
"$program" table info --by quads --svg hexahedra.svg >/dev/null
python3 -B zones.py ../../tables/data/hexatlas.census.sqlite >zones.tsv
{
  TIMEFORMAT=$'table check, seconds on one core\t%U'
  time taskset -c 0 "$program" table check >/dev/null
} 2>check.tsv
{
  printf 'table\tquads\tqueries\tper cent filled\tmedian s\t95 %% s\tmost s\tmean hexahedra\tmost\n'
  python3 -B queries.py "$program" ../../tables/data/hexatlas.hxt 22 500
  python3 -B queries.py "$program" ../../tables/data/hexatlas.hxt 24 500
  python3 -B queries.py "$program" ../../tables/data/hexatlas-22.hxt 24 500
} >queries.tsv
python3 -B kills.py "$program" "$folder" >kills.tsv
python3 -B corruptions.py "$program" ../../tables/data/hexatlas.hxt "$folder" >corruptions.tsv
python3 -B removals.py "$program" ../../tables/data/hexatlas.hxt "$folder" "${REMOVALS:-8}" >removals.tsv
{
  echo "$commit"
  "$program" --version
  lscpu | sed -n 's/^Model name: *//p'
} >provenance.txt
