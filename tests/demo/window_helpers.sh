# shellcheck shell=bash disable=SC2034,SC2154
# Sourced by the tests of the window: a program on a virtual display of its own, its keys and its pictures. Many of these
# tests may run side by side. The caller has set `program` and `probe`.

folder=$(mktemp -d)
child=
window=
display=
trap 'kill $child $display 2>/dev/null; wait; rm -rf "$folder"' EXIT

# open_display: the server itself chooses a number that is free, so that no two tests share one.
open_display() {
  mkfifo "$folder/number"
  Xvfb -displayfd 3 -screen 0 1024x768x24 -noreset -nolisten tcp 3>"$folder/number" 2>"$folder/stderr" &
  display=$!
  read -r DISPLAY <"$folder/number" || fail "no virtual display came up"
  export DISPLAY=:$DISPLAY
  unset WAYLAND_DISPLAY
}

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

# still_picture: pictures until two in a row are the same, which is then in `shot`: what was asked for has taken effect.
still_picture() {
  local before try
  picture
  for try in 1 2 3 4 5 6; do
    before=$shot
    picture
    [ "$("$probe" differ "$before" "$shot")" = 0.000 ] && return 0
  done
  fail "the picture does not come to rest"
}

# another_picture BEFORE LEAST WORDS: pictures until one differs that much from the one before; fails with the words
# where none does.
another_picture() {
  local difference try
  for try in 1 2 3 4 5 6; do
    picture
    difference=$("$probe" differ "$1" "$shot")
    awk -v a="$difference" -v b="$2" 'BEGIN { exit !(a >= b) }' && return 0
    sleep 0.3
  done
  fail "$3: $difference, wanted at least $2"
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
