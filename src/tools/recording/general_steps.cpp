// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording/general_steps.h"

#include <algorithm>

namespace croquis::recorded {

void File::describe(Fields& fields) {
  fields.required("do", verb);
  fields.required("file", file);
  if (verb == "open") {
    fields.seldom("replaces", replaces);
    fields.seldom("traces", traces);
  } else if (verb == "export") {
    fields.seldom("objects", objects, Words{"picked", "visible", "all"});
    fields.seldom("unit", unit, Words{"mm", "cm", "m", "in"});
  }
}

void Click::describe(Fields& fields) {
  fields.given("view", view);
  fields.place("at", at, place);
  if (fields.reads() || clicks != 1) fields.given("clicks", clicks);
  fields.require(clicks >= 1 && clicks <= 2, "\"clicks\" must be 1 or 2");
  fields.modifiers(modifiers);
}

void Box::describe(Fields& fields) {
  fields.given("view", view);
  fields.place("from", from, from_place);
  fields.place("to", to, to_place);
  fields.require(from_place.has_value() == to_place.has_value(),
                 "\"from\" and \"to\" must both have two numbers, or both three");
  fields.modifiers(modifiers);
}

void Navigate::describe(Fields& fields) {
  fields.given("view", view);
  fields.required("motion", motion, Words{"tumble", "track", "dolly"});
  fields.required("by", by);
}

void Place::describe(Fields& fields) {
  fields.required("nodes", nodes);
  std::vector<std::vector<double>> lists;
  for (const Placement& placement : places) {
    lists.emplace_back();
    for (const Vec3& numbers : {placement.position, placement.rotation, placement.scale})
      lists.back().insert(lists.back().end(), numbers.begin(), numbers.end());
  }
  fields.required("places", lists);
  places.clear();
  for (const std::vector<double>& numbers : lists) {
    fields.require(numbers.size() == 9, "a place has 9 numbers: position, rotation and scale");
    const Eigen::Map<const Eigen::Matrix3d> columns(numbers.data());
    places.push_back({columns.col(0), columns.col(1), columns.col(2)});
    fields.require(is_valid(places.back()), "the scales of a place must be above 0");
  }
  fields.require(places.size() == nodes.size(), "there must be as many \"places\" as \"nodes\"");
}

void Expect::describe(Fields& fields) {
  const Words ranges = fields.reads() ? fields.vocabulary().ranges() : Words();
  Words names = fields.reads() ? fields.vocabulary().counts() : Words();
  names.insert(names.end(), ranges.begin(), ranges.end());
  fields.required("what", what, names);
  const bool is_range = fields.reads() ? std::ranges::find(ranges, what) != ranges.end() : value.has_value();
  if (is_range) {
    fields.required("value", value);
    fields.seldom("to", to);
  } else {
    fields.required("count", count);
  }
  fields.seldom("node", node);
}

const Vocabulary& general_steps() {
  static const Vocabulary vocabulary =
      vocabulary_of<Action, Set, Wait, Screenshot, File, Click, Box, Navigate, Expect, FaceSetChoice, NodeChoice,
                    Place>({"objects", "findings", "faces", "vertices", "edges", "selected"});
  return vocabulary;
}

}  // namespace croquis::recorded
