// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/hole_ids.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/index_list.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

Finding refused_ids(std::string_view word) {
  return make_error(
      Category::Usage, "E_PARAMETER",
      "'" + std::string(word) + "' is no value for only: it takes the numbers of holes, counted from 0, such as 0,3-5.",
      {{SubjectKind::Parameter, "only", {}, {}, {}}});
}

}  // namespace

std::vector<Index> parse_hole_ids(const std::string& text) {
  std::vector<Index> ids;
  Findings findings;
  for (const std::string_view word : text_parts(text, ",; ")) {
    if (!append_indices(word, ids)) findings.push_back(refused_ids(word));
  }
  if (ids.empty() && findings.empty() && !text.empty()) findings.push_back(refused_ids(text));
  if (!findings.empty()) throw Error(std::move(findings));
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

}  // namespace croquis
