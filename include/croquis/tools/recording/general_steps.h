// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/geometry/placement.h"
#include "croquis/tools/recording/vocabulary.h"

/// Steps that belong to no tool.
namespace croquis::recorded {

/// A named action of the window ("undo", "draw", "frame-all").
struct Action {
  std::string name;

  static const StepKind& step_kind();
};
struct Set {
  std::string node;  ///< its name
  std::string parameter;
  ParameterValue value;

  static const StepKind& step_kind();
};
/// Waits until something is finished.
struct Wait {
  std::string what = "solid";

  static const StepKind& step_kind();
};
struct Screenshot {
  std::string file;

  static const StepKind& step_kind();
};
struct File {
  std::string verb;  ///< "save", "open" or "export"
  std::string file;
  bool replaces = false;     ///< "open": a mesh takes the place of what is open
  std::string objects = {};  ///< "export" of meshes: "picked" (also when empty), "visible" or "all"
  std::string unit = {};     ///< … and the unit of the file's lengths; empty: the document's
  bool traces = false;       ///< "open": a picture's lines become strokes

  static const StepKind& step_kind();
};
struct Click {
  std::string view = "sketch";
  Vec2 at = Vec2::Zero();
  std::vector<std::string> modifiers;  ///< of "shift", "ctrl", "alt", "super"
  ModelPlace place = {};               ///< instead of `at`
  int clicks = 1;                      ///< 2: a double click

  static const StepKind& step_kind();
};
struct Box {
  std::string view = "sketch";
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  std::vector<std::string> modifiers;
  ModelPlace from_place = {};  ///< both places or none; instead of `from` …
  ModelPlace to_place = {};    ///< … and `to`

  static const StepKind& step_kind();
};
struct Navigate {
  std::string view = "perspective";
  std::string motion;      ///< "tumble", "track" or "dolly"
  Vec2 by = Vec2::Zero();  ///< pixels of a view 1000 pixels high, y down; of a dolly only x and y's sum matters

  static const StepKind& step_kind();
};
/// Objects or steps of their chains were selected.
struct NodeChoice {
  std::vector<std::string> nodes;  ///< their names, at least one

  static const StepKind& step_kind();
};
/// Faces were selected by the names of their sets.
struct FaceSetChoice {
  std::string node;                ///< the object's name
  std::vector<std::string> names;  ///< "patches", "patch of hole 3" …

  static const StepKind& step_kind();
};
/// Objects were moved, rotated or scaled.
struct Place {
  std::vector<std::string> nodes;  ///< the objects' names, at least one
  std::vector<Placement> places;   ///< of each: where it stands now

  static const StepKind& step_kind();
};
/// Fails the replay when it isn't so.
struct Expect {
  std::string what;  ///< one of the vocabulary's counts or ranges
  std::int64_t count = 0;
  std::optional<double> value = {};  ///< of a range instead of a count: all are that …
  std::optional<double> to = {};     ///< … or the greatest is this, if `value` is to be the smallest
  std::string node = {};             ///< whose result is meant; empty for the object worked on

  static const StepKind& step_kind();
};

/// All of them, and what can be counted of every document: objects, findings, selected elements, elements of a mesh.
const Vocabulary& general_steps();

}  // namespace croquis::recorded
