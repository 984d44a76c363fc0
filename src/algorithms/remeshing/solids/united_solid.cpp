// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/solids/united_solid.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/parallel.h"

namespace croquis::remeshing {
namespace {

constexpr double ends_beyond = 2;         // × cell: so far a surface with a border goes on, to be cut off in between
constexpr double rim_tolerance = 0.5;     // × cell: so far it is there, as where rims are left open
constexpr double off_the_surface = 0.75;  // × cell: corners of cubes at a surface are nearer to it than this on average
constexpr double clearly_far = 3;         // × cell: so far off a surface, or its box, the distance needn't be known
constexpr double rounding = 1e-6;         // of distances that are added up
constexpr std::size_t places_per_part = 1024;  // places that one walk leads to
constexpr std::size_t asked = 200;             // vertices of a cavity tested for whether it lies in a body

double distance_to(const implicit::Box& box, const Vec3& place) {
  return (box.low - place).cwiseMax(place - box.high).cwiseMax(Vec3::Zero()).norm();
}

}  // namespace

UnitedSolid::UnitedSolid(std::span<const std::unique_ptr<const SignedSurface>> members, double cell)
    : members_(members), cell_(cell) {
  std::vector<Index> cavities;
  for (Index m = 0; m < members.size(); ++m) {
    if (members[m]->volume() < 0)
      cavities.push_back(m);
    else
      solids_.push_back({m, {}});
  }
  assign_cavities(cavities);
}

void UnitedSolid::assign_cavities(std::span<const Index> cavities) {
  const std::size_t bodies = solids_.size();
  Solid space;
  for (const Index cavity : cavities) {
    Solid* smallest = nullptr;
    for (std::size_t s = 0; s < bodies; ++s) {
      if (!lies_in(cavity, solids_[s].body)) continue;
      if (smallest == nullptr || members_[solids_[s].body]->volume() < members_[smallest->body]->volume())
        smallest = &solids_[s];
    }
    if (smallest != nullptr)
      smallest->cavities.push_back(cavity);
    else if (members_[cavity]->is_closed())
      space.cavities.push_back(cavity);
    else
      solids_.push_back({cavity, {}});
  }
  if (!space.cavities.empty()) solids_.push_back(std::move(space));
}

/// Most of it: they cross.
bool UnitedSolid::lies_in(Index cavity, Index body) const {
  const std::vector<Vec3>& vertices = members_[cavity]->mesh().positions;
  const std::size_t stride = vertices.size() / asked + 1;
  std::size_t inside = 0, all = 0;
  Walk walk(*this);
  for (std::size_t v = 0; v < vertices.size(); v += stride, ++all)
    if (walk.of_member(body, vertices[v], false).value < 0) ++inside;
  return 2 * inside > all;
}

/// Out of its box and beyond its borders a body isn't there, nor is a cavity.
UnitedSolid::Place UnitedSolid::Walk::of_member(Index member, const Vec3& place, bool is_cavity) {
  const SignedSurface& surface = *solid_.members_[member];
  const double absent = is_cavity ? -1 : 1, far = clearly_far * solid_.cell_;
  const double away = distance_to(surface.box(), place);
  if (away > far) return {absent * away, absent * (place - surface.box().middle()).normalized(), member};
  Last& last = last_[member];
  const double moved = (place - last.place).norm(), left = std::abs(last.distance) - moved;
  if (left > far && surface.is_closed() && std::isfinite(left))
    return {std::copysign(left, last.distance), Vec3::Zero(), member};
  const SignedPlace found = surface.at(place, (1 + rounding) * (std::abs(last.distance) + moved));
  last = {place, found.distance};
  if (found.out > ends_beyond * solid_.cell_) {
    const double flip = found.value * absent < 0 ? -1 : 1;
    return {flip * found.value, flip * found.gradient, member};
  }
  return {found.value, found.gradient, member};
}

UnitedSolid::Place UnitedSolid::Walk::of_solid(std::size_t number, const Vec3& place) {
  const Solid& solid = solid_.solids_[number];
  Place greatest;
  bool any = solid.body != no_index;
  if (any) greatest = of_member(solid.body, place, false);
  for (const Index cavity : solid.cavities) {
    const Place here = of_member(cavity, place, true);
    if (!any || here.value > greatest.value) greatest = here;
    any = true;
  }
  return greatest;
}

UnitedSolid::Place UnitedSolid::Walk::at(const Vec3& place) {
  Place least = of_solid(0, place);
  for (std::size_t s = 1; s < solid_.solids_.size(); ++s) {
    const Place here = of_solid(s, place);
    if (here.value < least.value) least = here;
  }
  return least;
}

std::vector<UnitedSolid::Place> UnitedSolid::at(std::span<const Vec3> places, int threads, Progress& progress) const {
  std::vector<Place> found(places.size());
  for_each_part(places.size(), places_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    Walk walk(*this);
    for (std::size_t i = begin; i < end; ++i) found[i] = walk.at(places[i]);
  });
  return found;
}

implicit::Field UnitedSolid::field() const {
  return [this](std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) {
    Walk walk(*this);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Place here = walk.at(points[i]);
      values[i] = here.value;
      if (!gradients.empty()) gradients[i] = here.gradient;
    }
  };
}

bool UnitedSolid::is_there(const Vec3& place, Walk& walk) const {
  const Index ruling = walk.at(place).member;
  const SignedPlace found = members_[ruling]->at(place);
  return std::abs(found.distance) < off_the_surface * cell_ && found.out < rim_tolerance * cell_;
}

implicit::Covered UnitedSolid::covered() const {
  if (std::ranges::all_of(members_, [](const auto& member) { return member->is_closed(); })) return {};
  return [this](std::span<const Vec3> places, std::span<std::uint8_t> covered) {
    Walk walk(*this);
    for (std::size_t i = 0; i < places.size(); ++i) covered[i] = is_there(places[i], walk) ? 0 : 1;
  };
}

implicit::Box UnitedSolid::box() const {
  implicit::Box box = members_.front()->box();
  for (const auto& member : members_) {
    box.low = box.low.cwiseMin(member->box().low);
    box.high = box.high.cwiseMax(member->box().high);
  }
  return box;
}

}  // namespace croquis::remeshing
