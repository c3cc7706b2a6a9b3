#!/usr/bin/env bash
# Builds everything and runs the tests; installs what is missing. Arguments go to ctest.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
. "$root/cmake/prepare.sh"

install_missing "${build_packages[@]}" "${picture_packages[@]}" libgtest-dev libbenchmark-dev libassimp-dev libcgal-dev \
  python3-jsonschema xvfb xdotool doxygen binutils
build_in "$root/build-tests" all -DDRENCH_BUILD_TESTS=ON -DDRENCH_BUILD_BENCHMARKS=ON -DDRENCH_WERROR=ON -DBUILD_SHARED_LIBS=ON \
  -DDRENCH_FLOAT64_TESTS="$root/build-tests-float64"
build_in "$root/build-tests-float64" all -DDRENCH_BUILD_TESTS=ON -DDRENCH_WERROR=ON -DDRENCH_BUILD_DEMOS=OFF \
  -DDRENCH_DOUBLE_PRECISION=ON -DDRENCH_CORE_FROM="$root/build-tests"

exec ctest --test-dir "$root/build-tests" --output-on-failure --parallel "$(nproc 2>/dev/null || echo 2)" "$@"
