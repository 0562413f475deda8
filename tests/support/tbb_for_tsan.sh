#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds Debian's own oneTBB, of the version that is installed, under ThreadSanitizer, into build/tbb-tsan: the packaged
# one is not instrumented, so that a correct tbb::parallel_for over a vector is reported as dozens of races.
# Needs what the build needs, network for `apt-get source`, and some minutes. Run from anywhere, once, before
# `cmake --preset tsan`.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build="$root/build/tbb-tsan"
. /etc/os-release

rm -rf "$build"
mkdir -p "$build/lists/partial" "$build/source"
cd "$build"
# The machine's own lists stay as they are: sources are looked for in lists of this folder.
case "$ID" in
debian) echo "deb-src http://deb.debian.org/debian $VERSION_CODENAME main" ;;
ubuntu) echo "deb-src http://archive.ubuntu.com/ubuntu $VERSION_CODENAME universe" ;;
*) echo "tbb_for_tsan: knows Debian and Ubuntu; build oneTBB with -DTBB_SANITIZE=thread into $build/installed" >&2; exit 4 ;;
esac >"$build/sources.list"
apt=(apt-get -q -o "Dir::Etc::SourceList=$build/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o "Dir::State::Lists=$build/lists" -o "APT::Sandbox::User=$(id -un)")
"${apt[@]}" update
"${apt[@]}" --download-only source onetbb
# The archive as upstream made it: Debian's patches concern other machines, and unpacking needs no dpkg-dev.
tar xf onetbb_*.orig.tar.* -C source --strip-components=1
cmake -S source -B "$build/build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_INSTALL_PREFIX="$build/installed" \
    -DTBB_SANITIZE=thread -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF
cmake --build "$build/build" --target install
