// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "croquis/tools/perspective/drawing_edit.h"
#include "croquis/tools/perspective/mirror_completion.h"
#include "croquis/tools/recording/vocabulary.h"

/// Steps of the perspective tool. Places are px of the sheet, y down; groups are "x", "y", "z", "normal-x", "normal-y",
/// "normal-z".
namespace croquis::recorded {

/// The pen drew on the sheet, or with the eraser deleted what it touched.
struct SheetStroke {
  std::vector<Vec2> points;          ///< at least one
  std::optional<StrokeGroup> group;  ///< none: by where it points
  StrokeRole role = StrokeRole::Edge;
  bool erases = false;
  double scale = 1;                 ///< px of the sheet per pixel of the view drawn in
  std::vector<StrokeGroup> groups;  ///< that were found for its strokes, one each; empty: found again

  static constexpr std::array verbs{"perspective-stroke"};
  void describe(Fields& fields);
};

/// A point of a stroke (see points_of), or without one the whole stroke, was dragged.
struct SheetDrag {
  std::string stroke;
  std::optional<std::size_t> point;
  Vec2 by = Vec2::Zero();
  bool alone = false;  ///< an end without the others at its vertex

  static constexpr std::array verbs{"perspective-drag"};
  void describe(Fields& fields) {
    fields.required("stroke", stroke);
    fields.seldom("point", point);
    fields.required("by", by);
    fields.seldom("alone", alone);
  }
};

/// The vanishing point of an axis was dragged.
struct SheetAim {
  int axis = 0;
  Vec2 at = Vec2::Zero();

  static constexpr std::array verbs{"perspective-aim"};
  void describe(Fields& fields);
};

/// What a stroke is was set.
struct SheetSetting {
  std::vector<std::string> strokes;
  StrokeSetting setting;

  static constexpr std::array verbs{"perspective-set"};
  void describe(Fields& fields);
};

struct SheetDelete {
  std::vector<std::string> strokes;

  static constexpr std::array verbs{"perspective-delete"};
  void describe(Fields& fields) { fields.required("strokes", strokes); }
};

/// A place whose point in space is known; without both, none is.
struct SheetPoint {
  std::optional<KnownPoint> known;

  static constexpr std::array verbs{"perspective-point"};
  void describe(Fields& fields);
};

/// The length of a stroke in space; without one, none is known.
struct SheetLength {
  std::string stroke;
  std::optional<double> length;

  static constexpr std::array verbs{"perspective-length"};
  void describe(Fields& fields) {
    fields.required("stroke", stroke);
    fields.seldom("length", length);
  }
};

/// The unit of lengths: "mm", "cm", "m", "in"; empty: none.
struct SheetUnit {
  std::string unit;

  static constexpr std::array verbs{"perspective-unit"};
  void describe(Fields& fields);
};

/// One set of faces was chosen among several that fit: each face by its strokes, "s1+s2+s3".
struct SheetFaces {
  std::vector<std::string> required;
  std::vector<std::string> forbidden;

  static constexpr std::array verbs{"perspective-choose-faces"};
  void describe(Fields& fields);
};

/// What is known of the camera; what isn't given isn't known.
struct SheetCamera {
  std::optional<double> field_of_view;  ///< radians; degrees in recordings
  std::optional<Vec2> principal_point;

  static constexpr std::array verbs{"perspective-camera"};
  void describe(Fields& fields);
};

/// Something was put on a list of the operation, or taken off.
struct SheetChoice {
  std::string list;  ///< "faces", "no-faces", "ignore" or "sharp"
  std::string item;  ///< a stroke, or the strokes of a face: "s1+s2+s3"
  bool on = true;

  static constexpr std::array verbs{"perspective-choose"};
  void describe(Fields& fields);
};

/// What a mirror adds was accepted.
struct SheetMirror {
  MirrorPlane plane;
  std::vector<PerspectiveStroke> strokes;  ///< that it added: shape and group; empty: found again

  static constexpr std::array verbs{"perspective-mirror"};
  void describe(Fields& fields);
};

/// The sheet got another size, px; strokes keep their places.
struct SheetSize {
  Vec2 size = Vec2::Zero();

  static constexpr std::array verbs{"perspective-sheet"};
  void describe(Fields& fields);
};

/// All of them, and what can be counted of a perspective drawing.
const Vocabulary& perspective_steps();

}  // namespace croquis::recorded
