// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/cage_builder.h"

#include <utility>

namespace croquis {
namespace {

CageBuilder::Row part_of_row(const CageBuilder::Row& row, std::size_t first, std::size_t last) {
  return {row.begin() + static_cast<std::ptrdiff_t>(first), row.begin() + static_cast<std::ptrdiff_t>(last + 1)};
}

}  // namespace

Index CageBuilder::add_vertex(const Vec3& point) {
  mesh.positions.push_back(point);
  return static_cast<Index>(mesh.positions.size() - 1);
}

void CageBuilder::add_grid(const std::array<Row, 4>& sides, const std::function<Vec3(double u, double v)>& at) {
  const std::size_t n = sides[0].size() - 1;
  const double step = 1 / static_cast<double>(n);
  std::vector<Row> rows(n + 1, Row(n + 1));
  for (std::size_t row = 0; row <= n; ++row) {
    for (std::size_t column = 0; column <= n; ++column) {
      Index& vertex = rows[row][column];
      if (row == 0) {
        vertex = sides[0][column];
      } else if (row == n) {
        vertex = sides[2][n - column];
      } else if (column == 0) {
        vertex = sides[3][n - row];
      } else if (column == n) {
        vertex = sides[1][row];
      } else {
        vertex = add_vertex(at(static_cast<double>(column) * step, static_cast<double>(row) * step));
      }
    }
  }
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t column = 0; column < n; ++column)
      mesh.add_face(
          std::array{rows[row][column], rows[row][column + 1], rows[row + 1][column + 1], rows[row + 1][column]});
  }
}

void CageBuilder::add_star(const std::vector<Row>& sides, const Vec3& middle,
                           const std::function<Vec3(std::size_t corner, double u, double v)>& at) {
  const std::size_t n = sides.size(), segments = sides[0].size() - 1, half = segments / 2;
  const Index centre = add_vertex(middle);
  std::vector<Row> spokes;  // from the middles of sides to the middle of the face
  for (std::size_t i = 0; i < n; ++i) {
    Row& spoke = spokes.emplace_back();
    spoke.push_back(sides[i][half]);
    for (std::size_t k = 1; k < half; ++k)
      spoke.push_back(add_vertex(at(i, 1, static_cast<double>(k) / static_cast<double>(half))));
    spoke.push_back(centre);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    Row back(spokes[before].rbegin(), spokes[before].rend());
    add_grid({part_of_row(sides[i], 0, half), spokes[i], std::move(back), part_of_row(sides[before], half, segments)},
             [&](double u, double v) { return at(i, u, v); });
  }
}

void CageBuilder::add_crease(const Row& row, const Vec3& leaving, const Vec3& arriving) {
  for (std::size_t i = 0; i + 1 < row.size(); ++i)
    mesh.tags.creases.push_back({{row[i], row[i + 1]}, infinite_sharpness});
  leaving_[row.front()].push_back(leaving);
  leaving_[row.back()].push_back(-arriving);
}

void CageBuilder::add_pins(double corner_turn) {
  for (const auto& [vertex, directions] : leaving_) {
    const bool turns = directions.size() == 2 && angle_between(directions[0], -directions[1]) > corner_turn;
    if (turns) mesh.tags.pins.push_back(vertex);
  }
}

}  // namespace croquis
