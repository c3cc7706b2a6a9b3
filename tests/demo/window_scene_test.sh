#!/usr/bin/env bash
# A scene runs five seconds in a window on a virtual display, draws, and meets no OpenGL error. $1: the program,
# $2: picture_probe, $3: the scene.
set -u
program=$1 probe=$2 scene=$3
. "$(dirname "$0")/window_helpers.sh"
open_display
open_window "$scene" --resolution 16 --seconds 5 --speed 0 --size 320 180
wait_for "$scene does not come to its end" test -s "$folder/stdout"
picture
at_least "$("$probe" spread "$shot")" 10 "$scene is blank"
close_window
