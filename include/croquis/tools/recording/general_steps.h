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

  static constexpr std::array verbs{"action"};
  void describe(Fields& fields) { fields.required("name", name); }
};
struct Set {
  std::string node;  ///< its name
  std::string parameter;
  ParameterValue value;

  static constexpr std::array verbs{"set"};
  void describe(Fields& fields) {
    fields.required("node", node);
    fields.required("parameter", parameter);
    fields.required("value", value);
  }
};
/// Waits until something is finished.
struct Wait {
  std::string what = "solid";

  static constexpr std::array verbs{"wait"};
  void describe(Fields& fields) { fields.required("for", what); }
};
struct Screenshot {
  std::string file;

  static constexpr std::array verbs{"screenshot"};
  void describe(Fields& fields) { fields.required("file", file); }
};
struct File {
  std::string verb;  ///< "save", "open" or "export"
  std::string file;
  bool replaces = false;     ///< "open": a mesh takes the place of what is open
  std::string objects = {};  ///< "export" of meshes: "picked" (also when empty), "visible" or "all"
  std::string unit = {};     ///< … and the unit of the file's lengths; empty: the document's
  bool traces = false;       ///< "open": a picture's lines become strokes

  static constexpr std::array verbs{"save", "open", "export"};
  void describe(Fields& fields);
};
struct Click {
  std::string view = "sketch";
  Vec2 at = Vec2::Zero();
  std::vector<std::string> modifiers;  ///< of "shift", "ctrl", "alt", "super"
  ModelPlace place = {};               ///< instead of `at`
  int clicks = 1;                      ///< 2: a double click

  static constexpr std::array verbs{"click"};
  void describe(Fields& fields);
};
struct Box {
  std::string view = "sketch";
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
  std::vector<std::string> modifiers;
  ModelPlace from_place = {};  ///< both places or none; instead of `from` …
  ModelPlace to_place = {};    ///< … and `to`

  static constexpr std::array verbs{"box"};
  void describe(Fields& fields);
};
struct Navigate {
  std::string view = "perspective";
  std::string motion;      ///< "tumble", "track" or "dolly"
  Vec2 by = Vec2::Zero();  ///< pixels of a view 1000 pixels high, y down; of a dolly only x and y's sum matters

  static constexpr std::array verbs{"navigate"};
  void describe(Fields& fields);
};
/// Objects or steps of their chains were selected.
struct NodeChoice {
  std::vector<std::string> nodes;  ///< their names, at least one

  static constexpr std::array verbs{"select"};
  void describe(Fields& fields) { fields.required("nodes", nodes); }
};
/// Faces were selected by the names of their sets.
struct FaceSetChoice {
  std::string node;                ///< the object's name
  std::vector<std::string> names;  ///< "patches", "patch of hole 3" …

  static constexpr std::array verbs{"face-set"};
  void describe(Fields& fields) {
    fields.required("node", node);
    fields.required("names", names);
  }
};
/// Objects were moved, rotated or scaled.
struct Place {
  std::vector<std::string> nodes;  ///< the objects' names, at least one
  std::vector<Placement> places;   ///< of each: where it stands now

  static constexpr std::array verbs{"place"};
  void describe(Fields& fields);
};
/// Fails the replay when it isn't so.
struct Expect {
  std::string what;  ///< one of the vocabulary's counts or ranges
  std::int64_t count = 0;
  std::optional<double> value = {};  ///< of a range instead of a count: all are that …
  std::optional<double> to = {};     ///< … or the greatest is this, if `value` is to be the smallest
  std::string node = {};             ///< whose result is meant; empty for the object worked on

  static constexpr std::array verbs{"expect"};
  void describe(Fields& fields);
};

/// All of them, and what can be counted of every document: objects, findings, selected elements, elements of a mesh.
const Vocabulary& general_steps();

}  // namespace croquis::recorded
