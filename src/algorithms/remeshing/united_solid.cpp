// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/united_solid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/remeshing/field.h"
#include "algorithms/remeshing/surface_parts.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::remeshing {
namespace {

// Cosines of a vertex' normal and its triangles': surfaces are smooth above the one, creased below the other.
constexpr double smooth_cosine = 0.9;
constexpr double creased_cosine = 0.75;

constexpr Index corners_between_checks = 4096;  // of the cancel flag

constexpr double ends_beyond = 2;         // × cell: so far a surface with a border goes on, to be cut off in between
constexpr double rim_tolerance = 0.5;     // × cell: so far it is there, as where rims are left open
constexpr double off_the_surface = 0.75;  // × cell: corners of cubes at a surface are nearer to it than this on average
constexpr double clearly_far = 3;         // × cell: so far off a surface, or its box, the distance needn't be known
constexpr std::size_t places_per_part = 1024;
constexpr std::size_t most_asked = 200;  // vertices that are tested for whether they lie in another member
constexpr double leaves_beyond = 2;      // × cell
constexpr double goes_round = 0.6;       // more than a plane, from right below it

double distance_to(const implicit::Box& box, const Vec3& place) {
  return (box.low - place).cwiseMax(place - box.high).cwiseMax(Vec3::Zero()).norm();
}

bool are_closed(const SolidMembers& members) {
  return std::ranges::all_of(members, [](const SignedSurface* member) { return member->is_closed(); });
}

bool leaves_members(const PolyMesh& made, const SolidMembers& members, double far, int threads, Progress& progress) {
  std::atomic<bool> found = false;
  for_each_part(made.vertex_count(), vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end && !found; ++v) {
      const bool is_backed = std::ranges::any_of(members, [&](const SignedSurface* member) {
        return std::abs(member->at(made.positions[v]).distance) <= far;
      });
      if (!is_backed) found = true;
    }
  });
  return found;
}

/// Of what seems lost a sample is asked for whether another member encloses it.
bool loses_too_much(const PolyMesh& made, const SignedSurface* own, const SolidMembers& members, double cell,
                    int threads, Progress& progress) {
  const std::vector<Vec3>& places = own->mesh().positions;
  const std::vector<Index> missed =
      lost_points(made, places, cell, threads, progress.step("look for lost detail", 0.5));
  const double share = static_cast<double>(missed.size()) / static_cast<double>(places.size());
  if (share <= most_lost) return false;
  const std::size_t stride = missed.size() / most_asked + 1;
  std::size_t asked = 0, lost = 0;
  for (std::size_t i = 0; i < missed.size(); i += stride, ++asked) {
    progress.check();
    const bool is_enclosed = std::ranges::any_of(members, [&](const SignedSurface* member) {
      return member != own && std::abs(member->winding_number(places[missed[i]])) > goes_round;
    });
    lost += is_enclosed ? 0U : 1U;
  }
  return share * static_cast<double>(lost) / static_cast<double>(asked) > most_lost;
}

}  // namespace

SignedSurface::SignedSurface(PolyMesh mesh, const Progress& progress)
    : mesh_(std::move(mesh)),
      fans_(mesh_.vertex_count(), mesh_.corners),
      tree_(places_of(mesh_), progress),
      extent_(extent_of_surface(mesh_, true)),
      normals_(mesh_.vertex_count(), Vec3::Zero()),
      smooth_(mesh_.vertex_count(), 1) {
  for (Index corner = 0; corner < mesh_.corners.size(); ++corner) {
    const Vec3& here = mesh_.positions[mesh_.corners[corner]];
    const Vec3 next = mesh_.positions[fans_.next(corner)] - here;
    const Vec3 previous = mesh_.positions[fans_.previous(corner)] - here;
    const double angle = std::atan2(next.cross(previous).norm(), next.dot(previous));
    normals_[mesh_.corners[corner]] += angle * normal_of(corner / 3);
  }
  for (Vec3& normal : normals_) normal = unit_or_zero(normal);
  for (Index corner = 0; corner < mesh_.corners.size(); ++corner) {
    if (corner % corners_between_checks == 0) progress.check();
    const Index from = mesh_.corners[corner], to = fans_.next(corner);
    const Vec3 normal = normal_of(corner / 3);
    const double share = (normals_[from].dot(normal) - creased_cosine) / (smooth_cosine - creased_cosine);
    smooth_[from] = std::min(smooth_[from], static_cast<float>(std::clamp(share, 0.0, 1.0)));
    bool is_border = false;
    across(corner, is_border);
    if (!is_border) continue;
    if (outs_.empty()) outs_.assign(mesh_.vertex_count(), Vec3::Zero());
    const Vec3 out = (mesh_.positions[to] - mesh_.positions[from]).cross(normal);
    outs_[from] += out;
    outs_[to] += out;
  }
}

