// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pointer/face_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/morton_order.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/polygon_cut.h"

namespace croquis {
namespace {

constexpr int bits_per_axis = 14;
constexpr float infinite = std::numeric_limits<float>::infinity();

/// A share of the mesh's extent as a whole number.
std::uint64_t cell_of(double share) {
  constexpr double cells = 1 << bits_per_axis;
  const double scaled = share * cells;
  return scaled > 0 ? static_cast<std::uint64_t>(std::min(scaled, cells - 1)) : 0;  // 0 for NaN too
}

/// One over each component, huge where that is zero: so no box test has to multiply infinity by zero.
Vec3 inverse_of(const Vec3& direction) {
  Vec3 inverse;
  for (int axis = 0; axis < 3; ++axis) inverse[axis] = std::abs(direction[axis]) > 1e-300 ? 1 / direction[axis] : 1e300;
  return inverse;
}

}  // namespace

FaceHit::FaceHit(const Ray& ray) : ray_(ray), x_(ray.direction.unitOrthogonal()), y_(ray.direction.cross(x_)) {}

FaceHit::Seen FaceHit::seen(const Vec3& place) const {
  const Vec3 offset = place - ray_.origin;
  return {x_.dot(offset), y_.dot(offset), ray_.direction.dot(offset)};
}

std::optional<double> FaceHit::triangle(const Seen& a, const Seen& b, const Seen& c) {
  // A shared edge gives the same number with the other sign in both faces, so 0 counts as inside for both.
  const double at_a = b.x * c.y - b.y * c.x;
  const double at_b = c.x * a.y - c.y * a.x;
  const double at_c = a.x * b.y - a.y * b.x;
  const bool inside = (at_a >= 0 && at_b >= 0 && at_c >= 0) || (at_a <= 0 && at_b <= 0 && at_c <= 0);
  const double area = at_a + at_b + at_c;
  if (!inside || area == 0) return std::nullopt;
  return (at_a * a.depth + at_b * b.depth + at_c * c.depth) / area;
}

std::optional<double> FaceHit::quad(const PolyMesh& mesh, std::span<const Index> corners) const {
  const std::size_t first = quad_cut(mesh.positions, corners);
  const Seen a = seen(mesh.positions[corners[first]]);
  const Seen b = seen(mesh.positions[corners[first + 1]]);
  const Seen c = seen(mesh.positions[corners[first + 2]]);
  const Seen d = seen(mesh.positions[corners[(first + 3) % 4]]);
  const auto one = triangle(a, b, c);
  const auto two = triangle(a, c, d);
  if (one && two) return std::min(*one, *two);
  return one ? one : two;
}

std::optional<double> FaceHit::polygon(const PolyMesh& mesh, Index face) const {
  const auto corners = mesh.face(face);
  bool inside = false;
  double nearest = std::numeric_limits<double>::infinity();
  double furthest = -nearest;
  Seen a = seen(mesh.positions[corners.back()]);
  for (const Index corner : corners) {
    const Seen b = seen(mesh.positions[corner]);
    nearest = std::min(nearest, b.depth);
    furthest = std::max(furthest, b.depth);
    if ((a.y > 0) != (b.y > 0)) {
      const double side = a.x * b.y - a.y * b.x;
      if ((side > 0) == (b.y > a.y)) inside = !inside;
    }
    a = b;
  }
  if (!inside) return std::nullopt;
  const Vec3 normal = area_normal(mesh, face);
  const double across = normal.dot(ray_.direction);
  if (across == 0) return nearest;
  const double depth = normal.dot(mesh.positions[corners[0]] - ray_.origin) / across;
  return std::clamp(depth, nearest, furthest);  // a polygon needn't be flat
}

std::optional<double> FaceHit::distance(const PolyMesh& mesh, Index face) const {
  const auto corners = mesh.face(face);
  if (corners.size() < 3) return std::nullopt;
  if (corners.size() == 4) return quad(mesh, corners);
  if (corners.size() > 4) return polygon(mesh, face);
  return triangle(seen(mesh.positions[corners[0]]), seen(mesh.positions[corners[1]]), seen(mesh.positions[corners[2]]));
}

FaceTree::Box FaceTree::empty_box() { return {{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}}; }

void FaceTree::add(Box& box, const Box& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(box.low[axis], other.low[axis]);
    box.high[axis] = std::max(box.high[axis], other.high[axis]);
  }
}

FaceTree::Box FaceTree::box_of(const PolyMesh& mesh, Index face) {
  const auto corners = mesh.face(face);
  if (corners.empty()) return empty_box();
  Vec3 low = mesh.positions[corners[0]];
  Vec3 high = low;
  for (const Index corner : corners) {
    low = low.cwiseMin(mesh.positions[corner]);
    high = high.cwiseMax(mesh.positions[corner]);
  }
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // One step further than rounding could have gone inwards.
    box.low[axis] = std::nextafter(static_cast<float>(low[static_cast<Eigen::Index>(axis)]), -infinite);
    box.high[axis] = std::nextafter(static_cast<float>(high[static_cast<Eigen::Index>(axis)]), infinite);
  }
  return box;
}

