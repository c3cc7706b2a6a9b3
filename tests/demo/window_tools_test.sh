#!/usr/bin/env bash
# The mouse tools in a real window, and that without them a window changes nothing. $1: the program,
# $2: picture_probe.
set -u
program=$1 probe=$2
. "$(dirname "$0")/window_helpers.sh"
open_display
other=
trap 'kill $child $other $display 2>/dev/null; wait; rm -rf "$folder"' EXIT

# ended: waits for the program, which must end well by itself.
ended() {
  wait "$child"
  local status=$?
  [ $status -eq 0 ] || fail "exit status $status"
}

# supplied_at SECONDS FILE: water brought by then, kg.
supplied_at() {
  awk -F, -v t="$1" 'NR > 1 && $1 <= t { last = $2 } END { print last + 0 }' "$2"
}

# The same numbers bit for bit with and without a window.
for scene in flag rain; do
  "$program" $scene --headless --seconds 2 --resolution 16 --csv "$folder/headless.csv" >/dev/null 2>&1
  open_window $scene --seconds 2 --resolution 16 --speed 0 --size 320 180 --quit-at-end --csv "$folder/window.csv"
  ended
  cmp "$folder/headless.csv" "$folder/window.csv" || fail "$scene in a window is not as without one"
done

# The hose wets while H and the button are held, and stops when the window loses the focus.
open_window drape --resolution 8 --size 100 100
other=$child elsewhere=$window
# On a machine that is busy the window may see the keys when the scene is over; then once more.
for attempt in 1 2 3; do
  open_window flag --dry --seconds 8 --resolution 16 --size 480 270 --quit-at-end --csv "$folder/hose.csv"
  picture
  hide_panel
  xdotool mousemove --window "$window" 130 110 keydown h mousedown 1
  sleep 2.5
  xdotool windowfocus --sync "$elsewhere"
  ended
  xdotool mouseup 1 keyup h
  supplied=$(supplied_at 8 "$folder/hose.csv")
  awk -v kg="$supplied" 'BEGIN { exit !(kg >= 0.005) }' && break
done
at_least "$supplied" 0.005 "the hose brings no water"
awk -F, 'NR > 1 { if ($2 > most + 1e-9) { most = $2; last = $1 } } END { exit !(last < 7.5) }' "$folder/hose.csv" ||
  fail "the hose goes on without the focus"
kill "$other"

# Dragging moves the cloth; the towel takes water.
open_window flag --seconds 5 --resolution 16 --size 480 270 --quit-at-end --csv "$folder/towel.csv"
hide_panel
xdotool mousemove --window "$window" 130 110 mousedown 1
for x in 140 150 160 170 180; do
  xdotool mousemove --window "$window" $x 130
  sleep 0.1
done
xdotool mouseup 1 mousemove --window "$window" 290 110 keydown d mousedown 1
ended
xdotool mouseup 1 keyup d
awk -F, 'NR > 1 { returned = $7 } END { exit !(returned > 1e-4) }' "$folder/towel.csv" || fail "the towel takes no water"
awk -F, 'NR > 1 { open = $2 - $3 - $4 - $5 - $6 - $7; if (open > 2e-6 || open < -2e-6) exit 1 }' "$folder/towel.csv" ||
  fail "the ledger does not close"
exit 0
