// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/perspective_steps.h"

#include <algorithm>
#include <numbers>

#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/perspective/stroke_shape.h"

namespace croquis::recorded {
namespace {

const std::vector<std::string> group_words = {"x", "y", "z", "normal-x", "normal-y", "normal-z", "unknown"};
const std::vector<std::string> role_words = {"construction", "edge"};
const std::vector<std::string> lock_words = {"none", "smooth", "corner"};
const std::vector<std::string> axis_words = {"x", "y", "z"};
const std::vector<std::string> list_words = {"faces", "no-faces", "ignore", "sharp"};

constexpr double degree_in_radians = std::numbers::pi / 180;

template <typename T>
std::optional<T> read_sheet_word(Fields& fields, const std::string& name, const std::vector<std::string>& words) {
  if (!fields.has(name)) return std::nullopt;
  return static_cast<T>(std::ranges::find(words, fields.one_of(name, words)) - words.begin());
}

template <typename T>
void write_sheet_word(FieldWriter& writer, const std::string& name, const std::vector<std::string>& words, T value) {
  writer.text(name, words[static_cast<std::size_t>(value)]);
}

std::vector<StrokeGroup> read_sheet_groups(Fields& fields, const std::string& name) {
  std::vector<StrokeGroup> groups;
  for (const std::string& word : fields.names(name)) {
    const auto found = std::ranges::find(group_words, word);
    if (found == group_words.end()) throw Mistake{'"' + name + "\" has \"" + word + "\", which is no group"};
    groups.push_back(static_cast<StrokeGroup>(found - group_words.begin()));
  }
  return groups;
}

void write_sheet_groups(FieldWriter& writer, const std::string& name, const std::vector<StrokeGroup>& groups) {
  std::vector<std::string> words;
  for (const StrokeGroup group : groups) words.push_back(group_words[static_cast<std::size_t>(group)]);
  writer.names(name, words);
}

SheetStroke read_sheet_stroke(Fields& fields) {
  SheetStroke step;
  for (const std::vector<double>& place : fields.number_lists("points")) {
    if (place.size() != 2) throw Mistake{"\"points\" must be a list of places of two numbers"};
    step.points.emplace_back(place[0], place[1]);
  }
  step.group = read_sheet_word<StrokeGroup>(fields, "group", group_words);
  step.role = read_sheet_word<StrokeRole>(fields, "role", role_words).value_or(step.role);
  if (fields.has("erases")) step.erases = fields.flag("erases");
  if (fields.has("scale")) step.scale = fields.number("scale");
  if (fields.has("groups")) step.groups = read_sheet_groups(fields, "groups");
  if (!(step.scale > 0)) throw Mistake{"\"scale\" must be a number above 0"};
  return step;
}

void write_sheet_stroke(const SheetStroke& step, FieldWriter& writer) {
  std::vector<std::vector<double>> points;
  for (const Vec2& place : step.points) points.push_back({place.x(), place.y()});
  writer.number_lists("points", points);
  if (step.group) write_sheet_word(writer, "group", group_words, *step.group);
  write_sheet_word(writer, "role", role_words, step.role);
  if (step.erases) writer.flag("erases", true);
  writer.number("scale", step.scale);
  if (!step.groups.empty()) write_sheet_groups(writer, "groups", step.groups);
}

SheetDrag read_sheet_drag(Fields& fields) {
  SheetDrag step;
  step.stroke = fields.text("stroke");
  if (fields.has("point")) step.point = static_cast<std::size_t>(fields.count("point"));
  step.by = fields.pair("by");
  if (fields.has("alone")) step.alone = fields.flag("alone");
  return step;
}

void write_sheet_drag(const SheetDrag& step, FieldWriter& writer) {
  writer.text("stroke", step.stroke);
  if (step.point) writer.count("point", static_cast<std::int64_t>(*step.point));
  writer.pair("by", step.by);
  if (step.alone) writer.flag("alone", true);
}

SheetAim read_sheet_aim(Fields& fields) {
  SheetAim step;
  const std::string axis = fields.one_of("axis", axis_words);
  step.axis = static_cast<int>(std::ranges::find(axis_words, axis) - axis_words.begin());
  step.at = fields.pair("at");
  return step;
}

void write_sheet_aim(const SheetAim& step, FieldWriter& writer) {
  write_sheet_word(writer, "axis", axis_words, step.axis);
  writer.pair("at", step.at);
}

std::optional<bool> read_sheet_flag(Fields& fields, const std::string& name) {
  return fields.has(name) ? std::optional(fields.flag(name)) : std::nullopt;
}

SheetSetting read_sheet_setting(Fields& fields) {
  SheetSetting step;
  step.strokes = fields.names("strokes");
  step.setting.group = read_sheet_word<StrokeGroup>(fields, "group", group_words);
  step.setting.role = read_sheet_word<StrokeRole>(fields, "role", role_words);
  step.setting.hidden = read_sheet_flag(fields, "hidden");
  step.setting.link = read_sheet_flag(fields, "link");
  step.setting.start_lock = read_sheet_word<EndLock>(fields, "start-lock", lock_words);
  step.setting.end_lock = read_sheet_word<EndLock>(fields, "end-lock", lock_words);
  if (fields.has("weight")) {
    step.setting.weight = fields.number("weight");
    if (!(*step.setting.weight > 0)) throw Mistake{"\"weight\" must be a number above 0"};
  }
  if (!step.setting.any()) throw Mistake{"nothing is set: give \"group\", \"role\", \"hidden\" or another setting"};
  return step;
}

void write_sheet_setting(const SheetSetting& step, FieldWriter& writer) {
  const StrokeSetting& setting = step.setting;
  writer.names("strokes", step.strokes);
  if (setting.group) write_sheet_word(writer, "group", group_words, *setting.group);
  if (setting.role) write_sheet_word(writer, "role", role_words, *setting.role);
  if (setting.hidden) writer.flag("hidden", *setting.hidden);
  if (setting.link) writer.flag("link", *setting.link);
  if (setting.start_lock) write_sheet_word(writer, "start-lock", lock_words, *setting.start_lock);
  if (setting.end_lock) write_sheet_word(writer, "end-lock", lock_words, *setting.end_lock);
  if (setting.weight) writer.number("weight", *setting.weight);
}

SheetSize read_sheet_size(Fields& fields) {
  const SheetSize step{fields.pair("size")};
  if (!(step.size.minCoeff() > 0)) throw Mistake{"\"size\" must be two numbers above 0"};
  return step;
}

void write_sheet_size(const SheetSize& step, FieldWriter& writer) { writer.pair("size", step.size); }

SheetDelete read_sheet_delete(Fields& fields) { return {fields.names("strokes")}; }

void write_sheet_delete(const SheetDelete& step, FieldWriter& writer) { writer.names("strokes", step.strokes); }

SheetPoint read_sheet_point(Fields& fields) {
  if (!fields.has("at")) return {};
  return {KnownPoint{fields.pair("at"), fields.triple("point")}};
}

void write_sheet_point(const SheetPoint& step, FieldWriter& writer) {
  if (!step.known) return;
  writer.pair("at", step.known->at);
  writer.triple("point", step.known->point);
}

SheetLength read_sheet_length(Fields& fields) {
  SheetLength step{fields.text("stroke"), {}};
  if (fields.has("length")) step.length = fields.number("length");
  return step;
}

void write_sheet_length(const SheetLength& step, FieldWriter& writer) {
  writer.text("stroke", step.stroke);
  if (step.length) writer.number("length", *step.length);
}

SheetUnit read_sheet_unit(Fields& fields) {
  std::vector<std::string> words = length_units();
  words.emplace_back();
  return {fields.one_of("unit", words)};
}

void write_sheet_unit(const SheetUnit& step, FieldWriter& writer) { writer.text("unit", step.unit); }

SheetFaces read_sheet_faces(Fields& fields) {
  SheetFaces step;
  if (fields.has("required")) step.required = fields.names("required");
  if (fields.has("forbidden")) step.forbidden = fields.names("forbidden");
  if (step.required.empty() && step.forbidden.empty()) throw Mistake{"no face is \"required\" or \"forbidden\""};
  return step;
}

void write_sheet_faces(const SheetFaces& step, FieldWriter& writer) {
  if (!step.required.empty()) writer.names("required", step.required);
  if (!step.forbidden.empty()) writer.names("forbidden", step.forbidden);
}

SheetCamera read_sheet_camera(Fields& fields) {
  SheetCamera step;
  if (fields.has("field-of-view")) {
    const double degrees = fields.number("field-of-view");
    if (!(degrees > 0 && degrees < 180)) throw Mistake{"\"field-of-view\" must be above 0 and below 180 degrees"};
    step.field_of_view = degrees * degree_in_radians;
  }
  if (fields.has("principal")) step.principal_point = fields.pair("principal");
  return step;
}

void write_sheet_camera(const SheetCamera& step, FieldWriter& writer) {
  if (step.field_of_view) writer.number("field-of-view", *step.field_of_view / degree_in_radians);
  if (step.principal_point) writer.pair("principal", *step.principal_point);
}

SheetChoice read_sheet_choice(Fields& fields) {
  SheetChoice step{fields.one_of("list", list_words), fields.text("item"), true};
  if (fields.has("on")) step.on = fields.flag("on");
  return step;
}

void write_sheet_choice(const SheetChoice& step, FieldWriter& writer) {
  writer.text("list", step.list);
  writer.text("item", step.item);
  writer.flag("on", step.on);
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

SheetMirror read_sheet_mirror(Fields& fields) {
  SheetMirror step;
  const std::string axis = fields.one_of("axis", axis_words);
  step.plane.axis = static_cast<int>(std::ranges::find(axis_words, axis) - axis_words.begin());
  step.plane.at = fields.number("at");
  if (!fields.has("curves")) return step;
  for (const std::vector<double>& numbers : fields.number_lists("curves"))
    step.strokes.push_back(stroke_of_numbers(numbers));
  const std::vector<StrokeGroup> groups = read_sheet_groups(fields, "groups");
  if (groups.size() != step.strokes.size()) throw Mistake{"\"groups\" must name a group for each of \"curves\""};
  for (std::size_t i = 0; i < groups.size(); ++i) step.strokes[i].group = groups[i];
  return step;
}

void write_sheet_mirror(const SheetMirror& step, FieldWriter& writer) {
  write_sheet_word(writer, "axis", axis_words, step.plane.axis);
  writer.number("at", step.plane.at);
  if (step.strokes.empty()) return;
  std::vector<std::vector<double>> curves;
  std::vector<StrokeGroup> groups;
  for (const PerspectiveStroke& stroke : step.strokes) {
    curves.push_back(curve_numbers(stroke));
    groups.push_back(stroke.group);
  }
  writer.number_lists("curves", curves);
  write_sheet_groups(writer, "groups", groups);
}

}  // namespace

const StepKind& SheetStroke::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-stroke"}, read_sheet_stroke, write_sheet_stroke);
  return kind;
}

const StepKind& SheetDrag::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-drag"}, read_sheet_drag, write_sheet_drag);
  return kind;
}

