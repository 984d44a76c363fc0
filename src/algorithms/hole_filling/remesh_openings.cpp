// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/remesh_openings.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "algorithms/hole_filling/triangle_fans.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

/// The hole (or no_index: open on purpose) that most of the loop's vertices are nearest to; the lower of equals.
Index elected(const PolyMesh& surface, const Hole& loop, const implicit::PointTree& tree,
              const std::vector<Index>& hole_of) {
  std::map<Index, std::size_t> votes;
  for (const Index v : loop.vertices) ++votes[hole_of[tree.nearest(surface.positions[v])]];
  return std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

bool is_open(const PolyMesh& surface, int threads, Progress& progress) {
  const TriangleFans fans(surface.vertex_count(), surface.corners);
  const std::vector<TriangleFans::Link> links = fans.links(threads, progress);
  return std::any_of(links.begin(), links.end(), [](TriangleFans::Link link) {
    return link == TriangleFans::Link::Path || link == TriangleFans::Link::Broken;
  });
}

}  // namespace

Openings find_openings(const PolyMesh& surface, const PolyMesh& mesh, const RemeshPiece& piece,
                       const std::vector<RimPlace>& rims, int threads, Progress& progress) {
  Openings openings;
  Progress looking = progress.step("look for openings", 0.2);
  if (surface.face_count() == 0 || !is_open(surface, threads, looking)) return openings;
  std::vector<Vec3> places;
  std::vector<Index> hole_of;
  for (const RimPlace& rim : rims) {
    if (!std::binary_search(piece.vertices.begin(), piece.vertices.end(), rim.vertex)) continue;
    places.push_back(mesh.positions[rim.vertex]);
    hole_of.push_back(rim.hole);
  }
  const implicit::PointTree tree(places);
  Progress analysing = progress.step("measure openings", 0.8);
  for (const Hole& loop : analyse_holes(surface, analysing).holes) {
    const Index hole = places.empty() ? no_index : elected(surface, loop, tree, hole_of);
    if (hole == no_index && piece.stays_open) {
      ++openings.meant;
      continue;
    }
    openings.loops.push_back(loop.id);
    openings.holes.push_back(hole);
  }
  return openings;
}

std::size_t close_by_patches(PolyMesh& surface, Openings& openings, const FillOptions& options, Progress& progress) {
  FillOptions patching = options;
  patching.only = openings.loops;
  patching.requests.clear();
  patching.max_diameter = std::numeric_limits<double>::infinity();
  patching.trim_rim = 0;
  patching.mark_patches = false;
  patching.cache = nullptr;
  FillResult filled = fill_holes(surface, patching, progress);
  Openings left;
  left.meant = openings.meant;
  for (std::size_t i = 0; i < openings.loops.size(); ++i) {
    if (filled.outcomes[openings.loops[i]].action == FillAction::Fill) continue;
    left.loops.push_back(openings.loops[i]);
    left.holes.push_back(openings.holes[i]);
  }
  const std::size_t closed = openings.loops.size() - left.loops.size();
  surface = std::move(filled.mesh);
  openings = std::move(left);
  return closed;
}

}  // namespace croquis::hole_filling
