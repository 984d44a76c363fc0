// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/measure/measure_steps.h"

#include "croquis/tools/measure/measure_tool.h"

namespace croquis::recorded {

void Measure::describe(Fields& fields) {
  fields.required("places", places);
  fields.require(places.size() <= MeasureTool::most_places, "\"places\" may hold three places at most");
}

const Vocabulary& measure_steps() {
  static const Vocabulary vocabulary = vocabulary_of<Measure>({}, {"measured"});
  return vocabulary;
}

}  // namespace croquis::recorded
