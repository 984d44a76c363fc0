// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/fairing/fairing.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

constexpr double doubtful_error = 0.01;  ///< × diagonal: trusted by a half

/// What distances are measured from, and in what.
struct Rims {
  std::vector<Vec3> points;
  double diagonal = 0;

  Rims(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis) {
    for (const Index id : patch.holes) {
      const Hole& hole = analysis.holes[id];
      for (const Index v : hole.vertices) points.push_back(mesh.positions[v]);
      diagonal = std::max(diagonal, analysis.component_diagonal[hole.component]);
    }
  }

  /// × diagonal, of the places given the farthest from the rims.
  double depth_of(std::span<const Vec3> places) const {
    const implicit::PointTree tree(points);
    double farthest = 0;
    for (const Vec3& place : places) farthest = std::max(farthest, (place - points[tree.nearest(place)]).norm());
    return farthest / diagonal;
  }
};

/// Places on a patch of rim vertices alone, evenly by area (the additive recurrence of Roberts 2018).
std::vector<Vec3> places_on(const HolePatch& patch, const PolyMesh& mesh) {
  constexpr double about = 2000, first_step = 0.7548776662466927, second_step = 0.5698402909980532;
  double whole = 0;
  const auto area_of = [&](const std::array<Index, 3>& t) {
    const Vec3& a = mesh.positions[t[0]];
    return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).norm();
  };
  for (const auto& t : patch.triangles) whole += area_of(t);
  std::vector<Vec3> places;
  for (const auto& t : patch.triangles) {
    const double count = whole > 0 ? about * area_of(t) / whole : 0;
    double u = 0.5, v = 0.5;
    for (double i = 0; i < count; ++i) {
      u = std::fmod(u + first_step, 1.0);
      v = std::fmod(v + second_step, 1.0);
      const double a = u + v > 1 ? 1 - u : u, b = u + v > 1 ? 1 - v : v;
      places.push_back((1 - a - b) * mesh.positions[t[0]] + a * mesh.positions[t[1]] + b * mesh.positions[t[2]]);
    }
  }
  return places;
}

/// Along the rims, so that distances to edges are known as well as to vertices.
void add_edge_points(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis, Rims& rims) {
  for (const Index id : patch.holes) {
    const std::vector<Index>& rim = analysis.holes[id].vertices;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Vec3 &a = mesh.positions[rim[i]], &b = mesh.positions[rim[(i + 1) % rim.size()]];
      for (const double t : {0.25, 0.5, 0.75}) rims.points.emplace_back(a + t * (b - a));
    }
  }
}

Vec3 normal_of(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

/// Of stretches of a sixteenth of a rim, four edges at least: the mean of how far each turns, by length.
double mean_fold(const std::vector<std::vector<RimFold>>& folds) {
  double turned = 0, length = 0;
  for (const std::vector<RimFold>& along : folds) {
    const std::size_t stretch = std::max<std::size_t>(4, along.size() / 16);
    for (std::size_t first = 0; first < along.size(); first += stretch) {
      double sum = 0;
      for (std::size_t i = first; i < std::min(first + stretch, along.size()); ++i) {
        sum += along[i].length * along[i].angle;
        length += along[i].length;
      }
      turned += std::abs(sum);
    }
  }
  return length > 0 ? turned / length : 0;
}

/// Per rim vertex of the patch the greatest angle across the rim's edges there.
Eigen::VectorXd rim_jumps(const std::vector<std::vector<RimFold>>& folds, std::span<const Index> rim) {
  Eigen::VectorXd jumps = Eigen::VectorXd::Zero(std::ssize(rim));
  for (const std::vector<RimFold>& along : folds) {
    for (const RimFold& fold : along) {
      for (const Index end : {fold.from, fold.to}) {
        const auto place = std::ranges::lower_bound(rim, end);
        if (place == rim.end() || *place != end) continue;
        double& known = jumps[place - rim.begin()];
        known = std::max(known, std::abs(fold.angle));
      }
    }
  }
  return jumps;
}

/// Whether a triangle is so thin that its normal says nothing: its height is below a fiftieth of its longest side.
bool is_needle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return normal_of(a, b, c).norm() < 0.02 * longest;
}

/// The greatest angle between neighbouring faces of a patch, across its rims too; needles are left out.
double sharpest_fold(const HolePatch& patch, const PolyMesh& mesh, const std::vector<std::vector<RimFold>>& folds) {
  const auto at = [&](Index v) -> const Vec3& { return place_of(patch, mesh, v); };
  std::vector<std::array<Index, 3>> edges;  // low end, high end, triangle
  for (Index t = 0; t < patch.triangles.size(); ++t) {
    const auto& [a, b, c] = patch.triangles[t];
    if (is_needle(at(a), at(b), at(c))) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(patch.triangles[t][i], patch.triangles[t][(i + 1) % 3]);
      edges.push_back({low, high, t});
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto normal_at = [&](const std::array<Index, 3>& edge) {
    const auto& [a, b, c] = patch.triangles[edge[2]];
    return normal_of(at(a), at(b), at(c));
  };
  double sharpest = 0;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i - 1][0] == edges[i][0] && edges[i - 1][1] == edges[i][1])
      sharpest = std::max(sharpest, angle_between(normal_at(edges[i - 1]), normal_at(edges[i])));
  }
  for (const std::vector<RimFold>& along : folds) {
    for (const RimFold& fold : along) sharpest = std::max(sharpest, std::abs(fold.angle));
  }
  return sharpest;
}

