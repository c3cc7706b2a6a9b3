#!/usr/bin/env bash
# Every scene runs five seconds in a window on a virtual display, draws, and meets no OpenGL error; and a window that cannot
# be opened says why. $1: the program, $2: picture_probe.
set -u
program=$1 probe=$2
. "$(dirname "$0")/window_helpers.sh"
open_display

# refuses PATTERN COMMAND...: exit status 2, with that on stderr.
refuses() {
  local pattern=$1 output status
  shift
  output=$("$@" 2>&1)
  status=$?
  if [ $status -ne 2 ] || ! grep -q -- "$pattern" <<<"$output"; then
    echo "exit $status without '$pattern': $*: $output"
    exit 1
  fi
}
refuses 'OpenGL 3.3 is not available.*--headless' env MESA_GL_VERSION_OVERRIDE=2.1 "$program" drape
refuses 'no display.*--headless' env -u DISPLAY -u WAYLAND_DISPLAY "$program" drape

for scene in $("$program" --list | grep -v '^ '); do
  open_window "$scene" --resolution 16 --seconds 5 --speed 0 --size 320 180
  wait_for 30 test -s "$folder/stdout" || fail "$scene does not come to its end"
  picture
  at_least "$("$probe" spread "$shot")" 10 "$scene is blank"
  close_window
done
exit 0
