// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/edits/edit_line.h"
#include "croquis/tools/recording/vocabulary.h"

/// Steps on meshes: by the name of the source node, elements by their numbers (edges: MeshTopology's). A mesh tool does
/// them to the mesh that it works on, whatever their node is, and records the name of that mesh's node.
namespace croquis::recorded {

/// The pointer was dragged between two places of the model as a view shows them: a manipulator's handle, a sharpness.
struct ModelDrag {
  std::string view = "perspective";
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  std::vector<std::string> modifiers;

  static constexpr std::array verbs{"drag"};
  static constexpr const char* mark = "from";  ///< strokes are dragged, too
  void describe(Fields& fields);
};
struct Pick {
  std::string node = {};
  std::string kind = "edge";  ///< "vertex", "edge" or "face"
  std::vector<Index> elements;
  std::string how =
      "replace";  ///< "replace", "add", "remove", "toggle", "loop", "ring", "path", "connected", "chain", "all"

  static constexpr std::array verbs{"pick"};
  void describe(Fields& fields);
};
/// Any edit, of the elements that its line names.
struct EditStep {
  std::string node = {};
  EditLine line;
  bool again = false;  ///< instead of the edit before it, which differs in its parameters

  static constexpr std::array verbs{"edit"};
  void describe(Fields& fields);
};
/// What is selected was moved, turned or scaled.
struct Move {
  std::string node = {};
  Vec3 by = Vec3::Zero();

  static constexpr std::array verbs{"move"};
  void describe(Fields& fields) {
    fields.required("node", node);
    fields.required("by", by);
  }
};
struct Rotate {
  std::string node = {};
  Vec3 axis = Vec3::UnitZ();  ///< not zero
  double degrees = 0;
  ModelPlace pivot = {};  ///< without it the middle of what is selected

  static constexpr std::array verbs{"rotate"};
  void describe(Fields& fields);
};
struct Scale {
  std::string node = {};
  Vec3 factors = {1, 1, 1};
  ModelPlace pivot = {};

  static constexpr std::array verbs{"scale"};
  void describe(Fields& fields) {
    fields.required("node", node);
    fields.required("factors", factors);
    fields.seldom("pivot", pivot);
  }
};
/// Edges got a sharpness, or theirs changed.
struct Tag {
  std::string node = {};
  std::string edges = "selected";        ///< "selected", "boundary", "tagged" or "sharper-than"
  double degrees = 0;                    ///< of "sharper-than"
  std::optional<double> sharpness = {};  ///< this or …
  std::optional<double> change = {};     ///< … that; of the selected edges

  static constexpr std::array verbs{"tag"};
  void describe(Fields& fields);
};
struct Pin {
  std::string node = {};
  bool pinned = true;

  static constexpr std::array verbs{"pin"};
  void describe(Fields& fields) {
    fields.required("node", node);
    fields.given("pinned", pinned);
  }
};
/// A named set of tags.
struct TagSet {
  std::string node = {};
  std::string how = "make";  ///< "make", "rename", "sharpness", "select", "merge", "remove" or "untag"
  std::string name = {};
  std::string other = {};                ///< rename: the new name; merge: the set that is taken in
  std::optional<double> sharpness = {};  ///< make, sharpness

  static constexpr std::array verbs{"tag-set"};
  void describe(Fields& fields);
};
struct Extrude {
  std::string node = {};
  Vec3 by = Vec3::Zero();

  static constexpr std::array verbs{"extrude"};
  void describe(Fields& fields) {
    fields.required("node", node);
    fields.required("by", by);
  }
};
struct LoopCut {
  std::string node = {};
  Index edge = 0;
  double at = 0.5;

  static constexpr std::array verbs{"loop-cut"};
  void describe(Fields& fields);
};

/// All of them, the count of sharp edges and the range of their dihedral angles.
const Vocabulary& mesh_steps();

}  // namespace croquis::recorded
