// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/cage/figure_cage.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/cage/quad_sheet.h"
#include "algorithms/silhouette/skeleton/triangle_corners.h"

namespace croquis::silhouette {
namespace {

constexpr int fit_rounds = 8;
constexpr int overlap_levels = 2;

/// Where a sheet begins on its contours: per contour and position, the lifted triangle behind the segment there and
/// the lifted vertex.
struct SheetRims {
  std::vector<std::vector<Index>> triangles, vertices;
};

SheetRims rims_of(const LabelledFigure& figure, const SheetSampling& sheets) {
  SheetRims rims;
  for (const FigureContour& contour : figure.contours) {
    rims.triangles.emplace_back(contour.vertices.size(), no_index);
    rims.vertices.emplace_back(contour.vertices.size(), no_index);
  }
  const LiftedTriangulation& lifted = sheets.lifted;
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      if (lifted.neighbours[m][corner] != no_index) continue;
      const RimPiece& piece = sheets.pieces[sheets.planar.constraints[lifted.planar_triangle[m]][corner]];
      if (piece.begin != figure.contours[piece.contour].vertices[piece.position]) continue;
      const Index first = lifted.triangles[m][next(corner)], second = lifted.triangles[m][previous(corner)];
      rims.triangles[piece.contour][piece.position] = m;
      rims.vertices[piece.contour][piece.position] = lifted.planar_vertex[first] == piece.begin ? first : second;
    }
  }
  return rims;
}

/// From a lifted triangle towards a place, staying in the sheet: the triangle that holds it, or the last one before the
/// sheet ends.
Index walk_in_sheet(const SheetSampling& sheets, Index from, const Vec2& to) {
  const LiftedTriangulation& lifted = sheets.lifted;
  Index here = from, last = no_index;
  for (std::size_t steps = 0; steps < lifted.triangles.size(); ++steps) {
    const std::array<Index, 3>& corners = lifted.triangles[here];
    const auto point = [&](Index corner) { return sheets.points[lifted.planar_vertex[corners[corner]]]; };
    Index way = no_index;
    double farthest = 0;
    for (Index corner = 0; corner < 3; ++corner) {
      const Index beyond = lifted.neighbours[here][corner];
      if (beyond == no_index || beyond == last) continue;
      const Vec2 a = point(next(corner)), edge = point(previous(corner)) - a;
      const double outside = -cross(edge, to - a) / edge.norm();
      if (outside > farthest) std::tie(way, farthest) = std::pair(beyond, outside);
    }
    if (way == no_index) return here;
    last = std::exchange(here, way);
  }
  return here;
}

/// What the surface over a sheet's vertices is to be.
struct Targets {
  std::vector<Vec2> place;
  std::vector<double> middle, half;  ///< front and back are middle +- half
};

Targets targets_of(const LabelledFigure& figure, const std::vector<RimLine>& lines, const QuadSheet& quads,
                   const InflatedSheets& sheets) {
  const SheetRims rims = rims_of(figure, sheets.sampling);
  std::vector<Index> triangle;  // per vertex
  Targets targets;
  for (const QuadVertex& vertex : quads.vertices) {
    targets.place.push_back(vertex.place);
    if (vertex.rim == no_index) {
      triangle.push_back(walk_in_sheet(sheets.sampling, triangle[vertex.before], vertex.place));
      const LiftedPlace place = place_in(sheets.sampling, triangle.back(), vertex.place);
      targets.middle.push_back(value_at(place, sheets.z));
      targets.half.push_back(value_at(place, sheets.thickness));
      continue;
    }
    const RimLine& line = lines[vertex.rim];
    const auto count = static_cast<Index>(line.points.size());
    const Index segment = line.segment_at(vertex.at), after = (segment + 1) % count;
    // `walked` is its own inverse; a segment walked against its contour begins at its later point.
    const Index begin = line.walked(segment), end = line.walked(after);
    const Vec2 a = line.points[segment], b = line.points[after];
    const double part = (vertex.place - a).norm() / std::max((b - a).norm(), 1e-300);
    const std::vector<Index>& lifted = rims.vertices[vertex.rim];
    triangle.push_back(rims.triangles[vertex.rim][line.side > 0 ? begin : end]);
    targets.middle.push_back((1 - part) * sheets.z[lifted[begin]] + part * sheets.z[lifted[end]]);
    targets.half.push_back(0);
  }
  return targets;
}

/// Fronts and backs of a sheet, which share the rim's vertices.
struct DoubledSheet {
  PolyMesh mesh;
  std::vector<Index> backs;  ///< per vertex of the sheet, whose numbers fronts have
};

