#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The tables of docs/measurements/methods.md from what was measured: a row for each method of each scene.
#   tests/bench_results/methods_table.sh FOLDER
# The folder holds SCENE.json and SCENE_*.json of `demolish bench SCENE --methods --json FILE` and of
# `bullet_bench SCENE --json FILE`. A method that is in several files is taken from the first. Needs jq.
set -euo pipefail
folder=${1:?a folder with JSON files}
echo "| scene, cells | method | paper's FPS | FPS whole | FPS broken | sim ms | pieces | single cells | half in | largest | map moved | outline, h / rad per h | energy |"
echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
for scene in bunny wolf vase column; do
    files=()
    for file in "$folder/$scene".json "$folder/$scene"_*.json; do
        [[ -s $file ]] && files+=("$file")
    done
    ((${#files[@]})) || continue
    jq -rs '
        def digits($n): . * pow(10; $n) | round | tostring
            | if $n == 0 then . else ("0" * ([$n + 1 - length, 0] | max) // "") + . | .[:-$n] + "." + .[-$n:] end;
        def thousands: tostring | if length > 3 then .[:-3] + "," + .[-3:] else . end;
        def rate: if . == 0 then "" elif . < 9.95 then digits(1) elif . < 99.5 then digits(1)
            else round | thousands end;
        ["pattern-at-impact", "heavy", "pattern", "cores", "ours", "bullet"] as $order
        | .[0] as $place
        | [.[] | .particles as $cells | .methods[] | . + {cells: $cells}] | . as $rows
        | (any($rows[]; .name == "cores") | not) as $alone  # a machine without a GPU: the two are one run
        | def called: if $alone and .name == "ours" then "`cores`, `ours`" else "`\(.name)`" end
              + if .cells == $place.particles then "" else " of \(.cells | thousands) cells" end;
        def paper: if $alone and .name == "ours" then "real, 60" elif .name == "cores" then "real" elif .paper_fps == null then "" else .paper_fps end;
        [$order[] as $name | $rows | map(select(.name == $name)) | .[0] // empty]
        | to_entries[] | .key as $at | .value
        | "| \(if $at == 0 then "\($place.scene), \($place.particles | thousands)" else "" end) | \(called) | \(paper)"
          + " | \(.fps_whole | rate) | \(.fps_broken | rate) | \(.sim_ms | if . < 9.995 then digits(2) else digits(1) end)"
          + " | \(.pieces | thousands) | \(.single_cells | thousands) | \(.pieces_of_half) | \(100 * .largest_share | digits(1)) %"
          + " | \(.map_distance | digits(2))"
          + " | \(if .outline then "\(.outline.deviation_h | digits(3)) / \(.outline.turning_rad_per_h | digits(2))" else "" end)"
          + " | \(if .energy_closure then .energy_closure | digits(4) else "≤ \(.most_energy | digits(3))" end) |"' \
        "${files[@]}"
done
