// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/attribute_surface/network_elements.h"

/// Attribute networks that are symmetric about a plane, as cars are.
namespace croquis {

struct SymmetryPlane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitX();  ///< of any length above 0

  friend bool operator==(const SymmetryPlane&, const SymmetryPlane&) = default;
};

/// The mirror image of a place.
Vec3 mirrored(const Vec3& place, const SymmetryPlane& plane);

/// For each element the index of its mirror image: its own for what is symmetric in itself, no_index for none.
struct NetworkPartners {
  std::vector<Index> nodes;
  std::vector<Index> curves;
  std::vector<Index> faces;
  std::vector<Index> points;

  bool any() const;  ///< at least one element has an image that isn't itself
};

/// @param tolerance model units, > 0: how far images may be off
NetworkPartners find_partners(const AttributeNetwork& network, const SymmetryPlane& plane, double tolerance);

struct MirroredNetwork {
  AttributeNetwork network;
  NetworkElements added;  ///< ids: those of the originals with "_m", and a number where that is taken
  Findings findings;      ///< W_MIRROR_CROSSING: curves that cross the plane without being symmetric
};

/// Adds the mirror images of all elements that have none yet. Loops of images run the other way round, so that normals
/// point to the mirrored side. What lies in the plane is shared, and brought into it exactly.
MirroredNetwork mirror_network(const AttributeNetwork& network, const SymmetryPlane& plane, double tolerance);

/// An edit done on both sides: what became of an element becomes of its image, too; what is new gets an image; the
/// image of what was deleted goes. Where both were changed, the first one counts. What is its own image stays so:
/// places in the plane stay in it. Where the image of an edit would open the loop of a face that has no image itself,
/// the edit is done alone.
/// @param before, after the network without and with the edit
AttributeNetwork with_symmetric_edit(const AttributeNetwork& before, const AttributeNetwork& after,
                                     const SymmetryPlane& plane, const NetworkPartners& partners);

}  // namespace croquis
