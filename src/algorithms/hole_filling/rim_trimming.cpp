// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/rim_trimming.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::hole_filling {
namespace {

constexpr int most_rings = 3;

void lower(Index& hole, Index other) { hole = std::min(hole, other); }

/// Per face whether it touches the rim of a hole with no rings.
std::vector<bool> faces_at_untrimmed_rims(std::size_t vertices, std::size_t faces, const HoleAnalysis& analysis,
                                          const std::vector<int>& rings) {
  const SurfaceView& view = analysis.view;
  std::vector<bool> is_kept(vertices, false), stays(faces, false);
  for (const Hole& hole : analysis.holes) {
    if (rings[hole.id] > 0) continue;
    for (const Index vertex : hole.vertices) is_kept[view.representative_of(vertex)] = true;
  }
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    for (const Index vertex : view.triangles[t]) {
      if (is_kept[vertex]) stays[view.face[t]] = true;
    }
  }
  return stays;
}

/// Removes all faces at vertices that the holes' removals have reached.
/// @param hole_of_vertex of the view: whose removals have reached it
void remove_ring(const SurfaceView& view, const std::vector<int>& rings, int ring, const std::vector<bool>& stays,
                 std::vector<Index>& hole_of_vertex, std::vector<Index>& hole_of_face) {
  std::vector<std::array<Index, 2>> removed;  // face, hole
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const Index face = view.face[t];
    if (stays[face] || hole_of_face[face] != no_index) continue;
    Index hole = no_index;
    for (const Index vertex : view.triangles[t]) {
      const Index reached = hole_of_vertex[vertex];
      if (reached != no_index && rings[reached] >= ring) lower(hole, reached);
    }
    if (hole != no_index) removed.push_back({face, hole});
  }
  for (const auto& [face, hole] : removed) lower(hole_of_face[face], hole);
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const Index hole = hole_of_face[view.face[t]];
    if (hole == no_index) continue;
    for (const Index vertex : view.triangles[t]) {
      if (hole_of_vertex[vertex] == no_index) hole_of_vertex[vertex] = hole;
    }
  }
}

/// Removes faces that hang on the rest by one edge or none.
void remove_ears(const SurfaceView& view, const std::vector<bool>& stays, std::vector<Index>& hole_of_face) {
  struct Edges {
    int all = 0, open = 0;
    Index hole = no_index;
  };
  std::vector<Edges> edges(hole_of_face.size());
  for (Index corner = 0; corner < 3 * view.triangles.size(); ++corner) {
    const Index face = view.face[corner / 3];
    const Index other = view.has_opposite(corner) ? view.face[view.opposite[corner] / 3] : no_index;
    if (other == face) continue;
    Edges& count = edges[face];
    ++count.all;
    if (view.opposite[corner] == no_index) ++count.open;
    if (other == no_index || hole_of_face[other] == no_index) continue;
    ++count.open;
    lower(count.hole, hole_of_face[other]);
  }
  for (std::size_t face = 0; face < edges.size(); ++face) {
    const Edges& count = edges[face];
    const bool hangs = count.hole != no_index && count.open + 1 >= count.all;
    if (hangs && !stays[face] && hole_of_face[face] == no_index) hole_of_face[face] = count.hole;
  }
}

/// Per face the hole that it is removed for, or no_index for those that stay.
std::vector<Index> holes_of_removed_faces(const PolyMesh& mesh, const HoleAnalysis& analysis,
                                          const std::vector<int>& rings, const Progress& progress) {
  const SurfaceView& view = analysis.view;
  const auto stays = faces_at_untrimmed_rims(mesh.vertex_count(), mesh.face_count(), analysis, rings);
  std::vector<Index> hole_of_face(mesh.face_count(), no_index), hole_of_vertex(mesh.vertex_count(), no_index);
  for (const Hole& hole : analysis.holes) {
    if (rings[hole.id] == 0) continue;
    for (const Index vertex : hole.vertices) lower(hole_of_vertex[view.representative_of(vertex)], hole.id);
  }
  for (int ring = 1; ring <= most_rings; ++ring) {
    progress.check();
    remove_ring(view, rings, ring, stays, hole_of_vertex, hole_of_face);
  }
  remove_ears(view, stays, hole_of_face);
  return hole_of_face;
}

