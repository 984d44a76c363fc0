// SPDX-License-Identifier: GPL-3.0-or-later
#include "perspective/network_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <Eigen/Geometry>

namespace croquis::test {
namespace {

/// The cubic nearest to the arc of the unit sphere between two of its points.
RationalCubic arc(const Vec3& a, const Vec3& b) {
  const double angle = angle_between(a, b);
  const double handle = 4.0 / 3.0 * std::tan(angle / 4);
  const Vec3 at_a = (b - a.dot(b) * a).normalized(), at_b = (a - a.dot(b) * b).normalized();
  return {{a, a + handle * at_a, b + handle * at_b, b}};
}

/// Points joined to all others at the least distance.
CurveNetwork nearest_net(const std::vector<Vec3>& points) {
  CurveNetwork network;
  double least = 1e300;
  for (const Vec3& p : points) network.vertices.push_back(p.normalized());
  const std::vector<Vec3>& v = network.vertices;
  for (Index i = 0; i < v.size(); ++i) {
    for (Index j = 0; j < i; ++j) least = std::min(least, (v[i] - v[j]).norm());
  }
  for (Index i = 0; i < v.size(); ++i) {
    for (Index j = 0; j < i; ++j) {
      if ((v[i] - v[j]).norm() > 1.01 * least) continue;
      network.curves.push_back({"c" + std::to_string(network.curves.size()), j, i, {arc(v[j], v[i])}, false});
    }
  }
  return network;
}

PolyhedronNet dodecahedron() {
  const double g = std::numbers::phi, h = 1 / g;
  std::vector<Vec3> points;
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      for (const double z : {-1, 1}) points.emplace_back(x, y, z);
      points.emplace_back(0, x * h, y * g);
      points.emplace_back(x * h, y * g, 0);
      points.emplace_back(x * g, 0, y * h);
    }
  }
  return {"dodecahedron", nearest_net(points), 12};
}

PolyhedronNet three_prism() {
  PolyhedronNet net{"prism", {}, 5};
  for (const double z : {-0.5, 0.5}) {
    for (int i = 0; i < 3; ++i) {
      const double angle = 2 * std::numbers::pi / 3 * i + 0.1;
      net.network.vertices.push_back(Vec3(std::cos(angle), std::sin(angle), z).normalized());
    }
  }
  const auto join = [&](Index a, Index b) {
    const std::vector<Vec3>& v = net.network.vertices;
    net.network.curves.push_back({"c" + std::to_string(net.network.curves.size()), a, b, {arc(v[a], v[b])}, false});
  };
  for (Index i = 0; i < 3; ++i) {
    join(i, (i + 1) % 3);
    join(3 + i, 3 + (i + 1) % 3);
    join(i, 3 + i);
  }
  return net;
}

}  // namespace

std::multiset<FaceIds> ids_of_faces(const CurveNetwork& network, const FaceSet& set) {
  std::multiset<FaceIds> result;
  for (const NetworkFace& face : set.faces) {
    FaceIds loops;
    for (const CurveLoop& loop : face.loops) {
      std::set<std::string> ids;
      for (const CurveUse& use : loop) ids.insert(network.curves[use.curve].id);
      loops.insert(ids);
    }
    result.insert(loops);
  }
  return result;
}

std::multiset<FaceIds> ids_of_faces(const PerspectiveSolid& solid) {
  std::multiset<FaceIds> result;
  for (const SolidFace& face : solid.faces) {
    FaceIds loops;
    for (const auto& loop : face.loops) {
      std::set<std::string> ids;
      for (const SolidSide& side : loop) ids.insert(solid.network.curves[side.curve].id);
      loops.insert(ids);
    }
    result.insert(loops);
  }
  return result;
}