DoubledSheet doubled(const QuadSheet& quads) {
  DoubledSheet made;
  auto count = static_cast<Index>(quads.vertices.size());
  for (Index v = 0; v < quads.vertices.size(); ++v) {
    made.backs.push_back(quads.vertices[v].rim == no_index ? count++ : v);
  }
  made.mesh.positions.resize(count);
  for (const std::array<Index, 4>& face : quads.faces) made.mesh.add_face(face);
  for (const auto& [a, b, c, d] : quads.faces) {
    made.mesh.add_face(std::array{made.backs[a], made.backs[d], made.backs[c], made.backs[b]});
  }
  return made;
}

/// Where the vertices of a closed mesh of quads end when it is subdivided for ever, the mean of both schemes.
std::vector<Vec3> limit_points(const PolyMesh& mesh) {
  std::vector<Vec3> beside(mesh.vertex_count(), Vec3::Zero()), across = beside;
  std::vector<double> valence(mesh.vertex_count(), 0);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < 4; ++i) {
      beside[face[i]] += (mesh.positions[face[(i + 1) % 4]] + mesh.positions[face[(i + 3) % 4]]) / 2;
      across[face[i]] += mesh.positions[face[(i + 2) % 4]];
      valence[face[i]] += 1;
    }
  }
  for (Index v = 0; v < beside.size(); ++v) {
    const double n = valence[v];
    const double own = (n / (n + 5) + 9.0 / 16) / 2, edges = (4 / (n + 5) + 6.0 / 16) / 2;
    beside[v] = own * mesh.positions[v] + edges / n * beside[v] + (1 - own - edges) / n * across[v];
  }
  return beside;
}

/// How far a quad is from being folded at a corner: 1 for a parallelogram, 0 for a triangle, less where it is folded.
double least_corner(const PolyMesh& mesh, Index face) {
  const auto corners = mesh.face(face);
  const auto at = [&](std::size_t i) { return mesh.positions[corners[i % 4]]; };
  std::array<Vec3, 4> normals;
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    normals[i] = (at(i + 1) - at(i)).cross(at(i + 3) - at(i));
    sum += normals[i];
  }
  double least = 1;
  for (const Vec3& normal : normals) least = std::min(least, 4 * normal.dot(sum) / sum.squaredNorm());
  return least;
}

/// Per vertex of a sheet how far its control point may lie from its target: a share of the edges there.
std::vector<double> reaches_of(const QuadSheet& quads, const Targets& targets) {
  constexpr double share = 0.45;
  std::vector<double> length(quads.vertices.size(), 0), edges = length;
  const auto at = [&](Index v) { return Vec3(targets.place[v].x(), targets.place[v].y(), targets.half[v]); };
  for (const std::array<Index, 4>& face : quads.faces) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Index a = face[i], b = face[(i + 1) % 4];
      for (const Index v : {a, b}) {
        length[v] += (at(a) - at(b)).norm();
        edges[v] += 1;
      }
    }
  }
  for (std::size_t v = 0; v < length.size(); ++v) length[v] *= share / edges[v];
  return length;
}

/// Moves the sheet's control points so that the surface comes nearer to the targets; where a face would fold its
/// vertices move less.
void fit_once(const QuadSheet& quads, const Targets& targets, std::span<const double> reach, DoubledSheet& cage) {
  constexpr int halvings = 4;
  constexpr double nearly_folded = 0.1;
  std::vector<Vec3>& positions = cage.mesh.positions;
  const std::vector<Vec3> limit = limit_points(cage.mesh), old = positions;
  const auto count = static_cast<Index>(quads.vertices.size());
  std::vector<double> share(count, 1);
  const auto set = [&](Index v) {
    const Index back = cage.backs[v];
    // Places, and the middle and half of the depth there.
    const auto halved = [&](const std::vector<Vec3>& of) {
      return Eigen::Vector4d(of[v].x(), of[v].y(), (of[v].z() + of[back].z()) / 2, (of[v].z() - of[back].z()) / 2);
    };
    const Eigen::Vector4d target(targets.place[v].x(), targets.place[v].y(), targets.middle[v], targets.half[v]);
    const Eigen::Vector4d from = halved(old);
    Eigen::Vector4d offset = from - halved(limit);
    offset *= std::min(1.0, reach[v] / std::max(offset.norm(), 1e-300));
    const Eigen::Vector4d now = from + share[v] * (target + offset - from);
    positions[v] = {now[0], now[1], now[2] + now[3]};
    positions[back] = {now[0], now[1], now[2] - now[3]};
  };
  std::vector<double> before(quads.faces.size());
  for (Index f = 0; f < before.size(); ++f) before[f] = least_corner(cage.mesh, f);
  for (Index v = 0; v < count; ++v) set(v);
  for (int k = 0; k < halvings; ++k) {
    std::vector<Index> held;
    for (Index f = 0; f < before.size(); ++f) {
      if (least_corner(cage.mesh, f) > std::min(before[f], nearly_folded)) continue;
      for (const Index v : quads.faces[f]) held.push_back(v);
    }
    for (const Index v : held) share[v] = k + 1 < halvings ? share[v] / 2 : 0;
    for (const Index v : held) set(v);
  }
}

}  // namespace

