#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every library that CMake looks for comes from a package that scripts/packages lists for those who need it: `build` for
# programs, `build` or `test` for what is only looked for with CROQUIS_BUILD_TESTS.
set -euo pipefail
project=$1
build=$2
command -v dpkg >/dev/null || { echo "no Debian here: skipped"; exit 77; }

# group NAME LIST
group() { sed -n "s/^$1: //p" "$2" | tr ' ' '\n'; }
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt" | head -n 1; }

# looked_for FILE: "NAME GROUP" for each find_package, its components and pkg_check_modules; pkg-config's as "pc:NAME"
looked_for() {
  awk '/^if\(CROQUIS_BUILD_TESTS/ { tests = 1 } /^if\(.*CROQUIS_WITH_OCCT/ { step = 1 } /^endif/ { tests = step = 0 }
       step { next }  # optional: the group `step` brings it
       match($0, /find_package\([A-Za-z0-9_]+/) {
         name = substr($0, RSTART + 13, RLENGTH - 13)
         print name, tests ? "test" : "build"
         if (match($0, /COMPONENTS [^)]+/)) {
           count = split(substr($0, RSTART + 11, RLENGTH - 11), parts, " ")
           for (i = 1; i <= count; ++i) print name parts[i], tests ? "test" : "build"
         }
       }
       match($0, /IMPORTED_TARGET [^)]+/) { print "pc:" substr($0, RSTART + 16, RLENGTH - 16), tests ? "test" : "build" }' "$1"
}

# file_of NAME: a file that only the wanted package can have brought
file_of() {
  local folder
  case "$1" in
    pc:*) echo "$(pkg-config --variable=pcfiledir "${1#pc:}")/${1#pc:}.pc" ;;
    GLPK) echo "$(cached GLPK_INCLUDE_DIR)/glpk.h" ;;
    OpenSubdiv) echo "$(cached OpenSubdiv_INCLUDE_DIR)/opensubdiv/far/topologyRefiner.h" ;;
    PNG) echo "$(cached PNG_PNG_INCLUDE_DIR)/png.h" ;;
    *)
      folder=$(cached "$1_DIR")
      ls "$folder/$1Config.cmake" "$folder/${1,,}-config.cmake" 2>/dev/null | head -n 1 || true
      ;;
  esac
}

# check LIST: each library is in the group of those who need it; names those that aren't, and their number is `seen`
seen=0
declare -A owners=()  # the packages of each library: dpkg is slow to tell
check() {
  local failed=0 name needed_by file packages listed
  seen=0
  while read -r name needed_by; do
    case "$name" in
      Threads) continue ;;    # the C library itself
      PkgConfig) continue ;;  # a program, which two packages may bring
    esac
    seen=$((seen + 1))
    file=$(file_of "$name")
    [ -n "$file" ] || { echo "$name: CMake's cache doesn't say where it was found" >&2; failed=1; continue; }
    [ -n "${owners[$name]+known}" ] ||
      owners[$name]=$(dpkg -S "$(readlink -f "$file")" "$file" 2>/dev/null | sed 's/:.*//; s/, /\n/g' | sort -u)
    packages=${owners[$name]}
    listed=$(group build "$1")
    [ "$needed_by" = build ] || listed+=$'\n'$(group test "$1")
    if ! grep -qxFf <(printf '%s\n' "$packages") <(printf '%s\n' "$listed"); then
      echo "$name comes from ${packages:-no package}, which scripts/packages doesn't list for '$needed_by'" >&2
      failed=1
    fi
  done < <(looked_for "$project/cmake/CroquisDependencies.cmake"; looked_for "$project/cmake/CroquisThirdParty.cmake")
  return "$failed"
}

failed=0
check "$project/scripts/packages" || failed=1
[ "$seen" -ge 20 ] || { echo "only $seen libraries were found in cmake/: the test reads it wrongly" >&2; exit 1; }

# A list that lacks a package must be noticed, or nothing above means anything.
short=$(mktemp)
trap 'rm -f "$short"' EXIT
for package in qt6-svg-dev libpugixml-dev libcgal-dev catch2; do
  sed "s/\b$package\b//" "$project/scripts/packages" >"$short"
  if check "$short" 2>/dev/null; then echo "nobody misses $package" >&2; failed=1; fi
done

elsewhere=$(grep -rlE '^ *(find_package|pkg_check_modules)\(' "$project" --include=CMakeLists.txt --include='*.cmake' \
  --exclude-dir=build --exclude-dir=outside | grep -vE '/cmake/Croquis(Dependencies|ThirdParty)\.cmake$' || true)
[ -z "$elsewhere" ] || { echo "libraries are looked for in cmake/ alone, not in $elsewhere" >&2; failed=1; }
echo "$seen libraries looked at"
exit "$failed"
