// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/perspective_steps.h"

#include <algorithm>
#include <numbers>

#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/perspective/stroke_shape.h"

namespace croquis::recorded {
namespace {

const Words group_words = {"x", "y", "z", "normal-x", "normal-y", "normal-z", "unknown"};
const Words role_words(stroke_role_words.begin(), stroke_role_words.end());
const Words lock_words(end_lock_words.begin(), end_lock_words.end());
const Words axis_words = {"x", "y", "z"};

constexpr double degree_in_radians = std::numbers::pi / 180;

void describe_groups(Fields& fields, std::vector<StrokeGroup>& groups) {
  std::vector<std::string> words;
  for (const StrokeGroup group : groups) words.push_back(group_words[static_cast<std::size_t>(group)]);
  fields.required("groups", words);
  groups.clear();
  for (const std::string& word : words) {
    const auto found = std::ranges::find(group_words, word);
    if (found == group_words.end()) throw Mistake{"\"groups\" has \"" + word + "\", which is no group"};
    groups.push_back(static_cast<StrokeGroup>(found - group_words.begin()));
  }
}

/// Eight numbers for each piece; a line has its two ends.
std::vector<double> curve_numbers(const PerspectiveStroke& stroke) {
  std::vector<Vec2> places;
  if (stroke.straight) places = {stroke.start(), stroke.end()};
  for (const PictureCubic& piece : stroke.straight ? std::vector<PictureCubic>() : stroke.pieces)
    places.insert(places.end(), piece.begin(), piece.end());
  std::vector<double> numbers;
  for (const Vec2& place : places) numbers.insert(numbers.end(), {place.x(), place.y()});
  return numbers;
}

PerspectiveStroke stroke_of_numbers(const std::vector<double>& numbers) {
  PerspectiveStroke stroke;
  stroke.hidden = true;
  stroke.straight = numbers.size() == 4;
  if (stroke.straight) {
    stroke.pieces = {line_piece({numbers[0], numbers[1]}, {numbers[2], numbers[3]})};
    return stroke;
  }
  if (numbers.empty() || numbers.size() % 8 != 0)
    throw Mistake{"\"curves\" must be lists of 4 numbers for a line, or of 8 for each piece of a curve"};
  for (std::size_t i = 0; i < numbers.size(); i += 8) {
    PictureCubic piece;
    for (std::size_t k = 0; k < 4; ++k) piece[k] = {numbers[i + 2 * k], numbers[i + 2 * k + 1]};
    stroke.pieces.push_back(piece);
  }
  return stroke;
}

/// Fields that people set; what is read becomes part of the setting.
void describe_fields(Fields& fields, StrokeSetting& setting) {
  for (const StrokeField& field : stroke_fields) {
    if (field.verb == nullptr) continue;
    std::string name = field.name;
    std::ranges::replace(name, '_', '-');
    const auto exchange = [&]<typename T>(T PerspectiveStroke::*) {
      std::optional<T> value;
      if (const auto given = setting.fields.find(field.name); given != setting.fields.end())
        value = std::get<T>(given->second);
      if constexpr (std::is_same_v<T, EndLock>) {
        fields.seldom(name, value, lock_words);
      } else {
        fields.seldom(name, value);
      }
      if (value) setting.fields[field.name] = *value;
    };
    std::visit(exchange, field.member);
  }
}

}  // namespace

void SheetStroke::describe(Fields& fields) {
  fields.required("points", points);
  fields.seldom("group", group, group_words);
  fields.given("role", role, role_words);
  fields.seldom("erases", erases);
  fields.given("scale", scale);
  if (fields.reads() ? fields.has("groups") : !groups.empty()) describe_groups(fields, groups);
  fields.require(scale > 0, "\"scale\" must be a number above 0");
}

void SheetAim::describe(Fields& fields) {
  fields.required("axis", axis, axis_words);
  fields.required("at", at);
}

void SheetSetting::describe(Fields& fields) {
  fields.required("strokes", strokes);
  fields.seldom("group", setting.group, group_words);
  fields.seldom("role", setting.role, role_words);
  describe_fields(fields, setting);
  const auto weight = setting.fields.find("weight");
  fields.require(weight == setting.fields.end() || std::get<double>(weight->second) > 0,
                 "\"weight\" must be a number above 0");
  fields.require(setting.any(), "nothing is set: give \"group\", \"role\", \"hidden\" or another setting");
}

void SheetSize::describe(Fields& fields) {
  fields.required("size", size);
  fields.require(size.minCoeff() > 0, "\"size\" must be two numbers above 0");
}

void SheetPoint::describe(Fields& fields) {
  if (fields.reads() && fields.has("at")) known.emplace();
  if (!known) return;
  fields.required("at", known->at);
  fields.required("point", known->point);
}

void SheetUnit::describe(Fields& fields) {
  Words words = length_units();
  words.emplace_back();
  fields.required("unit", unit, words);
}

void SheetFaces::describe(Fields& fields) {
  fields.seldom("required", required);
  fields.seldom("forbidden", forbidden);
  fields.require(!required.empty() || !forbidden.empty(), "no face is \"required\" or \"forbidden\"");
}

void SheetCamera::describe(Fields& fields) {
  std::optional<double> degrees;
  if (field_of_view) degrees = *field_of_view / degree_in_radians;
  fields.seldom("field-of-view", degrees);
  fields.require(!degrees || (*degrees > 0 && *degrees < 180),
                 "\"field-of-view\" must be above 0 and below 180 degrees");
  if (degrees) field_of_view = *degrees * degree_in_radians;
  fields.seldom("principal", principal_point);
}

void SheetChoice::describe(Fields& fields) {
  fields.required("list", list, Words{"faces", "no-faces", "ignore", "sharp"});
  fields.required("item", item);
  fields.given("on", on);
}

void SheetMirror::describe(Fields& fields) {
  fields.required("axis", plane.axis, axis_words);
  fields.required("at", plane.at);
  if (fields.reads() ? !fields.has("curves") : strokes.empty()) return;
  std::vector<std::vector<double>> curves;
  std::vector<StrokeGroup> groups;
  for (const PerspectiveStroke& stroke : strokes) {
    curves.push_back(curve_numbers(stroke));
    groups.push_back(stroke.group);
  }
  fields.required("curves", curves);
  strokes.clear();
  for (const std::vector<double>& numbers : curves) strokes.push_back(stroke_of_numbers(numbers));
  describe_groups(fields, groups);
  fields.require(groups.size() == strokes.size(), "\"groups\" must name a group for each of \"curves\"");
  for (std::size_t i = 0; i < groups.size(); ++i) strokes[i].group = groups[i];
}

const Vocabulary& perspective_steps() {
  static const Vocabulary vocabulary =
      vocabulary_of<SheetStroke, SheetDrag, SheetAim, SheetSetting, SheetDelete, SheetSize, SheetPoint, SheetLength,
                    SheetCamera, SheetChoice, SheetMirror, SheetUnit, SheetFaces>(
          {"perspective-strokes", "perspective-faces", "perspective-open", "perspective-closed", "perspective-mode",
           "perspective-fixes"},
          {"perspective-residual"});
  return vocabulary;
}

}  // namespace croquis::recorded