Vec3 SignedSurface::normal_of(Index triangle) const { return unit_or_zero(area_normal(mesh_, triangle)); }

/// How far above a triangle the curved surface lies.
double SignedSurface::bulge(Index triangle, const Vec3& foot) const {
  const auto face = mesh_.face(triangle);
  const std::array<Vec3, 3> corners = places_of(mesh_.positions, face);
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return 0;
  double above = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& next = corners[(i + 1) % 3];
    const double weight = (corners[(i + 2) % 3] - next).cross(foot - next).dot(normal) / squared;
    above += weight * static_cast<double>(smooth_[face[i]]) * (corners[i] - foot).dot(normals_[face[i]]);
  }
  return 0.5 * above;
}

/// Of the edge that begins at a corner: the sum of its triangles' normals.
Vec3 SignedSurface::across(Index corner, bool& is_border) const {
  Vec3 sum = normal_of(corner / 3);
  is_border = true;
  const Index from = mesh_.corners[corner], to = fans_.next(corner);
  for (const Index other : fans_.at(to)) {
    if (fans_.next(other) != from) continue;
    is_border = false;
    sum += normal_of(other / 3);
  }
  return sum;
}

SignedPlace SignedSurface::at(const Vec3& place, double within) const {
  TriangleFoot foot = tree_.nearest(place, within);
  if (foot.triangle == no_index) foot = tree_.nearest(place, std::numeric_limits<double>::infinity());
  SignedPlace found;
  found.triangle = foot.triangle;
  const Index first = 3 * foot.triangle;
  Vec3 normal, out = Vec3::Zero();
  if (foot.corner >= 0) {
    const Index vertex = mesh_.corners[first + static_cast<Index>(foot.corner)];
    normal = normals_[vertex];
    if (!outs_.empty()) out = outs_[vertex];
  } else if (foot.edge >= 0) {
    const Index corner = first + static_cast<Index>(foot.edge);
    bool is_border = false;
    normal = across(corner, is_border);
    if (is_border) out = (mesh_.positions[fans_.next(corner)] - mesh_.positions[mesh_.corners[corner]]).cross(normal);
  } else {
    normal = normal_of(foot.triangle);
  }
  const Vec3 away = place - foot.point;
  const bool is_inside = away.dot(normal) < 0;
  found.distance = is_inside ? -foot.distance : foot.distance;
  found.value = found.distance - bulge(foot.triangle, foot.point);
  found.out = away.dot(unit_or_zero(out));
  found.gradient = foot.distance > 0 ? Vec3((is_inside ? -1 : 1) / foot.distance * away) : unit_or_zero(normal);
  return found;
}

double SignedSurface::winding_number(const Vec3& place) const {
  double sum = 0;  // of solid angles, halved (Van Oosterom and Strackee 1983)
  for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
    auto [a, b, c] = places_of(mesh_.positions, mesh_.face(f));
    for (Vec3* corner : {&a, &b, &c}) *corner -= place;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (2 * std::numbers::pi);
}

