// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/fill_jobs.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "croquis/hole_filling/hole_groups.h"

namespace croquis::hole_filling {
namespace {

/// A loose triangle's rim, and that of up to four.
constexpr std::size_t most_stray_edges = 6;

/// Rims that requests bridge, those that stay open left out; true for each of them.
std::vector<bool> bridge_rims(const FillOptions& options, const std::vector<bool>& is_chosen, HoleGroups& together) {
  std::vector<bool> bridged(is_chosen.size(), false);
  for (const HoleRequest& request : options.requests) {
    if (!request.bridge) continue;
    std::vector<Index> rims;
    std::copy_if(request.holes.begin(), request.holes.end(), std::back_inserter(rims),
                 [&](Index hole) { return is_chosen[hole]; });
    if (rims.size() < 2) continue;
    for (const Index rim : rims) {
      together.merge(rims.front(), rim);
      bridged[rim] = true;
    }
  }
  return bridged;
}

/// Sets anything of the patch's shape, which then isn't flat.
bool shapes(const HoleRequest& request) {
  return request.fairness || request.kernel || request.bulge || !request.through.empty();
}

bool names_any(const HoleRequest& request, const std::vector<Index>& holes) {
  return std::ranges::find_first_of(request.holes, holes) != request.holes.end();
}

void apply(const HoleRequest& request, PatchWish& wish) {
  if (request.fairness) wish.fairness = *request.fairness;
  if (request.kernel) wish.implicit.kernel = *request.kernel;
  if (request.bulge) wish.bulge = *request.bulge;
  if (!request.through.empty()) wish.through = request.through;
}

}  // namespace

std::vector<FillJob> make_jobs(std::span<const Hole> holes, const FillOptions& options,
                               const std::vector<bool>& is_chosen) {
  HoleGroups together(holes.size());
  const std::vector<bool> bridged = bridge_rims(options, is_chosen, together);
  for (const Hole& hole : holes) {
    for (const Index other : hole.companions) {
      const bool both = is_chosen[hole.id] && is_chosen[other];
      if (both && !bridged[hole.id] && !bridged[other]) together.merge(hole.id, other);
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
      apply(request, job.wish);
      if (shapes(request) || (request.fill == true && !takes_outer)) job.is_cap = false;
    }
    if (!job.bridge) job.strays = strays_among(holes, job.holes);
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

std::vector<Index> strays_among(std::span<const Hole> all, const std::vector<Index>& group) {
  const Index largest = *std::ranges::max_element(group, {}, [&](Index hole) { return all[hole].diameter; });
  std::vector<Index> strays;
  for (const Index id : group) {
    const Hole& hole = all[id];
    const bool hangs = hole.kind == HoleClass::Islands && hole.shares_vertex;
    if (hangs && id != largest && hole.vertices.size() <= most_stray_edges) strays.push_back(id);
  }
  return strays;
}

FillJob without_strays(const FillJob& job) {
  FillJob rest = job;
  rest.holes.clear();
  rest.strays.clear();
  std::ranges::set_difference(job.holes, job.strays, std::back_inserter(rest.holes));
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
