// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette/surface_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

namespace croquis::test {
namespace {

constexpr double degrees = 180 / 3.14159265358979323846;

Vec3 face_normal(const PolyMesh& mesh, std::size_t f) {
  const auto c = mesh.face(f);
  const Vec3& a = mesh.positions[c[0]];
  return (mesh.positions[c[1]] - a).cross(mesh.positions[c[2]] - a).normalized();
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// An edge of the outline, leaving its vertex: where it leads, and the front face beside it.
struct RimStep {
  Index to = 0;
  std::size_t face = 0;
};

std::map<Index, RimStep> rim_steps(const PolyMesh& mesh) {
  std::map<std::pair<Index, Index>, std::size_t> front;
  std::map<std::pair<Index, Index>, std::size_t> back;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    auto& side = face_normal(mesh, f).z() > 0 ? front : back;
    for (std::size_t i = 0; i < 3; ++i) side[{c[i], c[(i + 1) % 3]}] = f;
  }
  std::map<Index, RimStep> steps;
  for (const auto& [edge, face] : front) {
    if (back.count({edge.second, edge.first}) > 0) steps[edge.first] = {edge.second, face};
  }
  return steps;
}

/// Distance along a line to the nearest face that it pierces ahead.
std::optional<double> first_hit(const PolyMesh& mesh, const Vec3& origin, const Vec3& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    const Vec3 a = mesh.positions[c[0]] - origin;
    const Vec3 b = mesh.positions[c[1]] - origin;
    const Vec3 d = mesh.positions[c[2]] - origin;
    const double u = direction.dot(b.cross(d));
    const double v = direction.dot(d.cross(a));
    const double w = direction.dot(a.cross(b));
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0) continue;
    const double t = (u * a + v * b + w * d).dot(direction) / (u + v + w);
    if (t > 0) nearest = std::min(nearest, t);
  }
  if (std::isinf(nearest)) return std::nullopt;
  return nearest;
}

/// Half way between the front and the back of the sheet that a node lies in.
std::optional<Vec3> sheet_middle(const PolyMesh& mesh, const Vec3& node) {
  // Nodes are vertices of the mesh; beside them a line meets the inside of faces.
  const std::vector<double> hits = vertical_hits(mesh, node.head<2>() + Vec2(1e-3, 0.7e-3));
  std::optional<Vec3> best;
  for (std::size_t i = 0; i + 1 < hits.size(); i += 2) {
    const Vec3 middle(node.x(), node.y(), (hits[i] + hits[i + 1]) / 2);
    if (!best || std::abs(middle.z() - node.z()) < std::abs(best->z() - node.z())) best = middle;
  }
  return best;
}

std::optional<double> half_axis(const PolyMesh& mesh, const Vec3& centre, const Vec3& direction) {
  const auto ahead = first_hit(mesh, centre, direction);
  const auto behind = first_hit(mesh, centre, -direction);
  if (!ahead || !behind) return std::nullopt;
  return (*ahead + *behind) / 2;
}

/// Nearer to an end than this part of the radius an inclined section meets the cap.
constexpr double end_clearance = 1;

/// Radii along a tube differ by at most this part within a radius; where they flare a section isn't an ellipse.
constexpr double tube_flare = 0.1;

/// A branch is a tube at those nodes from which a radius to either side is left, of nearly equal radii.
bool inside_tube(const PolyMesh& skeleton, std::span<const Index> line, std::size_t node) {
  const auto& radii = std::get<std::vector<double>>(skeleton.channel("radius", Domain::Vertex)->data);
  const double radius = radii[line[node]];
  const auto reaches = [&](int direction) {
    double left = end_clearance * radius;
    for (std::size_t i = node; left > 0;) {
      if (direction < 0 ? i == 0 : i + 1 == line.size()) return line.front() == line.back();
      const std::size_t next = direction < 0 ? i - 1 : i + 1;
      left -= (skeleton.positions[line[next]] - skeleton.positions[line[i]]).head<2>().norm();
      if (std::abs(radii[line[next]] - radius) > tube_flare * radius) return false;
      i = next;
    }
    return true;
  };
  return reaches(1) && reaches(-1);
}

}  // namespace

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  double sum = 0;
  for (const double value : values) sum += value;
  return {sum / static_cast<double>(values.size()), values[values.size() * 95 / 100], values.back()};
}

std::vector<double> smallest_angles(const PolyMesh& mesh) {
  std::vector<double> angles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& at = mesh.positions[corners[k]];
      const Vec3 a = mesh.positions[corners[(k + 1) % 3]] - at;
      const Vec3 b = mesh.positions[corners[(k + 2) % 3]] - at;
      smallest = std::min(smallest, angle_between(a, b) * degrees);
    }
    angles.push_back(smallest);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

