#!/usr/bin/env bash
# pkg_config_test.sh COMPILER PREFIX PACKAGE SOURCE [ARGUMENT...]: builds a program with what pkg-config says of a package, and
# runs it with the arguments and a folder to write to.
set -euo pipefail
compiler=$1 prefix=$2 package=$3 source=$4
shift 4
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name "$package.pc")")
export PKG_CONFIG_PATH
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# shellcheck disable=SC2046  # one word a flag
"$compiler" -std=c++17 "$source" -o "$folder/program" $(pkg-config --cflags --libs "$package")
LD_LIBRARY_PATH=$PKG_CONFIG_PATH/.. "$folder/program" "$@" "$folder"
