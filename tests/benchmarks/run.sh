#!/usr/bin/env bash
# Builds and runs the benchmarks, and writes docs/benchmarks/water_step.csv; installs what is missing.
# Arguments go to the program; with any, the table stays as it is.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
. "$root/cmake/prepare.sh"

install_missing "${build_packages[@]}" libbenchmark-dev
build_in "$root/build-benchmarks" drench_benchmarks \
  -DDRENCH_BUILD_BENCHMARKS=ON -DDRENCH_BUILD_TESTS=OFF -DDRENCH_BUILD_DEMOS=OFF

if [ $# -eq 0 ]; then
  mkdir -p "$root/docs/benchmarks"
  set -- --csv="$root/docs/benchmarks/water_step.csv"
fi
exec "$root/build-benchmarks/tests/benchmarks/drench_benchmarks" "$@"