std::pair<CurveNetwork, std::vector<std::string>> shuffled(const CurveNetwork& network, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Index> vertices(network.vertices.size()), curves(network.curves.size()), number(vertices.size());
  std::iota(vertices.begin(), vertices.end(), Index{0});
  std::iota(curves.begin(), curves.end(), Index{0});
  std::ranges::shuffle(vertices, random);
  std::ranges::shuffle(curves, random);
  CurveNetwork result;
  std::vector<std::string> old_ids;
  for (Index i = 0; i < vertices.size(); ++i) {
    number[vertices[i]] = i;
    result.vertices.push_back(network.vertices[vertices[i]]);
  }
  for (const Index c : curves) {
    NetworkCurve curve = network.curves[c];
    old_ids.push_back(curve.id);
    curve.id = "s" + std::to_string(random() % 1000000) + "_" + std::to_string(c);
    curve.start = number[curve.start];
    curve.end = number[curve.end];
    if (random() % 2 == 0) {
      std::swap(curve.start, curve.end);
      std::ranges::reverse(curve.pieces);
      for (RationalCubic& piece : curve.pieces) piece = piece.reversed();
    }
    result.curves.push_back(std::move(curve));
  }
  return {result, old_ids};
}

CurveNetwork joined(CurveNetwork a, const CurveNetwork& b, const std::string& prefix) {
  const auto first = static_cast<Index>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (NetworkCurve curve : b.curves) {
    curve.id = prefix + curve.id;
    curve.start += first;
    curve.end += first;
    a.curves.push_back(std::move(curve));
  }
  return a;
}

CurveNetwork moved(CurveNetwork network, double scale, const Vec3& by) {
  for (Vec3& p : network.vertices) p = scale * p + by;
  for (NetworkCurve& curve : network.curves) {
    for (RationalCubic& piece : curve.pieces) {
      for (Vec3& p : piece.points) p = scale * p + by;
    }
  }
  return network;
}

CurveNetwork rotated(CurveNetwork network) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& p : network.vertices) p = turn * p;
  for (NetworkCurve& curve : network.curves) {
    for (RationalCubic& piece : curve.pieces) {
      for (Vec3& p : piece.points) p = turn * p;
    }
  }
  return network;
}

CurveNetwork without(CurveNetwork network, const std::set<std::string>& ids) {
  std::erase_if(network.curves, [&](const NetworkCurve& curve) { return ids.contains(curve.id); });
  return network;
}

std::vector<PolyhedronNet> sphere_nets() {
  std::vector<Vec3> cube, octahedron;
  for (int i = 0; i < 8; ++i) cube.emplace_back(i % 2 * 2 - 1, i / 2 % 2 * 2 - 1, i / 4 * 2 - 1);
  for (int i = 0; i < 6; ++i) octahedron.push_back((i < 3 ? 1.0 : -1.0) * Vec3::Unit(i % 3));
  return {{"cube", nearest_net(cube), 6}, {"octahedron", nearest_net(octahedron), 8}, dodecahedron(), three_prism()};
}

CurveNetwork perturbed(CurveNetwork network, double by, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> spread(-by, by);
  const auto step = [&] { return Vec3(spread(random), spread(random), spread(random)); };
  std::vector<Vec3> moves;
  for (Vec3& p : network.vertices) {
    moves.push_back(step());
    p += moves.back();
  }
  for (NetworkCurve& curve : network.curves) {
    std::array<Vec3, 4>& p = curve.pieces.front().points;
    p[1] += moves[curve.start] + 0.3 * step();
    p[2] += moves[curve.end] + 0.3 * step();
    p[0] = network.vertices[curve.start];
    p[3] = network.vertices[curve.end];
  }
  return network;
}

CurveNetwork line_network(const std::vector<Vec3>& vertices, const std::vector<std::array<Index, 2>>& lines) {
  CurveNetwork network{vertices, {}};
  for (const auto& [a, b] : lines) {
    network.curves.push_back(
        {"e" + std::to_string(network.curves.size()), a, b, {straight_cubic(vertices[a], vertices[b])}, true});
  }
  return network;
}

