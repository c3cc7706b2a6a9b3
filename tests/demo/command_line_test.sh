#!/usr/bin/env bash
# Runs drench-demo as a user would and looks at exit statuses, messages and files. $1: the program.
set -u
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0

# expect STATUS PATTERN ARGUMENT...: the exit status, and what stdout and stderr together must contain.
expect() {
  local status=$1 pattern=$2
  shift 2
  local output got
  output=$("$program" "$@" 2>&1)
  got=$?
  if [ "$got" -ne "$status" ] || ! grep -qE -- "$pattern" <<<"$output"; then
    echo "drench-demo $*: exit $got (want $status), output without '$pattern':"
    echo "$output" | tail -5
    failed=1
  fi
}

# exists FILE...: written, and not empty.
exists() {
  local file
  for file in "$@"; do
    [ -s "$file" ] || { echo "missing: ${file#"$folder"/}"; failed=1; }
  done
}

unset DISPLAY WAYLAND_DISPLAY
expect 0 'ten-steps' --list
expect 0 '--headless' --help
expect 2 'SCENE' --headless
expect 2 'no-such-scene' no-such-scene --headless
expect 2 'tweed' drape --headless --fabric tweed
expect 2 'resolution' drape --headless --resolution 0
expect 2 'seconds' drape --headless --seconds nan
expect 2 'every' drape --headless --every -1
expect 2 'run with --headless' drape
expect 2 '/proc/no/such.csv' drape --headless --seconds 0.1 --resolution 8 --csv /proc/no/such.csv

expect 2 '/proc/no' drape --headless --seconds 0.1 --resolution 8 --frames /proc/no/pictures
expect 2 'does not run in the deformable world; these do: ten-steps' rain --headless --world deformable
expect 2 "has Bullet's own solver" drape --headless --world deformable --solver small-step
expect 2 'solver' drape --headless --solver fast
expect 1 'before anything was measured' ten-steps --headless --seconds 0.5 --resolution 8

expect 0 'check passed' drape --headless --seconds 0.2 --resolution 12 --csv "$folder/new/drape.csv" \
  --frames "$folder/frames" --every 5
exists "$folder/new/drape.csv" "$folder/frames/frame-000005.png" "$folder/frames/frame-000010.png" \
  "$folder/frames/contact-sheet.png"

# Stock Bullet, and the deformable world.
for choice in '--solver stock' '--world deformable'; do
  # shellcheck disable=SC2086
  expect 0 'check passed' drape --headless --seconds 0.2 --resolution 12 $choice
done
expect 0 'Substeps per frame' ten-steps --headless --seconds 5 --resolution 8 --world deformable
expect 0 'check passed' stock-and-drench --headless --seconds 2 --resolution 24 --frames "$folder/side"
expect 0 'drape_%' drape-meter --headless --fabric denim --resolution 24 --frames "$folder/meter"
exists "$folder/side/stock-and-drench.png" "$folder/meter/silhouette-dry.png" "$folder/meter/silhouette-wet.png"

# Every scene runs, and logs the water of each frame under the same names.
water='time_s,supplied_kg,pore_kg,film_kg,dripped_kg,evaporated_kg,returned_kg,mean_saturation'
for scene in drape wick rain clothesline spill; do
  expect 0 'check passed' "$scene" --headless --seconds 0.5 --resolution 16 --csv "$folder/$scene.csv"
  head -1 "$folder/$scene.csv" | grep -q "^$water" || { echo "$scene.csv has no such header"; failed=1; }
  rows=$(wc -l <"$folder/$scene.csv")
  [ "$rows" -eq 31 ] || { echo "$scene.csv has $rows lines in place of 30 frames and a header"; failed=1; }
  awk -F, -v scene="$scene" 'NR > 1 {
    open = $2 - $3 - $4 - $5 - $6 - $7
    if (open > 1e-6 * $2 + 1e-9 || -open > 1e-6 * $2 + 1e-9) { print scene ": open by " open " kg in line " NR; exit 1 }
  }' "$folder/$scene.csv" || failed=1
done

# The same seed gives the same numbers.
for run in 1 2; do
  expect 0 'check passed' ten-steps --headless --seconds 5 --resolution 12 --seed 7 --csv "$folder/run$run.csv"
  cut -d, -f1-9 "$folder/run$run.csv" >"$folder/run$run.physics"  # without the columns that time the machine
done
cmp "$folder/run1.physics" "$folder/run2.physics" || failed=1
head -1 "$folder/run1-water.csv" | grep -q "^$water,step" || { echo "run1-water.csv has no such header"; failed=1; }
for run in 1 2; do
  expect 0 'check passed' rain --headless --seconds 4 --resolution 16 --seed 3 --csv "$folder/rain$run.csv"
done
cmp "$folder/rain1.csv" "$folder/rain2.csv" || failed=1
exit $failed