Spread rim_serration(const PolyMesh& mesh) {
  const std::map<Index, RimStep> steps = rim_steps(mesh);
  std::vector<double> excess;
  for (const auto& [vertex, step] : steps) {
    const auto next = steps.find(step.to);
    if (next == steps.end()) continue;
    const Vec3 along = mesh.positions[step.to] - mesh.positions[vertex];
    const Vec3 onward = mesh.positions[next->second.to] - mesh.positions[step.to];
    const Vec2 a = along.head<2>();
    const Vec2 b = onward.head<2>();
    const double turn = std::abs(std::atan2(cross(a, b), a.dot(b)));
    const double bend = angle_between(face_normal(mesh, step.face), face_normal(mesh, next->second.face));
    excess.push_back(std::abs(bend - turn) * degrees);
  }
  return spread_of(std::move(excess));
}

double deepest_rim_notch(const PolyMesh& mesh) {
  const std::map<Index, RimStep> steps = rim_steps(mesh);
  std::map<std::pair<Index, Index>, std::pair<std::size_t, Index>> front;  // edge: its face and the corner opposite
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    if (face_normal(mesh, f).z() <= 0) continue;
    for (std::size_t i = 0; i < 3; ++i) front[{c[i], c[(i + 1) % 3]}] = {f, c[(i + 2) % 3]};
  }
  double deepest = 0;
  for (const auto& [edge, side] : front) {
    const auto twin = front.find({edge.second, edge.first});
    if (twin == front.end() || steps.count(edge.first) == 0) continue;
    const Vec3 normal = face_normal(mesh, side.first);
    const Vec3 across = mesh.positions[twin->second.second] - mesh.positions[edge.first];
    if (normal.dot(across) <= 0) continue;
    deepest = std::max(deepest, angle_between(normal, face_normal(mesh, twin->second.first)) * degrees);
  }
  return deepest;
}

std::vector<double> vertical_hits(const PolyMesh& mesh, const Vec2& place) {
  std::vector<double> hits;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    std::array<double, 3> area{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 a = mesh.positions[c[(i + 1) % 3]].head<2>() - place;
      const Vec2 b = mesh.positions[c[(i + 2) % 3]].head<2>() - place;
      area[i] = cross(a, b);
    }
    const bool left = area[0] > 0 && area[1] > 0 && area[2] > 0;
    const bool right = area[0] < 0 && area[1] < 0 && area[2] < 0;
    if (!left && !right) continue;
    double height = 0;
    for (std::size_t i = 0; i < 3; ++i) height += area[i] * mesh.positions[c[i]].z();
    hits.push_back(height / (area[0] + area[1] + area[2]));
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

std::vector<double> half_axis_ratios(const PolyMesh& mesh, const PolyMesh& skeleton) {
  std::vector<double> ratios;
  for (std::size_t l = 0; l < skeleton.line_count(); ++l) {
    const auto line = skeleton.line(l);
    for (std::size_t i = 2; i + 2 < line.size(); ++i) {
      if (!inside_tube(skeleton, line, i)) continue;
      const auto before = sheet_middle(mesh, skeleton.positions[line[i - 1]]);
      const auto centre = sheet_middle(mesh, skeleton.positions[line[i]]);
      const auto after = sheet_middle(mesh, skeleton.positions[line[i + 1]]);
      if (!before || !centre || !after) continue;
      const Vec3 tangent = (*after - *before).normalized();
      const Vec3 level = Vec3::UnitZ().cross(tangent).normalized();
      const auto leaning = half_axis(mesh, *centre, tangent.cross(level));
      const auto wide = half_axis(mesh, *centre, level);
      if (leaning && wide) ratios.push_back(*leaning / *wide);
    }
  }
  return ratios;
}

PolyMesh part_of(const PolyMesh& mesh, int object) {
  const auto& labels = std::get<std::vector<std::int32_t>>(mesh.channel("object", Domain::Face)->data);
  PolyMesh part;
  std::vector<Index> number(mesh.positions.size(), no_index);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (labels[f] != object) continue;
    std::array<Index, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Index v = mesh.face(f)[i];
      if (number[v] == no_index) {
        number[v] = static_cast<Index>(part.positions.size());
        part.positions.push_back(mesh.positions[v]);
      }
      corners[i] = number[v];
    }
    part.add_triangle(corners[0], corners[1], corners[2]);
  }
  return part;
}

PolyMesh rounded_to_float(PolyMesh mesh) {
  for (Vec3& p : mesh.positions) p = p.cast<float>().cast<double>();
  return mesh;
}

PolyMesh rounded_to_grid(PolyMesh mesh, double spacing) {
  for (Vec3& p : mesh.positions) p = (p / spacing).array().round() * spacing;
  return mesh;
}

}  // namespace croquis::test
