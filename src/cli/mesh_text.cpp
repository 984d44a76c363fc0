// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_text.h"

#include <cstdio>

namespace croquis::cli {
namespace {

std::string point_text(const Vec3& point) {
  return number_text(point.x()) + " " + number_text(point.y()) + " " + number_text(point.z());
}

std::string topology_text(const MeshReport& report, std::optional<std::size_t> added) {
  std::string text = report.closed ? "closed"
                                   : "open (" + grouped(report.boundary_loops) + " boundary loops, " +
                                         grouped(report.boundary_edges) + " edges)";
  text += report.oriented ? ", oriented" : ", not oriented";
  if (report.nonmanifold_edges + report.nonmanifold_vertices > 0) {
    text += ", not manifold (" + grouped(report.nonmanifold_edges) + " edges, " + grouped(report.nonmanifold_vertices) +
            " vertices)";
  }
  if (report.degenerate_faces > 0) text += ", " + grouped(report.degenerate_faces) + " faces without area";
  if (report.self_intersections) text += ", " + grouped(*report.self_intersections) + " self-intersections";
  if (added && report.self_intersections > 0)
    text += *added == 0 ? ", which were there before" : ", " + grouped(*added) + " of them added";
  return text;
}

}  // namespace

std::string number_text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (auto place = static_cast<std::ptrdiff_t>(digits.size()) - 3; place > 0; place -= 3) {
    digits.insert(static_cast<std::size_t>(place), ",");
  }
  return digits;
}

std::string mesh_text(const MeshReport& report, std::optional<std::size_t> added) {
  std::string text = grouped(report.vertices) + " vertices, " + grouped(report.edges) + " edges, " +
                     grouped(report.faces) + " faces in " + grouped(report.components) +
                     (report.components == 1 ? " component" : " components");
  text += "\n" + topology_text(report, added);
  text += "\nEuler characteristic " + std::to_string(report.euler_characteristic);
  if (report.genus) text += ", genus " + std::to_string(*report.genus);
  text += "\narea " + number_text(report.area);
  if (report.volume) text += ", volume " + number_text(*report.volume);
  if (report.bounds)
    text += "\nfrom " + point_text(report.bounds->front()) + " to " + point_text(report.bounds->back());
  return text;
}

}  // namespace croquis::cli
