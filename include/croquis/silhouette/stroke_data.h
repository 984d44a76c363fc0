// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/geometry/drawing.h"

/// What a drawing says about its own strokes, in their data attributes (SVG: with "data-" before the name).
namespace croquis::silhouette {

/// The attribute "kind".
enum class StrokeKind {
  Visible,   ///< "visible", or not given: its meaning is found
  Hidden,    ///< "hidden": a piece of contour behind something, used instead of one that is found
  Contour,   ///< "contour": it bounds a surface
  Part,      ///< "part": a closed outline within another one bounds a part in front
  Hole,      ///< "hole": it bounds a hole
  Blob,      ///< "blob": it bounds a small part on another one, such as an eye or a button
  Detail,    ///< "detail": a line on the surface, such as a mouth or a fold
  Scribble,  ///< "scribble": many of them drawn in one go, such as fur
  Tube,      ///< "tube": a limb of one line, such as a leg, a tail or an arm; with a radius a tube's centre line
  Ignored    ///< "ignored": no part of the drawing, such as a letter
};

inline constexpr const char* kind_key = "kind";

/// "thickness": factor of the depth of the object that the stroke bounds, 0.05 to 4; of several strokes of an object
/// the first one's counts, of a named object that of its group.
inline constexpr const char* thickness_key = "thickness";

/// What people call the part that a stroke bounds, or all strokes of a group. It changes no shape.
inline constexpr const char* title_key = "title";

/// "behind": ids of strokes, separated by commas, that this one passes behind where they cross in full view, though it
/// was drawn later; "all" for all drawn before it.
inline constexpr const char* behind_key = "behind";
inline constexpr const char* behind_all = "all";

/// "copy": "far" for a part of which there is a second one, mirrored, on the far side of what it belongs to, such as a
/// leg or an ear in a drawing from the side.
inline constexpr const char* copy_key = "copy";
inline constexpr const char* copy_far = "far";
bool has_far_copy(const std::map<std::string, std::string>& data);  ///< of a stroke or a group

/// "fill", of a closed stroke or a group: the colour of the part that it bounds, "#rrggbb". It changes no shape. Parts
/// without one have that of a part that they are attached to.
inline constexpr const char* fill_key = "fill";

/// "mirror": x of a vertical line, in the drawing's units, on both sides of which the stroke is the same. "twin": the
/// id of its mirror image, where that is a stroke of its own. Where all outlines have the same line, so has the solid:
/// the right half has the same numbers as the left one.
inline constexpr const char* mirror_key = "mirror";
inline constexpr const char* twin_key = "twin";

/// "radius", of kind "tube": the stroke is the centre line of a tube. One number above 0 in the drawing's units, or
/// several separated by commas: one a sample, else spread evenly over the length. One number is multiplied by 0.4 + 1.2
/// times the pen's pressure where that varies.
inline constexpr const char* radius_key = "radius";

/// "ends", of an open tube.
enum class TubeEnds {
  Round,   ///< "round", or not given: half circles around its ends
  Flat,    ///< "flat": it stops at its ends
  Pointed  ///< "pointed": tips beyond its ends
};

inline constexpr const char* ends_key = "ends";

/// "over": a word for each crossing of a tube with itself or another tube, separated by commas, in the order in which
/// its centre line first comes there. The word of the later one of two tubes counts more.
inline constexpr const char* over_key = "over";
inline constexpr std::string_view over_word = "over";    ///< it passes over there
inline constexpr std::string_view under_word = "under";  ///< it passes under
inline constexpr std::string_view auto_word = "auto";    ///< over and under by turns; the later of two tubes is over

/// "joined": pairs of ends that are one line, in full view or behind something, separated by commas: which of its own
/// ends, the other stroke's id, and which of its ends, such as "end s3 start". "apart": the same of ends that aren't.
/// One of the two strokes says it. Pairs with strokes that don't exist mean nothing.
inline constexpr const char* joined_key = "joined";
inline constexpr const char* apart_key = "apart";
inline constexpr std::string_view start_word = "start";
inline constexpr std::string_view end_word = "end";

/// Where a stroke begins or ends.
struct StrokeEnd {
  Index stroke = 0;  ///< index into Drawing::strokes
  bool at_start = false;

  friend auto operator<=>(const StrokeEnd&, const StrokeEnd&) = default;
};

/// Two of them, the lower one first.
using EndPair = std::array<StrokeEnd, 2>;

/// What a drawing says of two ends.
struct PinnedEnds {
  EndPair ends;
  bool joined = true;  ///< else they are apart

  friend bool operator==(const PinnedEnds&, const PinnedEnds&) = default;
};

/// All of "joined" and "apart".
/// @throws Error (E_PIN) that names the strokes of entries that can't be read, or that contradict one another or the
/// kinds given to strokes
std::vector<PinnedEnds> pinned_ends(const Drawing& drawing);

/// Writes it to the first one's stroke.
void pin_ends(Drawing& drawing, const PinnedEnds& pin);

/// Whether a stroke is the centre line of a tube.
bool is_centre_line(const Stroke& stroke);

/// None for a word that is no shape of ends.
std::optional<TubeEnds> tube_ends(std::string_view word);

/// The parts of a list in a stroke's data, separated by commas; views of it. None where it has no such data.
std::vector<std::string_view> data_list(const Stroke& stroke, const char* key);

/// The words of a tube's crossings; views of its data.
std::vector<std::string_view> over_words(const Stroke& stroke);

/// None for a word that is no kind.
std::optional<StrokeKind> stroke_kind(const Stroke& stroke);

/// The kind of that word, as files have it; none for a word that is no kind.
std::optional<StrokeKind> stroke_kind(std::string_view word);

/// The text of a kind, as files have it.
std::string to_string(StrokeKind kind);

/// The ids that a stroke is set to lie behind, `behind_all` among them; views of its data. None when nothing is set.
std::vector<std::string_view> behind_ids(const Stroke& stroke);

/// Whether `later`, drawn after `earlier`, is set to lie behind it.
bool is_set_behind(const Stroke& later, const Stroke& earlier);

}  // namespace croquis::silhouette