MeshPart without(const PolyMesh& mesh, const std::vector<Index>& hole_of_face) {
  std::vector<bool> keep_face(mesh.face_count());
  std::vector<bool> keep_vertex(mesh.vertex_count(), true);
  for (std::size_t f = 0; f < keep_face.size(); ++f) {
    keep_face[f] = hole_of_face[f] == no_index;
    if (keep_face[f]) continue;
    for (const Index vertex : mesh.face(f)) keep_vertex[vertex] = false;
  }
  for (std::size_t f = 0; f < keep_face.size(); ++f) {
    if (!keep_face[f]) continue;
    for (const Index vertex : mesh.face(f)) keep_vertex[vertex] = true;
  }
  return part_of(mesh, keep_vertex, keep_face);
}

/// Which vertices belong to which holes of the scan: sorted pairs (vertex of the view, hole).
std::vector<std::array<Index, 2>> holes_at_vertices(const HoleAnalysis& analysis,
                                                    const std::vector<Index>& hole_of_face) {
  std::vector<std::array<Index, 2>> pairs;
  for (const Hole& hole : analysis.holes) {
    for (const Index vertex : hole.vertices) pairs.push_back({analysis.view.representative_of(vertex), hole.id});
  }
  for (std::size_t t = 0; t < analysis.view.triangles.size(); ++t) {
    const Index hole = hole_of_face[analysis.view.face[t]];
    if (hole == no_index) continue;
    for (const Index vertex : analysis.view.triangles[t]) pairs.push_back({vertex, hole});
  }
  sort_unique(pairs);
  return pairs;
}

/// A new rim is of the holes that any of its edges has at both ends.
std::vector<std::vector<Index>> rims_of_holes(const HoleAnalysis& before, const TrimmedScan& trimmed,
                                              const std::vector<std::array<Index, 2>>& holes_at) {
  const auto holes_of = [&](Index vertex) {
    const Index whole = before.view.representative_of(trimmed.part.vertices[vertex]);
    return with_key(holes_at, whole, [](const auto& pair) { return pair[0]; });
  };
  std::vector<std::vector<Index>> rims(before.holes.size());
  for (const Hole& rim : trimmed.analysis.holes) {
    for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
      const auto there = holes_of(rim.vertices[(i + 1) % rim.vertices.size()]);
      for (const auto& here : holes_of(rim.vertices[i])) {
        const bool at_both = std::ranges::find(there, here[1], [](const auto& pair) { return pair[1]; }) != there.end();
        std::vector<Index>& found = rims[here[1]];
        if (at_both && (found.empty() || found.back() != rim.id)) found.push_back(rim.id);
      }
    }
  }
  return rims;
}

/// What is small beside its piece of surface shouldn't depend on what was trimmed elsewhere: pieces are measured whole.
void take_measures(std::size_t faces, const HoleAnalysis& before, TrimmedScan& trimmed) {
  std::vector<Index> component_of_face(faces, no_index);
  for (std::size_t t = 0; t < before.view.triangles.size(); ++t)
    component_of_face[before.view.face[t]] = before.view.component[t];
  const SurfaceView& view = trimmed.analysis.view;
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const Index whole = component_of_face[trimmed.part.faces[view.face[t]]];
    trimmed.analysis.component_diagonal[view.component[t]] = before.component_diagonal[whole];
    trimmed.analysis.component_size[view.component[t]] = before.component_size[whole];
  }
}

/// Faces of a scan that aren't in a part of it.
std::vector<Index> faces_removed(const PolyMesh& scan, const TrimmedScan* trimmed) {
  std::vector<Index> removed;
  if (trimmed == nullptr) return removed;
  auto kept = trimmed->part.faces.begin();
  for (Index face = 0; face < scan.face_count(); ++face) {
    if (kept != trimmed->part.faces.end() && *kept == face)
      ++kept;
    else
      removed.push_back(face);
  }
  return removed;
}

