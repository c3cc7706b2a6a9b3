#!/usr/bin/env bash
# clang-tidy over the sources with the list in .clang-tidy; installs it if it is missing. Ends with 1 if it finds something.
# $1...: regular expressions of paths, such as src/water; all of src, demos and tests by default.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
. "$root/cmake/prepare.sh"

install_missing "${build_packages[@]}" libgtest-dev clang-tidy
[ $# -gt 0 ] || set -- src demos tests
cmake -S "$root" -B "$root/build-tidy" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DDRENCH_BUILD_TESTS=ON >/dev/null
exec run-clang-tidy -quiet -p "$root/build-tidy" -j "$(nproc 2>/dev/null || echo 2)" "${@/#/$root/}"
