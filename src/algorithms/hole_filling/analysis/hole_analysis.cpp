// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/hole_analysis.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "croquis/base/finding.h"
#include "croquis/base/text.h"

namespace croquis::hole_filling {
namespace {

/// Elements listed with a finding at most; the sentence gives their number.
constexpr std::size_t most_subjects = 20;

Finding warn(std::string code, std::string message, std::vector<Subject> subjects = {}) {
  return make_warning(Category::Geometry, std::move(code), std::move(message), std::move(subjects));
}

std::vector<Subject> flagged_faces(const SurfaceView& view, unsigned flags) {
  std::vector<Subject> subjects;
  Index last = no_index;
  for (std::size_t t = 0; t < view.triangles.size() && subjects.size() < most_subjects; ++t) {
    if ((view.flags[t] & flags) == 0 || view.face[t] == last) continue;
    last = view.face[t];
    subjects.push_back(numbered_subject(SubjectKind::Face, last));
  }
  return subjects;
}

std::vector<Subject> nonmanifold_edge_subjects(const SurfaceView& view) {
  std::vector<std::array<Index, 2>> edges;
  for (Index corner = 0; corner < view.opposite.size() && edges.size() < most_subjects; ++corner) {
    if (view.opposite[corner] != nonmanifold_edge) continue;
    const auto [low, high] = std::minmax({view.origin(corner), view.target(corner)});
    if (std::find(edges.begin(), edges.end(), std::array{low, high}) == edges.end()) edges.push_back({low, high});
  }
  std::vector<Subject> subjects;
  for (const auto& [low, high] : edges) subjects.push_back(edge_subject(low, high));
  return subjects;
}

void report_near_welds(const SurfaceView& view, Findings& findings) {
  const std::size_t count = view.nearly_welded_vertices;
  if (count == 0) return;
  char share[16];
  std::snprintf(share, sizeof share, "%.1g", view.widest_weld / view.diagonal);
  findings.push_back(warn("W_WELDED", counted(count, "vertex of a rim lies", "vertices of rims lie") +
                                          " nearly on another one (within " + share + " of the diagonal) and " +
                                          (count == 1 ? "counts as the same; it is" : "count as the same; they are") +
                                          " written as before: weld the source, or keep them apart with --weld 0."));
}

void report_orientation(const SurfaceView& view, Findings& findings) {
  if (view.turned_faces > 0)
    findings.push_back(warn("W_ORIENTATION",
                            counted(view.turned_faces, "face runs", "faces run") +
                                " against the neighbours: taken the other way round, and written as " +
                                (view.turned_faces == 1 ? "it was; flip it" : "they were; flip them") +
                                " in the source.",
                            flagged_faces(view, SurfaceView::Turned)));
  if (view.one_sided_components > 0)
    findings.push_back(
        warn("W_ORIENTATION",
             "The orientation is ambiguous: " + counted(view.one_sided_components, "component has", "components have") +
                 " only one side; look at what is filled there."));
}

void report_nonmanifold_edges(const HoleAnalysis& analysis, Findings& findings) {
  if (analysis.view.nonmanifold_edges == 0) return;
  const bool one = analysis.view.nonmanifold_edges == 1;
  std::string message = counted(analysis.view.nonmanifold_edges, "non-manifold edge has", "non-manifold edges have") +
                        " more than two faces and " + (one ? "stays as it is" : "stay as they are");
  if (analysis.open_rims > 0)
    message += "; " + counted(analysis.open_rims, "rim ends", "rims end") + " there and can't be filled";
  findings.push_back(warn("W_NONMANIFOLD", message + ": separate the sheets that meet in " + (one ? "it." : "them."),
                          nonmanifold_edge_subjects(analysis.view)));
}

void report_shared_vertices(const HoleAnalysis& analysis, Findings& findings) {
  std::vector<Subject> subjects;
  std::size_t count = 0;
  for (const Hole& hole : analysis.holes) {
    if (!hole.shares_vertex) continue;
    ++count;
    if (subjects.size() < most_subjects) subjects.push_back(numbered_subject(SubjectKind::Hole, hole.id));
  }
  if (count > 0)
    findings.push_back(warn("W_BOWTIE",
                            counted(count, "hole shares", "holes share") + " a vertex with another one and " +
                                (count == 1 ? "was" : "were") + " cut apart there: look at what is filled.",
                            std::move(subjects)));
}

/// What the analysis reports about a faulty mesh, one finding per type of fault.
Findings analysis_findings(const HoleAnalysis& analysis) {
  const SurfaceView& view = analysis.view;
  Findings findings;
  if (view.welded_vertices > 0)
    findings.push_back(warn("W_WELDED", counted(view.welded_vertices, "vertex lies", "vertices lie") +
                                            " exactly on another one and " +
                                            (view.welded_vertices == 1 ? "counts as the same; it is written as it was"
                                                                       : "count as the same; they are written as they "
                                                                         "were") +
                                            ", so weld the source to get a closed file."));
  report_near_welds(view, findings);
  report_orientation(view, findings);
  report_nonmanifold_edges(analysis, findings);
  if (view.unsound_triangles + view.dropped_triangles > 0)
    findings.push_back(warn("W_DEGENERATE",
                            counted(view.unsound_triangles + view.dropped_triangles, "triangle has", "triangles have") +
                                " next to no area; kept, but not used to continue the surface.",
                            flagged_faces(view, SurfaceView::NoArea | SurfaceView::Sliver)));
  report_shared_vertices(analysis, findings);
  return findings;
}

/// Vertices of the mesh instead of the view's along a rim: of copies at one place the one that the faces on both sides
/// of the rim use where they agree, so that a patch is joined in the file as written too.
void take_mesh_vertices(const SurfaceView& view, const PolyMesh& mesh, Hole& hole) {
  if (view.representative.empty()) return;
  const std::size_t count = hole.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto end_at = [&](Index corner) {
      return mesh_vertex(view, mesh, view.origin(corner) == hole.vertices[i] ? corner : SurfaceView::next(corner));
    };
    const Index before = end_at(hole.corners[(i + count - 1) % count]);
    if (before == end_at(hole.corners[i])) hole.vertices[i] = before;
  }
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

/// Each begins at its lowest vertex; they are numbered by it.
void find_holes(const PolyMesh& mesh, HoleAnalysis& analysis, Progress& progress) {
  walk_rims(mesh, analysis, progress);
  std::vector<Hole>& holes = analysis.holes;
  for (Hole& hole : holes) {
    take_mesh_vertices(analysis.view, mesh, hole);
    const auto lowest = std::ranges::min_element(hole.vertices) - hole.vertices.begin();
    std::rotate(hole.vertices.begin(), hole.vertices.begin() + lowest, hole.vertices.end());
    std::rotate(hole.corners.begin(), hole.corners.begin() + lowest, hole.corners.end());
  }
  std::ranges::sort(holes, {}, &Hole::vertices);
  for (std::size_t i = 0; i < holes.size(); ++i) holes[i].id = static_cast<Index>(i);
  mark_shared_vertices(analysis.view, mesh.vertex_count(), holes);
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
  find_holes(mesh, analysis, walking);
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