PolyMesh refined_quads(const PolyMesh& cage) {
  PolyMesh fine;
  fine.positions.assign(cage.vertex_count(), Vec3::Zero());
  std::vector<double> valence(cage.vertex_count(), 0);
  std::map<std::pair<Index, Index>, Index> edges;
  std::vector<Index> faces_first;
  const auto vertices = static_cast<Index>(cage.vertex_count()), faces = static_cast<Index>(cage.face_count());
  fine.positions.resize(vertices + faces, Vec3::Zero());
  for (Index f = 0; f < faces; ++f) {
    for (const Index v : cage.face(f)) fine.positions[vertices + f] += cage.positions[v] / 4;
  }
  for (Index f = 0; f < faces; ++f) {
    const auto face = cage.face(f);
    std::array<Index, 4> middle{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Index a = face[i], b = face[(i + 1) % 4];
      const auto [edge, is_new] = edges.try_emplace(std::minmax(a, b), static_cast<Index>(fine.positions.size()));
      if (is_new) fine.positions.push_back((cage.positions[a] + cage.positions[b]) / 4);
      middle[i] = edge->second;
      fine.positions[middle[i]] += fine.positions[vertices + f] / 4;
      // Of a vertex: its faces' centres and its edges' middles, each edge once from each of its faces.
      fine.positions[a] += fine.positions[vertices + f] + (cage.positions[a] + cage.positions[b]) / 2 +
                           (cage.positions[a] + cage.positions[face[(i + 3) % 4]]) / 2;
      valence[a] += 1;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      fine.add_face(std::array{face[i], middle[i], vertices + f, middle[(i + 3) % 4]});
    }
  }
  for (Index v = 0; v < vertices; ++v) {
    const double n = valence[v];
    fine.positions[v] = fine.positions[v] / (n * n) + (n - 3) / n * cage.positions[v];
  }
  return fine;
}

namespace {

Overlap overlap_of(const LabelledFigure& figure, PolyMesh cage) {
  for (int k = 0; k < overlap_levels; ++k) cage = refined_quads(cage);
  PolyMesh triangles;
  triangles.positions = std::move(cage.positions);
  for (Index f = 0; f < cage.face_count(); ++f) {
    const auto face = cage.face(f);
    triangles.add_triangle(face[0], face[1], face[2]);
    triangles.add_triangle(face[0], face[2], face[3]);
  }
  std::vector<SidedOutline> outlines;
  for (Index c = 0; c < figure.contours.size(); ++c) {
    outlines.push_back({figure.raw_contours[c], figure.contours[c].side});
  }
  const PolyMesh* mesh = &triangles;
  return silhouette_overlap({&mesh, 1}, outlines);
}

}  // namespace

FigureCage figure_cage(const LabelledFigure& figure, const InflatedSheets& sheets, double spacing, Progress& progress) {
  const ImmersedTriangulation immersed = immerse(figure, lift(figure), progress);
  const LimbedRegion region = limbed_region(figure, immersed, spacing);
  const QuadSheet quads = quad_sheet(region);
  const Targets targets = targets_of(figure, region.rims, quads, sheets);
  DoubledSheet cage = doubled(quads);
  for (Index v = 0; v < quads.vertices.size(); ++v) {
    const Vec2& place = targets.place[v];
    cage.mesh.positions[cage.backs[v]] = {place.x(), place.y(), targets.middle[v] - targets.half[v]};
    cage.mesh.positions[v] = {place.x(), place.y(), targets.middle[v] + targets.half[v]};
  }
  const std::vector<double> reach = reaches_of(quads, targets);
  for (int round = 0; round < fit_rounds; ++round) fit_once(quads, targets, reach, cage);
  FigureCage made;
  made.caps = quads.tips;
  for (int copy = 0; copy < 2; ++copy) {
    for (const std::array<Index, 4>& face : quads.faces) {
      // Every quad leads to the rim by vertices that were placed from there.
      Index v = face[0];
      while (quads.vertices[v].rim == no_index) v = quads.vertices[v].before;
      made.objects.push_back(figure.contours[quads.vertices[v].rim].object);
    }
  }
  made.overlap = overlap_of(figure, cage.mesh);
  made.mesh = std::move(cage.mesh);
  return made;
}

}  // namespace croquis::silhouette
