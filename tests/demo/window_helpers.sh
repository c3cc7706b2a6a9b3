# shellcheck shell=bash disable=SC2034,SC2154
# Sourced by the tests of the window: a program on a virtual display of its own, its keys and its pictures. Many of these
# tests may run side by side, on a machine that is as busy as it likes: they wait for what they look for, and count frames
# and pictures instead of seconds. The caller has set `program` and `probe`.

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

# open_window ARGUMENT...: starts the program, and waits until its window has the keys.
open_window() {
  (cd "$folder" && exec "$program" "$@" >"$folder/stdout" 2>"$folder/stderr") &
  child=$!
  stepped=0
  wait_for "no window came up" xdotool search --all --pid "$child" --name 'Drench: '
  window=$(xdotool search --all --pid "$child" --name 'Drench: ' | head -1)
  wait_for "the window takes no keys" focus "$window"
}

# focus WINDOW: gives it the keys; fails while it cannot take them.
focus() {
  xdotool windowfocus "$1"
  [ "$(xdotool getwindowfocus -f)" = "$1" ]
}

fail() {
  echo "$1"
  cat "$folder/stderr"
  exit 1
}

# wait_for WORDS COMMAND...: until the command succeeds; fails with the words if it never does, which takes 20 minutes to
# say so.
wait_for() {
  local words=$1 tries=12000
  shift
  while ! "$@" >/dev/null 2>&1; do
    kill -0 "$child" 2>/dev/null || fail "the program ended by itself"
    [ $((tries -= 1)) -gt 0 ] || fail "$words"
    sleep 0.1
  done
}

# press KEY...: as fingers do, since GLFW takes a key that is down again within 20 ms for one that was never up.
press() { xdotool key --delay 60 "$@"; }

# send KEY...: to the window itself, also where it has not got the focus. There, GLFW heeds only keys that were never
# pressed.
send() { xdotool key --window "$window" --delay 1 "$@"; }

# wrote FILE: whether the program says that it has written that file of the folder.
wrote() { grep -q "^wrote .*/$1\$" "$folder/stderr"; }

# picture: has F12 write one more, whose name is then in `shot`.
picture() {
  local number=1
  while [ -e "$folder/screenshot-$number.png" ]; do number=$((number + 1)); done
  press F12
  wait_for "F12 wrote no picture" wrote "screenshot-$number.png"
  shot=$folder/screenshot-$number.png
}

# settle: two more pictures. Between them the program has drawn a whole one with all keys and the mouse as they are now.
settle() {
  picture
  picture
}

# round: waits until the program has worked for a second of its own, in which it draws many pictures, where it takes no F12.
round() {
  worked=$(work)
  wait_for "the program does nothing" has_worked
}
work() { awk '{ print $14 + $15 }' "/proc/$child/stat"; }
has_worked() { [ $(($(work) - worked)) -ge 100 ]; }

# steps COUNT [KEY]: so many frames of a scene that stands still, a multiple of ten; waits until they are simulated. For
# windows with --frames . --every 10, but for frames whose pictures the scene gives names of its own.
steps() {
  local i keys=()
  for ((i = 0; i < $1; i++)); do keys+=("${2:-period}"); done
  stepped=$((stepped + $1))
  send "${keys[@]}"
  wait_for "frame $stepped never came" wrote "$(printf 'frame-%06d.png' $stepped)"
}

# compared COMPARISON FILE LIMIT WORDS: pictures until awk finds their difference from that file, `d`, so; fails with the
# words if none of fifty is.
compared() {
  local try difference
  for ((try = 0; try < 50; try++)); do
    picture
    difference=$("$probe" differ "$2" "$shot")
    awk -v d="$difference" -v limit="$3" "BEGIN { exit !($1) }" && return 0
    sleep 0.1
  done
  fail "$4: they differ by $difference"
}

# another_picture FILE LEAST WORDS: waits for one that differs that much from the file.
another_picture() { compared 'd >= limit' "$@"; }

# same_picture FILE WORDS: waits for one that is equal to the file.
same_picture() { compared 'd == limit' "$1" 0 "$2"; }

# hide_panel: so that the mouse is over the scene.
hide_panel() {
  press Tab
  settle
}

# at_least NUMBER NUMBER WORDS: fails with the words where the first is less than the second.
at_least() {
  awk -v a="$1" -v b="$2" 'BEGIN { exit !(a >= b) }' || fail "$3: $1, wanted at least $2"
}

# ended: waits for the program, which must end well by itself.
ended() {
  wait "$child"
  local status=$?
  [ $status -eq 0 ] || fail "exit status $status"
}

# close_window: Escape must end the program, and that well.
close_window() {
  press Escape
  ended
}
