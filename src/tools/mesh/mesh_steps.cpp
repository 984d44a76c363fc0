// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_steps.h"

#include "croquis/base/error.h"

namespace croquis::recorded {
namespace {

EditLine edit_line_of(const std::string& text) {
  std::vector<EditLine> lines;
  try {
    lines = parse_edit_lines(text);
  } catch (const Error& error) {
    std::string sentence = error.findings().front().message;
    if (sentence.ends_with('.')) sentence.pop_back();
    throw Mistake{sentence};
  }
  if (lines.size() != 1) throw Mistake{"\"line\" must hold one edit"};
  return lines.front();
}

}  // namespace

void ModelDrag::describe(Fields& fields) {
  fields.given("view", view);
  fields.required("from", from);
  fields.required("to", to);
  fields.modifiers(modifiers);
}

void Pick::describe(Fields& fields) {
  fields.required("node", node);
  fields.required("kind", kind, Words{"vertex", "edge", "face"});
  fields.required("elements", elements);
  fields.given("how", how,
               Words{"replace", "add", "remove", "toggle", "loop", "ring", "path", "connected", "chain", "all"});
}

void EditStep::describe(Fields& fields) {
  fields.required("node", node);
  std::string text = fields.reads() ? std::string() : to_text(line);
  fields.required("line", text);
  if (fields.reads()) line = edit_line_of(text);
  fields.seldom("again", again);
}

void Rotate::describe(Fields& fields) {
  fields.required("node", node);
  fields.required("axis", axis);
  fields.required("degrees", degrees);
  fields.seldom("pivot", pivot);
  fields.require(!axis.isZero(0), "\"axis\" may not be zero");
}

void Tag::describe(Fields& fields) {
  fields.required("node", node);
  fields.given("edges", edges, Words{"selected", "boundary", "tagged", "sharper-than"});
  if (edges == "sharper-than") fields.required("degrees", degrees);
  fields.seldom("change", change);
  if (!fields.reads() || !change) fields.required("sharpness", sharpness, OrInfinite());
}

void TagSet::describe(Fields& fields) {
  fields.required("node", node);
  fields.required("how", how, Words{"make", "rename", "sharpness", "select", "merge", "remove", "untag"});
  fields.required("name", name);
  if (how == "rename" || how == "merge") fields.required("other", other);
  if (how == "sharpness") fields.required("sharpness", sharpness, OrInfinite());
  if (how == "make") fields.seldom("sharpness", sharpness, OrInfinite());
}

void LoopCut::describe(Fields& fields) {
  fields.required("node", node);
  fields.required("edge", edge);
  fields.given("at", at);
  fields.require(at > 0 && at < 1, "\"at\" must be between 0 and 1");
}

const Vocabulary& mesh_steps() {
  static const Vocabulary vocabulary =
      vocabulary_of<ModelDrag, Pick, EditStep, Move, Rotate, Scale, Tag, Pin, TagSet, Extrude, LoopCut>({"sharp-edges"},
                                                                                                        {"dihedral"});
  return vocabulary;
}

}  // namespace croquis::recorded
