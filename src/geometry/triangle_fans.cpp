// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/triangle_fans.h"

#include <algorithm>
#include <cstdint>

#include "croquis/base/parallel.h"

namespace croquis {
namespace {

/// Vertices that one thread takes at a time: enough that dividing the work costs little.
constexpr std::size_t fans_per_part = 4096;

}  // namespace

TriangleFans::TriangleFans(std::size_t vertex_count, std::span<const Index> corners)
    : corners_(corners), first_(vertex_count + 1, 0), corners_at_(corners.size()) {
  for (const Index v : corners) ++first_[v];
  Index end = 0;
  for (Index& first : first_) {
    end += first;
    first = end;  // one past the vertex' last corner; filling backwards leaves its first
  }
  for (std::size_t c = corners.size(); c-- > 0;) corners_at_[--first_[corners[c]]] = static_cast<Index>(c);
}

TriangleFans::Link TriangleFans::link(std::size_t vertex) const {
  const auto fan = at(vertex);
  if (fan.empty()) return Link::None;
  // Each triangle leads from its next vertex to its previous one.
  std::vector<std::array<Index, 2>> steps;
  steps.reserve(fan.size());
  for (const Index corner : fan) steps.push_back({next(corner), previous(corner)});
  std::sort(steps.begin(), steps.end());
  const auto after = [&](Index from) {
    return std::ranges::lower_bound(steps, from, {}, [](const auto& step) { return step[0]; });
  };
  std::vector<Index> ends;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i > 0 && steps[i][0] == steps[i - 1][0]) return Link::Broken;
    ends.push_back(steps[i][1]);
  }
  std::sort(ends.begin(), ends.end());
  if (std::adjacent_find(ends.begin(), ends.end()) != ends.end()) return Link::Broken;
  const auto begin = std::find_if(steps.begin(), steps.end(), [&](const auto& step) {
    return !std::binary_search(ends.begin(), ends.end(), step[0]);
  });
  const Index start = begin == steps.end() ? steps.front()[0] : (*begin)[0];
  std::size_t walked = 0;
  for (Index here = start; walked < steps.size(); ++walked) {
    const auto step = after(here);
    if (step == steps.end() || (*step)[0] != here) break;
    here = (*step)[1];
    if (here == start) return walked + 1 == steps.size() ? Link::Cycle : Link::Broken;
  }
  return walked == steps.size() ? Link::Path : Link::Broken;
}

std::vector<TriangleFans::Link> TriangleFans::links(int threads, Progress& progress) const {
  std::vector<Link> found(vertex_count());
  for_each_part(found.size(), fans_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) found[v] = link(v);
  });
  return found;
}

std::size_t open_loop_count(const TriangleFans& fans, std::span<const TriangleFans::Link> links) {
  // A rim edge leads from a vertex to the one after it that no triangle has before it.
  const auto next_on_rim = [&](std::size_t v) {
    const auto fan = fans.at(v);
    for (const Index corner : fan) {
      const Index after = fans.next(corner);
      if (std::none_of(fan.begin(), fan.end(), [&](Index other) { return fans.previous(other) == after; }))
        return after;
    }
    return no_index;
  };
  std::vector<std::uint8_t> seen(links.size(), 0);
  std::size_t loops = 0;
  for (std::size_t v = 0; v < links.size(); ++v) {
    if (links[v] != TriangleFans::Link::Path || seen[v] != 0) continue;
    ++loops;
    for (std::size_t here = v; here < seen.size() && seen[here] == 0; here = next_on_rim(here)) seen[here] = 1;
  }
  return loops;
}

}  // namespace croquis
