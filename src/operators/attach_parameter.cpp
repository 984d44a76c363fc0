// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/attach_parameter.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {
namespace {

using silhouette::AttachedPair;

std::optional<double> read_number(std::string_view text) {
  double number = 0;
  const auto [stopped, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || stopped != text.data() + text.size()) return std::nullopt;
  return number;
}

std::string_view without_spaces(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::optional<AttachedPair> read_pair(std::string_view entry) {
  AttachedPair pair;
  const std::size_t equals = entry.rfind('=');
  if (equals != std::string_view::npos) {
    const std::optional<double> kappa = read_number(without_spaces(entry.substr(equals + 1)));
    if (!kappa) return std::nullopt;
    pair.kappa = *kappa;
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
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    const std::string_view entry = without_spaces(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
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
