// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/fill_settings.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {
namespace {

using hole_filling::Fairness;
using hole_filling::FillOptions;
using hole_filling::Precision;
using hole_filling::Selection;

/// More holes than any mesh has that fits into memory; a longer range is a slip of the pen.
constexpr Index most_ids = 10000000;

ParameterDescription choice(const std::string& name, const std::vector<std::string>& choices,
                            const std::string& sentence) {
  return {name, ParameterType::Choice, choices.front(), 0, 0, choices, "", sentence};
}

const std::string& text(const ParameterValues& parameters, const std::string& name) {
  return std::get<std::string>(parameters.at(name));
}

std::optional<Index> parse_id(std::string_view word) {
  Index id = 0;
  const auto [stopped, error] = std::from_chars(word.data(), word.data() + word.size(), id);
  if (error != std::errc{} || stopped != word.data() + word.size()) return std::nullopt;
  return id;
}

/// "7", or "3-5" for 3, 4 and 5.
bool append_ids(std::string_view word, std::vector<Index>& ids) {
  const std::size_t dash = word.find('-');
  const auto first = parse_id(word.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parse_id(word.substr(dash + 1));
  if (!first || !last || *last < *first || *last - *first >= most_ids) return false;
  for (Index id = *first; id < *last; ++id) ids.push_back(id);
  ids.push_back(*last);
  return true;
}

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
  constexpr const char* separators = ",; ";
  for (std::size_t at = text.find_first_not_of(separators); at != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    const std::string_view word = std::string_view(text).substr(at, end - at);
    if (!append_ids(word, ids)) findings.push_back(refused_ids(word));
    at = text.find_first_not_of(separators, end);
  }
  if (ids.empty() && findings.empty() && !text.empty()) findings.push_back(refused_ids(text));
  if (!findings.empty()) throw Error(std::move(findings));
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<ParameterDescription> fill_parameters() {
  return {choice("mode", {"patch"}, "patch closes holes and changes nothing else."),
          choice("select", {"inner", "all", "all-but-largest"},
                 "inner fills all holes that don't look like the border of an open surface."),
          {"only",
           ParameterType::Text,
           std::string(),
           0,
           0,
           {},
           "",
           "Numbers of the holes to fill instead, as the list shows them: 0,3-5.",
           true},
          {"max-diameter",
           ParameterType::Number,
           0.0,
           0,
           std::numeric_limits<double>::infinity(),
           {},
           "model units",
           "Wider holes stay open; 0 for no limit."},
          choice("fairness", {"rbf", "smooth", "flat"},
                 "rbf continues the surface around by functions fitted to it, smooth its tangents; flat adds no "
                 "vertices and has the least area."),
          choice("precision", {"double", "single"},
                 "How coordinates will be stored, by which patches are judged; files of single numbers set it."),
          {"patch-ids",
           ParameterType::Flag,
           true,
           0,
           0,
           {},
           "",
           "Mark each face with the number of its patch, -1 for the scan's own; files other than PLY can't hold it."},
          {"list",
           ParameterType::Flag,
           false,
           0,
           0,
           {},
           "",
           "Only list the holes and which of them would be filled; write nothing."}};
}

FillSettings read_fill_settings(const ParameterValues& parameters) {
  FillSettings settings;
  FillOptions& options = settings.options;
  const std::string& select = text(parameters, "select");
  if (select == "all") options.selection = Selection::All;
  if (select == "all-but-largest") options.selection = Selection::AllButLargest;
  options.only = parse_hole_ids(text(parameters, "only"));
  const double limit = std::get<double>(parameters.at("max-diameter"));
  if (limit > 0) options.max_diameter = limit;
  const std::string& fairness = text(parameters, "fairness");
  if (fairness == "rbf") options.fairness = Fairness::Implicit;
  if (fairness == "smooth") options.fairness = Fairness::Tangent;
  if (fairness == "flat") options.fairness = Fairness::Flat;
  if (text(parameters, "precision") == "single") options.precision = Precision::Single;
  options.mark_patches = std::get<bool>(parameters.at("patch-ids"));
  settings.list_only = std::get<bool>(parameters.at("list"));
  return settings;
}

}  // namespace croquis
