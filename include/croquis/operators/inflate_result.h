// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"
#include "croquis/silhouette/solid.h"
#include "croquis/silhouette/stroke_data.h"

/// What the operation `inflate` found in a drawing; its report is made of this. Places are those of Drawing, y up.
namespace croquis {

/// A part of the solid: what closed contours of the drawing stand for.
struct InflatedObject {
  std::string name;
  std::vector<std::string> strokes;  ///< names of those that it is made of
  int euler_region = 0;              ///< Euler number of the immersed region
  int euler_mesh = 0;                ///< of its mesh before it is joined with others
  double thickness = 1;              ///< factor of its depth
};

/// A closed surface of its own: one object, or several attached ones.
struct InflatedShell {
  std::vector<std::string> objects;  ///< names
  int euler_mesh = 0;
};

/// Two strands that lie over one another.
struct StrandOverlap {
  Vec2 at = Vec2::Zero();
  std::string upper, lower;     ///< names of objects
  std::vector<Vec2> crossings;  ///< corners of the overlap
};

/// Two objects that may be attached, and how.
struct SuggestedJoint {
  std::string a, b;  ///< names of objects
  Vec2 at = Vec2::Zero();
  silhouette::Hold hold = silhouette::Hold::Joined;
};

/// A closed outline within another one's surface.
struct NestedStroke {
  std::string stroke, around;  ///< ids of strokes
  bool hole = false;           ///< else a part in front
  bool chosen = false;         ///< by the drawing; else read from its shape
  Vec2 at = Vec2::Zero();      ///< on the outline
};

/// Two strokes that cross in full view.
struct StrokesInView {
  std::string front, behind;  ///< ids of strokes
  Vec2 at = Vec2::Zero();
  bool chosen = false;  ///< by the drawing; else by the order of drawing
};

/// The label of one arc of a contour.
struct ArcLabel {
  std::size_t contour = 0;  ///< number among all contours of the drawing
  int depth = 0;            ///< surfaces in front of it; 0 exactly for visible arcs
  bool visible = true;
  std::string object;  ///< name
};

struct InflateResult {
  std::size_t strokes = 0;
  std::vector<std::pair<std::string, silhouette::StrokeKind>> kinds;  ///< per stroke: its id, and what it was read as
  std::vector<InflatedObject> objects;
  std::size_t contours = 0;
  std::size_t completions = 0;         ///< hidden pieces that join stroke ends
  std::size_t contours_completed = 0;  ///< contours with such pieces
  std::size_t crossings = 0;
  std::vector<ArcLabel> arcs;  ///< one per stroke of the output "labels", in its order
  int panels = 0;
  std::size_t components = 0;
  std::vector<StrandOverlap> overlaps;
  std::vector<InflatedShell> shells;
  std::vector<silhouette::SolidAttachment> attached;
  std::vector<SuggestedJoint> suggested;
  std::vector<NestedStroke> nested;
  std::vector<StrokesInView> crossings_in_view;
  double used = 1;                    ///< share of the drawing's strokes, by length, that the solid is made of
  std::optional<std::size_t> carved;  ///< grooves or ridges, where they were asked for
  silhouette::SolidDiagnostics diagnostics;
};

std::size_t byte_size(const InflateResult& result);

}  // namespace croquis
