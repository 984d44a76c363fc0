// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/silhouette/stroke_edit.h"

/// What people say about strokes that are drawn already; it is kept as the strokes' data (silhouette/stroke_data.h).
namespace croquis {

inline constexpr double least_thickness = 0.05;  ///< factors of a part's depth
inline constexpr double most_thickness = 4;

/// Says what a stroke is: an outline, a hole, a line on the surface …
/// @param kind Visible takes back what was said; @throws Error (E_INPUT) when there is no such stroke
DrawingEdit set_kind(const Drawing& drawing, const std::string& id, silhouette::StrokeKind kind);

/// Says which of two strokes that cross in full view lies in front. Without a setting it is the one drawn later.
/// @throws Error (E_INPUT) when there is no such stroke
DrawingEdit set_in_front(const Drawing& drawing, const std::string& front, const std::string& behind);

/// Makes the part that a stroke bounds thicker or thinner. Where the drawing names the part, its group has the factor.
/// @param factor limited to least_thickness .. most_thickness; 1 is as drawn
/// @throws Error (E_INPUT) when there is no such stroke
DrawingEdit set_thickness(const Drawing& drawing, const std::string& id, double factor);

/// Says what the part that a stroke bounds is called. Where the drawing names the part, its group has the title.
/// @param title empty: it is called by its shape again; @throws Error (E_INPUT) when there is no such stroke
DrawingEdit set_title(const Drawing& drawing, const std::string& id, const std::string& title);

/// Says whether there is a second one of the part that a stroke bounds, on the far side of what it belongs to. Where
/// the drawing names the part, its group says so. @throws Error (E_INPUT) when there is no such stroke
DrawingEdit set_far_copy(const Drawing& drawing, const std::string& id, bool copied);

/// What was set; false for an unknown stroke.
bool has_far_copy(const Drawing& drawing, const std::string& id);

/// Says which strand of a tube is over at its crossings. @throws Error (E_INPUT) when there is no such stroke
DrawingEdit set_over(const Drawing& drawing, const std::string& id, const std::string& words);

/// Says which colour the part that a stroke bounds has. Where the drawing names the part, its group says so.
/// @param color "#rrggbb", or empty for none; @throws Error (E_INPUT) when there is no such stroke
DrawingEdit set_fill(const Drawing& drawing, const std::string& id, const std::string& color);

/// Says on both sides of which vertical line a stroke is to be the same; the tool then makes it so.
/// @param axis x of the line, sketch units, or empty: it and its twin are strokes of their own again
/// @throws Error (E_INPUT) when there is no such stroke
DrawingEdit set_mirror(const Drawing& drawing, const std::string& id, const std::string& axis);

/// What was set; empty where nothing was, and for an unknown stroke.
std::string fill_of(const Drawing& drawing, const std::string& id);

/// Sets data of several strokes.
/// @param says a stroke's id, a key and the value there; an empty value takes it away
/// @throws Error (E_INPUT) when there is no such stroke
DrawingEdit set_data(const Drawing& drawing, const std::vector<std::array<std::string, 3>>& says);

/// What was set; empty where nothing was, and for an unknown stroke.
std::string title_of(const Drawing& drawing, const std::string& id);

/// What was set; 1 where nothing or nonsense was. 1 for an unknown stroke.
double thickness_of(const Drawing& drawing, const std::string& id);

}  // namespace croquis
