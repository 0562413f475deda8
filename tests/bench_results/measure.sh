#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures everything that is kept in this folder: the four scenes, drawn, not drawn, drawn only and recorded
# as in the window, and the substep alone.
#   tests/bench_results/measure.sh FOLDER [options of `demolish bench` for the scenes]
# DEMOLISH names the program (default: ./demolish, which builds it first).
set -euo pipefail
cd "$(dirname "$0")/../.."
program=${DEMOLISH:-./demolish}
folder=tests/bench_results/${1:?the name of a folder for this machine}
shift
mkdir -p "$folder"

measure() { # name of the files, scene and options
    local name=$1
    shift
    echo "$program bench $* > $folder/$name.txt"
    "$program" bench "$@" --csv "$folder/$name.csv" > "$folder/$name.txt"
}

for scene in bunny wolf vase column; do
    measure "$scene" "$scene" "$@" --curve "$folder/$scene.svg"
    measure "${scene}_no_draw" "$scene" "$@" --no-draw
    measure "${scene}_draw_only" "$scene" "$@" --draw-only
    measure "${scene}_record" "$scene" "$@" --record
done
# The size that the README sets beside the full one.
measure bunny_2k bunny "$@" --particles 2000 --curve "$folder/bunny_2k.svg"
# The paper's counts read literally: 300 pieces of each vase, 100 of each column.
measure vase_300 vase "$@" --pieces 300
measure column_100 column "$@" --pieces 100
measure kernel --kernel
