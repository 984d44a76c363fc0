// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/silhouette/sketch_steps.h"

namespace croquis::recorded {
namespace {

std::vector<StrokeSample> read_points(Fields& fields) {
  std::vector<StrokeSample> points;
  for (const std::vector<double>& numbers : fields.number_lists("points")) {
    if (numbers.size() < 2 || numbers.size() > 4) throw Mistake{"a point is [x, y], [x, y, pressure] or with its time"};
    StrokeSample sample;
    sample.position = {numbers[0], numbers[1]};
    if (numbers.size() > 2) sample.pressure = numbers[2];
    if (numbers.size() > 3) sample.time = numbers[3];
    if (sample.pressure < 0 || sample.pressure > 1) throw Mistake{"a point's pressure must be within 0 and 1"};
    points.push_back(sample);
  }
  return points;
}

StrokeDrawn read_stroke(Fields& fields) {
  StrokeDrawn step;
  step.view = fields.text("view", step.view);
  step.points = read_points(fields);
  if (fields.has("device")) step.device = fields.one_of("device", {"mouse", "pen", "eraser"});
  if (fields.has("scale")) {
    step.scale = fields.number("scale");
    if (!(step.scale > 0)) throw Mistake{"\"scale\" must be a number above 0"};
  }
  if (fields.has("behind")) step.behind = fields.flag("behind");
  return step;
}

void write_stroke(const StrokeDrawn& step, FieldWriter& writer) {
  std::vector<std::vector<double>> points;
  for (const StrokeSample& sample : step.points)
    points.push_back({sample.position.x(), sample.position.y(), sample.pressure, sample.time});
  writer.text("view", step.view);
  writer.number_lists("points", points);
  writer.text("device", step.device);
  if (step.scale > 0) writer.number("scale", step.scale);
  if (step.behind) writer.flag("behind", true);
}

Drag read_drag(Fields& fields) {
  Drag step;
  step.stroke = fields.text("stroke");
  if (fields.has("anchor")) step.anchor = static_cast<std::size_t>(fields.count("anchor"));
  step.by = fields.pair("by");
  return step;
}

void write_drag(const Drag& step, FieldWriter& writer) {
  writer.text("stroke", step.stroke);
  if (step.anchor) writer.count("anchor", static_cast<std::int64_t>(*step.anchor));
  writer.pair("by", step.by);
}

StrokeReading read_setting(Fields& fields) {
  StrokeReading step;
  step.stroke = fields.text("stroke");
  if (fields.has("kind")) {
    step.kind = silhouette::stroke_kind(fields.text("kind"));
    if (!step.kind)
      throw Mistake{"\"kind\" must be contour, part, hole, blob, detail, scribble, tube, ignored or visible"};
  }
  if (fields.has("in-front-of")) step.in_front_of = fields.text("in-front-of");
  if (fields.has("thickness")) {
    step.thickness = fields.number("thickness");
    if (!(*step.thickness > 0)) throw Mistake{"\"thickness\" must be a number above 0"};
  }
  const int settings = step.kind.has_value() + step.in_front_of.has_value() + step.thickness.has_value();
  if (settings != 1) throw Mistake{"one of \"kind\", \"in-front-of\" and \"thickness\" is set"};
  return step;
}

void write_setting(const StrokeReading& step, FieldWriter& writer) {
  writer.text("stroke", step.stroke);
  if (step.kind) writer.text("kind", silhouette::to_string(*step.kind));
  if (step.in_front_of) writer.text("in-front-of", *step.in_front_of);
  if (step.thickness) writer.number("thickness", *step.thickness);
}

}  // namespace

const StepKind& StrokeDrawn::step_kind() {
  static const StepKind kind = make_step_kind({"stroke"}, read_stroke, write_stroke);
  return kind;
}

const StepKind& Drag::step_kind() {
  static const StepKind kind = make_step_kind({"drag"}, read_drag, write_drag);
  return kind;
}

const StepKind& StrokeReading::step_kind() {
  static const StepKind kind = make_step_kind({"stroke-set"}, read_setting, write_setting);
  return kind;
}

const Vocabulary& sketch_steps() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    made.add(StrokeDrawn::step_kind());
    made.add(Drag::step_kind());
    made.add(StrokeReading::step_kind());
    for (const char* name : {"strokes", "strokes-behind", "inner-holes", "inner-parts", "crossings-in-view",
                             "joined-pairs", "resting-pairs", "details", "tubes", "left-out"})
      made.add_count(name);
    return made;
  }();
  return vocabulary;
}

}  // namespace croquis::recorded
