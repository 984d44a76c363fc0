// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/network_mirror.h"
#include "croquis/geometry/affine3.h"

namespace croquis {

Affine3 reflection_at(const SymmetryPlane& plane);

/// Writes mirror images of a network's elements into it: as new elements, or over those that are their images already.
/// What an image refers to is made when it isn't there yet.
class NetworkImage {
 public:
  /// @param partners of the network; elements without one get an image when that is asked for
  NetworkImage(const AttributeNetwork& network, const SymmetryPlane& plane, NetworkPartners partners);

  // The image of an element of the network, made where there is none
  Index node(Index original);
  Index curve(Index original);
  Index face(Index original);
  Index point(Index original);

  // Writes the image over the one that is there
  void renew_node(Index original);
  void renew_curve(Index original);
  void renew_face_settings(Index original);
  void renew_face_loop(Index original);
  void renew_inner_curves(Index original);
  void renew_point(Index original);
  void add_slope(std::size_t original);  ///< where its face, if it has one, has an image
  /// Of the image of a curve all that the original has, and nothing else.
  void renew_slopes(Index original);

  // Of elements that are their own image
  void centre_node(Index node);
  void centre_curve(Index curve);
  void centre_point(Index point);
  void complete_loop(Index face);  ///< with the images of its curves

  /// Where an image has parted neighbours in a loop, as that of a curve that was split does, the new curve that goes
  /// from one to the other is put between them.
  void mend_loops();
  /// Curves follow nodes that were brought into the plane.
  void meet_nodes();

  const NetworkElements& added() const { return added_; }
  AttributeNetwork& network() { return result_; }

 private:
  std::string name_for(NetworkElement kind, const std::string& original);
  AttributeSide side(const AttributeSide& original);
  std::vector<AttributeSide> loop(Index original);
  std::optional<AttributeSide> new_side(Index from, Index to) const;
  std::vector<InnerCurve> inner_curves(Index original);
  AttributeCurve curve_image(Index original);
  PointAttribute point_image(Index original, Index face);

  SymmetryPlane plane_;
  Affine3 map_;
  AttributeNetwork original_;
  AttributeNetwork image_;  ///< the whole network mirrored: the same numbers as the original
  AttributeNetwork result_;
  NetworkPartners partners_;
  std::vector<bool> backwards_;  ///< the image of a curve runs against its mirrored direction
  NetworkElements added_;
};

}  // namespace croquis
