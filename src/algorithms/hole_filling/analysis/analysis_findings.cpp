// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/analysis_findings.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

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

void tell_near_welds(const SurfaceView& view, Findings& findings) {
  const std::size_t count = view.nearly_welded_vertices;
  if (count == 0) return;
  char share[16];
  std::snprintf(share, sizeof share, "%.1g", view.widest_weld / view.diagonal);
  findings.push_back(warn("W_WELDED", counted(count, "vertex of a rim lies", "vertices of rims lie") +
                                          " nearly on another one (within " + share + " of the diagonal) and " +
                                          (count == 1 ? "counts as the same; it is" : "count as the same; they are") +
                                          " written as before: weld the source, or keep them apart with --weld 0."));
}

void tell_orientation(const SurfaceView& view, Findings& findings) {
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

void tell_shared_vertices(const HoleAnalysis& analysis, Findings& findings) {
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

}  // namespace

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
  tell_near_welds(view, findings);
  tell_orientation(view, findings);
  report_nonmanifold_edges(analysis, findings);
  if (view.unsound_triangles + view.dropped_triangles > 0)
    findings.push_back(warn("W_DEGENERATE",
                            counted(view.unsound_triangles + view.dropped_triangles, "triangle has", "triangles have") +
                                " next to no area; kept, but not used to continue the surface.",
                            flagged_faces(view, SurfaceView::NoArea | SurfaceView::Sliver)));
  tell_shared_vertices(analysis, findings);
  return findings;
}

}  // namespace croquis::hole_filling