auto place_in_mesh(const PolyMesh& mesh) {
  return [&mesh](Index vertex) -> const Vec3& { return mesh.positions[vertex]; };
}

// How far methods look from the rims and the places that a patch is to go through.
constexpr double diameters_looked_at = 2;
constexpr double edges_looked_at = 12;  // of mean length

Box looked_at(const HoleSite& site) {
  Box box = box_of(site.polygon.points, std::identity());
  for (const Vec3& place : site.settings.through) box.extend(place);
  const Vec3 reach =
      Vec3::Constant(diameters_looked_at * widest_diameter(site) + edges_looked_at * mean_rim_edge(site));
  return {box.min() - reach, box.max() + reach};
}

}  // namespace

TrimmedScan trim_rims(const PolyMesh& mesh, const HoleAnalysis& analysis, const std::vector<int>& rings,
                      const HoleAnalysisOptions& options, Progress& progress) {
  const std::vector<Index> hole_of_face = holes_of_removed_faces(mesh, analysis, rings, progress);
  TrimmedScan trimmed;
  trimmed.part = without(mesh, hole_of_face);
  if (trimmed.part.faces.empty())
    throw Error(make_error(Category::Usage, "E_PARAMETER",
                           "Trimming the rims would leave no face of the mesh: remove fewer rings.",
                           {{SubjectKind::Parameter, "trim-rim", {}, {}, {}}}));
  trimmed.analysis = analyse_holes(trimmed.part.mesh, progress, options);
  take_measures(mesh.face_count(), analysis, trimmed);
  trimmed.rims = rims_of_holes(analysis, trimmed, holes_at_vertices(analysis, hole_of_face));
  return trimmed;
}

std::vector<FillJob> moved_jobs(const TrimmedScan& trimmed, const std::vector<FillJob>& jobs) {
  const std::vector<Hole>& rims = trimmed.analysis.holes;
  std::vector<Index> job_of_rim(rims.size(), no_index);
  for (Index j = 0; j < jobs.size(); ++j) {
    for (const Index hole : jobs[j].holes) {
      for (const Index rim : trimmed.rims[hole]) job_of_rim[rim] = std::min(job_of_rim[rim], j);
    }
  }
  DisjointSets together(rims.size());
  std::vector<Index> first_of_bridge(jobs.size(), no_index);
  for (const Hole& rim : rims) {
    const Index j = job_of_rim[rim.id];
    if (j == no_index) continue;
    for (const Index other : rim.companions) {
      if (job_of_rim[other] == j) together.unite(rim.id, other);
    }
    if (!jobs[j].bridge) continue;
    first_of_bridge[j] = std::min(first_of_bridge[j], rim.id);
    together.unite(first_of_bridge[j], rim.id);
  }
  std::vector<FillJob> moved;
  for (std::vector<Index>& group : together.lists()) {
    const Index j = job_of_rim[group.front()];
    if (j == no_index) continue;
    moved.push_back(jobs[j]);
    moved.back().bridge = jobs[j].bridge && group.size() > 1;
    moved.back().detached = moved.back().bridge ? std::vector<Index>{} : detached_among(rims, group);
    moved.back().holes = std::move(group);
  }
  return moved;
}

std::vector<HoleOutcome> outcomes_before_trimming(const TrimmedScan& trimmed, const std::vector<HoleOutcome>& outcomes,
                                                  const std::vector<bool>& is_chosen) {
  std::vector<HoleOutcome> before(trimmed.rims.size());
  for (std::size_t hole = 0; hole < before.size(); ++hole) {
    if (!is_chosen[hole]) continue;
    const std::vector<Index>& rims = trimmed.rims[hole];
    if (rims.empty()) {
      before[hole].action = FillAction::Fill;
      before[hole].method = "trimmed";
      continue;
    }
    const auto failed = std::ranges::find(rims, FillAction::Failed, [&](Index rim) { return outcomes[rim].action; });
    before[hole] = outcomes[failed == rims.end() ? rims.front() : *failed];
  }
  return before;
}

