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
expect 2 'speed' drape --speed nan
expect 2 'csv: give a name' drape --headless --csv ''
expect 2 'beauty,content,film,strain' drape --headless --view x-ray
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

# What is exported: an animation, numbered meshes and tables; and a fabric of a file.
expect 0 'check passed' drape --headless --seconds 0.2 --resolution 12 --export "$folder/new/run.glb"
[ "$(head -c 4 "$folder/new/run.glb")" = glTF ] || { echo "run.glb is no binary glTF"; failed=1; }
expect 0 'check passed' drape --headless --seconds 0.2 --resolution 12 --every 6 --export "$folder/mesh/cloth.obj"
exists "$folder/mesh/cloth.0001.obj" "$folder/mesh/cloth.0002.obj"
echo '{"like": "wool", "name": "loden", "thickness": {"value": 2, "unit": "mm"}}' >"$folder/loden.json"
expect 0 'check passed' drape --headless --seconds 0.2 --resolution 12 --fabric "$folder/loden.json" --every 12 \
  --export "$folder/mesh/cloth.csv" --save-scene "$folder/loden-scene.json"
exists "$folder/mesh/cloth.0001.csv"
grep -q '"name": "loden"' "$folder/loden-scene.json" || { echo "the saved scene has not got its fabric"; failed=1; }
expect 2 'add --headless' drape --export "$folder/run.glb"
expect 2 'ends in .glb or .obj or .csv' drape --headless --export "$folder/run.gltf"
expect 2 '/proc/no/run.glb' drape --headless --seconds 0.1 --resolution 8 --export /proc/no/run.glb
echo '{"like": "wool", "thicknes": 0.002}' >"$folder/loden.json"
expect 2 'loden.json: thicknes is no key.*did you mean thickness' drape --headless --fabric "$folder/loden.json"

# Scene files: one runs, is saved as it is at the end, and runs on; the others say what is wrong with them.
cat >"$folder/towel.json" <<'END'
{"name": "towel", "weather": {"rain": 60, "windSpeed": 2},
 "sheets": [{"name": "towel", "fabric": "linen", "nodes": [12, 12], "pins": [[0, 0], [-1, 0]]}],
 "solids": [{"shape": "ground"}]}
END
expect 0 'towel_pores_g' --scene-file "$folder/towel.json" --headless --seconds 1 --save-scene "$folder/saved/wet.json"
exists "$folder/saved/wet.json"
grep -q '"time": 1.0' "$folder/saved/wet.json" || { echo "the saved scene has not got its time"; failed=1; }
expect 0 'check passed' --scene-file "$folder/saved/wet.json" --headless --seconds 0.5 --frames "$folder/towel" --every 15
exists "$folder/towel/frame-000015.png"
expect 0 'not checked' --scene-file "$folder/towel.json" --headless --seconds 0.5 --dry --csv "$folder/dry.csv"
tail -1 "$folder/dry.csv" | grep -q '^0.5,0,' || { echo "a dry run got wet"; failed=1; }
expect 0 'not checked' spill --headless --seconds 3 --resolution 16 --dry
expect 2 'resolution' --scene-file "$folder/saved/wet.json" --headless --resolution 20
expect 2 'no such file' --scene-file "$folder/missing.json" --headless
expect 2 'excludes' drape --scene-file "$folder/towel.json" --headless
expect 2 'no rectangle' drape-meter --headless --seconds 0.1 --resolution 16 --save-scene "$folder/disc.json"
expect 2 '/proc/no/scene.json' drape --headless --seconds 0.1 --resolution 8 --save-scene /proc/no/scene.json
echo '{"sheets": [{"fabric": {"stretchWarp": -3}}]}' >"$folder/bad.json"
expect 2 'bad.json: sheets\[0\].fabric.stretchWarp is -3; give a number, 1 to 1e6' --scene-file "$folder/bad.json" --headless
printf '{\n "name": }' >"$folder/bad.json"
expect 2 'line 2, column 10' --scene-file "$folder/bad.json" --headless

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
for scene in drape wick rain clothesline spill fold wring heap; do
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
