#!/usr/bin/env bash
# Opens drench-demo in a real window on a virtual display, presses keys, uses the mouse, and looks at pictures.
# $1: the program, $2: picture_probe.
set -u
program=$1 probe=$2
. "$(dirname "$0")/window_helpers.sh"
open_display

open_window flag --resolution 16 --size 480 270
picture
at_least "$("$probe" spread "$shot")" 15 "the first picture is blank"

# Standing still, the picture stays the same, through resizing, hiding, and everything in the panel but water.
xdotool key space Down # dry
still_picture
dry=$shot
xdotool windowsize --sync "$window" 700 400
sleep 0.3
xdotool windowsize --sync "$window" 20 10
sleep 0.3
xdotool windowunmap --sync "$window"
sleep 0.3
xdotool windowmap --sync "$window" windowsize --sync "$window" 480 270
xdotool windowfocus --sync "$window"
xdotool key F1 key Tab key F1 key Tab
picture
[ "$("$probe" differ "$dry" "$shot")" = 0.000 ] || fail "the scene did not survive resizing and hiding"

# Ten steps of wetting, while the sheets hang as they hung.
for _ in 1 2 3 4 5 6 7 8 9 10; do xdotool key Up; done
another_picture "$dry" 0.5 "dry and wet look alike"
wet=$shot

# The view of water, and dry and wet side by side.
xdotool key v
another_picture "$wet" 2 "the view of water looks like the beauty"
xdotool key v key v key v key s key space
another_picture "$wet" 2 "the split picture looks like one"
at_least "$("$probe" spread "$shot")" 15 "the split picture is blank"

# Orbit, pan and zoom beside the cloth, reset, steps, and the next scenes, all with the panel.
before=$shot
xdotool key s
another_picture "$before" 2 "the split picture stays"
before=$shot
hide_panel
xdotool mousemove --window "$window" 240 250 mousedown 1 mousemove --window "$window" 300 200 mouseup 1
xdotool mousedown 3 mousemove --window "$window" 280 220 mouseup 3 click 4 click 5 click 4
xdotool key space key period key period key Right key r
another_picture "$before" 2 "the mouse does not move the camera"
for key in Next Next Next Prior; do
  xdotool key $key
  sleep 0.5
done
another_picture "$shot" 2 "the next scene looks like the one before"
at_least "$("$probe" spread "$shot")" 10 "the next scene is blank"
close_window
grep -q 'check\|trouble\|error' "$folder/stderr" && fail "there is something on stderr"
exit 0
