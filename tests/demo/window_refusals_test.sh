#!/usr/bin/env bash
# A window that cannot be opened says why. Also: the scenes that have a test of their own in a window, $3 and after, are
# all that there are. $1: the program.
set -u
program=$1
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

shift 2
diff <("$program" --list | grep -v '^ ' | sort) <(printf '%s\n' "$@" | sort) || fail "these scenes have no test in a window"
