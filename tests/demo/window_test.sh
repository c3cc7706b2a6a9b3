#!/usr/bin/env bash
# Opens drench-demo in a real window on a virtual display, presses keys and drags the mouse. $1: the program.
set -u
program=$1
if [ "${2:-}" != inside ]; then
  exec xvfb-run --auto-servernum --server-args='-screen 0 1400x900x24' "$0" "$program" inside
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"; kill $child 2>/dev/null' EXIT
"$program" ten-steps --resolution 16 --frames "$folder" >"$folder/stdout" 2>"$folder/stderr" &
child=$!

fail() {
  echo "$1"
  cat "$folder/stderr"
  exit 1
}

# wait_for SECONDS COMMAND...: until the command succeeds.
wait_for() {
  local tries=$(($1 * 5))
  shift
  while ! "$@" >/dev/null 2>&1; do
    kill -0 $child 2>/dev/null || fail "the program ended by itself"
    [ $((tries -= 1)) -gt 0 ] || return 1
    sleep 0.2
  done
}

# picture: presses F12 until one picture more is there, and names it; a loaded machine may lose a key.
picture() {
  local before try
  before=$(find "$folder" -name 'screenshot-*.png' | wc -l)
  for try in 1 2 3 4; do
    xdotool key --window "$window" F12
    wait_for 15 test -s "$folder/screenshot-$((before + 1)).png" && return 0
  done
  return 1
}

wait_for 60 xdotool search --name 'Drench: ten-steps' || fail "no window came up"
window=$(xdotool search --name 'Drench: ten-steps' | head -1)
xdotool windowfocus "$window" 2>/dev/null
sleep 1

xdotool mousemove --window "$window" 500 400 mousedown 1 mousemove --window "$window" 560 380 mouseup 1
xdotool key --window "$window" space key --window "$window" period key --window "$window" r key --window "$window" space
picture || fail "F12 wrote no picture"
xdotool windowsize "$window" 700 500
sleep 1
picture || fail "no picture after resizing"
# A picture with nothing in it would pack to a few kilobytes.
for file in "$folder"/screenshot-*.png; do
  [ "$(stat -c %s "$file")" -gt 60000 ] || fail "${file##*/} is blank"
done

for _ in $(seq 20); do
  xdotool key --window "$window" Escape 2>/dev/null
  for _ in $(seq 10); do
    kill -0 $child 2>/dev/null || { wait $child; status=$?; [ $status -eq 0 ] || fail "exit status $status"; exit 0; }
    sleep 0.2
  done
done
fail "Escape did not close the window"
