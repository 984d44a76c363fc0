// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "croquis/attribute_surface/attribute_surface.h"
#include "support/attribute_surface/reference_surface.h"

/// What tests ask of surfaces again and again.
namespace croquis::test {

/// Evaluates a network without waiting for anybody.
AttributeSurface surface_of(const AttributeNetwork& network, const AttributeSurfaceOptions& options = {});

/// The surface of the first face.
/// @throws std::runtime_error when it can't be evaluated, with what is wrong
FaceSurface first_surface(const AttributeNetwork& network, const AttributeSurfaceOptions& options = {});

/// Places all over a face's domain, in every fan; none on its sides.
std::vector<FanPlace> spread_places(std::size_t corners, std::size_t count, std::uint64_t seed);

/// Greatest distance from the origin of anything in the network: what rounding is relative to.
double extent(const AttributeNetwork& network);

/// A network with points pulled off its faces: of each face as many as there are corners, at most `most`.
/// @param off distance from the surface, relative to the face's mean side
AttributeNetwork with_points(const AttributeNetwork& network, std::size_t most, double off, std::uint64_t seed);

/// The points of one face as the reference takes them.
std::vector<ReferencePoint> reference_points(const AttributeNetwork& network, Index face);

}  // namespace croquis::test