const StepKind& SheetAim::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-aim"}, read_sheet_aim, write_sheet_aim);
  return kind;
}

const StepKind& SheetSetting::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-set"}, read_sheet_setting, write_sheet_setting);
  return kind;
}

const StepKind& SheetSize::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-sheet"}, read_sheet_size, write_sheet_size);
  return kind;
}

const StepKind& SheetDelete::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-delete"}, read_sheet_delete, write_sheet_delete);
  return kind;
}

const StepKind& SheetPoint::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-point"}, read_sheet_point, write_sheet_point);
  return kind;
}

const StepKind& SheetLength::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-length"}, read_sheet_length, write_sheet_length);
  return kind;
}

const StepKind& SheetUnit::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-unit"}, read_sheet_unit, write_sheet_unit);
  return kind;
}

const StepKind& SheetFaces::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-choose-faces"}, read_sheet_faces, write_sheet_faces);
  return kind;
}

const StepKind& SheetCamera::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-camera"}, read_sheet_camera, write_sheet_camera);
  return kind;
}

const StepKind& SheetChoice::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-choose"}, read_sheet_choice, write_sheet_choice);
  return kind;
}

const StepKind& SheetMirror::step_kind() {
  static const StepKind kind = make_step_kind({"perspective-mirror"}, read_sheet_mirror, write_sheet_mirror);
  return kind;
}

const Vocabulary& perspective_steps() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    for (const StepKind* kind :
         {&SheetStroke::step_kind(), &SheetDrag::step_kind(), &SheetAim::step_kind(), &SheetSetting::step_kind(),
          &SheetDelete::step_kind(), &SheetSize::step_kind(), &SheetPoint::step_kind(), &SheetLength::step_kind(),
          &SheetCamera::step_kind(), &SheetChoice::step_kind(), &SheetMirror::step_kind(), &SheetUnit::step_kind(),
          &SheetFaces::step_kind()})
      made.add(*kind);
    for (const char* count : {"perspective-strokes", "perspective-faces", "perspective-open", "perspective-closed",
                              "perspective-mode", "perspective-fixes"})
      made.add_count(count);
    made.add_range("perspective-residual");
    return made;
  }();
  return vocabulary;
}

}  // namespace croquis::recorded
