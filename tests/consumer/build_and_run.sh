#!/usr/bin/env bash
# build_and_run.sh SOURCES FOLDER TARGET CMAKE-OPTION... -- COMMAND...: builds a project from nothing and runs a command.
set -euo pipefail
sources=$1 folder=$2 target=$3
shift 3
options=()
while [ "$1" != -- ]; do
  options+=("$1")
  shift
done
shift

rm -rf "$folder"
cmake -S "$sources" -B "$folder" "${options[@]}"
cmake --build "$folder" --target "$target"
"$@"
