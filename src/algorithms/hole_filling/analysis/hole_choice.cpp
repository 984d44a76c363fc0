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
                                  {numbered_subject(SubjectKind::Hole, first)}));
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

/// The place of the first of the widest holes, or no_index without any.
Index largest_of(std::span<const HoleSize> holes) {
  const auto found = std::ranges::max_element(holes, {}, &HoleSize::diameter);
  return found == holes.end() ? no_index : static_cast<Index>(found - holes.begin());
}

const char* reason_of(Naming naming) {
  switch (naming) {
    case Naming::Named: return nullptr;
    case Naming::NotChosen: return "not chosen";
    case Naming::Border: return "the border of an open surface";
    case Naming::Largest: return "the largest hole";
    case Naming::TooWide: return "wider than the limit";
  }
  return nullptr;
}

/// As `only` and the selection have it.
std::vector<Naming> named_by_options(std::span<const Hole> holes, const FillOptions& options) {
  std::vector<HoleSize> sizes;
  for (const Hole& hole : holes) sizes.push_back({hole.kind, hole.diameter});
  if (options.only.empty()) return named_holes(sizes, options.selection, options.max_diameter);
  std::vector<Naming> named = named_holes(sizes, Selection::All, options.max_diameter);
  for (std::size_t i = 0; i < holes.size(); ++i) {
    if (std::ranges::find(options.only, holes[i].id) == options.only.end()) named[i] = Naming::NotChosen;
  }
  return named;
}

}  // namespace

std::vector<Naming> named_holes(std::span<const HoleSize> holes, Selection selection, double max_diameter) {
  const Index largest = selection == Selection::AllButLargest ? largest_of(holes) : no_index;
  std::vector<Naming> named;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    if (selection == Selection::None)
      named.push_back(Naming::NotChosen);
    else if (selection == Selection::Inner && holes[i].kind == HoleClass::Outer)
      named.push_back(Naming::Border);
    else if (i == largest)
      named.push_back(Naming::Largest);
    else
      named.push_back(holes[i].diameter > max_diameter ? Naming::TooWide : Naming::Named);
  }
  return named;
}

HoleChoice choose_holes(std::span<const Hole> holes, const FillOptions& options) {
  require_known(holes, options);
  const auto asked = asked_for(holes.size(), options.requests);
  const std::vector<Naming> named = named_by_options(holes, options);
  HoleChoice choice{std::vector<bool>(holes.size(), true), std::vector<std::string>(holes.size()),
                    std::vector<bool>(holes.size(), false)};
  for (const Hole& hole : holes) {
    const auto& told = asked[hole.id];
    const char* reason = told ? (*told ? nullptr : "asked to stay open") : reason_of(named[hole.id]);
    if (reason == nullptr) continue;
    choice.is_chosen[hole.id] = false;
    choice.reason[hole.id] = reason;
    choice.is_border[hole.id] = !told && named[hole.id] == Naming::Border;
  }
  return choice;
}

}  // namespace croquis::hole_filling
