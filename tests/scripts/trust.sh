#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# docs/trust.md has one row for each stage of scripts/test --full, and scripts/trust enters results in it.
set -euo pipefail
project=$1
folder=$3
cd "$project"
fail() { echo "$*" >&2; exit 1; }

diff <(scripts/test --full --list) <(sed -n 's/^| `\([^`]*\)` .*/\1/p' docs/trust.md) ||
  fail "the stages of scripts/test --full and the rows of docs/trust.md differ"

# A change to one system leaves the mutators of the others, and nothing else, as they were.
paths=$(scripts/test --full --paths mutate-cage)
for system in src/algorithms/*/; do
  system=$(basename "$system")
  [ "$system" = mesh_editing ] || [ "$system" = subdivision ] || grep -qxF ":!src/algorithms/$system" <<<"$paths" ||
    fail "damaged cages are said to depend on $system"
done
! grep -q subdivision <<<"$paths" || fail "damaged cages are said not to depend on subdivision"
! scripts/test --full --paths counts | grep -q algorithms || fail "the tests are said not to depend on all systems"

mkdir -p "$folder"
page=$folder/page.md
cp docs/trust.md "$page"
git rev-parse -q --verify HEAD >/dev/null || { echo "no repository here: skipped"; exit 77; }
scripts/trust --page "$page" write threads passed "5 tests | none failed"
grep -qE '^\| `threads` \| [^|]+ \| [0-9a-f]{10}(, changed)? \| [0-9]{4}-[0-9]{2}-[0-9]{2} \| passed \| 5 tests , none failed \|$' "$page" ||
  fail "the row isn't as wanted: $(grep threads "$page")"
[ "$(diff docs/trust.md "$page" | grep -c '^>')" -eq 1 ] || fail "another row changed as well"

# A folder that no commit ever held is the same as on any commit, and a stage that failed never counts.
sed -i '/^| `threads`/s/, changed//' "$page"
scripts/trust --page "$page" holds threads no-such-folder || fail "a stage that passed doesn't count"
scripts/trust --page "$page" write threads failed "1 test failed"
! scripts/trust --page "$page" holds threads no-such-folder || fail "a stage that failed counts"
! scripts/trust --page "$page" write no-such-stage passed x 2>/dev/null || fail "a stage without a row was entered"
