// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/tools/perspective/sheet_units.h"

/// Completing what can't be seen: the strokes of one half of a symmetric solid give those of the other half.
namespace croquis {

/// Where an axis has that coordinate.
struct MirrorPlane {
  int axis = 0;   ///< 0..2
  double at = 0;  ///< model units
  friend bool operator==(const MirrorPlane&, const MirrorPlane&) = default;
};

struct MirrorOptions {
  double same_sheet = 0.012;  ///< × the sheet's diagonal: places of the sheet that are one vertex
  double same_share = 0.03;   ///< × the network's size: places in space that are one vertex; a hand is no better
};

/// The edges that the drawing lacks, as its curves seen in a mirror. Curves that lie in the plane, that have their
/// image already, or whose image isn't before the eye are left out. Images begin and end at the vertices that are there
/// already; each has the group of its original, is hidden, and has no id yet.
/// @param plane of the network's own space
std::vector<PerspectiveStroke> mirrored_strokes(const PerspectiveDrawing& drawing, const SolvedDrawing& solved,
                                                const MirrorPlane& plane, const MirrorOptions& options = {});

struct MirrorProposal {
  MirrorPlane plane;
  std::vector<PerspectiveStroke> strokes;  ///< that it adds, at least one
};

/// The plane that the drawing is most likely symmetric about, where something is missing. Tried are planes in the
/// middle of the network, and those at its ends where vertices lie that lack edges. A plane is worth more the more
/// vertices have their image and the more ends of open strokes it joins; nothing is proposed where
/// no stroke lacks a face and none ends in nothing.
std::optional<MirrorProposal> propose_mirror(const PerspectiveDrawing& drawing, const SolvedDrawing& solved,
                                             const MirrorOptions& options = {});

/// Adds the strokes with ids of their own. @return these
std::vector<std::string> add_mirrored(PerspectiveDrawing& drawing, const std::vector<PerspectiveStroke>& strokes);

}  // namespace croquis
