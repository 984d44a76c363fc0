// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/fences/smooth_corners.h"

#include <algorithm>

namespace croquis {
namespace {

constexpr std::size_t no_group = ~std::size_t{0};
/// A sum of unit normals below this part of their number is a knife edge's.
constexpr double least_agreement = 0.3;

/// The corner of a face at the start or the end of a curve.
FaceCorner corner_at(const AttributeNetwork& network, Index face, Index curve, bool end) {
  const std::vector<AttributeSide>& loop = network.faces[face].loop;
  const std::size_t side = side_of(network.faces[face], curve);
  return {face, loop[side].reversed == end ? side : (side + 1) % loop.size()};
}

}  // namespace

std::size_t side_of(const AttributeFace& face, Index curve) {
  return static_cast<std::size_t>(std::ranges::find(face.loop, curve, &AttributeSide::curve) - face.loop.begin());
}

SmoothCorners::SmoothCorners(const FenceInput& input, const std::vector<bool>& smooth,
                             const std::vector<FaceShape>& shapes)
    : shapes_(shapes) {
  for (Index face = 0; face < input.network.faces.size(); ++face) {
    first_of_face_.push_back(corners_.size());
    for (std::size_t side = 0; side < shapes[face].loop.size(); ++side) corners_.push_back({face, side});
  }
  links_.resize(corners_.size());
  entries_.resize(corners_.size(), {no_group, false});
  for (Index curve = 0; curve < smooth.size(); ++curve) {
    if (smooth[curve]) link_along(input, curve);
  }
  for (std::size_t corner = 0; corner < corners_.size(); ++corner) {
    if (entries_[corner].group == no_group) gather(corner);
  }
}

void SmoothCorners::link_along(const FenceInput& input, Index curve) {
  const Index first = input.faces_of_curve[curve][0];
  const Index second = input.faces_of_curve[curve][1];
  const auto reversed = [&](Index face) {
    const AttributeFace& of = input.network.faces[face];
    return of.loop[side_of(of, curve)].reversed;
  };
  const bool turned = reversed(first) == reversed(second);
  for (const bool end : {false, true}) {
    const std::size_t a = number(corner_at(input.network, first, curve, end));
    const std::size_t b = number(corner_at(input.network, second, curve, end));
    links_[a].push_back({b, turned});
    links_[b].push_back({a, turned});
  }
}

void SmoothCorners::gather(std::size_t first) {
  CornerGroup group;
  Vec3 sum = Vec3::Zero();
  std::vector<std::size_t> waiting{first};
  entries_[first] = {groups_.size(), false};
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    const FaceCorner corner = corners_[waiting[i]];
    group.corners.push_back(corner);
    const bool turned = entries_[waiting[i]].turned;
    sum += (turned ? -1 : 1) * shapes_[corner.face].normals.corners[corner.side];
    for (const Link& link : links_[waiting[i]]) {
      if (entries_[link.other].group != no_group) continue;
      entries_[link.other] = {groups_.size(), turned != link.turned};
      waiting.push_back(link.other);
    }
  }
  group.knife_edge = sum.norm() < least_agreement * static_cast<double>(waiting.size());
  group.normal = unit_or_zero(sum);
  groups_.push_back(group);
}

Vec3 SmoothCorners::normal(const FaceCorner& corner) const {
  const Entry& found = entry(corner);
  return found.turned ? Vec3(-groups_[found.group].normal) : groups_[found.group].normal;
}

}  // namespace croquis
