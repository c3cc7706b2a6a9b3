#!/usr/bin/env bash
# The mouse tools in a real window, frame by frame, and that without them a window changes nothing. $1: the program,
# $2: picture_probe.
set -u
program=$1 probe=$2
. "$(dirname "$0")/window_helpers.sh"
open_display
other=
trap 'kill $child $other $display 2>/dev/null; wait; rm -rf "$folder"' EXIT

# open_still SECONDS CSV ARGUMENT...: the flag, standing still, so that it simulates the frames that are asked for.
open_still() {
  local seconds=$1 csv=$2
  shift 2
  open_window flag --paused --speed 0 --seconds "$seconds" --resolution 16 --size 480 270 --frames . --every 10 \
    --csv "$csv" --quit-at-end "$@"
  hide_panel
}

# go_on: to the end of the scene.
go_on() {
  send space # with the focus or without
  ended
}

# The same numbers bit for bit with and without a window.
for scene in flag rain; do
  "$program" $scene --headless --seconds 2 --resolution 16 --csv "$folder/headless.csv" >/dev/null 2>&1
  open_window $scene --seconds 2 --resolution 16 --speed 0 --size 320 180 --quit-at-end --csv "$folder/window.csv"
  ended
  cmp "$folder/headless.csv" "$folder/window.csv" || fail "$scene in a window is not as without one"
done

# The hose, 0.1 kg/s, wets while H and the button are held, and stops when the window loses the focus. Drops that fall from
# one place of the flag on another bring less.
open_window drape --paused --resolution 8 --size 100 100
other=$child elsewhere=$window
open_still 2.5 "$folder/hose.csv" --dry
steps 10
xdotool mousemove --window "$window" 130 110 keydown h mousedown 1
settle
steps 60
wait_for "the window keeps the focus" focus "$elsewhere"
round
steps 30 Right
xdotool mouseup 1 keyup h
go_on
kill "$other"
awk -F, 'NR > 1 {
  if ($2 > last + 5e-4) { frames += 1; from = from ? from : NR - 1; to = NR - 1 }
  last = $2
} END {
  printf "the hose brings %g kg in %d frames, from frame %d to frame %d\n", last, frames, from, to
  exit !(last >= 0.005 && frames >= 50 && from > 10 && to <= 70)
}' "$folder/hose.csv" || fail "that is not while it is held, frames 11 to 70, or too little"

# Dragging moves the cloth; the towel takes water. A flag that nobody touches shows how it would have been.
"$program" flag --headless --seconds 1.5 --resolution 16 --frames "$folder/untouched" --every 10 >/dev/null 2>&1
open_still 2 "$folder/towel.csv"
steps 10
untouched=$folder/untouched/frame-000010.png
[ "$("$probe" differ "$untouched" "$folder/frame-000010.png")" = 0.000 ] || fail "the window shows another flag"
xdotool mousemove --window "$window" 130 110 mousedown 1
settle
for x in 140 160 180; do
  xdotool mousemove --window "$window" $x 130
  steps 20
done
at_least "$("$probe" differ "$folder/untouched/frame-000070.png" "$folder/frame-000070.png")" 0.5 "dragging moves nothing"
xdotool mouseup 1
settle
xdotool mousemove --window "$window" 290 110 keydown d mousedown 1
settle
steps 30
xdotool mouseup 1 keyup d
settle
go_on
awk -F, 'NR > 1 && NR <= 71 && $7 > 0 { exit 1 } NR > 1 { returned = $7 } END { exit !(returned > 1e-4) }' \
  "$folder/towel.csv" || fail "the towel takes no water, or before it is held"
awk -F, 'NR > 1 { open = $2 - $3 - $4 - $5 - $6 - $7; if (open > 2e-6 || open < -2e-6) exit 1 }' "$folder/towel.csv" ||
  fail "the ledger does not close"
exit 0
