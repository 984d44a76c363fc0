// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>

#include "io/ply/ply_tables.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr double longest_edge = 4;  // × the median

using Triangle = std::array<Index, 3>;

class RangeGrid {
 public:
  RangeGrid(const PlyGrid& size, const PlyTable& grid, const PlyColumn& indices, const PolyMesh& mesh,
            ReadContext& context)
      : size_(size), mesh_(mesh), context_(context) {
    if (size.columns == 0 || size.rows != grid.element.count / size.columns || grid.element.count % size.columns != 0) {
      context.fail("E_COUNT",
                   "the range grid has " + std::to_string(grid.element.count) +
                       " places; that needs the header's lines 'obj_info num_cols' and 'obj_info num_rows' with two "
                       "numbers of that product, but they say " +
                       std::to_string(size.columns) + " and " + std::to_string(size.rows),
                   {});
    }
    seen_.reserve(grid.element.count);
    std::visit(
        [&](const auto& values) {
          for (std::size_t place = 0; place < grid.element.count; ++place) {
            seen_.push_back(vertex_at(grid, indices, values, place));
          }
        },
        indices.values);
  }

  /// All triangles between neighbours, also across steps.
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> result;
    for (std::size_t row = 0; row + 1 < size_.rows; ++row) {
      for (std::size_t column = 0; column + 1 < size_.columns; ++column) {
        context_.tick(context_.file_size());
        add_cell({seen(row, column), seen(row + 1, column), seen(row + 1, column + 1), seen(row, column + 1)}, result);
      }
    }
    return result;
  }

  double median_edge() const {
    std::vector<double> lengths;
    const auto add = [&](Index a, Index b) {
      if (a != no_index && b != no_index) lengths.push_back((at(a) - at(b)).norm());
    };
    for (std::size_t row = 0; row < size_.rows; ++row) {
      for (std::size_t column = 0; column < size_.columns; ++column) {
        if (column + 1 < size_.columns) add(seen(row, column), seen(row, column + 1));
        if (row + 1 < size_.rows) add(seen(row, column), seen(row + 1, column));
      }
    }
    if (lengths.empty()) return 0;
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
  }

 private:
  template <typename Values>
  Index vertex_at(const PlyTable& grid, const PlyColumn& indices, const Values& values, std::size_t place) const {
    context_.tick(context_.file_size());
    const std::size_t count = indices.list_size(place);
    if (count == 0) return no_index;
    if (count > 1) {
      context_.error("E_COUNT",
                     "place " + std::to_string(place) + " of the range grid names " + std::to_string(count) +
                         " vertices; a scanner sees one there or none",
                     grid.place(place));
      return no_index;
    }
    const auto index = static_cast<std::int64_t>(values[indices.list_begin(place)]);
    if (index >= 0 && static_cast<std::size_t>(index) < mesh_.vertex_count()) return static_cast<Index>(index);
    context_.error("E_INDEX",
                   "place " + std::to_string(place) + " of the range grid uses vertex " + std::to_string(index) +
                       ", but the file has " + std::to_string(mesh_.vertex_count()) + " vertices",
                   grid.place(place));
    return no_index;
  }

  Index seen(std::size_t row, std::size_t column) const { return seen_[row * size_.columns + column]; }
  const Vec3& at(Index vertex) const { return mesh_.positions[vertex]; }
  // Corners in turn; of three that are seen the order stays.
  void add_cell(std::array<Index, 4> corners, std::vector<Triangle>& triangles) const {
    const auto hidden = std::find(corners.begin(), corners.end(), no_index);
    if (hidden == corners.end()) {
      const auto [a, b, c, d] = corners;
      if ((at(a) - at(c)).squaredNorm() <= (at(b) - at(d)).squaredNorm()) {
        triangles.insert(triangles.end(), {Triangle{a, b, c}, Triangle{a, c, d}});
      } else {
        triangles.insert(triangles.end(), {Triangle{a, b, d}, Triangle{b, c, d}});
      }
      return;
    }
    if (std::count(corners.begin(), corners.end(), no_index) > 1) return;
    std::rotate(corners.begin(), hidden + 1, corners.end());
    triangles.push_back({corners[0], corners[1], corners[2]});
  }

  PlyGrid size_;
  const PolyMesh& mesh_;
  ReadContext& context_;
  std::vector<Index> seen_;  // row by row
};

bool crosses_step(const Triangle& triangle, const PolyMesh& mesh, double limit) {
  const auto [a, b, c] = triangle;
  const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
  return std::max({(p - q).squaredNorm(), (q - r).squaredNorm(), (r - p).squaredNorm()}) > limit * limit;
}

double area_along_z(const std::vector<Triangle>& triangles, const PolyMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    sum += (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).z();
  }
  return sum;
}

}  // namespace

void triangulate_range_grid(const PlyGrid& size, const PlyTable& grid, const PlyColumn& indices, PolyMesh& mesh,
                            ReadContext& context) {
  const RangeGrid view(size, grid, indices, mesh, context);
  if (context.has_errors()) return;
  std::vector<Triangle> triangles = view.triangles();
  const double limit = longest_edge * view.median_edge();
  const std::size_t left_out =
      std::erase_if(triangles, [&](const Triangle& triangle) { return crosses_step(triangle, mesh, limit); });
  const bool turn = area_along_z(triangles, mesh) < 0;
  for (const auto& [a, b, c] : triangles) turn ? mesh.add_triangle(a, c, b) : mesh.add_triangle(a, b, c);
  if (left_out == 0) return;
  context.warn("W_RANGE_STEPS",
               std::to_string(left_out) + " triangles of the range grid would cross a step in depth (an edge longer " +
                   "than 4 times the median); they were left out",
               {});
}

}  // namespace croquis
