#!/usr/bin/env bash
# Films by ffmpeg: real ones where it is installed, and what is said where it is not or fails. $1: the program.
set -u
program=$1
. "$(dirname "$0")/window_helpers.sh"
failed=0
run=("$program" drape --headless --seconds 0.1 --resolution 12)

# expect STATUS PATTERN COMMAND...: the exit status, and what stdout and stderr together must contain.
expect() {
  local status=$1 pattern=$2 output got
  shift 2
  output=$("$@" 2>&1)
  got=$?
  if [ "$got" -ne "$status" ] || ! grep -qE -- "$pattern" <<<"$output"; then
    echo "$*: exit $got (want $status), output without '$pattern':"
    echo "$output" | tail -5
    failed=1
  fi
}

# fake SCRIPT: an ffmpeg that does this, first in the PATH of `faked`.
mkdir "$folder/bin"
fake() {
  printf '#!/bin/sh\n%s\n' "$1" >"$folder/bin/ffmpeg"
  chmod +x "$folder/bin/ffmpeg"
}
faked=(env "PATH=$folder/bin:$PATH" "${run[@]}")

# None at all: said before anything runs.
mkdir "$folder/empty"
expect 2 'install it .Debian: apt-get install ffmpeg' env "PATH=$folder/empty" "${run[@]}" --record "$folder/no.mp4" --csv \
  "$folder/no.csv"
[ ! -e "$folder/no.csv" ] || { echo "it ran without ffmpeg"; failed=1; }
expect 2 'cannot write /proc/no' "${run[@]}" --record /proc/no/film.mp4

# One that cannot make the film.
fake 'cat >/dev/null; exit 3'
expect 2 'ffmpeg cannot make the film .*x.mp4' "${faked[@]}" --record "$folder/x.mp4"

# One that ends on the way, though not at the trial: the pipe breaks, and the run goes on to its end.
fake 'case "$*" in *64x64*) cat >/dev/null; exit 0 ;; esac; head -c 100000 >/dev/null; exit 3'
expect 2 'ffmpeg has ended before the film .*x.mp4 was whole' "${faked[@]}" --record "$folder/x.mp4" --csv "$folder/x.csv"
[ "$(wc -l <"$folder/x.csv")" -eq 7 ] || { echo "the run did not go on without its film"; failed=1; }

# One that keeps what it gets: a file of any name, and each frame whole.
fake 'for last; do :; done; cat >"${last#file:}"'
name="$folder/a b 'c' \"d\" \$(e)"
expect 0 'check passed' "${faked[@]}" --record "$name/-f;g.mp4"
size=$(stat -c %s "$name/-f;g.mp4")
[ "$size" -eq $((6 * 1280 * 720 * 3)) ] || { echo "a film of $size bytes in place of 6 frames"; failed=1; }
expect 0 'check passed' "${faked[@]}" --record "$folder/third.mp4" --every 3
size=$(stat -c %s "$folder/third.mp4")
[ "$size" -eq $((2 * 1280 * 720 * 3)) ] || { echo "a film of $size bytes in place of 2 frames"; failed=1; }

if command -v Xvfb >/dev/null; then
  open_display
  expect 0 '' env "PATH=$folder/bin:$PATH" "$program" drape --seconds 0.1 --resolution 12 --size 320 180 \
    --record "$folder/window.mp4" --quit-at-end
  [ "$(stat -c %s "$folder/window.mp4")" -ge $((5 * 1280 * 720 * 3)) ] || { echo "the window films too little"; failed=1; }
fi

if command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null; then
  expect 0 'check passed' "${run[@]}" --record "$folder/real.mp4"
  frames=$(ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 "$folder/real.mp4")
  [ "$frames" = 6 ] || { echo "the real film has $frames frames in place of 6"; failed=1; }
fi
exit $failed