ScanNumbers::ScanNumbers(const PolyMesh& scan, const TrimmedScan* trimmed, const HoleAnalysis& analysis,
                         std::string scan_key)
    : scan_(scan),
      trimmed_(trimmed),
      analysis_(analysis),
      scan_key_(std::move(scan_key)),
      removed_(faces_removed(scan, trimmed)),
      removed_search_(removed_.size(),
                      [this](Index item) { return box_of(scan_.face(removed_[item]), place_in_mesh(scan_)); }) {
  for (const Hole& hole : analysis.holes) rim_boxes_.push_back(box_of(hole.vertices, place_in_mesh(mesh())));
}

void ScanNumbers::add_removed(const Box& box, StageKey& key) const {
  std::vector<Index> faces;
  if (!box.isEmpty()) removed_search_.visit(box, [&](Index item) { faces.push_back(removed_[item]); });
  std::ranges::sort(faces);
  key.add(faces);
}

void ScanNumbers::add_removed(const HolePatch& patch, StageKey& key) const {
  add_removed(box_of(patch.points, std::identity()), key);
}

void ScanNumbers::add_surroundings(const HoleSite& site, StageKey& key) const {
  key.add(std::string_view(scan_key_)).add(site.holes.size());
  for (const Index id : site.holes) {
    const Hole& hole = analysis_.holes[id];
    key.add(hole.kind)
        .add(analysis_.component_diagonal[hole.component])
        .add(analysis_.component_size[hole.component])
        .add(hole.vertices.size());
    for (const Index vertex : hole.vertices) key.add(scan_vertex(vertex));
  }
  const Box box = looked_at(site);
  add_removed(box, key);
  for (const Hole& hole : analysis_.holes) {
    if (rim_boxes_[hole.id].intersects(box))
      key.add(std::array{scan_vertex(hole.vertices[0]), scan_vertex(hole.vertices[1])});
  }
}

Index ScanNumbers::mesh_vertex(Index vertex) const {
  return trimmed_ == nullptr ? vertex : place_in(trimmed_->part.vertices, vertex);
}

HolePatch ScanNumbers::in_scan(HolePatch patch) const {
  const auto given = static_cast<Index>(mesh().vertex_count()), first = static_cast<Index>(scan_.vertex_count());
  for (auto& triangle : patch.triangles) {
    for (Index& vertex : triangle) vertex = vertex < given ? scan_vertex(vertex) : vertex - given + first;
  }
  patch.holes.clear();
  for (const Index id : std::exchange(patch.arrives_at, {})) {
    const std::vector<Index>& rim = analysis_.holes[id].vertices;
    patch.arrives_at.insert(patch.arrives_at.end(), {scan_vertex(rim[0]), scan_vertex(rim[1])});
  }
  return patch;
}

HolePatch ScanNumbers::in_mesh(HolePatch patch, const std::vector<Index>& holes) const {
  const auto given = static_cast<Index>(mesh().vertex_count()), first = static_cast<Index>(scan_.vertex_count());
  for (auto& triangle : patch.triangles) {
    for (Index& vertex : triangle) vertex = vertex < first ? mesh_vertex(vertex) : vertex - first + given;
  }
  patch.holes = holes;
  const std::vector<Index> names = std::exchange(patch.arrives_at, {});
  for (std::size_t i = 0; i + 1 < names.size(); i += 2) {
    const auto rim = std::ranges::find_if(analysis_.holes, [&](const Hole& hole) {
      return scan_vertex(hole.vertices[0]) == names[i] && scan_vertex(hole.vertices[1]) == names[i + 1];
    });
    if (rim != analysis_.holes.end()) patch.arrives_at.push_back(rim->id);
  }
  return patch;
}

}  // namespace croquis::hole_filling
