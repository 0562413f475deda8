#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The paper's Fig. 5: a column for each method (its Methods 1 to 4, then ours), a row for each moment.
#   tests/bench_results/methods_sheet.sh PICTURE SCENE MOMENTS [options of `demolish capture`]
#   tests/bench_results/methods_sheet.sh docs/pictures/methods.jpg bunny 0.4,0.56,2.4 --size 360x360
# A last column for Bullet where BULLET_BENCH names the program of tests/bullet.
# Needs ffmpeg. DEMOLISH names the program (default: ./demolish, which builds it first).
set -euo pipefail
cd "$(dirname "$0")/../.."
program=${DEMOLISH:-./demolish}
picture=${1:?the name of a picture}
scene=${2:?a scene}
moments=${3:?moments in seconds, with commas between them}
shift 3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# names the paper's method and ours above the column
title() {
    local style='font=Sans:fontcolor=white:x=(w-text_w)/2'
    echo "pad=iw:ih+44:0:44:color=0x202020,drawtext=$style:fontsize=18:y=5:text=$1,drawtext=$style:fontsize=14:y=26:text=$2"
}

# stacks what was drawn of a method: NAME PAPER
column() {
    local frames=()
    for frame in "$folder/$1"/frame_*.png; do frames+=(-i "$frame"); done
    ffmpeg -nostdin -y -loglevel error "${frames[@]}" \
        -filter_complex "vstack=inputs=$count,$(title "$1" "$2")" "$folder/$1.png"
    columns+=(-i "$folder/$1.png")
}

count=$(tr ',' '\n' <<< "$moments" | wc -l)
columns=()
while read -r method paper; do
    "$program" capture "$scene" --method "$method" --at "$moments" --out "$folder/$method" "$@" > /dev/null < /dev/null
    column "$method" "$paper"
done << 'METHODS'
pattern-at-impact Method 1 of the paper
heavy Method 2
pattern Method 3
cores Method 4
ours the paper’s own
METHODS
if [[ -n ${BULLET_BENCH:-} ]]; then
    "$BULLET_BENCH" "$scene" --pictures "$folder/bullet" --at "$moments" "$@"
    column bullet "pieces of pattern"
fi
ffmpeg -nostdin -y -loglevel error "${columns[@]}" \
    -filter_complex "hstack=inputs=$((${#columns[@]} / 2))" -q:v 3 -update 1 "$picture"
echo "$picture"
