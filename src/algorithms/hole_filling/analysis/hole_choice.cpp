// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/hole_choice.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"

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

/// Sets anything of the patch's shape, which then isn't flat.
bool shapes(const HoleRequest& request) {
  return request.fairness || request.kernel || request.bulge || !request.through.empty();
}

/// What requests set for each hole: filled, left open, or nothing.
std::vector<std::optional<bool>> asked_for(std::size_t hole_count, std::span<const HoleRequest> requests) {
  std::vector<std::optional<bool>> asked(hole_count);
  for (const HoleRequest& request : requests) {
    if (!request.fill && !request.bridge && !shapes(request)) continue;
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

/// A loose triangle's rim, and that of up to four.
constexpr std::size_t most_stray_edges = 6;

/// Rims that requests bridge, those that stay open left out; true for each of them.
std::vector<bool> bridge_rims(const FillOptions& options, const std::vector<bool>& is_chosen, DisjointSets& together) {
  std::vector<bool> bridged(is_chosen.size(), false);
  for (const HoleRequest& request : options.requests) {
    if (!request.bridge) continue;
    std::vector<Index> rims;
    std::copy_if(request.holes.begin(), request.holes.end(), std::back_inserter(rims),
                 [&](Index hole) { return is_chosen[hole]; });
    sort_unique(rims);
    if (rims.size() < 2) continue;
    for (const Index rim : rims) {
      together.unite(rims.front(), rim);
      bridged[rim] = true;
    }
  }
  return bridged;
}

bool names_any(const HoleRequest& request, const std::vector<Index>& holes) {
  return std::ranges::find_first_of(request.holes, holes) != request.holes.end();
}

void apply(const HoleRequest& request, PatchSettings& settings) {
  if (request.fairness) settings.fairness = *request.fairness;
  if (request.kernel) settings.implicit.kernel = *request.kernel;
  if (request.bulge) settings.bulge = *request.bulge;
  if (!request.through.empty()) settings.through = request.through;
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
    const auto& given = asked[hole.id];
    const char* reason = given ? (*given ? nullptr : "asked to stay open") : reason_of(named[hole.id]);
    if (reason == nullptr) continue;
    choice.is_chosen[hole.id] = false;
    choice.reason[hole.id] = reason;
    choice.is_border[hole.id] = !given && named[hole.id] == Naming::Border;
  }
  return choice;
}

std::vector<FillJob> make_jobs(std::span<const Hole> holes, const FillOptions& options,
                               const std::vector<bool>& is_chosen) {
  DisjointSets together(holes.size());
  const std::vector<bool> bridged = bridge_rims(options, is_chosen, together);
  for (const Hole& hole : holes) {
    for (const Index other : hole.companions) {
      const bool both = is_chosen[hole.id] && is_chosen[other];
      if (both && !bridged[hole.id] && !bridged[other]) together.unite(hole.id, other);
    }
  }
  const bool takes_outer = options.selection == Selection::All || options.selection == Selection::AllButLargest;
  std::vector<FillJob> jobs;
  for (std::vector<Index>& group : together.lists()) {
    const Index first = group.front();
    if (!is_chosen[first]) continue;
    FillJob job{std::move(group), {options.fairness, options.implicit, options.bulge, {}}, bridged[first], false};
    const bool is_named = std::ranges::find(options.only, first) != options.only.end();
    job.is_cap = options.flat_caps && holes[first].kind == HoleClass::Outer && !job.bridge && !is_named;
    for (const HoleRequest& request : options.requests) {
      if (!names_any(request, job.holes)) continue;
      apply(request, job.settings);
      if (shapes(request) || (request.fill == true && !takes_outer)) job.is_cap = false;
    }
    if (!job.bridge) job.detached = detached_among(holes, job.holes);
    jobs.push_back(std::move(job));
  }
  return jobs;
}

std::vector<FillJob> waiting_jobs(std::span<const Hole> holes, const FillOptions& options,
                                  const std::vector<bool>& is_border) {
  std::vector<FillJob> jobs;
  for (const Hole& hole : holes) {
    if (!is_border[hole.id]) continue;
    jobs.push_back({{hole.id}, {options.fairness, options.implicit, options.bulge, {}}, false, false, true});
  }
  return jobs;
}

std::vector<Index> detached_among(std::span<const Hole> all, const std::vector<Index>& group) {
  const Index largest = *std::ranges::max_element(group, {}, [&](Index hole) { return all[hole].diameter; });
  std::vector<Index> detached;
  for (const Index id : group) {
    const Hole& hole = all[id];
    const bool hangs = hole.kind == HoleClass::Islands && hole.shares_vertex;
    if (hangs && id != largest && hole.vertices.size() <= most_stray_edges) detached.push_back(id);
  }
  return detached;
}

FillJob without_detached(const FillJob& job) {
  FillJob rest = job;
  rest.holes.clear();
  rest.detached.clear();
  std::ranges::set_difference(job.holes, job.detached, std::back_inserter(rest.holes));
  return rest;
}

std::vector<int> rings_to_trim(std::span<const Hole> holes, const FillOptions& options,
                               const std::vector<bool>& is_chosen) {
  std::vector<int> rings(holes.size(), options.trim_rim);
  for (const HoleRequest& request : options.requests) {
    if (!request.trim_rim) continue;
    for (const Index hole : request.holes) rings[hole] = *request.trim_rim;
  }
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (!is_chosen[i]) rings[i] = 0;
  }
  return rings;
}

}  // namespace croquis::hole_filling
