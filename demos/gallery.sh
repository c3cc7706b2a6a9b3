#!/usr/bin/env bash
# Makes the pictures of README.md and docs/ again, without a window, in a few minutes; installs what is missing.
# $1: the folder to write them into; docs if there is none.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
. "$root/cmake/prepare.sh"

install_missing "${build_packages[@]}" "${picture_packages[@]}" imagemagick
build_in "$root/build" drench-demo -DDRENCH_BUILD_TESTS=OFF
target=$(realpath -m "${1:-$root/docs}")
mkdir -p "$target"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run SCENE [OPTION...]: its pictures come into $work/SCENE.
run() {
  echo "$1" >&2
  "$root/build/demos/drench-demo" "$1" --headless --frames "$work/$1" "${@:2}" >"$work/report" 2>&1 ||
    { cat "$work/report" >&2; exit 1; }
}

# keep WIDTH NAME FILE: a picture for people to look at, $work/FILE, becomes NAME.jpg.
keep() {
  convert "$work/$3" -resize "$1x" -quality 88 "$target/$2.jpg"
}

# keep_four NAME FILE FILE FILE FILE: two by two.
keep_four() {
  montage "${@:2}" -tile 2x2 -geometry 640x360+4+4 -background '#eaeaea' -quality 88 "$target/$1.jpg"
}

run ten-steps
keep 1716 ten-steps ten-steps/contact-sheet.png
keep 960 dry ten-steps/step-00.png
keep 960 soaked ten-steps/step-10.png

run rain --view content
keep 960 content rain/rain-15000ms.png
run rain
keep 960 rain rain/rain-20000ms.png

run flag
keep 960 flag flag/flag-07000ms.png
run cling
keep 960 cling cling/cling-03000ms.png
run clothesline
keep 1288 clothesline clothesline/contact-sheet.png

run stock-and-drench
keep 1448 stock-and-drench stock-and-drench/stock-and-drench.png
run drape
keep 960 drape drape/drape-03000ms.png

run fold
run wring
run heap
run spill
run wick
cd "$work"
keep_four layers fold/fold-02000ms.png fold/fold-09000ms.png wring/wring-07000ms.png heap/heap-06000ms.png
keep_four water clothesline/clothesline-2-dripping.png rain/rain-20000ms.png spill/spill-16000ms.png \
  wick/"$(ls wick | grep -v contact | tail -1)"
run pool
run slide
keep_four touch flag/flag-07000ms.png cling/cling-03000ms.png pool/pool-10000ms.png slide/slide-02000ms.png
