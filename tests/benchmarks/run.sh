#!/usr/bin/env bash
# Builds and runs the benchmarks, and writes their tables into docs/benchmarks/; installs what is missing.
# run.sh water or run.sh frames runs one of them; further arguments go to the program, and the table stays.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
. "$root/cmake/prepare.sh"

install_missing "${build_packages[@]}" libbenchmark-dev
build_in "$root/build-benchmarks" drench_benchmarks \
  -DDRENCH_BUILD_BENCHMARKS=ON -DDRENCH_BUILD_TESTS=OFF -DDRENCH_BUILD_DEMOS=OFF
programs="$root/build-benchmarks/tests/benchmarks"
mkdir -p "$root/docs/benchmarks"

# run PROGRAM TABLE [ARGUMENT...]
run() {
  local program=$1 table=$2
  shift 2
  [ $# -gt 0 ] || set -- --csv="$root/docs/benchmarks/$table"
  "$programs/$program" "$@"
}

which=${1:-all}
[ $# -eq 0 ] || shift
case $which in
  water) run drench_benchmarks water_step.csv "$@" ;;
  frames) run drench_frame_benchmarks small_steps.csv "$@" ;;
  all)
    run drench_benchmarks water_step.csv
    run drench_frame_benchmarks small_steps.csv
    ;;
  *)
    echo "usage: run.sh [water|frames [ARGUMENT...]]" >&2
    exit 2
    ;;
esac
