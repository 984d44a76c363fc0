// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/hole_cutter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "support/scans/triangle_measures.h"
#include "support/scans/virtual_scans.h"

namespace croquis::test {
namespace {

constexpr int most_tries = 300;
constexpr double crease_angle_cosine = 0.82;  // 35 degrees

/// The faces of the edges that bend by more than 35 degrees, or else of the hundredth that bends most.
std::vector<Index> faces_at_creases(const PolyMesh& mesh, const MeshTopology& topology) {
  std::vector<std::pair<double, Index>> bends;  // cosine, face
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    if (corners.size() != 2) continue;
    const Index face = topology.face(corners[0]);
    bends.emplace_back(normal_of_triangle(mesh, face).dot(normal_of_triangle(mesh, topology.face(corners[1]))), face);
  }
  std::sort(bends.begin(), bends.end());
  std::vector<Index> faces;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    if (bends[i].first > crease_angle_cosine && i > bends.size() / 100) break;
    faces.push_back(bends[i].second);
  }
  return faces;
}

std::vector<Index> difference(const std::vector<Index>& faces, const std::vector<Index>& less) {
  std::vector<Index> rest;
  std::set_difference(faces.begin(), faces.end(), less.begin(), less.end(), std::back_inserter(rest));
  return rest;
}

}  // namespace

const char* name_of(HoleKind kind) {
  constexpr std::array names = {"small",      "middle", "large",    "huge", "crease",  "islands", "near",
                                "both skins", "bent",   "occluded", "gap",  "opening", "pinhole"};
  return names[static_cast<std::size_t>(kind)];
}

HoleCutter::HoleCutter(const PolyMesh& mesh, std::uint64_t seed)
    : mesh_(mesh),
      cutter_(mesh),
      random_(seed),
      diagonal_(diagonal_of(mesh)),
      edge_(mean_edge_of(mesh)),
      creases_(faces_at_creases(mesh, cutter_.topology())) {}

bool HoleCutter::cut(HoleKind kind) {
  for (int i = 0; i < most_tries; ++i) {
    const bool is_cut = [&] {
      switch (kind) {
        case HoleKind::Small: return cut_disc(kind, 0.005, 0.015);
        case HoleKind::Middle: return cut_disc(kind, 0.015, 0.05);
        case HoleKind::Large: return cut_disc(kind, 0.05, 0.12);
        case HoleKind::Huge: return cut_disc(kind, 0.12, 0.25);
        case HoleKind::Crease: return cut_disc(kind, 0.02, 0.06);
        case HoleKind::Islands: return cut_ring();
        case HoleKind::Near: return cut_near();
        case HoleKind::BothSkins: return cut_skins();
        case HoleKind::Bent: return cut_band();
        case HoleKind::Pinhole: return cut_pinhole();
        default: return false;
      }
    }();
    if (is_cut) return true;
  }
  return false;
}

void HoleCutter::remove(HoleKind kind, std::vector<Index> faces) {
  if (faces.empty()) return;
  cutter_.take(faces);
  cuts_.push_back({kind, std::move(faces)});
}

Index HoleCutter::random_face() { return random_.below(static_cast<Index>(mesh_.face_count())); }

Index HoleCutter::random_crease() { return creases_[random_.below(static_cast<Index>(creases_.size()))]; }

std::vector<Index> HoleCutter::disc(Index first, double radius) {
  const Vec3 centre = mesh_.positions[mesh_.face(first)[0]];
  const RaggedRadius ragged(random_, radius, random_.between(0, 0.5));
  return cutter_.grow(first, [&](const Vec3& p) { return (p - centre).norm() < ragged.at(p - centre); });
}

/// Takes pieces that are all free, none of which shares a vertex with another.
bool HoleCutter::keep(HoleKind kind, Pieces pieces, std::ptrdiff_t rims) {
  std::set<Index> all;
  for (const auto& faces : pieces) {
    if (!cutter_.is_free(faces, rims)) return false;
    std::set<Index> own;
    for (const Index f : faces) own.insert(mesh_.face(f).begin(), mesh_.face(f).end());
    for (const Index v : own) {
      if (!all.insert(v).second) return false;
    }
  }
  for (auto& faces : pieces) {
    cutter_.take(faces);
    cuts_.push_back({kind, std::move(faces)});
  }
  return true;
}

bool HoleCutter::cut_disc(HoleKind kind, double low, double high) {
  const double radius = diagonal_ * low * std::pow(high / low, random_.unit());
  const Index first = kind == HoleKind::Crease ? random_crease() : random_face();
  return keep(kind, {disc(first, std::max(radius, 3 * edge_))}, 1);
}

bool HoleCutter::cut_ring() {
  const double radius = std::max(diagonal_ * random_.between(0.04, 0.1), 8 * edge_);
  const std::vector<Index> all = disc(random_face(), radius);
  if (all.empty()) return false;
  const std::size_t count = 1 + random_.below(5);
  std::vector<Index> kept;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 centre = centre_of_triangle(mesh_, all[random_.below(static_cast<Index>(all.size()))]);
    const double island = radius * random_.between(0.15, count > 1 ? 0.25 : 0.5);
    for (const Index f : all) {
      if ((centre_of_triangle(mesh_, f) - centre).norm() < island) kept.push_back(f);
    }
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  for (std::ptrdiff_t rims = static_cast<std::ptrdiff_t>(count) + 1; rims > 1; --rims) {  // islands may have met
    if (keep(HoleKind::Islands, {difference(all, kept)}, rims)) return true;
  }
  return false;
}

