#!/usr/bin/env bash
# Looks into a build folder ($1) whether Drench is compiled with the project's flags and the project without Drench's,
# and whether it adds anything to what the project installs.
set -euo pipefail
build=$1
commands=$build/compile_commands.json
expect() { grep -q -e "$2" <<<"$1" || { echo "no $2 in: $1"; exit 1; }; }
refuse() { if grep -q -e "$2" <<<"$1"; then echo "$2 in: $1"; exit 1; fi; }

drench=$(grep '"command".*wet_cloth.cpp' "$commands")
expect "$drench" -fno-omit-frame-pointer
expect "$drench" '-std=c++20'
project=$(grep '"command".*soft_rigid' "$commands")
for flag in -Wall -Wconversion -Werror -fno-trapping-math -fopenmp-simd -O3 -fvisibility; do
  refuse "$project" "$flag"
done

if grep -rq 'file(INSTALL' "$build" --include=cmake_install.cmake; then
  echo "Drench adds to what the project installs"
  exit 1
fi
