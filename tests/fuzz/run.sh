#!/usr/bin/env bash
# Runs one fuzzer for a while, on all its corpus and on; installs clang if it is missing. What it finds is written to
# build-fuzz/findings/NAME and ends it with a status other than 0; put it into the corpus once it is mended.
# $1: scene_file, fabric_file, mesh_file, mask, snapshot, moisture or sheet; $2: seconds, 60 by default; $3...: options of libFuzzer's.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
. "$root/cmake/prepare.sh"
name=$1
seconds=${2:-60}
shift $(($# < 2 ? $# : 2))

install_missing "${build_packages[@]}" libgtest-dev clang
build_in "$root/build-fuzz" "fuzz_$name" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DDRENCH_BUILD_FUZZERS=ON -DDRENCH_BUILD_TESTS=ON

folder=$root/build-fuzz/corpus/$name
findings=$root/build-fuzz/findings/$name
mkdir -p "$folder" "$findings"
dictionary=$root/tests/fuzz/$name.dict
[ ! -e "$dictionary" ] || set -- "-dict=$dictionary" "$@"
# Found inputs go into the first folder; the second is only read.
exec "$root/build-fuzz/tests/fuzz/fuzz_$name" -max_total_time="$seconds" -rss_limit_mb=1024 -malloc_limit_mb=1024 -timeout=10 \
  -artifact_prefix="$findings/" -print_final_stats=1 "$@" "$folder" "$root/tests/fuzz/corpus/$name"
