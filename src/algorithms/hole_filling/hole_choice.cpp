// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/hole_choice.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"

namespace croquis::hole_filling {
namespace {

void require_known(std::span<const Hole> holes, const std::vector<Index>& only) {
  Findings findings;
  for (const Index id : only) {
    if (id < holes.size()) continue;
    findings.push_back(make_error(Category::Usage, "E_PARAMETER",
                                  "There is no hole " + std::to_string(id) + ": the mesh has " +
                                      std::to_string(holes.size()) + ", numbered from 0; list them first.",
                                  {{SubjectKind::Hole, std::to_string(id), {}, {}, {}}}));
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

Index longest(std::span<const Hole> holes) {
  const auto found = std::max_element(holes.begin(), holes.end(),
                                      [](const Hole& a, const Hole& b) { return a.perimeter < b.perimeter; });
  return found == holes.end() ? no_index : found->id;
}

}  // namespace

HoleChoice choose_holes(std::span<const Hole> holes, const FillOptions& options) {
  require_known(holes, options.only);
  HoleChoice choice{std::vector<bool>(holes.size(), true), std::vector<std::string>(holes.size())};
  const auto leave = [&](Index hole, const char* reason) {
    choice.is_chosen[hole] = false;
    choice.reason[hole] = reason;
  };
  const Index largest = longest(holes);
  for (const Hole& hole : holes) {
    if (!options.only.empty()) {
      if (std::find(options.only.begin(), options.only.end(), hole.id) == options.only.end())
        leave(hole.id, "not chosen");
    } else if (options.selection == Selection::None) {
      leave(hole.id, "not chosen");
    } else if (options.selection == Selection::Inner && hole.kind == HoleClass::Outer) {
      leave(hole.id, "the border of an open surface");
    } else if (options.selection == Selection::AllButLargest && hole.id == largest) {
      leave(hole.id, "the largest hole");
    }
    if (choice.is_chosen[hole.id] && hole.diameter > options.max_diameter) leave(hole.id, "wider than the limit");
  }
  return choice;
}

}  // namespace croquis::hole_filling
