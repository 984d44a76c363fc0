// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/rim_trimming.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/hole_filling/hole_groups.h"

namespace croquis::hole_filling {
namespace {

constexpr int most_rings = 3;

/// Finds the faces to be removed, each with the hole that it is removed for.
class Trimming {
 public:
  Trimming(const PolyMesh& mesh, const HoleAnalysis& analysis, const std::vector<int>& rings)
      : view_(analysis.view),
        rings_(rings),
        hole_of_face_(mesh.face_count(), no_index),
        hole_of_vertex_(mesh.vertex_count(), no_index),
        stays_(mesh.face_count(), false) {
    keep_untrimmed_rims(analysis);
    for (const Hole& hole : analysis.holes) {
      if (rings[hole.id] == 0) continue;
      for (const Index vertex : hole.vertices) lower(hole_of_vertex_[view_.representative_of(vertex)], hole.id);
    }
  }

  /// Per face the hole, or no_index for those that stay.
  std::vector<Index> run(Progress& progress) {
    for (int ring = 1; ring <= most_rings; ++ring) {
      progress.check();
      remove_ring(ring);
    }
    remove_ears();
    return std::move(hole_of_face_);
  }

 private:
  static void lower(Index& hole, Index other) { hole = std::min(hole, other); }

  void keep_untrimmed_rims(const HoleAnalysis& analysis) {
    std::vector<bool> kept(hole_of_vertex_.size(), false);
    for (const Hole& hole : analysis.holes) {
      if (rings_[hole.id] > 0) continue;
      for (const Index vertex : hole.vertices) kept[view_.representative_of(vertex)] = true;
    }
    for (std::size_t t = 0; t < view_.triangles.size(); ++t) {
      for (const Index vertex : view_.triangles[t]) {
        if (kept[vertex]) stays_[view_.face[t]] = true;
      }
    }
  }

  /// All faces at vertices that the hole's removals have reached.
  void remove_ring(int ring) {
    std::vector<std::array<Index, 2>> removed;  // face, hole
    for (std::size_t t = 0; t < view_.triangles.size(); ++t) {
      const Index face = view_.face[t];
      if (stays_[face] || hole_of_face_[face] != no_index) continue;
      Index hole = no_index;
      for (const Index vertex : view_.triangles[t]) {
        const Index reached = hole_of_vertex_[vertex];
        if (reached != no_index && rings_[reached] >= ring) lower(hole, reached);
      }
      if (hole != no_index) removed.push_back({face, hole});
    }
    for (const auto& [face, hole] : removed) lower(hole_of_face_[face], hole);
    for (std::size_t t = 0; t < view_.triangles.size(); ++t) {
      const Index hole = hole_of_face_[view_.face[t]];
      if (hole == no_index) continue;
      for (const Index vertex : view_.triangles[t]) {
        if (hole_of_vertex_[vertex] == no_index) hole_of_vertex_[vertex] = hole;
      }
    }
  }

  /// Faces that hang on the rest by one edge or none.
  void remove_ears() {
    struct Edges {
      int all = 0, open = 0;
      Index hole = no_index;
    };
    std::vector<Edges> edges(hole_of_face_.size());
    for (Index corner = 0; corner < 3 * view_.triangles.size(); ++corner) {
      const Index face = view_.face[corner / 3];
      const Index other = view_.has_opposite(corner) ? view_.face[view_.opposite[corner] / 3] : no_index;
      if (other == face) continue;
      Edges& count = edges[face];
      ++count.all;
      if (view_.opposite[corner] == no_index) ++count.open;
      if (other == no_index || hole_of_face_[other] == no_index) continue;
      ++count.open;
      lower(count.hole, hole_of_face_[other]);
    }
    for (std::size_t face = 0; face < edges.size(); ++face) {
      const Edges& count = edges[face];
      const bool hangs = count.hole != no_index && count.open + 1 >= count.all;
      if (hangs && !stays_[face] && hole_of_face_[face] == no_index) hole_of_face_[face] = count.hole;
    }
  }

  const SurfaceView& view_;
  const std::vector<int>& rings_;
  std::vector<Index> hole_of_face_;
  std::vector<Index> hole_of_vertex_;  ///< of the view: whose removals have reached it
  std::vector<bool> stays_;
};

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
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// A new rim is of the holes that any of its edges has at both ends.
std::vector<std::vector<Index>> rims_of_holes(const HoleAnalysis& before, const TrimmedScan& trimmed,
                                              const std::vector<std::array<Index, 2>>& holes_at) {
  const auto holes_of = [&](Index vertex) {
    const Index whole = before.view.representative_of(trimmed.part.vertices[vertex]);
    return std::ranges::equal_range(holes_at, whole, {}, [](const auto& pair) { return pair[0]; });
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

}  // namespace

TrimmedScan trim_rims(const PolyMesh& mesh, const HoleAnalysis& analysis, const std::vector<int>& rings,
                      const HoleAnalysisOptions& options, Progress& progress) {
  const std::vector<Index> hole_of_face = Trimming(mesh, analysis, rings).run(progress);
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
  HoleGroups together(rims.size());
  std::vector<Index> first_of_bridge(jobs.size(), no_index);
  for (const Hole& rim : rims) {
    const Index j = job_of_rim[rim.id];
    if (j == no_index) continue;
    for (const Index other : rim.companions) {
      if (job_of_rim[other] == j) together.merge(rim.id, other);
    }
    if (!jobs[j].bridge) continue;
    first_of_bridge[j] = std::min(first_of_bridge[j], rim.id);
    together.merge(first_of_bridge[j], rim.id);
  }
  std::vector<FillJob> moved;
  for (std::vector<Index>& group : together.lists()) {
    const Index j = job_of_rim[group.front()];
    if (j == no_index) continue;
    moved.push_back(jobs[j]);
    moved.back().bridge = jobs[j].bridge && group.size() > 1;
    moved.back().strays = moved.back().bridge ? std::vector<Index>{} : strays_among(rims, group);
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

}  // namespace croquis::hole_filling
