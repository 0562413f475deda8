#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The paper's Fig. 5: a row for each method (its Methods 1 to 4, then ours), before, breaking and at rest.
#   tests/bench_results/methods_sheet.sh PICTURE SCENE MOMENTS [options of `demolish capture`]
#   tests/bench_results/methods_sheet.sh docs/pictures/methods.jpg bunny 0.4,0.56,2.4
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

count=$(tr ',' '\n' <<< "$moments" | wc -l)
rows=()
for method in pattern-at-impact heavy pattern cores ours; do
    "$program" capture "$scene" --method "$method" --at "$moments" --out "$folder/$method" "$@" > /dev/null
    frames=()
    for frame in "$folder/$method"/frame_*.png; do frames+=(-i "$frame"); done
    ffmpeg -y -loglevel error "${frames[@]}" -filter_complex "hstack=inputs=$count" "$folder/$method.png"
    rows+=(-i "$folder/$method.png")
done
ffmpeg -y -loglevel error "${rows[@]}" -filter_complex "vstack=inputs=5" -q:v 3 -update 1 "$picture"
echo "$picture"