CurveNetwork box_in_box() {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 2>> lines;
  for (Index i = 0; i < 16; ++i) {
    const double size = i < 8 ? 2 : 1;
    vertices.push_back(size * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    for (Index bit = 1; bit < 16; bit *= 2) {
      if ((i & bit) == 0) lines.push_back({i, i | bit});
    }
  }
  return line_network(vertices, lines);
}

CurveNetwork globe(int rings, int steps) {
  CurveNetwork network;
  const auto place = [&](int ring, int step) {
    const double up = std::numbers::pi * ring / (rings + 1), around = 2 * std::numbers::pi * step / steps + 0.05;
    return Vec3(std::sin(up) * std::cos(around), std::sin(up) * std::sin(around), -std::cos(up));
  };
  for (int r = 1; r <= rings; ++r) {
    for (int s = 0; s < steps; ++s) network.vertices.push_back(place(r, s));
  }
  const auto south = static_cast<Index>(network.vertices.size());
  network.vertices.emplace_back(0, 0, -1);
  network.vertices.emplace_back(0, 0, 1);
  const auto join = [&](Index a, Index b) {
    const std::vector<Vec3>& v = network.vertices;
    network.curves.push_back({"c" + std::to_string(network.curves.size()), a, b, {arc(v[a], v[b])}, false});
  };
  const auto at = [&](int ring, int step) {
    if (ring == 0) return south;
    if (ring == rings + 1) return south + 1;
    return static_cast<Index>((ring - 1) * steps + step % steps);
  };
  for (int r = 0; r <= rings; ++r) {
    for (int s = 0; s < steps; ++s) {
      if (r > 0) join(at(r, s), at(r, s + 1));
      join(at(r, s), at(r + 1, s));
    }
  }
  return network;
}

CurveNetwork box_wall(int nx, int nz) {
  CurveNetwork network;
  const auto at = [&](int x, int y, int z) { return static_cast<Index>((z * 2 + y) * (nx + 1) + x); };
  const auto join = [&](Index a, Index b) {
    const std::vector<Vec3>& v = network.vertices;
    network.curves.push_back({"w" + std::to_string(network.curves.size()), a, b, {straight_cubic(v[a], v[b])}, true});
  };
  for (int z = 0; z <= nz; ++z) {
    for (int y = 0; y <= 1; ++y) {
      for (int x = 0; x <= nx; ++x) network.vertices.emplace_back(1.1 * x, 0.9 * y, 1.3 * z);
    }
  }
  for (int z = 0; z <= nz; ++z) {
    for (int x = 0; x <= nx; ++x) {
      // Edges through the inside would have walls on all sides.
      if (x == 0 || x == nx || z == 0 || z == nz) join(at(x, 0, z), at(x, 1, z));
      for (int y = 0; y <= 1; ++y) {
        if (x < nx) join(at(x, y, z), at(x + 1, y, z));
        if (z < nz) join(at(x, y, z), at(x, y, z + 1));
      }
    }
  }
  return network;
}

FaceFindingResult faces_of(const CurveNetwork& network, const FaceFindingOptions& options) {
  Progress progress;
  return find_faces(network, progress, options);
}

std::vector<FittedCurve> polynomial_pieces(const CurveNetwork& network) {
  std::vector<FittedCurve> fitted;
  for (const NetworkCurve& curve : network.curves) {
    fitted.push_back({curve.pieces});
    for (RationalCubic& piece : fitted.back().pieces) piece.weights = {1, 1, 1, 1};
  }
  return fitted;
}

Solid solid_of(const CurveNetwork& network, const SolidOptions& options) {
  Progress progress;
  return make_solid(network, polynomial_pieces(network), faces_of(network).best, progress, options);
}

std::vector<std::string> sorted_codes(const Findings& findings) {
  std::vector<std::string> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  std::ranges::sort(codes);
  return codes;
}

}  // namespace croquis::test
