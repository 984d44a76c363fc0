// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/faces/shells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <Eigen/Geometry>

namespace croquis {
namespace {

struct EdgeUse {
  Index face;
  bool reversed;
};

std::map<Index, std::vector<EdgeUse>> sides_of_edges(const std::vector<FaceCandidate>& candidates,
                                                     const std::vector<Index>& chosen) {
  std::map<Index, std::vector<EdgeUse>> sides;
  for (Index f = 0; f < chosen.size(); ++f) {
    for (const std::vector<Index>& loop : candidates[chosen[f]].loops) {
      for (const Index half : loop) sides[half / 2].push_back({f, (half & 1U) != 0});
    }
  }
  return sides;
}

struct FaceNeighbour {
  Index face;
  bool turned;  ///< against each other
};

/// A face as closed polygons, spanned by fans: exact for flat faces with straight edges, near the rest.
struct FaceFan {
  std::vector<std::vector<Vec3>> loops;
  Vec3 apex = Vec3::Zero();
  Index part = no_index;
};

template <typename Visit>
void visit_triangles(const FaceFan& fan, const Visit& visit) {
  for (const std::vector<Vec3>& loop : fan.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) visit(fan.apex, loop[i], loop[(i + 1) % loop.size()]);
  }
}

/// Solid angle of a triangle (van Oosterom and Strackee 1983).
double solid_angle(const Vec3& at, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 a = p - at, b = q - at, c = r - at;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

class ShellMaker {
 public:
  ShellMaker(const SolidGraph& graph, const std::vector<FaceCandidate>& candidates, const std::vector<Index>& chosen)
      : graph_(graph), candidates_(candidates), chosen_(chosen), agreement_(agree_on_sides(candidates, chosen)) {
    for (Index f = 0; f < chosen.size(); ++f) fans_.push_back(fan_of(f));
    find_open_parts();
    std::vector<double> volume(agreement_.parts, 0);
    const Vec3 centre = graph.points.empty() ? Vec3::Zero() : graph.points[0];
    for (const FaceFan& fan : fans_) {
      visit_triangles(fan, [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        volume[fan.part] += (a - centre).dot((b - centre).cross(c - centre)) / 6;
      });
    }
    for (Index p = 0; p < agreement_.parts; ++p) {
      if (volume[p] < 0) turn(p);
    }
    is_void_.assign(agreement_.parts, false);
    find_voids();
  }

  FaceSet shells(double cost) const {
    FaceSet set;
    set.cost = cost;
    set.shells.resize(agreement_.parts);
    for (Index p = 0; p < agreement_.parts; ++p) set.shells[p] = {{}, !open_[p], is_void_[p]};
    for (Index f = 0; f < chosen_.size(); ++f) {
      set.shells[agreement_.part[f]].faces.push_back(f);
      set.faces.push_back(face_of(f));
    }
    return set;
  }

  /// How often the closed shells go around a point.
  double winding(const Vec3& at, Index part = no_index) const {
    double angle = 0;
    for (const FaceFan& fan : fans_) {
      if (open_[fan.part] || (part != no_index && fan.part != part)) continue;
      visit_triangles(fan, [&](const Vec3& a, const Vec3& b, const Vec3& c) { angle += solid_angle(at, a, b, c); });
    }
    return angle / (4 * std::numbers::pi);
  }

 private:
  std::vector<std::vector<Index>> loops_of(Index f) const {
    std::vector<std::vector<Index>> loops = candidates_[chosen_[f]].loops;
    if (agreement_.turned[f] != 0) {
      for (std::vector<Index>& loop : loops) loop = SolidGraph::turned(loop);
    }
    return loops;
  }

  FaceFan fan_of(Index f) const {
    FaceFan fan;
    for (const std::vector<Index>& loop : loops_of(f)) fan.loops.push_back(graph_.polygon(loop));
    fan.apex = candidates_[chosen_[f]].origin;
    fan.part = agreement_.part[f];
    return fan;
  }

  void find_open_parts() {
    open_.assign(agreement_.parts, false);
    std::map<Index, std::vector<Index>> parts_at;
    for (Index f = 0; f < chosen_.size(); ++f) {
      for (const Index e : candidates_[chosen_[f]].edges) parts_at[e].push_back(agreement_.part[f]);
    }
    for (const auto& [edge, parts] : parts_at) {
      if (parts.size() == 1) open_[parts[0]] = true;
    }
  }

  void turn(Index part) {
    for (Index f = 0; f < chosen_.size(); ++f) {
      if (agreement_.part[f] != part) continue;
      agreement_.turned[f] ^= 1;
      fans_[f] = fan_of(f);
    }
  }

  /// A shell inside an odd number of others bounds a void.
  void find_voids() {
    std::vector<bool> inside(agreement_.parts, false);
    std::set<Index> seen;
    for (Index f = 0; f < chosen_.size(); ++f) {
      const Index part = agreement_.part[f];
      if (!seen.insert(part).second || open_[part]) continue;
      const Vec3& at = fans_[f].loops[0][0];
      int around = 0;
      for (Index other = 0; other < agreement_.parts; ++other) {
        if (other != part && !open_[other] && std::abs(winding(at, other)) > 0.5) ++around;
      }
      inside[part] = around % 2 == 1;
    }
    for (Index p = 0; p < agreement_.parts; ++p) {
      is_void_[p] = inside[p];
      if (inside[p]) turn(p);
    }
  }

  NetworkFace face_of(Index f) const {
    const FaceCandidate& candidate = candidates_[chosen_[f]];
    NetworkFace face;
    for (const std::vector<Index>& loop : loops_of(f)) {
      CurveLoop uses;
      for (const Index half : loop) {
        const GraphEdge& edge = graph_.edges[half / 2];
        uses.push_back({edge.curve, ((half & 1U) != 0) != edge.reversed});
      }
      face.loops.push_back(std::move(uses));
    }
    face.planar = candidate.planar;
    face.origin = candidate.origin;
    face.normal = agreement_.turned[f] != 0 ? Vec3(-candidate.normal) : candidate.normal;
    face.flatness = candidate.flatness;
    face.cost = candidate.cost;
    face.shell = agreement_.part[f];
    return face;
  }

  const SolidGraph& graph_;
  const std::vector<FaceCandidate>& candidates_;
  const std::vector<Index>& chosen_;
  FaceAgreement agreement_;
  std::vector<FaceFan> fans_;
  std::vector<bool> open_, is_void_;
};

bool overlaps(const FaceCandidate& a, const FaceCandidate& b) {
  return a.plane == b.plane &&
         std::ranges::any_of(a.regions, [&](Index r) { return std::ranges::binary_search(b.regions, r); });
}

/// A point inside a flat polygon: the middle of an ear.
Vec3 inner_point(const std::vector<Vec3>& polygon, const Vec3& normal) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &a = polygon[(i + n - 1) % n], &b = polygon[i], &c = polygon[(i + 1) % n];
    if (normal.dot((b - a).cross(c - b)) <= 0) continue;
    const auto in_ear = [&](const Vec3& p) {
      return normal.dot((b - a).cross(p - a)) > 0 && normal.dot((c - b).cross(p - b)) > 0 &&
             normal.dot((a - c).cross(p - c)) > 0;
    };
    if (std::ranges::none_of(polygon, in_ear)) return (a + b + c) / 3;
  }
  return polygon[0];
}

}  // namespace

