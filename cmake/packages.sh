#!/usr/bin/env bash
# Installs the Debian 12 packages that a group needs and that are missing; asks nothing.
# usage: bash cmake/packages.sh build|compile-tests|test
set -euo pipefail

build_packages=(
  g++ cmake ninja-build pkg-config
  libboost-dev libgmp-dev libnauty2-dev libcli11-dev libfmt-dev nlohmann-json3-dev
  libzstd-dev zlib1g-dev libpugixml-dev libssl-dev
  libcadical-dev libz3-dev libsqlite3-dev libeigen3-dev
  nodejs npm
)
# What the tests are compiled with.
compile_packages=(libgtest-dev librapidcheck-dev libbenchmark-dev libcgal-dev libmpfr-dev python3 git)
# Sanitizers and fuzzing, fast links, static analysis, and programs that read our files as a second road.
test_packages=(
  clang lld libclang-rt-14-dev libomp-14-dev clang-tidy
  gmsh python3-vtk9 chromium coinor-cbc
)

die() {
  printf 'packages: %s\n' "$1" >&2
  exit 1
}

case ${1:-} in
  build) wanted=("${build_packages[@]}") ;;
  compile-tests) wanted=("${build_packages[@]}" "${compile_packages[@]}") ;;
  test) wanted=("${build_packages[@]}" "${compile_packages[@]}" "${test_packages[@]}") ;;
  *)
    printf 'usage: bash cmake/packages.sh build|compile-tests|test\n' >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query >/dev/null; then
  printf 'packages: no Debian system, nothing installed; needed are the equivalents of %s\n' \
    "${wanted[*]}" >&2
  exit 0
fi

# Node.js from elsewhere than Debian brings an npm, beside which that of Debian cannot be installed.
is_installed() {
  case $1 in
    nodejs) command -v node >/dev/null && return ;;
    npm) command -v npm >/dev/null && return ;;
  esac
  [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

missing=()
for package in "${wanted[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  by_hand="run as root: apt-get update && apt-get install --no-install-recommends ${missing[*]}"
  command -v sudo >/dev/null || die "packages are missing and there is no sudo; $by_hand"
  sudo -n true 2>/dev/null || die "packages are missing and sudo asks for a password; $by_hand"
  as_root=(sudo -n)
fi

printf 'packages: installing %s\n' "${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -q "$@" >"$log" 2>&1 </dev/null || {
    tail -n 20 "$log" >&2
    die "apt-get $1 failed"
  }
}
apt update
apt install --no-install-recommends "${missing[@]}"
printf 'packages: done\n'
