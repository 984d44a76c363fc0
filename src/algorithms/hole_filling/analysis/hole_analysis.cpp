// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/hole_analysis.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "algorithms/hole_filling/analysis/analysis_findings.h"
#include "algorithms/hole_filling/analysis/component_measures.h"
#include "algorithms/hole_filling/analysis/hole_classes.h"
#include "algorithms/hole_filling/analysis/hole_measures.h"
#include "algorithms/hole_filling/analysis/rim_walk.h"

namespace croquis::hole_filling {
namespace {

/// The vertices of the mesh along a cycle: of copies at one place the one that the faces on both sides of the rim use
/// where they agree, so that a patch is joined in the file as written too.
std::vector<Index> mesh_vertices(const SurfaceView& view, const PolyMesh& mesh, const RimCycle& cycle) {
  if (view.representative.empty()) return cycle.vertices;
  const std::size_t count = cycle.corners.size();
  std::vector<Index> vertices(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto end_at = [&](Index corner) {
      return mesh_vertex(view, mesh, view.origin(corner) == cycle.vertices[i] ? corner : SurfaceView::next(corner));
    };
    const Index before = end_at(cycle.corners[(i + count - 1) % count]);
    const Index after = end_at(cycle.corners[i]);
    vertices[i] = before == after ? before : cycle.vertices[i];
  }
  return vertices;
}

Hole make_hole(const SurfaceView& view, const PolyMesh& mesh, RimCycle cycle) {
  Hole hole;
  hole.vertices = mesh_vertices(view, mesh, cycle);
  hole.corners = std::move(cycle.corners);
  hole.ambiguous = cycle.ambiguous;
  const auto lowest = std::min_element(hole.vertices.begin(), hole.vertices.end()) - hole.vertices.begin();
  std::rotate(hole.vertices.begin(), hole.vertices.begin() + lowest, hole.vertices.end());
  std::rotate(hole.corners.begin(), hole.corners.begin() + lowest, hole.corners.end());
  return hole;
}

void mark_shared_vertices(const SurfaceView& view, std::size_t vertex_count, std::vector<Hole>& holes) {
  std::vector<std::uint8_t> uses(vertex_count, 0);
  const auto count_of = [&](Index vertex) -> std::uint8_t& { return uses[view.representative_of(vertex)]; };
  for (const Hole& hole : holes) {
    for (const Index vertex : hole.vertices)
      count_of(vertex) = static_cast<std::uint8_t>(count_of(vertex) == 0 ? 1 : 2);
  }
  for (Hole& hole : holes) {
    hole.shares_vertex =
        std::any_of(hole.vertices.begin(), hole.vertices.end(), [&](Index vertex) { return count_of(vertex) > 1; });
  }
}

std::vector<Hole> find_holes(const PolyMesh& mesh, HoleAnalysis& analysis, Progress& progress) {
  RimCycles cycles = walk_rims(analysis.view, mesh.positions, progress);
  analysis.open_rims = cycles.open_rims;
  std::vector<Hole> holes;
  holes.reserve(cycles.cycles.size());
  for (RimCycle& cycle : cycles.cycles) holes.push_back(make_hole(analysis.view, mesh, std::move(cycle)));
  std::sort(holes.begin(), holes.end(), [](const Hole& a, const Hole& b) { return a.vertices < b.vertices; });
  for (std::size_t i = 0; i < holes.size(); ++i) holes[i].id = static_cast<Index>(i);
  mark_shared_vertices(analysis.view, mesh.vertex_count(), holes);
  return holes;
}

}  // namespace

const char* to_string(HoleClass kind) {
  switch (kind) {
    case HoleClass::Small: return "small";
    case HoleClass::Simple: return "simple";
    case HoleClass::Islands: return "islands";
    case HoleClass::Tunnel: return "tunnel";
    case HoleClass::Outer: return "OUTER";
    case HoleClass::Slit: return "slit";
    case HoleClass::BowTie: return "bow-tie";
  }
  return "";
}

HoleAnalysis analyse_holes(const PolyMesh& mesh, Progress& progress, const HoleAnalysisOptions& options) {
  HoleAnalysis analysis;
  Progress viewing = progress.step("join faces", 0.7);
  analysis.view = view_surface(mesh, viewing, options.weld_tolerance);
  Progress walking = progress.step("find rims", 0.1);
  analysis.holes = find_holes(mesh, analysis, walking);
  measure_components(mesh, analysis);
  Progress measuring = progress.step("measure holes", 0.2);
  for (Hole& hole : analysis.holes) {
    measure_hole(mesh, analysis.view, options, hole, measuring);
    measuring.report(static_cast<double>(hole.id + 1) / static_cast<double>(analysis.holes.size()));
  }
  classify_holes(mesh, options, analysis);
  analysis.warnings = analysis_findings(analysis);
  progress.report(1);
  return analysis;
}

}  // namespace croquis::hole_filling
