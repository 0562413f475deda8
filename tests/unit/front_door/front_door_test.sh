#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The set-up script on a machine that lacks packages: names them, installs nothing when told so, and fails with code 4.
set -u
script=$1
fakes=$(mktemp -d)
trap 'rm -rf "$fakes"' EXIT
printf '#!/bin/sh\nexit 1\n' >"$fakes/dpkg-query"             # nothing is installed
printf '#!/bin/sh\ntouch "%s/apt_ran"\n' "$fakes" >"$fakes/apt-get"
chmod +x "$fakes"/*

failures=0
expect() {
    if ! eval "$2"; then
        echo "FAILED: $1"
        failures=$((failures + 1))
    fi
}

said=$(PATH="$fakes:$PATH" "$script" --no-install test 2>&1)
code=$?
expect "exit code 4 when packages are missing and may not be installed (got $code)" '[ "$code" -eq 4 ]'
expect "the missing packages are named" '[[ "$said" == *libassimp-dev* && "$said" == *libimgui-dev* ]]'
expect "what only a comparison needs is not among them" '[[ "$said" != *bullet* ]]'
expect "the remedy is named" '[[ "$said" == *"sudo apt-get install"* ]]'
expect "nothing was installed" '[ ! -e "$fakes/apt_ran" ]'

# A tree with nothing but the script and a program that says what it was called with.
tree=$fakes/tree
mkdir -p "$tree/build/release/app"
cp "$script" "$tree/demolish"
touch "$tree/build/release/build.ninja"
printf '#!/bin/sh\necho "$@"\n' >"$tree/build/release/app/demolish"
printf '#!/bin/sh\necho installed\n' >"$fakes/dpkg-query"
printf '#!/bin/sh\n' >"$fakes/cmake"  # nothing to build
chmod +x "$tree/build/release/app/demolish" "$fakes/cmake"
demo() { env -u DISPLAY -u WAYLAND_DISPLAY PATH="$fakes:$PATH" "$tree/demolish" demo "$@" 2>&1 | tail -1; }

said=$(demo)
expect "the demonstration without a display is a capture (said: $said)" \
    '[[ "$said" == "capture bunny --frames 150 --out $tree/out/bunny --video "*" --report "* ]]'
said=$(demo --frames 40 --out elsewhere)
expect "what the caller asks for is asked once (said: $said)" \
    '[[ "$said" == *" --frames 40 --out elsewhere" && "$said" != *"--frames 150"* && "$said" != *"--out $tree"* ]]'

[ "$failures" -eq 0 ]
