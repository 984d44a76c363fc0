#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Programs configure without what only tests need: scripts/run installs no more than that.
set -euo pipefail
project=$1
folder=$3

rm -rf "$folder"
cmake -S "$project" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCROQUIS_BUILD_TESTS=OFF \
  -DCMAKE_DISABLE_FIND_PACKAGE_Catch2=ON -DCMAKE_DISABLE_FIND_PACKAGE_glfw3=ON \
  -DCMAKE_DISABLE_FIND_PACKAGE_Qt6Test=ON
ninja -C "$folder" -n croquis croquis-cli >/dev/null

# The test can fail: with tests, the same must be refused.
if cmake -S "$project" -B "$folder" -DCROQUIS_BUILD_TESTS=ON >/dev/null 2>&1; then
  echo "tests were configured without Catch2: nothing was proved" >&2
  exit 1
fi
