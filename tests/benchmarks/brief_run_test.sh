#!/usr/bin/env bash
# Runs a benchmark on little and looks for a row of its table, printed and in the file.
# $1: the program; $2: how the row goes on after machine and compiler; $3...: arguments of the program.
set -euo pipefail
program=$1 row=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "$1" >&2
  cat "$folder/printed" >&2
  exit 1
}

"$program" "$@" --csv="$folder/table.csv" >"$folder/printed" || fail "$program ended with $?"
grep -q "^${row%%,*}.*[0-9]" "$folder/printed" || fail "no row of ${row%%,*} was printed"
grep -q ",$row[0-9]" "$folder/table.csv" || fail "the table has no row of $row"
