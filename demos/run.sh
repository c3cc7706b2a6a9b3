#!/usr/bin/env bash
# Builds and runs drench-demo; installs what is missing. Arguments go to the program.
# Without arguments: ten-steps, in a window where there is a display, else as a table and pictures in out/.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
. "$root/cmake/prepare.sh"

install_missing "${build_packages[@]}" "${picture_packages[@]}"
build_in "$root/build" drench-demo -DDRENCH_BUILD_TESTS=OFF

if [ $# -gt 0 ]; then
  exec "$root/build/demos/drench-demo" "$@"
elif [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$root/build/demos/drench-demo" ten-steps
else
  exec "$root/build/demos/drench-demo" ten-steps --headless --csv "$root/out/ten-steps.csv" --frames "$root/out"
fi
