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

wait_for 60 xdotool search --name 'Drench: ten-steps' || fail "no window came up"
window=$(xdotool search --name 'Drench: ten-steps' | head -1)
xdotool windowfocus "$window" 2>/dev/null
sleep 1

xdotool mousemove --window "$window" 500 400 mousedown 1 mousemove --window "$window" 560 380 mouseup 1
xdotool key --window "$window" space key --window "$window" period key --window "$window" r key --window "$window" space
xdotool key --window "$window" F12
wait_for 60 test -s "$folder/screenshot-1.png" || fail "F12 wrote no picture"
xdotool windowsize "$window" 700 500
sleep 1
xdotool key --window "$window" F12
wait_for 60 test -s "$folder/screenshot-2.png" || fail "no picture after resizing"
# A picture with nothing in it would pack to a few kilobytes.
[ "$(stat -c %s "$folder/screenshot-2.png")" -gt 60000 ] || fail "the picture is blank"

xdotool key --window "$window" Escape
for _ in $(seq 100); do
  kill -0 $child 2>/dev/null || { wait $child; status=$?; [ $status -eq 0 ] || fail "exit status $status"; exit 0; }
  sleep 0.2
done
fail "Escape did not close the window"