FaceAgreement agree_on_sides(const std::vector<FaceCandidate>& candidates, const std::vector<Index>& chosen) {
  std::vector<std::vector<FaceNeighbour>> neighbours(chosen.size());
  for (const auto& [edge, sides] : sides_of_edges(candidates, chosen)) {
    if (sides.size() != 2) continue;
    const bool turned = sides[0].reversed == sides[1].reversed;
    neighbours[sides[0].face].push_back({sides[1].face, turned});
    neighbours[sides[1].face].push_back({sides[0].face, turned});
  }
  FaceAgreement result{true, std::vector<std::uint8_t>(chosen.size(), 0), std::vector<Index>(chosen.size(), no_index),
                       0};
  for (Index first = 0; first < chosen.size(); ++first) {
    if (result.part[first] != no_index) continue;
    std::vector<Index> pending = {first};
    result.part[first] = result.parts;
    while (!pending.empty()) {
      const Index f = pending.back();
      pending.pop_back();
      for (const FaceNeighbour& other : neighbours[f]) {
        const auto turned = static_cast<std::uint8_t>((result.turned[f] != 0) != other.turned);
        if (result.part[other.face] == no_index) {
          result.part[other.face] = result.parts;
          result.turned[other.face] = turned;
          pending.push_back(other.face);
        } else if (result.turned[other.face] != turned) {
          result.possible = false;
        }
      }
    }
    ++result.parts;
  }
  return result;
}

FaceSet make_shells(const SolidGraph& graph, const std::vector<FaceCandidate>& candidates,
                    const std::vector<Index>& chosen, double cost) {
  return ShellMaker(graph, candidates, chosen).shells(cost);
}

std::size_t count_internal(const SolidGraph& graph, const std::vector<FaceCandidate>& candidates,
                           const std::vector<Index>& chosen) {
  const ShellMaker shells(graph, candidates, chosen);
  std::size_t count = 0;
  for (Index c = 0; c < candidates.size(); ++c) {
    const FaceCandidate& face = candidates[c];
    if (face.plane == no_index || face.regions.size() != 1 || std::ranges::binary_search(chosen, c)) continue;
    const bool covered = std::ranges::any_of(chosen, [&](Index other) { return overlaps(face, candidates[other]); });
    if (!covered && shells.winding(inner_point(graph.polygon(face.loops[0]), face.normal)) > 0.5) ++count;
  }
  return count;
}

}  // namespace croquis
