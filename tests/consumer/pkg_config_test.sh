#!/usr/bin/env bash
# Builds a program ($3) with a compiler ($1) and what pkg-config says of the package in a prefix ($2), and runs it.
set -euo pipefail
compiler=$1 prefix=$2 source=$3
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name drench.pc)")
export PKG_CONFIG_PATH
program=$(mktemp)
trap 'rm -f "$program"' EXIT
# shellcheck disable=SC2046  # one word a flag
"$compiler" -std=c++17 "$source" -o "$program" $(pkg-config --cflags --libs drench)
LD_LIBRARY_PATH=$PKG_CONFIG_PATH/.. "$program"
