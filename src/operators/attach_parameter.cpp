// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/attach_parameter.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

using silhouette::AttachedPair;

std::string_view without_spaces(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::optional<AttachedPair> read_pair(std::string_view entry) {
  AttachedPair pair;
  const std::size_t equals = entry.rfind('=');
  if (equals != std::string_view::npos) {
    if (!read_number(without_spaces(entry.substr(equals + 1)), pair.kappa)) return std::nullopt;
    entry = entry.substr(0, equals);
  }
  const std::size_t comma = entry.find(',');
  if (comma == std::string_view::npos || entry.find(',', comma + 1) != std::string_view::npos) return std::nullopt;
  pair.a = without_spaces(entry.substr(0, comma));
  pair.b = without_spaces(entry.substr(comma + 1));
  if (pair.a.empty() || pair.b.empty()) return std::nullopt;
  return pair;
}

}  // namespace

std::vector<AttachedPair> parse_attached_pairs(const std::string& text) {
  std::vector<AttachedPair> pairs;
  Findings findings;
  for (const std::string_view part : text_parts(text, ";")) {
    const std::string_view entry = without_spaces(part);
    if (entry.empty()) continue;
    if (std::optional<AttachedPair> pair = read_pair(entry)) {
      pairs.push_back(*std::move(pair));
    } else {
      findings.push_back(
          make_error(Category::Usage, "E_PARAMETER",
                     "'" + std::string(entry) + "' is no value for attach: it takes two names as A,B or A,B=0.55.",
                     {{SubjectKind::Parameter, "attach", {}, {}, {}}}));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return pairs;
}

}  // namespace croquis