UnitedSolid::UnitedSolid(const SolidMembers& members, double cell) : members_(members), cell_(cell) {
  std::vector<Index> cavities;
  for (Index m = 0; m < members.size(); ++m) {
    if (members[m]->volume() < 0)
      cavities.push_back(m);
    else
      solids_.push_back({m, {}});
  }
  const std::size_t bodies = solids_.size();
  Solid space;
  for (const Index cavity : cavities) {
    Solid* smallest = nullptr;
    for (std::size_t s = 0; s < bodies; ++s) {
      if (!lies_in(cavity, solids_[s].body)) continue;
      if (smallest == nullptr || members[solids_[s].body]->volume() < members[smallest->body]->volume())
        smallest = &solids_[s];
    }
    if (smallest != nullptr)
      smallest->cavities.push_back(cavity);
    else if (members[cavity]->is_closed())
      space.cavities.push_back(cavity);
    else
      solids_.push_back({cavity, {}});
  }
  if (!space.cavities.empty()) solids_.push_back(std::move(space));
}

/// Most of it: they cross.
bool UnitedSolid::lies_in(Index cavity, Index body) const {
  const std::vector<Vec3>& vertices = members_[cavity]->mesh().positions;
  const std::size_t stride = vertices.size() / most_asked + 1;
  std::size_t inside = 0, all = 0;
  for (std::size_t v = 0; v < vertices.size(); v += stride, ++all)
    if (at_member(body, vertices[v], false).value < 0) ++inside;
  return 2 * inside > all;
}

/// Out of its box and beyond its borders a body isn't there, nor is a cavity.
UnitedSolid::Place UnitedSolid::at_member(Index member, const Vec3& place, bool is_cavity) const {
  const SignedSurface& surface = *members_[member];
  const double absent = is_cavity ? -1 : 1, far = clearly_far * cell_;
  const double away = distance_to(surface.box(), place);
  if (away > far) return {absent * away, absent * (place - surface.box().middle()).normalized(), member};
  const SignedPlace found = surface.at(place, far);
  const bool is_absent = found.out > ends_beyond * cell_;
  const double flip = is_absent && found.value * absent < 0 ? -1 : 1;
  return {flip * found.value, flip * found.gradient, member};
}

/// The least over solids of the greatest of body and cavities.
UnitedSolid::Place UnitedSolid::at(const Vec3& place) const {
  Place least;
  for (const Solid& solid : solids_) {
    Place greatest;
    if (solid.body != no_index) greatest = at_member(solid.body, place, false);
    for (const Index cavity : solid.cavities) {
      const Place here = at_member(cavity, place, true);
      if (greatest.member == no_index || here.value > greatest.value) greatest = here;
    }
    if (least.member == no_index || greatest.value < least.value) least = greatest;
  }
  return least;
}

std::vector<UnitedSolid::Place> UnitedSolid::at(std::span<const Vec3> places, int threads, Progress progress) const {
  std::vector<Place> found(places.size());
  for_each_part(places.size(), places_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = at(places[i]);
  });
  return found;
}

implicit::Field UnitedSolid::field() const {
  return [this](std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Place here = at(points[i]);
      values[i] = here.value;
      if (!gradients.empty()) gradients[i] = here.gradient;
    }
  };
}

implicit::Covered UnitedSolid::covered() const {
  if (are_closed(members_)) return {};
  return [this](std::span<const Vec3> places, std::span<std::uint8_t> covered) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const SignedPlace found = members_[at(places[i]).member]->at(places[i]);
      const bool is_there = std::abs(found.distance) < off_the_surface * cell_ && found.out < rim_tolerance * cell_;
      covered[i] = is_there ? 0 : 1;
    }
  };
}

implicit::Box UnitedSolid::box() const {
  implicit::Box box = members_.front()->box();
  for (const SignedSurface* member : members_) {
    box.low = box.low.cwiseMin(member->box().low);
    box.high = box.high.cwiseMax(member->box().high);
  }
  return box;
}

UnionFaults faults_of(const PolyMesh& made, const SolidMembers& members, double cell, int threads, Progress progress) {
  UnionFaults faults;
  faults.leaves_members =
      made.face_count() == 0 || leaves_members(made, members, leaves_beyond * cell, threads, progress);
  if (are_closed(members)) return faults;
  for (std::size_t m = 0; m < members.size(); ++m)
    if (loses_too_much(made, members[m], members, cell, threads, progress)) faults.losing.push_back(m);
  return faults;
}

}  // namespace croquis::remeshing