bool HoleCutter::cut_near() {
  const Index first = random_face();
  const double radius = std::max(diagonal_ * random_.between(0.01, 0.04), 3 * edge_);
  Pieces pieces = {disc(first, radius)};
  const std::size_t count = 2 + random_.below(2);
  for (int i = 0; i < 60 && pieces.size() < count; ++i) {
    const double own = std::max(radius * random_.between(0.4, 1), 3 * edge_), gap = random_.between(1, 3) * edge_;
    const double away = radius + own + gap;
    const std::vector<Index> around = cutter_.grow(
        first, [&](const Vec3& p) { return (p - centre_of_triangle(mesh_, first)).norm() < away + edge_; });
    if (around.empty()) return false;
    const Index other = around[random_.below(static_cast<Index>(around.size()))];
    if (std::abs((centre_of_triangle(mesh_, other) - centre_of_triangle(mesh_, first)).norm() - away) > edge_) continue;
    pieces.push_back(disc(other, own));
  }
  return pieces.size() > 1 && keep(HoleKind::Near, std::move(pieces), 1);
}

bool HoleCutter::cut_skins() {
  const Index first = random_face();
  const Vec3 place = centre_of_triangle(mesh_, first), normal = normal_of_triangle(mesh_, first);
  Index behind = no_index;
  double least = 0.06 * diagonal_;
  for (Index f = 0; f < mesh_.face_count(); ++f) {
    const Vec3 to = centre_of_triangle(mesh_, f) - place;
    const double deep = -to.dot(normal);
    if (deep <= 0 || deep >= least || (to + deep * normal).norm() > 0.5 * deep + edge_) continue;
    if (normal_of_triangle(mesh_, f).dot(normal) < -0.5) least = deep, behind = f;
  }
  if (behind == no_index) return false;
  const double radius = std::max(diagonal_ * random_.between(0.02, 0.08), 3 * edge_);
  return keep(HoleKind::BothSkins, {disc(first, radius), disc(behind, radius * random_.between(0.7, 1.2))}, 1);
}

/// The neighbour that lies ahead most; the heading turns with the surface, and a little by itself.
Index HoleCutter::random_neighbour(Index vertex, Vec3& heading) {
  const MeshTopology& topology = cutter_.topology();
  Index best = no_index;
  double most = -std::numeric_limits<double>::infinity();
  Vec3 normal = Vec3::Zero();
  for (const Index corner : topology.vertex_corners(vertex)) {
    normal += normal_of_triangle(mesh_, topology.face(corner));
    const Index other = topology.vertex(topology.next(corner));
    const double ahead = (mesh_.positions[other] - mesh_.positions[vertex]).normalized().dot(heading);
    if (ahead > most) most = ahead, best = other;
  }
  normal.normalize();
  heading += 0.25 * random_.between(-1, 1) * normal.cross(heading);
  heading = (heading - heading.dot(normal) * normal).normalized();
  return best;
}

bool HoleCutter::cut_band() {
  const Index first = random_face();
  const double wide = std::max(diagonal_ * random_.between(0.012, 0.025), 2.5 * edge_);
  const double length = std::clamp(170 * edge_, 0.15 * diagonal_, 0.9 * diagonal_);
  Index vertex = mesh_.face(first)[0];
  Vec3 heading = normal_of_triangle(mesh_, first).unitOrthogonal();
  heading = Eigen::AngleAxisd(random_.between(0, 6.28), normal_of_triangle(mesh_, first)) * heading;
  std::vector<Vec3> way = {mesh_.positions[vertex]};
  double walked = 0;
  while (walked < length && way.size() < 2000) {
    vertex = random_neighbour(vertex, heading);
    if (vertex == no_index) return false;
    walked += (mesh_.positions[vertex] - way.back()).norm();
    way.push_back(mesh_.positions[vertex]);
  }
  const auto is_near = [&](const Vec3& p) {
    return std::any_of(way.begin(), way.end(), [&](const Vec3& q) { return (p - q).squaredNorm() < wide * wide; });
  };
  return keep(HoleKind::Bent, {cutter_.grow(first, is_near)}, 1);
}

/// A face that is left and has one vertex on the rim of one hole, and no other on any.
bool HoleCutter::cut_pinhole() {
  if (cuts_.empty()) return false;
  const MeshTopology& topology = cutter_.topology();
  std::vector<bool> is_gone(mesh_.face_count(), false), is_on_rim(mesh_.vertex_count(), false);
  for (const HoleCut& cut : cuts_) {
    for (const Index f : cut.faces) {
      is_gone[f] = true;
      for (const Index v : mesh_.face(f)) is_on_rim[v] = true;
    }
  }
  for (const Index v : topology.boundary_loops().values) is_on_rim[v] = true;
  const HoleCut& cut = cuts_[random_.below(static_cast<Index>(cuts_.size()))];
  const Index gone = cut.faces[random_.below(static_cast<Index>(cut.faces.size()))];
  for (const Index v : mesh_.face(gone)) {
    for (const Index corner : topology.vertex_corners(v)) {
      const Index face = topology.face(corner);
      const auto t = mesh_.face(face);
      if (is_gone[face] || std::count_if(t.begin(), t.end(), [&](Index w) { return is_on_rim[w]; }) != 1) continue;
      cuts_.push_back({HoleKind::Pinhole, {face}});
      return true;
    }
  }
  return false;
}

}  // namespace croquis::test
