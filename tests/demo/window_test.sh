#!/usr/bin/env bash
# Opens drench-demo in a real window on a virtual display, presses keys, uses the mouse, and looks at pictures. The scene
# stands still, so that each difference has one cause. $1: the program, $2: picture_probe.
set -u
program=$1 probe=$2
. "$(dirname "$0")/window_helpers.sh"
open_display

open_window flag --paused --resolution 16 --size 480 270
picture
at_least "$("$probe" spread "$shot")" 15 "the first picture is blank"
first=$shot

# It stays the same through resizing, hiding, and help and panel that come and go.
for size in '700 400' '20 10'; do
  # shellcheck disable=SC2086
  xdotool windowsize --sync "$window" $size
  settle
done
xdotool windowunmap --sync "$window"
round
xdotool windowmap --sync "$window" windowsize --sync "$window" 480 270
wait_for "the window takes no keys again" focus "$window"
for key in F1 Tab F1 Tab; do
  press $key
  settle
done
[ "$("$probe" differ "$first" "$shot")" = 0.000 ] || fail "the scene did not survive resizing and hiding"

# Ten steps of wetting, from nothing.
press Down
settle
dry=$shot
press Up Up Up Up Up Up Up Up Up Up
another_picture "$dry" 0.5 "dry and wet look alike"
settle
wet=$shot

# The view of water, and all others back to the first; dry and wet side by side, and back.
press v
another_picture "$wet" 2 "the view of water looks like the beauty"
press v v v
same_picture "$wet" "four views are not once round"
press s
another_picture "$wet" 2 "the split picture looks like one"
at_least "$("$probe" spread "$shot")" 15 "the split picture is blank"
split=$shot
press s
another_picture "$split" 2 "the split picture stays"

# Orbit, pan and zoom beside the cloth.
hide_panel
before=$shot
xdotool mousemove --window "$window" 240 250 mousedown 1
settle
xdotool mousemove --window "$window" 300 200
settle
xdotool mouseup 1
another_picture "$before" 2 "the left button does not turn the camera"
before=$shot
xdotool mousedown 3
settle
xdotool mousemove --window "$window" 280 220
settle
xdotool mouseup 3
another_picture "$before" 2 "the right button does not move the camera"
before=$shot
xdotool click 5
another_picture "$before" 0.5 "the wheel does not move the camera"

# The scene goes on, stands still, steps, and begins anew.
start=$shot
press space
another_picture "$start" 1 "space does not let the scene go on"
press space
still=
until [ -n "$still" ] && [ "$("$probe" differ "$still" "$shot")" = 0.000 ]; do
  [ "${shot##*-}" != 300.png ] || fail "space does not let the scene stand still"
  still=$shot
  picture
done
press Right
another_picture "$still" 0.001 "a step changes nothing"
press r
same_picture "$start" "the scene does not begin anew"

# The next scenes.
for key in Next Next Next Prior; do
  before=$shot
  press $key
  another_picture "$before" 2 "the next scene looks like the one before"
  at_least "$("$probe" spread "$shot")" 10 "the next scene is blank"
done
close_window
grep -q 'check\|trouble\|error' "$folder/stderr" && fail "there is something on stderr"
exit 0
