// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording/general_steps.h"

#include <algorithm>

namespace croquis::recorded {
namespace {

Action read_action(Fields& fields) { return {fields.text("name")}; }
void write_action(const Action& step, FieldWriter& writer) { writer.text("name", step.name); }

Set read_set(Fields& fields) { return {fields.text("node"), fields.text("parameter"), fields.value("value")}; }

void write_set(const Set& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.text("parameter", step.parameter);
  writer.value("value", step.value);
}

Wait read_wait(Fields& fields) { return {fields.text("for")}; }
void write_wait(const Wait& step, FieldWriter& writer) { writer.text("for", step.what); }

Screenshot read_screenshot(Fields& fields) { return {fields.text("file")}; }
void write_screenshot(const Screenshot& step, FieldWriter& writer) { writer.text("file", step.file); }

File read_file_step(Fields& fields) {
  File step{fields.verb(), fields.text("file")};
  if (step.verb == "open" && fields.has("replaces")) step.replaces = fields.flag("replaces");
  if (step.verb == "open" && fields.has("traces")) step.traces = fields.flag("traces");
  if (step.verb != "export") return step;
  if (fields.has("objects")) step.objects = fields.one_of("objects", {"picked", "visible", "all"});
  if (fields.has("unit")) step.unit = fields.one_of("unit", {"mm", "cm", "m", "in"});
  return step;
}

void write_file_step(const File& step, FieldWriter& writer) {
  writer.verb(step.verb);
  writer.text("file", step.file);
  if (step.replaces) writer.flag("replaces", true);
  if (step.traces) writer.flag("traces", true);
  if (!step.objects.empty()) writer.text("objects", step.objects);
  if (!step.unit.empty()) writer.text("unit", step.unit);
}

Click read_click(Fields& fields) {
  Click step;
  step.view = fields.text("view", step.view);
  fields.place("at", step.at, step.place);
  if (fields.has("clicks")) step.clicks = static_cast<int>(fields.count("clicks"));
  if (step.clicks < 1 || step.clicks > 2) throw Mistake{"\"clicks\" must be 1 or 2"};
  step.modifiers = fields.modifiers();
  return step;
}

void write_click(const Click& step, FieldWriter& writer) {
  writer.text("view", step.view);
  writer.place("at", step.at, step.place);
  if (step.clicks != 1) writer.count("clicks", step.clicks);
  writer.modifiers(step.modifiers);
}

Box read_box(Fields& fields) {
  Box step;
  step.view = fields.text("view", step.view);
  fields.place("from", step.from, step.from_place);
  fields.place("to", step.to, step.to_place);
  if (step.from_place.has_value() != step.to_place.has_value())
    throw Mistake{"\"from\" and \"to\" must both have two numbers, or both three"};
  step.modifiers = fields.modifiers();
  return step;
}

void write_box(const Box& step, FieldWriter& writer) {
  writer.text("view", step.view);
  writer.place("from", step.from, step.from_place);
  writer.place("to", step.to, step.to_place);
  writer.modifiers(step.modifiers);
}

Navigate read_navigate(Fields& fields) {
  Navigate step;
  step.view = fields.text("view", step.view);
  step.motion = fields.one_of("motion", {"tumble", "track", "dolly"});
  step.by = fields.pair("by");
  return step;
}

void write_navigate(const Navigate& step, FieldWriter& writer) {
  writer.text("view", step.view);
  writer.text("motion", step.motion);
  writer.pair("by", step.by);
}

Expect read_expect(Fields& fields) {
  const std::vector<std::string>& ranges = fields.vocabulary().ranges();
  std::vector<std::string> names = fields.vocabulary().counts();
  names.insert(names.end(), ranges.begin(), ranges.end());
  Expect step;
  step.what = fields.one_of("what", names);
  step.node = fields.text("node", "");
  if (std::find(ranges.begin(), ranges.end(), step.what) == ranges.end()) {
    step.count = fields.count("count");
    return step;
  }
  step.value = fields.number("value");
  if (fields.has("to")) step.to = fields.number("to");
  return step;
}

void write_expect(const Expect& step, FieldWriter& writer) {
  writer.text("what", step.what);
  if (step.value) writer.number("value", *step.value);
  if (step.to) writer.number("to", *step.to);
  if (!step.value) writer.count("count", step.count);
  if (!step.node.empty()) writer.text("node", step.node);
}

NodeChoice read_nodes(Fields& fields) { return {fields.names("nodes")}; }

void write_nodes(const NodeChoice& step, FieldWriter& writer) { writer.names("nodes", step.nodes); }

Place read_place(Fields& fields) {
  Place step{fields.names("nodes"), {}};
  for (const std::vector<double>& numbers : fields.number_lists("places")) {
    if (numbers.size() != 9) throw Mistake{"a place has 9 numbers: position, rotation and scale"};
    const Eigen::Map<const Eigen::Matrix3d> columns(numbers.data());
    step.places.push_back({columns.col(0), columns.col(1), columns.col(2)});
    if (!is_valid(step.places.back())) throw Mistake{"the scales of a place must be above 0"};
  }
  if (step.places.size() != step.nodes.size()) throw Mistake{"there must be as many \"places\" as \"nodes\""};
  return step;
}

void write_place(const Place& step, FieldWriter& writer) {
  writer.names("nodes", step.nodes);
  std::vector<std::vector<double>> places;
  for (const Placement& place : step.places) {
    places.emplace_back();
    for (const Vec3& numbers : {place.position, place.rotation, place.scale})
      places.back().insert(places.back().end(), numbers.begin(), numbers.end());
  }
  writer.number_lists("places", places);
}

FaceSetChoice read_face_set(Fields& fields) { return {fields.text("node"), fields.names("names")}; }

void write_face_set(const FaceSetChoice& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.names("names", step.names);
}

}  // namespace

const StepKind& Action::step_kind() {
  static const StepKind kind = make_step_kind({"action"}, read_action, write_action);
  return kind;
}

const StepKind& Set::step_kind() {
  static const StepKind kind = make_step_kind({"set"}, read_set, write_set);
  return kind;
}

const StepKind& Wait::step_kind() {
  static const StepKind kind = make_step_kind({"wait"}, read_wait, write_wait);
  return kind;
}

const StepKind& Screenshot::step_kind() {
  static const StepKind kind = make_step_kind({"screenshot"}, read_screenshot, write_screenshot);
  return kind;
}

const StepKind& File::step_kind() {
  static const StepKind kind = make_step_kind({"save", "open", "export"}, read_file_step, write_file_step);
  return kind;
}

const StepKind& Click::step_kind() {
  static const StepKind kind = make_step_kind({"click"}, read_click, write_click);
  return kind;
}

const StepKind& Box::step_kind() {
  static const StepKind kind = make_step_kind({"box"}, read_box, write_box);
  return kind;
}

const StepKind& Navigate::step_kind() {
  static const StepKind kind = make_step_kind({"navigate"}, read_navigate, write_navigate);
  return kind;
}

const StepKind& Expect::step_kind() {
  static const StepKind kind = make_step_kind({"expect"}, read_expect, write_expect);
  return kind;
}

const StepKind& FaceSetChoice::step_kind() {
  static const StepKind kind = make_step_kind({"face-set"}, read_face_set, write_face_set);
  return kind;
}

const StepKind& NodeChoice::step_kind() {
  static const StepKind kind = make_step_kind({"select"}, read_nodes, write_nodes);
  return kind;
}

const StepKind& Place::step_kind() {
  static const StepKind kind = make_step_kind({"place"}, read_place, write_place);
  return kind;
}

const Vocabulary& general_steps() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    for (const StepKind* kind :
         {&Action::step_kind(), &Set::step_kind(), &Wait::step_kind(), &Screenshot::step_kind(), &File::step_kind(),
          &Click::step_kind(), &Box::step_kind(), &Navigate::step_kind(), &Expect::step_kind(),
          &FaceSetChoice::step_kind(), &NodeChoice::step_kind(), &Place::step_kind()}) {
      made.add(*kind);
    }
    for (const char* count : {"objects", "findings", "faces", "vertices", "edges", "selected"}) made.add_count(count);
    return made;
  }();
  return vocabulary;
}

}  // namespace croquis::recorded
