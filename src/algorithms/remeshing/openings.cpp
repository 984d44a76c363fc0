// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/openings.h"

#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <variant>

#include "croquis/geometry/triangle_fans.h"
#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

// Where views end. What closes in on itself has patches that fold less at their rims, whatever the tilt.
constexpr double end_tilt = 60 * std::numbers::pi / 180;
constexpr double end_fold = 6 * std::numbers::pi / 180;

bool is_open(const PolyMesh& surface, int threads, Progress progress) {
  const TriangleFans fans(surface.vertex_count(), surface.corners);
  return std::ranges::any_of(fans.links(threads, progress), [](TriangleFans::Link link) {
    return link == TriangleFans::Link::Path || link == TriangleFans::Link::Broken;
  });
}

/// Options name rims of the mesh given: a loop that views leave is none of them, but where a rim that was named is
/// near.
bool stays_open(const Hole& loop, const Opening& opening, const FillOptions& options) {
  if (opening.rule != RimRule::Seam) return opening.rule == RimRule::Open;
  if (!options.only.empty()) return opening.hole == no_index;
  const HoleSize size{loop.kind, loop.diameter};
  return named_holes({&size, 1}, options.selection, options.max_diameter).front() != Naming::Named;
}

/// Whether nothing near shows the shape of what views leave between them, so that the best patch is a guess; or it is
/// the end of what they saw of a limb, or of the inside of a pot, and no hole in what they saw: wide, and the surface
/// around leads on out of it, where its patch doesn't follow.
bool is_guess(const FillResult& filled, const Opening& opening) {
  const HoleOutcome& outcome = filled.outcomes[opening.loop];
  if (opening.rule != RimRule::Seam || outcome.action != FillAction::Fill) return false;
  if (outcome.confidence < low_confidence) return true;
  return is_wide(filled.analysis, opening.loop) && filled.analysis.holes[opening.loop].conormal_tilt < end_tilt &&
         outcome.mean_fold > end_fold;
}

/// Asks for flat patches of those openings for which that holds. @return whether there are any
template <typename Holds>
bool request_flat(const Openings& openings, const Holds& is_flat, FillOptions& patching) {
  HoleRequest flat;
  flat.fairness = Fairness::Flat;
  for (const Opening& opening : openings.loops)
    if (is_flat(opening)) flat.holes.push_back(opening.loop);
  if (flat.holes.empty()) return false;
  patching.requests.push_back(std::move(flat));
  return true;
}

}  // namespace

std::vector<Index> Openings::holes() const {
  std::vector<Index> holes;
  for (const Opening& opening : loops) holes.push_back(opening.hole);
  return holes;
}

Openings find_openings(const PolyMesh& surface, const PolyMesh& mesh, const RemeshPiece& piece,
                       const RemeshPieces& pieces, const FillOptions& options, Progress progress) {
  Openings openings;
  if (surface.face_count() == 0 || !is_open(surface, options.threads, progress.step("look for openings", 0.2)))
    return openings;
  std::vector<Vec3> places;
  std::vector<std::pair<RimRule, Index>> rims;
  pieces.for_each_rim(piece, [&](Index, const RimPlace& rim) {
    places.push_back(mesh.positions[rim.vertex]);
    rims.emplace_back(rim.rule, rim.hole);
  });
  const implicit::PointTree tree(places);
  Progress analysing = progress.step("measure openings", 0.8);
  for (const Hole& loop : analyse_holes(surface, analysing).holes) {
    Opening opening{loop.id, no_index, RimRule::Field};
    if (!places.empty()) {
      std::map<std::pair<RimRule, Index>, std::size_t> votes;  // of equals the lower one counts
      for (const Index v : loop.vertices) ++votes[rims[tree.nearest(surface.positions[v])]];
      const auto most = std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; });
      std::tie(opening.rule, opening.hole) = most->first;
    }
    if (!stays_open(loop, opening, options)) {
      openings.loops.push_back(opening);
      continue;
    }
    ++openings.meant;
    if (opening.hole != no_index && opening.rule == RimRule::Seam) openings.left.push_back(opening.hole);
  }
  return openings;
}

PatchedOpenings close_by_patches(PolyMesh& surface, Openings& openings, const FillOptions& options, Progress progress) {
  FillOptions patching = options;
  patching.only.clear();
  for (const Opening& opening : openings.loops) patching.only.push_back(opening.loop);
  patching.requests.clear();
  patching.max_diameter = std::numeric_limits<double>::infinity();
  patching.trim_rim = 0;
  patching.mark_patches = true;
  patching.cache = nullptr;
  request_flat(
      openings, [](const Opening& opening) { return opening.rule == RimRule::Patch; }, patching);
  const std::size_t first_face = surface.face_count();
  FillResult filled = fill_holes(surface, patching, progress);
  if (request_flat(
          openings, [&](const Opening& opening) { return is_guess(filled, opening); }, patching))
    filled = fill_holes(surface, patching, progress);
  PatchedOpenings patched;
  std::vector<Opening> left;
  std::map<std::int32_t, Index> hole_of_patch;
  for (const Opening& opening : openings.loops) {
    const HoleOutcome& outcome = filled.outcomes[opening.loop];
    if (outcome.action != FillAction::Fill) {
      left.push_back(opening);
      continue;
    }
    patched.closed.emplace_back(opening, outcome);
    hole_of_patch.emplace(static_cast<std::int32_t>(outcome.patch), opening.hole);
  }
  if (const AttributeChannel* channel = filled.mesh.channel(patch_channel, Domain::Face)) {
    const auto& patch_of = std::get<std::vector<std::int32_t>>(channel->data);
    for (std::size_t f = first_face; f < patch_of.size(); ++f)
      patched.faces.emplace_back(f, hole_of_patch[patch_of[f]]);
  }
  surface = std::move(filled.mesh);
  surface.channels.clear();
  openings.loops = std::move(left);
  return patched;
}

}  // namespace croquis::remeshing
