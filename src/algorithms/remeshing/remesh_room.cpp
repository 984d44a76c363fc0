// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_room.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/remeshing/remesh_attributes.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double box_differs = 2;        // × cell
constexpr double volume_differs = 0.05;  // × volume
constexpr double surface_differs = 0.1;  // × cell, all over
constexpr double hole_bulge = 0.5;       // × diameter, over a hole

constexpr double crossing_volume = 0.5;  // × volume: where a surface crosses itself parts count twice

double volume_below(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& middle) {
  return (a - middle).dot((b - middle).cross(c - middle)) / 6;
}

/// All holes of a piece that are closed.
std::vector<Index> closed_holes(const RemeshPiece& piece) {
  std::vector<Index> holes = piece.caps;
  for (const std::vector<Index>& group : piece.groups) holes.insert(holes.end(), group.begin(), group.end());
  std::ranges::sort(holes);
  return holes;
}

implicit::Box box_of(const std::vector<Vec3>& positions, std::span<const Index> vertices) {
  implicit::Box box{positions[vertices.front()], positions[vertices.front()]};
  for (const Index v : vertices) {
    box.low = box.low.cwiseMin(positions[v]);
    box.high = box.high.cwiseMax(positions[v]);
  }
  return box;
}

}  // namespace

PieceRoom room_of_scan(const PolyMesh& mesh, const HoleAnalysis& analysis, const RemeshPiece& piece) {
  PieceRoom room{box_of(mesh.positions, piece.vertices), {}, 0};
  const std::vector<Index> closed = closed_holes(piece);
  const Vec3 middle = room.box.middle();
  double volume = 0;
  for (const Index t : piece.triangles) {
    const auto& [a, b, c] = analysis.view.triangles[t];
    const Vec3 &pa = mesh.positions[a], &pb = mesh.positions[b], &pc = mesh.positions[c];
    room.area += 0.5 * (pb - pa).cross(pc - pa).norm();
    volume += volume_below(pa, pb, pc, middle);
  }
  for (const Hole& hole : analysis.holes) {
    if (!std::ranges::binary_search(piece.vertices, hole.vertices.front())) continue;
    if (!std::ranges::binary_search(closed, hole.id)) return room;
    for (std::size_t i = 0; i < hole.vertices.size(); ++i) {
      const Vec3& from = mesh.positions[hole.vertices[i]];
      const Vec3& to = mesh.positions[hole.vertices[(i + 1) % hole.vertices.size()]];
      volume += volume_below(hole.centre, to, from, middle);
    }
  }
  room.volume = volume;
  return room;
}

PieceRoom room_of_surface(const PolyMesh& surface, bool is_closed) {
  PieceRoom room{implicit::bounds(surface.positions), {}, 0};
  if (!is_closed) return room;
  const Vec3 middle = room.box.middle();
  double volume = 0;
  for (Index f = 0; f < surface.face_count(); ++f) {
    const auto face = surface.face(f);
    volume += volume_below(surface.positions[face[0]], surface.positions[face[1]], surface.positions[face[2]], middle);
  }
  room.volume = volume;
  return room;
}

RoomChange change_of(const PieceRoom& given, const PieceRoom& made, const HoleAnalysis& analysis,
                     const RemeshPiece& piece, double cell) {
  RoomChange change;
  double bulge = 0, enclosed = 0;
  for (const Index id : closed_holes(piece)) {
    const Hole& hole = analysis.holes[id];
    bulge = std::max(bulge, hole_bulge * hole.diameter);
    enclosed += hole_bulge * hole.diameter * hole.area;
  }
  const double shrunk =
      std::max((made.box.low - given.box.low).maxCoeff(), (given.box.high - made.box.high).maxCoeff());
  const double grown = std::max((given.box.low - made.box.low).maxCoeff(), (made.box.high - given.box.high).maxCoeff());
  if (shrunk > box_differs * cell) change.shrunk = shrunk;
  if (grown > box_differs * cell + bulge && piece.seams.empty()) change.grown = grown;
  if (!given.volume || !made.volume) return change;
  const double most = volume_differs * std::abs(*given.volume) + surface_differs * cell * given.area + enclosed;
  if (std::abs(*made.volume - *given.volume) > most) {
    change.given = *given.volume;
    change.made = *made.volume;
  }
  return change;
}

RoomChange change_of_solid(const std::vector<std::optional<double>>& volumes, const PolyMesh& solid, double cell) {
  RoomChange change;
  double largest = 0, all = 0, cavities = 0, area = 0;
  for (const std::optional<double>& volume : volumes) {
    if (!volume) return change;
    largest = std::max(largest, *volume);
    all += std::max(*volume, 0.0);
    cavities -= std::min(*volume, 0.0);
  }
  for (std::size_t f = 0; f < solid.face_count(); ++f) area += 0.5 * face_normal(solid, f).norm();
  const double made = *room_of_surface(solid, true).volume;
  const double least = (volumes.size() == 1 ? crossing_volume : 1) * largest - cavities;
  const double allowed = volume_differs * all + surface_differs * cell * area;
  if (made >= least - allowed && made <= all + allowed) return change;
  change.given = made < least ? least : all;
  change.made = made;
  return change;
}

}  // namespace croquis::remeshing
