#!/usr/bin/env bash
# Builds everything with AddressSanitizer, UndefinedBehaviorSanitizer and LeakSanitizer, and runs the tests with them; installs
# what is missing. Arguments go to ctest.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
. "$root/cmake/prepare.sh"

install_missing "${build_packages[@]}" "${picture_packages[@]}" libgtest-dev libassimp-dev libcgal-dev python3-jsonschema xvfb xdotool \
  doxygen binutils
(cd "$root" && cmake --preset sanitizers >/dev/null && cmake --build --preset sanitizers --parallel "$(nproc)")

# Windows are drawn by the processor, which takes hours in a program that is ten times slower.
cd "$root"
export LSAN_OPTIONS=suppressions=$root/tests/leaks.supp:print_suppressions=0
exec ctest --preset sanitizers --parallel "$(nproc)" --label-exclude window "$@"