FaceTree::FaceTree(const PolyMesh& mesh) {
  const auto count = static_cast<Index>(mesh.face_count());
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const Vec3& position : mesh.positions) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  const double extent = mesh.positions.empty() ? 0 : (high - low).maxCoeff();
  const double scale = extent > 0 ? 1 / extent : 0;
  std::vector<std::uint64_t> keys(count);
  for (Index face = 0; face < count; ++face) {
    Vec3 middle = low;
    const auto corners = mesh.face(face);
    // Two opposite corners are enough for the place of a face.
    if (!corners.empty()) middle = (mesh.positions[corners[0]] + mesh.positions[corners[corners.size() / 2]]) / 2;
    const Vec3 at = (middle - low) * scale;
    keys[face] = spread_by_three(cell_of(at.x())) << 2U | spread_by_three(cell_of(at.y())) << 1U |
                 spread_by_three(cell_of(at.z()));
  }
  order_ = radix_order(keys);
  const Index leaves = std::bit_ceil(std::max<Index>(1, (count + leaf_faces - 1) / leaf_faces));
  boxes_.assign(std::size_t{2} * leaves, empty_box());
  refit(mesh);
}

void FaceTree::refit(const PolyMesh& mesh) {
  const Index leaves = leaf_count();
  for (Index leaf = 0; std::size_t{leaf} * leaf_faces < order_.size(); ++leaf) {
    Box& box = boxes_[leaves + leaf];
    box = empty_box();
    const std::size_t end = std::min<std::size_t>(order_.size(), (std::size_t{leaf} + 1) * leaf_faces);
    for (std::size_t i = std::size_t{leaf} * leaf_faces; i < end; ++i) add(box, box_of(mesh, order_[i]));
  }
  for (Index node = leaves - 1; node > 0; --node) {
    boxes_[node] = boxes_[std::size_t{2} * node];
    add(boxes_[node], boxes_[std::size_t{2} * node + 1]);
  }
}

/// Calls for every face whose leaf the ray meets between two distances, nearer boxes first.
/// @param to may be lowered by `visit`, which returns true to stop
template <typename Visit>
void FaceTree::walk(const Ray& ray, double from, double& to, Visit visit) const {
  const Vec3 inverse = inverse_of(ray.direction);
  const auto enters = [&](Index node) {
    const Box& box = boxes_[node];
    if (box.low[0] > box.high[0]) return std::numeric_limits<double>::infinity();
    double near = from;
    double far = to;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<Eigen::Index>(axis);
      const double a = (static_cast<double>(box.low[axis]) - ray.origin[k]) * inverse[k];
      const double b = (static_cast<double>(box.high[axis]) - ray.origin[k]) * inverse[k];
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    return near <= far ? near : std::numeric_limits<double>::infinity();
  };
  std::array<std::pair<double, Index>, 64> stack;  // a path of at most 31 levels, and each level's other child
  std::size_t height = 0;
  const auto push = [&](double near, Index node) {
    if (near <= to && near < std::numeric_limits<double>::infinity()) stack[height++] = {near, node};
  };
  push(enters(1), 1);
  while (height > 0) {
    const auto [near, node] = stack[--height];
    if (near > to) continue;
    if (node < leaf_count()) {
      const double left = enters(2 * node);
      const double right = enters(2 * node + 1);
      push(std::max(left, right), left > right ? 2 * node : 2 * node + 1);
      push(std::min(left, right), left > right ? 2 * node + 1 : 2 * node);
      continue;
    }
    const std::size_t begin = std::size_t{node - leaf_count()} * leaf_faces;
    const std::size_t end = std::min<std::size_t>(order_.size(), begin + leaf_faces);
    for (std::size_t i = begin; i < end; ++i) {
      if (visit(order_[i])) return;
    }
  }
}

FaceTree::Hit FaceTree::first(const PolyMesh& mesh, const Ray& ray, double from, double to) const {
  const FaceHit meets(ray);
  Hit best;
  walk(ray, from, to, [&](Index face) {
    const auto distance = meets.distance(mesh, face);
    if (!distance || *distance < from || *distance > to) return false;
    if (*distance < best.distance || (*distance == best.distance && face < best.face)) best = {face, *distance};
    to = best.distance;
    return false;
  });
  return best;
}

bool FaceTree::any(const PolyMesh& mesh, const Ray& ray, double from, double to,
                   const std::vector<Index>& except) const {
  const FaceHit meets(ray);
  bool found = false;
  walk(ray, from, to, [&](Index face) {
    const auto distance = meets.distance(mesh, face);
    if (!distance || *distance < from || *distance > to) return false;
    found = !std::binary_search(except.begin(), except.end(), face);
    return found;
  });
  return found;
}

std::vector<Index> FaceTree::near(const Planes& planes) const {
  const auto outside = [&](const Box& box) {
    return std::any_of(planes.begin(), planes.end(), [&](const Eigen::Vector4d& plane) {
      double most = plane.w();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double k = plane[static_cast<Eigen::Index>(axis)];
        most += k * static_cast<double>(k > 0 ? box.high[axis] : box.low[axis]);
      }
      return most < 0;
    });
  };
  std::vector<Index> faces;
  std::vector<Index> stack = {1};
  while (!stack.empty()) {
    const Index node = stack.back();
    stack.pop_back();
    if (boxes_[node].low[0] > boxes_[node].high[0] || outside(boxes_[node])) continue;
    if (node < leaf_count()) {
      stack.push_back(2 * node + 1);
      stack.push_back(2 * node);
      continue;
    }
    const std::size_t begin = std::size_t{node - leaf_count()} * leaf_faces;
    const std::size_t end = std::min<std::size_t>(order_.size(), begin + leaf_faces);
    faces.insert(faces.end(), order_.begin() + static_cast<std::ptrdiff_t>(begin),
                 order_.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return faces;
}

}  // namespace croquis
