// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_openings.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <variant>

#include "algorithms/remeshing/remesh_attributes.h"
#include "croquis/geometry/triangle_fans.h"
#include "croquis/hole_filling/channel_names.h"
#include "croquis/hole_filling/patch_confidence.h"
#include "croquis/hole_filling/wide_holes.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

// Where views end. What closes in on itself has patches that fold less at their rims, whatever the tilt.
constexpr double end_tilt = 60 * std::numbers::pi / 180;
constexpr double end_fold = 6 * std::numbers::pi / 180;

using RimName = std::pair<RimFate, Index>;

/// The fate and hole of the rim that most of the loop's vertices are nearest to; the lower of equals.
RimName elected(const PolyMesh& surface, const Hole& loop, const implicit::PointTree& tree,
                const std::vector<RimName>& names) {
  std::map<RimName, std::size_t> votes;
  for (const Index v : loop.vertices) ++votes[names[tree.nearest(surface.positions[v])]];
  return std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// Wishes name rims of the mesh given: a loop that views leave is none of them, but where a rim that was named is near.
bool stays_open(const Hole& loop, const RimName& name, const FillOptions& options) {
  const auto& [fate, hole] = name;
  if (fate != RimFate::Seam) return fate == RimFate::Open;
  if (!options.only.empty()) return hole == no_index;
  const HoleSize size{loop.kind, loop.diameter};
  return named_holes({&size, 1}, options.selection, options.max_diameter).front() != Naming::Named;
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
                       const std::vector<RimPlace>& rims, const FillOptions& options, Progress& progress) {
  Openings openings;
  Progress looking = progress.step("look for openings", 0.2);
  if (surface.face_count() == 0 || !is_open(surface, options.threads, looking)) return openings;
  std::vector<Vec3> places;
  std::vector<RimName> names;
  for (const RimPlace& rim : rims) {
    if (!std::binary_search(piece.vertices.begin(), piece.vertices.end(), rim.vertex)) continue;
    places.push_back(mesh.positions[rim.vertex]);
    names.emplace_back(rim.fate, rim.hole);
  }
  const implicit::PointTree tree(places);
  Progress analysing = progress.step("measure openings", 0.8);
  for (const Hole& loop : analyse_holes(surface, analysing).holes) {
    const RimName name = places.empty() ? RimName(RimFate::Field, no_index) : elected(surface, loop, tree, names);
    if (stays_open(loop, name, options)) {
      ++openings.meant;
      if (name.second != no_index && name.first == RimFate::Seam) openings.left.push_back(name.second);
      continue;
    }
    openings.loops.push_back(loop.id);
    openings.holes.push_back(name.second);
    openings.fates.push_back(name.first);
  }
  return openings;
}

/// Mean angle between a patch and the surface around, radians, by the rim edges of a loop that the patch closes.
double mean_fold(const FillResult& filled, Index loop) {
  const PolyMesh& mesh = filled.mesh;
  const SurfaceView& view = filled.analysis.view;
  const auto* channel = mesh.channel(patch_channel, Domain::Face);
  const auto& patch_of = std::get<std::vector<std::int32_t>>(channel->data);
  const auto patch = static_cast<std::int32_t>(filled.outcomes[loop].patch);
  std::map<std::pair<Index, Index>, std::size_t> face_at;
  for (std::size_t f = 0; f < patch_of.size(); ++f) {
    if (patch_of[f] != patch) continue;
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < 3; ++k) face_at[{face[k], face[(k + 1) % 3]}] = f;
  }
  double sum = 0, length = 0;
  for (const Index corner : filled.analysis.holes[loop].corners) {
    const Index a = view.origin(corner), b = view.target(corner);
    const auto across = face_at.find({b, a});
    if (across == face_at.end()) continue;
    const double edge = (mesh.positions[b] - mesh.positions[a]).norm();
    sum += edge * angle_between(face_normal(mesh, view.face[corner / 3]), face_normal(mesh, across->second));
    length += edge;
  }
  return length > 0 ? sum / length : 0;
}

/// Wide, and the surface around leads on out of it, where its patch doesn't follow: the end of what views saw of a
/// limb, or of the inside of a pot, and no hole in what they saw.
bool is_open_end(const FillResult& filled, Index loop) {
  return is_wide(filled.analysis, loop) && filled.analysis.holes[loop].conormal_tilt < end_tilt &&
         mean_fold(filled, loop) > end_fold;
}

/// Loops that views leave between them, and of which nothing near shows the shape: the best patch is a guess.
std::vector<Index> doubtful(const Openings& openings, const FillResult& filled) {
  std::vector<Index> loops;
  for (std::size_t i = 0; i < openings.loops.size(); ++i) {
    if (openings.fates[i] != RimFate::Seam) continue;
    const HoleOutcome& outcome = filled.outcomes[openings.loops[i]];
    if (outcome.action != FillAction::Fill) continue;
    if (outcome.confidence < low_confidence || is_open_end(filled, openings.loops[i]))
      loops.push_back(openings.loops[i]);
  }
  return loops;
}

PatchedHoles close_by_patches(PolyMesh& surface, Openings& openings, const FillOptions& options, Progress& progress) {
  FillOptions patching = options;
  patching.only = openings.loops;
  patching.requests.clear();
  patching.max_diameter = std::numeric_limits<double>::infinity();
  patching.trim_rim = 0;
  patching.mark_patches = true;
  patching.cache = nullptr;
  HoleRequest flat;
  flat.fairness = Fairness::Flat;
  for (std::size_t i = 0; i < openings.loops.size(); ++i)
    if (openings.fates[i] == RimFate::Patch) flat.holes.push_back(openings.loops[i]);
  if (!flat.holes.empty()) patching.requests.push_back(flat);
  const std::size_t first_face = surface.face_count();
  FillResult filled = fill_holes(surface, patching, progress);
  if (std::vector<Index> guesses = doubtful(openings, filled); !guesses.empty()) {
    patching.requests.emplace_back().holes = std::move(guesses);
    patching.requests.back().fairness = Fairness::Flat;
    filled = fill_holes(surface, patching, progress);
  }
  PatchedHoles patched;
  Openings left;
  left.meant = openings.meant;
  left.left = std::move(openings.left);
  std::map<std::int32_t, Index> hole_of_patch;
  for (std::size_t i = 0; i < openings.loops.size(); ++i) {
    const HoleOutcome& outcome = filled.outcomes[openings.loops[i]];
    if (outcome.action == FillAction::Fill) {
      patched.loops.push_back({openings.holes[i], openings.fates[i], outcome});
      hole_of_patch.emplace(static_cast<std::int32_t>(outcome.patch), openings.holes[i]);
    } else {
      left.loops.push_back(openings.loops[i]);
      left.holes.push_back(openings.holes[i]);
      left.fates.push_back(openings.fates[i]);
    }
  }
  if (const AttributeChannel* channel = filled.mesh.channel(patch_channel, Domain::Face)) {
    const auto& patch_of = std::get<std::vector<std::int32_t>>(channel->data);
    for (std::size_t f = first_face; f < patch_of.size(); ++f)
      patched.faces.emplace_back(f, hole_of_patch[patch_of[f]]);
  }
  surface = std::move(filled.mesh);
  surface.channels.clear();
  openings = std::move(left);
  return patched;
}

}  // namespace croquis::remeshing
