// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/described.h"
#include "croquis/geometry/vector.h"
#include "croquis/silhouette/solid.h"
#include "croquis/silhouette/stroke_data.h"

/// What the operation `inflate` found in a drawing; its report is made of this. Places are those of Drawing, y up.
namespace croquis {

/// As reports have places: in the sketch's own frame, y down.
inline Report sketch_place(const Vec2& at) { return Report::list(std::array{at.x(), -at.y()}); }
inline Report sketch_places(const std::vector<Vec2>& places) {
  Report list = Report::array();
  for (const Vec2& at : places) list.push(sketch_place(at));
  return list;
}

/// "apart", "resting", "joined".
constexpr const char* word_of(silhouette::Hold hold) {
  if (hold == silhouette::Hold::Joined) return "joined";
  return hold == silhouette::Hold::Resting ? "resting" : "apart";
}

/// A part of the solid: what closed contours of the drawing stand for.
struct InflatedObject {
  std::string name;
  std::vector<std::string> strokes;  ///< names of those that it is made of
  int euler_region = 0;              ///< Euler number of the immersed region
  int euler_mesh = 0;                ///< of its mesh before it is joined with others
  double thickness = 1;              ///< factor of its depth
};
inline auto described(const InflatedObject& object) {
  return fields(named("name", object.name), named("strokes", object.strokes),
                named("euler_region", object.euler_region), named("euler_mesh", object.euler_mesh),
                named("thickness", object.thickness));
}
static_assert(describes_every_member<InflatedObject>);

/// A closed surface of its own: one object, or several attached ones.
struct InflatedShell {
  std::vector<std::string> objects;  ///< names
  int euler_mesh = 0;
};
inline auto described(const InflatedShell& shell) {
  return fields(named("objects", shell.objects), named("euler_mesh", shell.euler_mesh));
}
static_assert(describes_every_member<InflatedShell>);

/// Two strands that lie over one another.
struct StrandOverlap {
  std::size_t index = 0;  ///< place in InflateResult::overlaps
  Vec2 at = Vec2::Zero();
  std::string upper, lower;     ///< names of objects
  std::vector<Vec2> crossings;  ///< corners of the overlap
};
inline auto described(const StrandOverlap& overlap) {
  return fields(named("index", overlap.index), named("at", sketch_place(overlap.at)), named("upper", overlap.upper),
                named("lower", overlap.lower), named("crossings", sketch_places(overlap.crossings)));
}
static_assert(describes_every_member<StrandOverlap>);

/// Where a tube passes over another one, or itself, and what turns that round; it isn't in the report.
struct TubeSwap {
  Vec2 at = Vec2::Zero();
  std::string front, behind;  ///< ids of strokes
  std::string stroke;         ///< id of the one whose words are written
  std::string over;           ///< those words, see silhouette::over_key
};

/// Two objects that may be attached, and how.
struct SuggestedJoint {
  std::string a, b;  ///< names of objects
  Vec2 at = Vec2::Zero();
  silhouette::Hold hold = silhouette::Hold::Joined;
};
inline auto described(const SuggestedJoint& joint) {
  return fields(named("a", joint.a), named("b", joint.b), named("at", sketch_place(joint.at)),
                named("hold", word_of(joint.hold)));
}
static_assert(describes_every_member<SuggestedJoint>);

/// A closed outline within another one's surface.
struct NestedStroke {
  std::string stroke, around;  ///< ids of strokes
  bool hole = false;           ///< else a part in front
  bool chosen = false;         ///< by the drawing; else read from its shape
  Vec2 at = Vec2::Zero();      ///< on the outline
};
inline auto described(const NestedStroke& nested) {
  return fields(named("stroke", nested.stroke), named("around", nested.around),
                named("kind", nested.hole ? "hole" : "part"), named("chosen", nested.chosen),
                named("at", sketch_place(nested.at)));
}
static_assert(describes_every_member<NestedStroke>);

/// Two strokes that cross in full view.
struct StrokesInView {
  std::string front, behind;  ///< ids of strokes
  Vec2 at = Vec2::Zero();
  bool chosen = false;  ///< by the drawing; else by the order of drawing
};
inline auto described(const StrokesInView& pair) {
  return fields(named("front", pair.front), named("behind", pair.behind), named("chosen", pair.chosen),
                named("at", sketch_place(pair.at)));
}
static_assert(describes_every_member<StrokesInView>);

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
  std::vector<TubeSwap> tube_swaps;
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
