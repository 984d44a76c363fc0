// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/attribute_surface.h"

/// What chordlength domains are for, in numbers: where the dents of points come to lie, and how round they are, beside
/// those of a domain that takes no notice of the curves' lengths.
/// Source: Kim and Park 2006, section 4 (there in pictures).
namespace croquis {

/// What a point does to its patch: the part of the surface that is moved by half of the point's own way or more.
struct DentMeasures {
  double offset = 0;      ///< model units across the point's way: from the point's foot to the middle of that part
  double anisotropy = 1;  ///< >= 1: of that part, seen along the point's way
};

/// @param point index into face.points(); the others are left out
/// @param foot  where on the surface the point was put before it was pulled
/// @return none for a point that doesn't move the surface
std::optional<DentMeasures> measure_dent(const FaceSurface& face, std::size_t point, const Vec3& foot);

/// A point attribute in both domains.
struct ComparedPoint {
  std::string id;
  std::optional<DentMeasures> own;
  std::optional<DentMeasures> uniform;
};

struct DomainComparison {
  AttributeNetwork network;  ///< all faces with uniform domains; points at the same places of space
  AttributeSurface surface;
  std::vector<ComparedPoint> points;  ///< those that both have placed, in the network's order
};

/// The same network on uniform domains. Points are put where they were put in space, with the radii that they have.
/// @param surface of that network
/// @throws Cancelled
DomainComparison compare_with_uniform(const AttributeNetwork& network, const AttributeSurface& surface,
                                      Progress& progress);

/// Which of a face's points, as FaceSurface has them, an attribute of the network is; none where it isn't placed.
std::optional<std::size_t> placed_index(const AttributeNetwork& network, const AttributeSurface& surface, Index point);

}  // namespace croquis
