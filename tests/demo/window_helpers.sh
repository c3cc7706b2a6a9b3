# shellcheck shell=bash disable=SC2034,SC2154
# Sourced by the tests of the window: a program on a virtual display, its keys and its pictures.
# The caller has set `program` and `folder`, and runs within xvfb-run.

child=
window=

# open_window ARGUMENT...: starts the program and waits for its window.
open_window() {
  (cd "$folder" && exec "$program" "$@" >"$folder/stdout" 2>"$folder/stderr") &
  child=$!
  wait_for 60 xdotool search --all --pid "$child" --name 'Drench: ' || fail "no window came up"
  window=$(xdotool search --all --pid "$child" --name 'Drench: ' | head -1)
  xdotool windowfocus --sync "$window" 2>/dev/null
}

fail() {
  echo "$1"
  cat "$folder/stderr"
  exit 1
}

# wait_for SECONDS COMMAND...: until the command succeeds.
wait_for() {
  local tries=$(($1 * 10))
  shift
  while ! "$@" >/dev/null 2>&1; do
    kill -0 "$child" 2>/dev/null || fail "the program ended by itself"
    [ $((tries -= 1)) -gt 0 ] || return 1
    sleep 0.1
  done
}

# picture: presses F12 until one picture more is there, whose name is then in `shot`; a loaded machine may lose a key.
picture() {
  local number=1 try
  while [ -e "$folder/screenshot-$number.png" ]; do number=$((number + 1)); done
  shot=$folder/screenshot-$number.png
  for try in 1 2 3 4; do
    xdotool key F12
    wait_for 10 test -s "$shot" && return 0
  done
  fail "F12 wrote no picture"
}

# hide_panel: so that the mouse, from the next picture on, is over the scene.
hide_panel() {
  xdotool key Tab
  sleep 0.7
}

# at_least NUMBER NUMBER WORDS: fails with the words where the first is less than the second.
at_least() {
  awk -v a="$1" -v b="$2" 'BEGIN { exit !(a >= b) }' || fail "$3: $1, wanted at least $2"
}

# close_window: presses Escape until the program has ended, which must be well.
close_window() {
  local try status
  for try in $(seq 10); do
    xdotool key Escape 2>/dev/null
    for _ in $(seq 20); do
      kill -0 "$child" 2>/dev/null || break 2
      sleep 0.1
    done
  done
  kill -0 "$child" 2>/dev/null && fail "Escape did not close the window"
  wait "$child"
  status=$?
  [ $status -eq 0 ] || fail "exit status $status"
}
