// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/hole_ids.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {
namespace {

/// More holes than any mesh has that fits into memory; a longer range is a typing error.
constexpr Index most_ids = 10000000;

std::optional<Index> parse_id(std::string_view word) {
  Index id = 0;
  const auto [stopped, error] = std::from_chars(word.data(), word.data() + word.size(), id);
  if (error != std::errc{} || stopped != word.data() + word.size()) return std::nullopt;
  return id;
}

Finding refused_ids(std::string_view word) {
  return make_error(
      Category::Usage, "E_PARAMETER",
      "'" + std::string(word) + "' is no value for only: it takes the numbers of holes, counted from 0, such as 0,3-5.",
      {{SubjectKind::Parameter, "only", {}, {}, {}}});
}

}  // namespace

bool append_hole_ids(std::string_view word, std::vector<Index>& ids) {
  const std::size_t dash = word.find('-');
  const auto first = parse_id(word.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parse_id(word.substr(dash + 1));
  if (!first || !last || *last < *first || *last - *first >= most_ids) return false;
  for (Index id = *first; id < *last; ++id) ids.push_back(id);
  ids.push_back(*last);
  return true;
}

std::vector<Index> parse_hole_ids(const std::string& text) {
  std::vector<Index> ids;
  Findings findings;
  constexpr const char* separators = ",; ";
  for (std::size_t at = text.find_first_not_of(separators); at != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    const std::string_view word = std::string_view(text).substr(at, end - at);
    if (!append_hole_ids(word, ids)) findings.push_back(refused_ids(word));
    at = text.find_first_not_of(separators, end);
  }
  if (ids.empty() && findings.empty() && !text.empty()) findings.push_back(refused_ids(text));
  if (!findings.empty()) throw Error(std::move(findings));
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::string hole_ids_text(const std::vector<Index>& ids, char separator) {
  std::string text;
  for (std::size_t i = 0; i < ids.size();) {
    std::size_t last = i;
    while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1) ++last;
    if (!text.empty()) text += separator;
    text += std::to_string(ids[i]);
    if (last > i) text += '-' + std::to_string(ids[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace croquis
