// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/curve_edit.h"

/// What people do to the faces and points of an attribute network: pure functions, as in curve_edit.h, with the same
/// errors.
namespace croquis {

/// What isn't given stays.
struct FaceSetting {
  std::optional<AttributeMode> mode;
  std::optional<AttributeDomain> domain;
  std::optional<double> fullness;  ///< -1..2

  bool any() const { return mode || domain || fullness; }
  friend bool operator==(const FaceSetting&, const FaceSetting&) = default;
};

/// A face on a loop that is in order (see sort_loop). A single closed curve is divided into four first.
AddedElement add_face(AttributeNetwork network, std::vector<AttributeSide> loop, const FaceSetting& setting = {});

AttributeNetwork set_faces(AttributeNetwork network, const std::vector<std::string>& faces, const FaceSetting& setting);

/// Turns the loops round: the normals point to the other side. Points keep their places.
AttributeNetwork turn_faces(AttributeNetwork network, const std::vector<std::string>& faces);

/// A face in two.
struct SplitFace {
  AttributeNetwork network;
  std::string second;  ///< the new face; the first part keeps the id
};

/// Divides a face by a curve whose ends lie on its loop: at nodes, or on curves, which are split there. Points and
/// inner curves go to the part that their places of the domain are in, and lose their fan places.
/// @param reach model units, >= 0: how far the curve's ends may be from the loop
/// @throws Error (Geometry, E_OPEN_LOOP) naming curve and gap where an end is farther from it
SplitFace split_face(AttributeNetwork network, const std::string& face, const std::string& curve, double reach);

/// Whether a curve could split a face: both ends within reach of the loop, at different places.
bool can_split_face(const AttributeNetwork& network, Index face, Index curve, double reach);

/// Makes one face of the two that share a curve, which is deleted with those that it would leave hanging between them.
/// The first keeps its id and settings; points and inner curves of the second go to it.
/// @throws Error (Usage, E_INPUT) where the curve isn't between exactly two faces, or these meet elsewhere, too
AttributeNetwork merge_faces(AttributeNetwork network, const std::string& curve);

bool can_merge_faces(const AttributeNetwork& network, Index curve);

/// Deletes elements with what can't be without them: curves of deleted nodes; faces of deleted curves, but two faces
/// that can be merged are; nodes that have no curve any more; inner curves without nodes, points and slopes of deleted
/// faces. Unknown ids are left out.
AttributeNetwork delete_elements(AttributeNetwork network, const NetworkElements& elements);

// ---- Points

struct NewPoint {
  std::string face;
  Vec3 point = Vec3::Zero();
  std::optional<FanPlace> fan;
  std::optional<double> radius;  ///< model units, > 0
  PointProfile profile = PointProfile::Smooth;
};

AddedElement add_point(AttributeNetwork network, const NewPoint& point);

/// Their places of the domain stay.
AttributeNetwork move_points(AttributeNetwork network, const std::vector<std::string>& points, const Vec3& by);

/// What isn't given stays.
struct PointSetting {
  std::optional<Vec3> point;
  std::optional<std::optional<double>> radius;  ///< an empty one: from the distance to the face's sides
  std::optional<PointProfile> profile;
  std::optional<std::optional<Vec3>> normal;  ///< an empty one: as it comes

  bool any() const { return point || radius || profile || normal; }
};

AttributeNetwork set_points(AttributeNetwork network, const std::vector<std::string>& points,
                            const PointSetting& setting);

// ---- Inner curves

/// Puts a curve into a face, which passes through it then. @param curve one that isn't in the face's loop
AttributeNetwork add_inner_curve(AttributeNetwork network, const std::string& face, const InnerCurve& inner);

/// What isn't given stays.
struct InnerSetting {
  std::optional<InnerProfile> profile;
  std::optional<std::optional<double>> radius;
};

/// Of the curve in all faces that have it inside.
AttributeNetwork set_inner_curve(AttributeNetwork network, const std::string& curve, const InnerSetting& setting);

/// The curve stays, the face no longer passes through it.
AttributeNetwork remove_inner_curve(AttributeNetwork network, const std::string& face, const std::string& curve);

}  // namespace croquis
