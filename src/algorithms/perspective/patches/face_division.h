// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "croquis/perspective/solid.h"

/// Faces that one star of patches can't fill are divided by an edge of their own, which no stroke drew, from corner to
/// corner. Both parts go on smoothly into each other across it.
namespace croquis {

/// A side of a face in two halves that meet at its middle.
struct FaceSide {
  PatchSide first, second;
  bool whole = true;  ///< one cubic, `full`
  std::array<Vec3, 4> full{};
  Vec3 middle = Vec3::Zero();
  Vec3 tangent = Vec3::Zero();  ///< unit, along the side at its middle
  Vec3 inwards = Vec3::Zero();  ///< unit, into the face at the middle: half way between the slopes at the ends

  /// The side as that of a patch over the whole face. Only where it is one cubic.
  PatchSide as_one() const { return {full, first.common, {first.across[0], second.across[1]}}; }
};

/// The sides of a face's outer loop on their way around.
std::vector<FaceSide> face_sides(const Brep& brep, const BrepFace& face);

/// A cubic from one corner of a face to another.
struct FaceDiagonal {
  std::array<Index, 2> halves = {no_index, no_index};          ///< start at its corners; in the order of the loop
  std::array<Vec3, 2> legs = {Vec3::Zero(), Vec3::Zero()};     ///< from its corners to its handles
  std::array<Vec3, 2> normals = {Vec3::Zero(), Vec3::Zero()};  ///< unit, of the tangent planes at its corners
  double cost = 0;
};

/// The diagonals of a face, the best first: short ones that leave four sides on both of theirs and begin in corners of
/// more than 180 degrees. They lie well inside
/// the angles at both corners and in the planes that the face's sides span there.
std::vector<FaceDiagonal> diagonals(const Brep& brep, Index face);

/// Divides the face along a diagonal. The part that begins with the diagonal's second corner becomes the last face of
/// the B-rep. If both parts have four sides, the diagonal takes its shape of least energy.
void divide_face(Brep& brep, Index face, const FaceDiagonal& diagonal);

}  // namespace croquis
