// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/silhouette/sketch_steps.h"

#include <algorithm>
#include <iterator>

#include "croquis/base/text.h"

namespace croquis::recorded {
namespace {

/// A place, and where they are known the pressure and the time.
StrokeSample sample_of(const std::vector<double>& numbers) {
  if (numbers.size() < 2 || numbers.size() > 4) throw Mistake{"a point is [x, y], [x, y, pressure] or with its time"};
  StrokeSample sample;
  sample.position = {numbers[0], numbers[1]};
  if (numbers.size() > 2) sample.pressure = numbers[2];
  if (numbers.size() > 3) sample.time = numbers[3];
  if (sample.pressure < 0 || sample.pressure > 1) throw Mistake{"a point's pressure must be within 0 and 1"};
  return sample;
}

}  // namespace

void StrokeDrawn::describe(Fields& fields) {
  fields.given("view", view);
  std::vector<std::vector<double>> numbers;
  for (const StrokeSample& sample : points)
    numbers.push_back({sample.position.x(), sample.position.y(), sample.pressure, sample.time});
  fields.required("points", numbers);
  if (fields.reads()) std::ranges::transform(numbers, std::back_inserter(points), sample_of);
  fields.given("device", device, Words{"mouse", "pen", "eraser"});
  std::optional<double> units = scale > 0 ? std::optional(scale) : std::nullopt;
  fields.seldom("scale", units);
  fields.require(!units || *units > 0, "\"scale\" must be a number above 0");
  scale = units.value_or(0);
  fields.seldom("behind", behind);
  fields.seldom("tube", tube);
  fields.seldom("mirror", mirror);
  fields.require(!tube || *tube > 0, "\"tube\" must be a number above 0");
}

void StrokeReading::describe(Fields& fields) {
  fields.required("stroke", stroke);
  std::optional<std::string> word;
  if (kind) word = silhouette::to_string(*kind);
  fields.seldom("kind", word);
  if (word) kind = silhouette::stroke_kind(*word);
  fields.require(kind || !word,
                 "\"kind\" must be contour, part, hole, blob, detail, scribble, tube, ignored or visible");
  fields.seldom("in-front-of", in_front_of);
  fields.seldom("thickness", thickness);
  fields.require(!thickness || *thickness > 0, "\"thickness\" must be a number above 0");
  fields.seldom("title", title);
  std::optional<std::string> copy;
  if (far_copy) copy = *far_copy ? silhouette::copy_far : "";
  fields.seldom("copy", copy);
  fields.require(!copy || copy->empty() || *copy == silhouette::copy_far, "\"copy\" must be far, or empty for none");
  if (copy) far_copy = !copy->empty();
  fields.seldom("over", over);
  fields.seldom("fill", fill);
  fields.seldom("mirror", mirror);
  double axis = 0;
  fields.require(!mirror || mirror->empty() || read_number(*mirror, axis),
                 "\"mirror\" must be a number, or empty for none");
  const int given = kind.has_value() + in_front_of.has_value() + thickness.has_value() + title.has_value() +
                    far_copy.has_value() + over.has_value() + fill.has_value() + mirror.has_value();
  fields.require(
      given == 1,
      "one of \"kind\", \"in-front-of\", \"thickness\", \"title\", \"copy\", \"over\", \"fill\" and \"mirror\" is set");
}

void ReadingChosen::describe(Fields& fields) {
  std::vector<std::string> words;
  for (const auto& row : says) words.insert(words.end(), row.begin(), row.end());
  fields.required("says", words);
  if (!fields.reads()) return;
  fields.require(words.size() % 3 == 0, "\"says\" must be a stroke, a key and a value, and so on");
  for (std::size_t i = 0; i < words.size(); i += 3) says.push_back({words[i], words[i + 1], words[i + 2]});
}

const Vocabulary& sketch_steps() {
  static const Vocabulary vocabulary = vocabulary_of<StrokeDrawn, Drag, StrokeReading, ReadingChosen>(
      {"strokes", "strokes-behind", "inner-holes", "inner-parts", "crossings-in-view", "joined-pairs", "resting-pairs",
       "details", "tubes", "left-out"});
  return vocabulary;
}

}  // namespace croquis::recorded
