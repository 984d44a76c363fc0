// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/holes/hole_steps.h"

#include <cmath>

namespace croquis::recorded {
namespace {

HoleChoice read_hole(Fields& fields) {
  HoleChoice step;
  if (fields.has("up-to")) {
    step.action = fields.one_of("action", {"fill"});
    step.up_to = fields.number("up-to");
    if (!(*step.up_to > 0)) throw Mistake{"\"up-to\" must be greater than 0"};
    step.node = fields.text("node", "");
    return step;
  }
  step.holes = fields.has("hole") ? std::vector<Index>{fields.index("hole")} : fields.indices("holes");
  if (fields.has("action"))
    step.action = fields.one_of("action", {"select", "add", "remove", "toggle", "fill", "leave"});
  if (step.holes.empty() && step.action != "select")
    throw Mistake{"\"holes\" must name a hole for \"" + step.action + "\""};
  step.node = fields.text("node", "");
  return step;
}

void write_hole(const HoleChoice& step, FieldWriter& writer) {
  if (!step.up_to) writer.indices("holes", step.holes);
  writer.text("action", step.action);
  if (step.up_to) writer.number("up-to", *step.up_to);
  if (!step.node.empty()) writer.text("node", step.node);
}

HoleWay read_hole_way(Fields& fields) {
  HoleWay step{fields.has("holes") ? fields.indices("holes") : std::vector<Index>{}};
  if (fields.has("fairness")) step.fairness = fields.one_of("fairness", {"auto", "rbf", "smooth", "flat"});
  if (fields.has("kernel")) step.kernel = fields.text("kernel");
  if (fields.has("bulge")) step.bulge = fields.number("bulge");
  if (fields.has("trim-rim")) step.trim_rim = fields.count("trim-rim");
  if (step.bulge && std::abs(*step.bulge) > 1) throw Mistake{"\"bulge\" must be from -1 to 1"};
  if (!step.fairness && !step.kernel && !step.bulge && !step.trim_rim)
    throw Mistake{"\"fairness\", \"kernel\", \"bulge\" or \"trim-rim\" is missing"};
  step.node = fields.text("node", "");
  return step;
}

void write_hole_way(const HoleWay& step, FieldWriter& writer) {
  writer.indices("holes", step.holes);
  if (step.fairness) writer.text("fairness", *step.fairness);
  if (step.kernel) writer.text("kernel", *step.kernel);
  if (step.bulge) writer.number("bulge", *step.bulge);
  if (step.trim_rim) writer.count("trim-rim", *step.trim_rim);
  if (!step.node.empty()) writer.text("node", step.node);
}

HolePoint read_hole_point(Fields& fields) {
  HolePoint step{fields.index("hole"), fields.model_place("from"), fields.model_place("to"), fields.text("node", "")};
  if (!step.from && !step.to) throw Mistake{"\"from\", \"to\" or both are missing"};
  return step;
}

void write_hole_point(const HolePoint& step, FieldWriter& writer) {
  writer.count("hole", step.hole);
  if (step.from) writer.triple("from", *step.from);
  if (step.to) writer.triple("to", *step.to);
  if (!step.node.empty()) writer.text("node", step.node);
}

}  // namespace

const StepKind& HoleChoice::step_kind() {
  static const StepKind kind = make_step_kind({"hole"}, read_hole, write_hole);
  return kind;
}

const StepKind& HoleWay::step_kind() {
  static const StepKind kind = make_step_kind({"hole-way"}, read_hole_way, write_hole_way);
  return kind;
}

const StepKind& HolePoint::step_kind() {
  static const StepKind kind = make_step_kind({"hole-point"}, read_hole_point, write_hole_point);
  return kind;
}

const Vocabulary& hole_steps() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    made.add(HoleChoice::step_kind());
    made.add(HoleWay::step_kind());
    made.add(HolePoint::step_kind());
    made.add_count("holes");
    made.add_count("patches");
    return made;
  }();
  return vocabulary;
}

}  // namespace croquis::recorded
