// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_steps.h"

#include "croquis/base/error.h"

namespace croquis::recorded {
namespace {

ModelDrag read_model_drag(Fields& fields) {
  ModelDrag step;
  step.view = fields.text("view", step.view);
  step.from = fields.triple("from");
  step.to = fields.triple("to");
  step.modifiers = fields.modifiers();
  return step;
}

void write_model_drag(const ModelDrag& step, FieldWriter& writer) {
  writer.text("view", step.view);
  writer.triple("from", step.from);
  writer.triple("to", step.to);
  writer.modifiers(step.modifiers);
}

Pick read_pick(Fields& fields) {
  static const std::vector<std::string> hows = {"replace", "add",  "remove",    "toggle", "loop",
                                                "ring",    "path", "connected", "chain",  "all"};
  Pick step;
  step.node = fields.text("node");
  step.kind = fields.one_of("kind", {"vertex", "edge", "face"});
  step.elements = fields.indices("elements");
  if (fields.has("how")) step.how = fields.one_of("how", hows);
  return step;
}

void write_pick(const Pick& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.text("kind", step.kind);
  writer.indices("elements", step.elements);
  writer.text("how", step.how);
}

std::vector<EditLine> edit_lines_of(const std::string& text) {
  try {
    return parse_edit_lines(text, all_edits());
  } catch (const Error& error) {
    std::string sentence = error.findings().front().message;
    if (sentence.ends_with('.')) sentence.pop_back();
    throw Mistake{sentence};
  }
}

EditStep read_edit(Fields& fields) {
  EditStep step{fields.text("node"), {}, false};
  std::vector<EditLine> lines = edit_lines_of(fields.text("line"));
  if (lines.size() != 1) throw Mistake{"\"line\" must hold one edit"};
  step.line = std::move(lines.front());
  if (fields.has("again")) step.again = fields.flag("again");
  return step;
}

void write_edit(const EditStep& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.text("line", to_text(step.line));
  if (step.again) writer.flag("again", true);
}

Move read_move(Fields& fields) { return {fields.text("node"), fields.triple("by")}; }

void write_move(const Move& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.triple("by", step.by);
}

Rotate read_rotate(Fields& fields) {
  Rotate step{fields.text("node"), fields.triple("axis"), fields.number("degrees"), fields.model_place("pivot")};
  if (step.axis.isZero(0)) throw Mistake{"\"axis\" may not be zero"};
  return step;
}

void write_rotate(const Rotate& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.triple("axis", step.axis);
  writer.number("degrees", step.degrees);
  if (step.pivot) writer.triple("pivot", *step.pivot);
}

Scale read_scale(Fields& fields) {
  return {fields.text("node"), fields.triple("factors"), fields.model_place("pivot")};
}

void write_scale(const Scale& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.triple("factors", step.factors);
  if (step.pivot) writer.triple("pivot", *step.pivot);
}

Tag read_tag(Fields& fields) {
  Tag step;
  step.node = fields.text("node");
  if (fields.has("edges")) step.edges = fields.one_of("edges", {"selected", "boundary", "tagged", "sharper-than"});
  if (step.edges == "sharper-than") step.degrees = fields.number("degrees");
  if (fields.has("change")) {
    step.change = fields.number("change");
  } else {
    step.sharpness = fields.number_or_infinite("sharpness");
  }
  return step;
}

void write_tag(const Tag& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.text("edges", step.edges);
  if (step.edges == "sharper-than") writer.number("degrees", step.degrees);
  if (step.change) writer.number("change", *step.change);
  if (step.sharpness) writer.number_or_infinite("sharpness", *step.sharpness);
}

Pin read_pin(Fields& fields) {
  Pin step{fields.text("node"), true};
  if (fields.has("pinned")) step.pinned = fields.flag("pinned");
  return step;
}

void write_pin(const Pin& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.flag("pinned", step.pinned);
}

TagSet read_tag_set(Fields& fields) {
  TagSet step;
  step.node = fields.text("node");
  step.how = fields.one_of("how", {"make", "rename", "sharpness", "select", "merge", "remove", "untag"});
  step.name = fields.text("name");
  if (step.how == "rename" || step.how == "merge") step.other = fields.text("other");
  if (step.how == "sharpness" || (step.how == "make" && fields.has("sharpness")))
    step.sharpness = fields.number_or_infinite("sharpness");
  return step;
}

void write_tag_set(const TagSet& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.text("how", step.how);
  writer.text("name", step.name);
  if (!step.other.empty()) writer.text("other", step.other);
  if (step.sharpness) writer.number_or_infinite("sharpness", *step.sharpness);
}

Extrude read_extrude(Fields& fields) { return {fields.text("node"), fields.triple("by")}; }

void write_extrude(const Extrude& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.triple("by", step.by);
}

LoopCut read_loop_cut(Fields& fields) {
  LoopCut step{fields.text("node"), fields.index("edge"), 0.5};
  if (fields.has("at")) step.at = fields.number("at");
  if (!(step.at > 0 && step.at < 1)) throw Mistake{"\"at\" must be between 0 and 1"};
  return step;
}

void write_loop_cut(const LoopCut& step, FieldWriter& writer) {
  writer.text("node", step.node);
  writer.count("edge", step.edge);
  writer.number("at", step.at);
}

}  // namespace

const StepKind& ModelDrag::step_kind() {
  static const StepKind kind = make_step_kind({"drag"}, read_model_drag, write_model_drag, "from");
  return kind;
}

const StepKind& Pick::step_kind() {
  static const StepKind kind = make_step_kind({"pick"}, read_pick, write_pick);
  return kind;
}

const StepKind& EditStep::step_kind() {
  static const StepKind kind = make_step_kind({"edit"}, read_edit, write_edit);
  return kind;
}

const StepKind& Move::step_kind() {
  static const StepKind kind = make_step_kind({"move"}, read_move, write_move);
  return kind;
}

const StepKind& Rotate::step_kind() {
  static const StepKind kind = make_step_kind({"rotate"}, read_rotate, write_rotate);
  return kind;
}

const StepKind& Scale::step_kind() {
  static const StepKind kind = make_step_kind({"scale"}, read_scale, write_scale);
  return kind;
}

const StepKind& Tag::step_kind() {
  static const StepKind kind = make_step_kind({"tag"}, read_tag, write_tag);
  return kind;
}

const StepKind& Pin::step_kind() {
  static const StepKind kind = make_step_kind({"pin"}, read_pin, write_pin);
  return kind;
}

const StepKind& TagSet::step_kind() {
  static const StepKind kind = make_step_kind({"tag-set"}, read_tag_set, write_tag_set);
  return kind;
}

const StepKind& Extrude::step_kind() {
  static const StepKind kind = make_step_kind({"extrude"}, read_extrude, write_extrude);
  return kind;
}

const StepKind& LoopCut::step_kind() {
  static const StepKind kind = make_step_kind({"loop-cut"}, read_loop_cut, write_loop_cut);
  return kind;
}

const Vocabulary& mesh_steps() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    for (const StepKind* kind :
         {&ModelDrag::step_kind(), &Pick::step_kind(), &EditStep::step_kind(), &Move::step_kind(), &Rotate::step_kind(),
          &Scale::step_kind(), &Tag::step_kind(), &Pin::step_kind(), &TagSet::step_kind(), &Extrude::step_kind(),
          &LoopCut::step_kind()}) {
      made.add(*kind);
    }
    made.add_count("sharp-edges");
    made.add_range("dihedral");
    return made;
  }();
  return vocabulary;
}

}  // namespace croquis::recorded
