// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/backdrop/backdrop_steps.h"

namespace croquis::recorded {
namespace {

BackdropSetting read_backdrop_setting(Fields& fields) {
  BackdropSetting step;
  step.centre = fields.pair("centre");
  step.scale = fields.number("scale");
  if (!(step.scale > 0)) throw Mistake{"\"scale\" must be a number above 0"};
  if (fields.has("opacity")) step.opacity = fields.number("opacity");
  if (!(step.opacity >= 0 && step.opacity <= 1)) throw Mistake{"\"opacity\" must be a number from 0 to 1"};
  if (fields.has("visible")) step.visible = fields.flag("visible");
  return step;
}

void write_backdrop_setting(const BackdropSetting& step, FieldWriter& writer) {
  writer.pair("centre", step.centre);
  writer.number("scale", step.scale);
  writer.number("opacity", step.opacity);
  if (!step.visible) writer.flag("visible", false);
}

BackdropRemoval read_backdrop_removal(Fields&) { return {}; }
void write_backdrop_removal(const BackdropRemoval&, FieldWriter&) {}

}  // namespace

const StepKind& BackdropSetting::step_kind() {
  static const StepKind kind = make_step_kind({"backdrop"}, read_backdrop_setting, write_backdrop_setting);
  return kind;
}

const StepKind& BackdropRemoval::step_kind() {
  static const StepKind kind = make_step_kind({"remove-backdrop"}, read_backdrop_removal, write_backdrop_removal);
  return kind;
}

const Vocabulary& backdrop_steps() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    made.add(BackdropSetting::step_kind());
    made.add(BackdropRemoval::step_kind());
    made.add_count("backdrops");
    made.add_range("backdrop-scale");
    return made;
  }();
  return vocabulary;
}

}  // namespace croquis::recorded
