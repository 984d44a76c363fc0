// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/hole_choice.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "croquis/base/error.h"

namespace croquis::hole_filling {
namespace {

/// Ids that no hole has, as ranges (first, last).
std::vector<std::array<Index, 2>> unknown_ids(std::size_t hole_count, std::vector<Index> ids) {
  std::sort(ids.begin(), ids.end());
  std::vector<std::array<Index, 2>> ranges;
  for (const Index id : ids) {
    if (id < hole_count) continue;
    if (!ranges.empty() && id <= ranges.back()[1] + 1)
      ranges.back()[1] = id;
    else
      ranges.push_back({id, id});
  }
  return ranges;
}

void require_known(std::span<const Hole> holes, const FillOptions& options) {
  std::vector<Index> named = options.only;
  for (const HoleRequest& request : options.requests)
    named.insert(named.end(), request.holes.begin(), request.holes.end());
  Findings findings;
  for (const auto& [first, last] : unknown_ids(holes.size(), std::move(named))) {
    const std::string ids = std::to_string(first) + (last > first ? "-" + std::to_string(last) : "");
    findings.push_back(make_error(Category::Usage, "E_PARAMETER",
                                  "There is no hole " + ids + ": the mesh has " + std::to_string(holes.size()) +
                                      ", numbered from 0; list them first.",
                                  {{SubjectKind::Hole, std::to_string(first), {}, {}, {}}}));
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

/// What requests set for each hole: filled, left open, or nothing.
std::vector<std::optional<bool>> asked_for(std::size_t hole_count, std::span<const HoleRequest> requests) {
  std::vector<std::optional<bool>> asked(hole_count);
  for (const HoleRequest& request : requests) {
    const bool shapes =
        request.bridge || request.fairness || request.kernel || request.bulge || !request.through.empty();
    if (!request.fill && !shapes) continue;
    for (const Index hole : request.holes) asked[hole] = request.fill.value_or(true);
  }
  return asked;
}

Index largest_of(std::span<const Hole> holes) {
  std::vector<double> diameters;
  for (const Hole& hole : holes) diameters.push_back(hole.diameter);
  const Index place = largest_hole(diameters);
  return place == no_index ? no_index : holes[place].id;
}

/// Why the options for all holes leave this one open, or null.
const char* reason_to_leave(const Hole& hole, const FillOptions& options, Index largest) {
  if (!options.only.empty()) {
    if (std::find(options.only.begin(), options.only.end(), hole.id) == options.only.end()) return "not chosen";
  } else if (options.selection == Selection::None) {
    return "not chosen";
  } else if (options.selection == Selection::Inner && hole.kind == HoleClass::Outer) {
    return "the border of an open surface";
  } else if (options.selection == Selection::AllButLargest && hole.id == largest) {
    return "the largest hole";
  }
  return hole.diameter > options.max_diameter ? "wider than the limit" : nullptr;
}

}  // namespace

Index largest_hole(std::span<const double> diameters) {
  const auto found = std::ranges::max_element(diameters);
  return found == diameters.end() ? no_index : static_cast<Index>(found - diameters.begin());
}

HoleChoice choose_holes(std::span<const Hole> holes, const FillOptions& options) {
  require_known(holes, options);
  const auto asked = asked_for(holes.size(), options.requests);
  const Index largest = largest_of(holes);
  HoleChoice choice{std::vector<bool>(holes.size(), true), std::vector<std::string>(holes.size())};
  for (const Hole& hole : holes) {
    const bool is_told = asked[hole.id].has_value();
    const char* reason =
        is_told ? (*asked[hole.id] ? nullptr : "asked to stay open") : reason_to_leave(hole, options, largest);
    if (reason == nullptr) continue;
    choice.is_chosen[hole.id] = false;
    choice.reason[hole.id] = reason;
  }
  return choice;
}

}  // namespace croquis::hole_filling
