#!/usr/bin/env bash
# Bodies with recesses, random ones and some with names; as ../2026-11-swept-bodies/run.sh.
set -euo pipefail
cd "$(dirname "$0")"
exec bash ../2026-11-swept-bodies/run.sh "$PWD"
