#!/usr/bin/env bash
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
expect "the remedy is named" '[[ "$said" == *"sudo apt-get install"* ]]'
expect "nothing was installed" '[ ! -e "$fakes/apt_ran" ]'

[ "$failures" -eq 0 ]
