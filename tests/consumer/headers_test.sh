#!/usr/bin/env bash
# Compiles each header in a prefix ($1) by itself with each compiler ($2...), and all together for double precision.
set -euo pipefail
prefix=$1
shift
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name drench.pc)")
export PKG_CONFIG_PATH
# Bullet's and Eigen's headers are not ours to mend.
others=$(pkg-config --cflags-only-I bullet eigen3 | sed 's/-I/-isystem /g')

for compiler in "$@"; do
  if [ -x "$compiler" ]; then
    find "$prefix/include/drench" -name '*.h' -printf "$compiler %p\n"
    echo "$compiler $prefix/include/drench/drench.h -DBT_USE_DOUBLE_PRECISION"
  fi
done | xargs -P "$(nproc)" -L 1 bash -euc '
  compiler=$1 header=$2
  shift 2
  # A header that is compiled itself would be warned of its "#pragma once".
  echo "#include \"$header\"" |
    "$compiler" -std=c++17 -fsyntax-only -Wall -Wextra -Wpedantic -Werror -I "'"$prefix"'/include" '"$others"' "$@" -x c++ -
' compile
