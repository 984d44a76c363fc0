// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/measure/measure_steps.h"

#include "croquis/tools/measure/measure_tool.h"

namespace croquis::recorded {
namespace {

Measure read_measure(Fields& fields) {
  Measure step;
  for (const std::vector<double>& place : fields.number_lists("places")) {
    if (place.size() != 3) throw Mistake{"\"places\" must be a list of places of three numbers"};
    step.places.emplace_back(place[0], place[1], place[2]);
  }
  if (step.places.size() > MeasureTool::most_places) throw Mistake{"\"places\" may hold three places at most"};
  return step;
}

void write_measure(const Measure& step, FieldWriter& writer) {
  std::vector<std::vector<double>> places;
  for (const Vec3& place : step.places) places.push_back({place.x(), place.y(), place.z()});
  writer.number_lists("places", places);
}

}  // namespace

const StepKind& Measure::step_kind() {
  static const StepKind kind = make_step_kind({"measure"}, read_measure, write_measure);
  return kind;
}

const Vocabulary& measure_steps() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    made.add(Measure::step_kind());
    made.add_range("measured");
    return made;
  }();
  return vocabulary;
}

}  // namespace croquis::recorded
