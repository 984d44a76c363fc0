// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/backdrop/backdrop_steps.h"

namespace croquis::recorded {

void BackdropSetting::describe(Fields& fields) {
  fields.required("centre", centre);
  fields.required("scale", scale);
  fields.require(scale > 0, "\"scale\" must be a number above 0");
  fields.given("opacity", opacity);
  fields.require(opacity >= 0 && opacity <= 1, "\"opacity\" must be a number from 0 to 1");
  if (fields.reads() || !visible) fields.given("visible", visible);
}

const Vocabulary& backdrop_steps() {
  static const Vocabulary vocabulary =
      vocabulary_of<BackdropSetting, BackdropRemoval>({"backdrops"}, {"backdrop-scale"});
  return vocabulary;
}

}  // namespace croquis::recorded
