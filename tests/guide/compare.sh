#!/usr/bin/env bash
# Whether the diff block of a guide ($1) is what changes between two programs ($2, $3), and is ten lines.
set -euo pipefail
shown=$(sed -n '/^```diff$/,/^```$/p' "$1" | sed '1d;$d')
real=$(diff -U1 "$2" "$3" | tail -n +3 | grep -v '^@@' || true)
diff <(echo "$shown" | grep -v '^ \.\.\.$') <(echo "$real")
[ "$(echo "$real" | grep -c "^+")" -eq 10 ]
