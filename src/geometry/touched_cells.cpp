// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/touched_cells.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

namespace croquis {
namespace {

using Bounds = Eigen::AlignedBox3d;
using Cell = std::array<std::size_t, 3>;

/// Powers of two. The first and the last along each axis lie outside the bounds and are never touched.
constexpr std::size_t fewest_cells_per_axis = 8;
constexpr std::size_t most_cells_per_axis = 64;

/// As fine as faces are small where they cover a volume: a few faces each touch a large part of their bounds.
std::size_t cells_per_axis_for(std::size_t faces) {
  const auto cells = static_cast<std::size_t>(4 * std::cbrt(static_cast<double>(faces)));
  return std::clamp(std::bit_floor(cells), fewest_cells_per_axis, most_cells_per_axis);
}

/// A face in more cells counts as near without a test of each.
constexpr std::size_t most_cells = 512;

Bounds bounds_of(const PolyMesh& mesh, std::span<const Index> faces) {
  Bounds bounds;
  for (const Index f : faces) {
    for (const Index v : mesh.face(f)) bounds.extend(mesh.positions[v]);
  }
  return bounds;
}

/// Monotonic in the coordinate, so that boxes which meet have a cell in common however coordinates are rounded.
std::uint64_t cell(double coordinate, double low, double high, double cells_per_length, std::size_t cells_per_axis) {
  if (coordinate < low) return 0;
  if (coordinate > high) return cells_per_axis - 1;
  const auto inside = static_cast<double>(cells_per_axis - 3);
  return 1 + static_cast<std::uint64_t>(std::min((coordinate - low) * cells_per_length, inside));
}

/// Zero where lengths are too small or too large for numbers: all lies in one cell then.
double cells_per_length(double size, std::size_t cells_per_axis) {
  const double scale = static_cast<double>(cells_per_axis - 2) / size;
  return std::isnormal(size) && std::isnormal(scale) ? scale : 0;
}

Cell unpacked(PackedPlace place) {
  const auto axis = [&](unsigned k) {
    return static_cast<std::size_t>(place >> (k * packed_stride) & (most_cells_per_axis - 1));
  };
  return {axis(0), axis(1), axis(2)};
}

std::size_t number_of(std::size_t x, std::size_t y, std::size_t z) {
  return (x * most_cells_per_axis + y) * most_cells_per_axis + z;
}

/// Stops at the first cell for which `found` is true. @return whether there was one
template <typename Found>
bool visit_cells(const Cell& low, const Cell& high, Found&& found) {
  for (std::size_t x = low[0]; x <= high[0]; ++x) {
    for (std::size_t y = low[1]; y <= high[1]; ++y) {
      for (std::size_t z = low[2]; z <= high[2]; ++z) {
        if (found(number_of(x, y, z))) return true;
      }
    }
  }
  return false;
}

}  // namespace

TouchedCells::TouchedCells(const PolyMesh& mesh, std::span<const Index> faces)
    : mesh_(mesh),
      cells_per_axis_(cells_per_axis_for(faces.size())),
      touched_(most_cells_per_axis * most_cells_per_axis * cells_per_axis_, false) {
  const Bounds bounds = bounds_of(mesh, faces);
  cells_.assign(mesh.vertex_count(), 0);
  if (!bounds.isEmpty()) number_cells(bounds.min(), bounds.max());
  for (const Index f : faces) {
    if (mesh.face(f).empty()) continue;
    const PackedBox box = cells_of(f);
    visit_cells(unpacked(box.low), unpacked(box.high), [&](std::size_t number) {
      touched_[number] = true;
      return false;
    });
  }
}

void TouchedCells::number_cells(const Vec3& low, const Vec3& high) {
  Vec3 scale;
  for (Eigen::Index axis = 0; axis < 3; ++axis) scale[axis] = cells_per_length(high[axis] - low[axis], cells_per_axis_);
  for (std::size_t v = 0; v < cells_.size(); ++v) {
    const Vec3& place = mesh_.positions[v];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<Eigen::Index>(axis);
      cells_[v] |= packed(cell(place[k], low[k], high[k], scale[k], cells_per_axis_), axis);
    }
  }
}

PackedBox TouchedCells::cells_of(Index face) const {
  const auto vertices = mesh_.face(face);
  PackedBox box{cells_[vertices.front()], cells_[vertices.front()]};
  for (const Index v : vertices.subspan(1)) box = extended(box, cells_[v]);
  return box;
}

bool TouchedCells::may_be_near(Index face) const {
  if (mesh_.face(face).empty()) return false;
  const PackedBox box = cells_of(face);
  const Cell low = unpacked(box.low);
  if (box.low == box.high) return touched_[number_of(low[0], low[1], low[2])];  // as nearly all
  const Cell high = unpacked(box.high);
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (high[axis] == 0 || low[axis] == cells_per_axis_ - 1) return false;
    count *= high[axis] - low[axis] + 1;
  }
  return count > most_cells || visit_cells(low, high, [&](std::size_t number) { return touched_[number]; });
}

}  // namespace croquis
