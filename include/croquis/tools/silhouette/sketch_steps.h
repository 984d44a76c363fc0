// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/recording/vocabulary.h"

/// Steps of the sketch tool.
namespace croquis::recorded {

/// A pen or mouse stroke; what it does depends on the tool's mode, as in the window.
struct StrokeDrawn {
  std::string view = "sketch";
  std::vector<StrokeSample> points;   ///< at least one; tilt isn't recorded
  std::string device = "mouse";       ///< "mouse", "pen" or "eraser"
  double scale = 0;                   ///< units per pixel of the view drawn in; 0 for the replaying view's own
  bool behind = false;                ///< drawn with the right button, or with Shift: behind what is there
  std::optional<double> tube = {};    ///< it is the centre line of a tube of this radius, sketch units, above 0
  std::optional<double> mirror = {};  ///< x of the line on both sides of which it is the same, sketch units

  static constexpr std::array verbs{"stroke"};
  void describe(Fields& fields);
};
/// An anchor of a stroke, or without one the whole stroke, was dragged.
struct Drag {
  std::string stroke;
  std::optional<std::size_t> anchor;  ///< 0-based
  Vec2 by = Vec2::Zero();

  static constexpr std::array verbs{"drag"};
  void describe(Fields& fields) {
    fields.required("stroke", stroke);
    fields.seldom("anchor", anchor);
    fields.required("by", by);
  }
};

/// How a stroke that is drawn already is to be read; one of these.
struct StrokeReading {
  std::string stroke;
  std::optional<silhouette::StrokeKind> kind = {};  ///< Visible: it is found again
  std::optional<std::string> in_front_of = {};      ///< id of the stroke that it crosses
  std::optional<double> thickness = {};             ///< factor of the depth of the part that it bounds, above 0
  std::optional<std::string> title = {};            ///< of the part that it bounds; empty: by its shape again
  std::optional<bool> far_copy = {};                ///< whether there is a second one of the part on the far side
  std::optional<std::string> over = {};             ///< of a tube: the words of its crossings, see silhouette::over_key
  std::optional<std::string> mirror = {};  ///< x of the line on both sides of which it is the same; empty: none
  std::optional<std::string> fill = {};    ///< "#rrggbb", of the part that it bounds; empty: none

  static constexpr std::array verbs{"stroke-set"};
  void describe(Fields& fields);
};

/// Another reading of the whole drawing was chosen: what strokes say of themselves then.
struct ReadingChosen {
  /// A stroke's id, a key of its data and the value there; an empty value takes it away. At least one.
  std::vector<std::array<std::string, 3>> says;

  static constexpr std::array verbs{"read-as"};
  void describe(Fields& fields);
};

/// All of them, and what can be counted: strokes, and how they are read.
const Vocabulary& sketch_steps();

}  // namespace croquis::recorded