/// How far a patch of rim vertices alone turns away from the surface: teeth of ragged rims are filled along it, and
/// hide the fold behind them. The mean direction of the surface into the hole leads out of the patch's plane.
double turn_of_ways(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis) {
  double turn = 0;
  for (const Index id : patch.holes) {
    const Hole& hole = analysis.holes[id];
    Vec3 sum = Vec3::Zero();
    double length = 0;
    for (std::size_t i = 0; i < hole.vertices.size(); ++i) {
      const Vec3 edge =
          mesh.positions[hole.vertices[(i + 1) % hole.vertices.size()]] - mesh.positions[hole.vertices[i]];
      const Vec3 normal = analysis.view.normal(hole.corners[i] / 3, mesh.positions);
      const double area = normal.norm();
      if (area > 0) sum += edge.cross(normal) / area;
      length += edge.norm();
    }
    if (length > 0) turn = std::max(turn, std::asin(std::min(1.0, sum.norm() / length)));
  }
  return turn;
}

/// Continued surface: only wide folds count.
double continued_fold(double angle) { return 4 * angle * angle * angle; }

double flat_fold(double angle) { return 8 * angle; }

}  // namespace

std::vector<std::vector<RimFold>> rim_folds(const HolePatch& patch, const PolyMesh& mesh,
                                            const HoleAnalysis& analysis) {
  std::vector<std::array<Index, 3>> sides;  // of edges between rim vertices: from, to, the corner across
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::max(t[i], t[(i + 1) % 3]) < mesh.vertex_count()) sides.push_back({t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
    }
  }
  std::ranges::sort(sides);
  std::vector<std::vector<RimFold>> folds;
  for (const Index id : patch.holes) {
    const Hole& hole = analysis.holes[id];
    std::vector<RimFold>& along = folds.emplace_back();
    for (std::size_t i = 0; i < hole.vertices.size(); ++i) {
      const Index a = hole.vertices[i], b = hole.vertices[(i + 1) % hole.vertices.size()];
      const Vec3 edge = mesh.positions[b] - mesh.positions[a];
      along.push_back({a, b, edge.norm(), 0});
      const auto side = std::ranges::lower_bound(sides, std::array<Index, 3>{b, a, 0});
      if (side == sides.end() || (*side)[0] != b || (*side)[1] != a) continue;
      const Vec3 given = analysis.view.normal(hole.corners[i] / 3, mesh.positions);
      const Vec3 made = normal_of(mesh.positions[b], mesh.positions[a], place_of(patch, mesh, (*side)[2]));
      const double angle = angle_between(given, made);
      along.back().angle = given.cross(made).dot(edge) < 0 ? -angle : angle;
    }
  }
  return folds;
}

double rim_bend(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const Index> holes) {
  double sum = 0, edges = 0;
  for (const Index id : holes) {
    const std::vector<Index>& corners = analysis.holes[id].corners;
    const auto normal_at = [&](std::size_t i) {
      return analysis.view.normal(corners[i % corners.size()] / 3, mesh.positions);
    };
    for (std::size_t i = 0; i < corners.size(); ++i) sum += angle_between(normal_at(i), normal_at(i + 1));
    edges += static_cast<double>(corners.size());
  }
  return edges > 0 ? sum / edges : 0;
}

double predicted_error(double depth, double bend, double fold) {
  constexpr double share = 0.1, growth = 3, least_doubt = 0.02, doubt_growth = 4;
  const double doubt = least_doubt + doubt_growth * depth * depth;
  return share * depth * (1 + growth * depth) * (doubt + bend + fold);
}

double confidence_in(double error) { return 1 / (1 + error / doubtful_error); }

double error_at(double confidence) { return doubtful_error * (1 / confidence - 1); }

double trust_in_fold(double angle) {
  constexpr double usual = 90 * std::numbers::pi / 180, doubtful = doubtful_fold - usual;
  const double excess = std::max(0.0, angle - usual) / doubtful;
  return 1 / (1 + excess * excess);
}

double confidence_of(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis) {
  Rims rims(patch, mesh, analysis);
  const bool is_flat = patch.points.empty();
  if (is_flat) add_edge_points(patch, mesh, analysis, rims);
  const double depth = rims.depth_of(is_flat ? places_on(patch, mesh) : patch.points);
  const auto folds = rim_folds(patch, mesh, analysis);
  const double turn = mean_fold(folds);
  const double fold = is_flat ? flat_fold(std::max(turn, turn_of_ways(patch, mesh, analysis))) : continued_fold(turn);
  return trust_in_fold(sharpest_fold(patch, mesh, folds)) *
         confidence_in(predicted_error(depth, rim_bend(mesh, analysis, patch.holes), fold));
}

std::vector<float> vertex_confidence(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis) {
  if (patch.points.empty()) return {};
  const Rims rims(patch, mesh, analysis);
  const implicit::PointTree tree(rims.points);
  const HarmonicValues harmonic(patch, static_cast<Index>(mesh.vertex_count()));
  const Eigen::VectorXd jumps =
      harmonic.continued(rim_jumps(rim_folds(patch, mesh, analysis), harmonic.rim_vertices()));
  const double bend = rim_bend(mesh, analysis, patch.holes);
  std::vector<float> confidence;
  for (std::size_t i = 0; i < patch.points.size(); ++i) {
    const Vec3& place = patch.points[i];
    const double depth = (place - rims.points[tree.nearest(place)]).norm() / rims.diagonal;
    confidence.push_back(static_cast<float>(
        confidence_in(predicted_error(depth, bend, continued_fold(jumps[static_cast<Eigen::Index>(i)])))));
  }
  return confidence;
}

}  // namespace croquis::hole_filling
