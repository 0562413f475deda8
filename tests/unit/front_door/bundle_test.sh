#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bundle_test.sh CMAKE BUILD: the installed program runs from where it lies, and no link of its pages is dead.
set -u
cmake=$1 build=$2
[ -x "$build/app/demolish" ] || exit 77
bundle=$(mktemp -d)
trap 'rm -rf "$bundle"' EXIT
failures=0
fail() {
    echo "FAILED: $1"
    failures=$((failures + 1))
}

"$cmake" --install "$build" --prefix "$bundle" --component program >"$bundle/said" 2>&1 || { cat "$bundle/said"; exit 1; }
env -i PATH="$PATH" "$bundle/bin/demolish" info >"$bundle/info" 2>&1 || { cat "$bundle/info"; fail "the program does not run"; }
grep -q bunny "$bundle/info" || fail "it finds no scenes"

pages=$(find "$bundle/share/demolish" -name '*.md')
[ "$(wc -w <<<"$pages")" -gt 20 ] || fail "pages are missing: $pages"
links=0
while IFS=: read -r page link; do
    target=${link#](}
    target=${target%)}
    target=${target%%#*}
    case $target in http*://* | "") continue ;; esac
    links=$((links + 1))
    [ -e "$(dirname "$page")/$target" ] || fail "${page#"$bundle"/} links to $target"
done < <(grep -oH '](\([^) ]*\))' $pages)
[ "$links" -gt 100 ] || fail "only $links links were found"
[ "$failures" -eq 0 ]
