// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/continuity.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::subdivision {
namespace {

constexpr double flat_bend = 1e-6;      // radians: far above rounding, far below what is seen
constexpr double halving_ratio = 0.62;  // one half, and what irregular vertices and early levels add to it

std::string degrees(double radians) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f degrees", radians * 180 / std::numbers::pi);
  return text;
}

std::string element(const LevelContinuity& level) {
  char text[96];
  std::snprintf(text, sizeof text, "edge %u near (%.6g, %.6g, %.6g)", level.edge, level.place.x(), level.place.y(),
                level.place.z());
  return text;
}

/// Sharpness that runs out later starts the rounding again.
bool runs_out(const Level& level) {
  return std::any_of(level.sharp.begin(), level.sharp.end(),
                     [](const SharpEdge& sharp) { return sharp.sharpness != infinite_sharpness; });
}

Smoothness judged(const ContinuityReport& report, bool rounding_goes_on) {
  if (report.levels.back().greatest_bend <= flat_bend) return Smoothness::Flat;
  if (rounding_goes_on || report.levels.size() < 3) return Smoothness::Unknown;
  if (report.ratio > kink_ratio) return Smoothness::Kink;
  return report.ratio <= halving_ratio ? Smoothness::Halving : Smoothness::Fading;
}

std::string sentence_of(const ContinuityReport& report) {
  const LevelContinuity& last = report.levels.back();
  const std::string angle = degrees(last.greatest_bend);
  switch (report.verdict) {
    case Smoothness::Unknown: return "too few levels for an answer; the largest angle is " + angle;
    case Smoothness::Flat: return "flat between the tags";
    case Smoothness::Halving: return "G1 (halving): " + angle + " left at " + element(last);
    case Smoothness::Fading: return "G1 (fading slowly): " + angle + " left at " + element(last);
    case Smoothness::Kink: return "kink at " + element(last) + ": " + angle + " stay";
  }
  return {};
}

template <typename Plan>
ContinuityReport report_of(const Plan& plan, const PositionBuffers& buffers, Progress& progress) {
  ContinuityReport report;
  for (int k = 0; k <= plan.levels(); ++k) {
    report.levels.push_back(continuity(plan.level(k), buffers.levels[static_cast<std::size_t>(k)]));
    progress.report((k + 1) / (plan.levels() + 2.0));
  }
  report.chains = edge_chains(plan.level(plan.levels()));
  report.shapes = chain_shapes(plan.level(plan.levels()), report.chains, buffers.levels.back());
  if (plan.levels() > 0) {
    const double before = report.levels[report.levels.size() - 2].greatest_bend;
    const double last = report.levels.back().greatest_bend;
    report.ratio = last > 0 ? last / before : 0;  // infinite where a flat level was no end of it
  }
  report.verdict = judged(report, runs_out(plan.level(std::max(plan.levels() - 1, 0))));
  report.sentence = sentence_of(report);
  progress.report(1);
  return report;
}

}  // namespace

std::vector<double> edge_bends(const Level& level, std::span<const Vec3> positions) {
  const HalfEdges& mesh = level.topology;
  const CornerFaces around(mesh);
  std::vector<Vec3> normals(mesh.face_count());
  for (Index face = 0; face < normals.size(); ++face) normals[face] = area_normal(positions, mesh.face(face));
  std::vector<double> bends(mesh.edge_count(), 0);
  for (Index edge = 0; edge < bends.size(); ++edge) {
    const Index corner = mesh.edge_corner[edge];
    if (mesh.twin[corner] == no_index) continue;
    bends[edge] = angle_between(normals[around.face(corner)], normals[around.face(mesh.twin[corner])]);
  }
  return bends;
}

LevelContinuity continuity(const Level& level, std::span<const Vec3> positions) {
  std::vector<double> bends = edge_bends(level, positions);
  for (const SharpEdge& sharp : level.sharp) bends[sharp.edge] = 0;
  LevelContinuity result;
  for (Index edge = 0; edge < bends.size(); ++edge) {
    if (bends[edge] <= result.greatest_bend) continue;
    result.greatest_bend = bends[edge];
    result.edge = edge;
  }
  if (result.edge == no_index) return result;
  const HalfEdges& mesh = level.topology;
  const Index corner = mesh.edge_corner[result.edge];
  result.place = (positions[mesh.corner_vertex[corner]] + positions[mesh.corner_vertex[mesh.twin[corner]]]) / 2;
  return result;
}

ContinuityReport continuity_report(const DooSabinPlan& plan, const PositionBuffers& buffers, Progress& progress) {
  return report_of(plan, buffers, progress);
}

ContinuityReport continuity_report(const UniformPlan& plan, const PositionBuffers& buffers, Progress& progress) {
  return report_of(plan, buffers, progress);
}

}  // namespace croquis::subdivision
