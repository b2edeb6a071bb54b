#!/bin/bash
# Installs the Debian packages that are missing, and only those. Quick and silent when nothing is.
#   setup.sh build   what `npm start` and `npm run build` need
#   setup.sh test    and what `npm test` needs
#   setup.sh bench   and what the benchmarks need
set -eu

build='cmake ninja-build emscripten nlohmann-json3-dev libcli11-dev libfmt-dev libeigen3-dev'
test='g++ clang clang-format googletest libgtest-dev libboost-dev libcgal-dev chromium fonts-dejavu-core'
bench='libbenchmark-dev libtet1.5-dev'
case "${1:-build}" in
  build) packages=$build ;;
  test) packages="$build $test" ;;
  bench) packages="$build $test $bench" ;;
  *) echo "usage: $0 build|test|bench" >&2; exit 2 ;;
esac

if ! command -v dpkg-query >/dev/null; then
  echo "This is not Debian: please see to it that these are there: $packages" >&2
  exit 0
fi

# Architectures are left out: a package that allows several is listed once for each.
installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' $packages 2>/dev/null || true)
missing=
for package in $packages; do
  # A chromium from elsewhere will do (CHROMIUM=/path/to/it).
  if [ "$package" = chromium ] && [ -n "${CHROMIUM:-}" ]; then continue; fi
  case $'\n'"$installed"$'\n' in
    *$'\n'"installed $package"$'\n'*) ;;
    *) missing="$missing $package" ;;
  esac
done
if [ -z "$missing" ]; then exit 0; fi

as_root=
if [ "$(id -u)" != 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Missing Debian packages, and no sudo to install them. As root: apt-get install$missing" >&2
    exit 1
  fi
  as_root=sudo
fi
echo "Installing missing Debian packages:$missing"
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
$as_root env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends $missing
