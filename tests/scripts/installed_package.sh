#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed can be used: a project outside finds the package, links one library, and makes a solid.
set -euo pipefail
project=$1
build=$2
folder=$3

rm -rf "$folder"
mkdir -p "$folder"
cmake --install "$build" --prefix "$folder/prefix" >/dev/null
cmake -S "$project/tests/outside" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$folder/prefix"
cmake --build "$folder/build"
"$folder/build/outside" | grep -q "a ball"

# Nothing of it may point back into the tree it was built from.
if grep -rIl -e "$project" -e "$build" "$folder/prefix/lib/cmake" "$folder/prefix/lib/"*/cmake 2>/dev/null; then
  echo "the installed package names the source tree" >&2
  exit 1
fi
"$folder/prefix/bin/croquis-cli" --version
