// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/surface/surface_steps.h"

#include <algorithm>

namespace croquis::recorded {
namespace {

const std::vector<std::string> join_words = {"crease", "smooth"};
const std::vector<std::string> blend_words = {"smooth", "position", "paper"};
const std::vector<std::string> domain_words = {"chordlength", "uniform"};
const std::vector<std::string> tip_words = {"smooth", "cone"};
const std::vector<std::string> ridge_words = {"smooth", "sharp"};

template <typename T>
std::optional<T> read_surface_word(Fields& fields, const std::string& name, const std::vector<std::string>& words) {
  if (!fields.has(name)) return std::nullopt;
  return static_cast<T>(std::ranges::find(words, fields.one_of(name, words)) - words.begin());
}

template <typename T>
void write_surface_word(FieldWriter& writer, const std::string& name, const std::vector<std::string>& words,
                        const std::optional<T>& value) {
  if (value) writer.text(name, words[static_cast<std::size_t>(*value)]);
}

std::vector<std::string> read_names(Fields& fields, const std::string& name) {
  return fields.has(name) ? fields.names(name) : std::vector<std::string>();
}

void write_names(FieldWriter& writer, const std::string& name, const std::vector<std::string>& names) {
  if (!names.empty()) writer.names(name, names);
}

NetworkElements read_elements(Fields& fields) {
  return {read_names(fields, "nodes"), read_names(fields, "curves"), read_names(fields, "faces"),
          read_names(fields, "points")};
}

void write_elements(FieldWriter& writer, const NetworkElements& elements) {
  write_names(writer, "nodes", elements.nodes);
  write_names(writer, "curves", elements.curves);
  write_names(writer, "faces", elements.faces);
  write_names(writer, "points", elements.points);
}

std::optional<double> read_number_if_any(Fields& fields, const std::string& name) {
  return fields.has(name) ? std::optional(fields.number(name)) : std::nullopt;
}

std::optional<Vec3> read_triple_if_any(Fields& fields, const std::string& name) {
  return fields.has(name) ? std::optional(fields.triple(name)) : std::nullopt;
}

double read_fraction(Fields& fields, const std::string& name) {
  const double at = fields.number(name);
  if (!(at >= 0 && at <= 1)) throw Mistake{'"' + name + "\" must be a fraction from 0 to 1"};
  return at;
}

/// "automatic", or a number above 0.
std::optional<std::optional<double>> read_radius(Fields& fields) {
  if (fields.has("automatic-radius") && fields.flag("automatic-radius")) return std::optional<double>();
  if (!fields.has("radius")) return std::nullopt;
  const double radius = fields.number("radius");
  if (!(radius > 0)) throw Mistake{"\"radius\" must be a number above 0"};
  return std::optional(radius);
}

void write_radius(FieldWriter& writer, const std::optional<std::optional<double>>& radius) {
  if (!radius) return;
  if (*radius) {
    writer.number("radius", **radius);
  } else {
    writer.flag("automatic-radius", true);
  }
}

CurveEnd read_end(Fields& fields, const std::string& prefix) {
  CurveEnd end{fields.text(prefix + "-node", ""), fields.text(prefix + "-curve", ""), 0};
  if (!end.curve.empty()) end.at = read_fraction(fields, prefix + "-at");
  return end;
}

void write_end(FieldWriter& writer, const std::string& prefix, const CurveEnd& end) {
  if (!end.node.empty()) writer.text(prefix + "-node", end.node);
  if (!end.node.empty() || end.curve.empty()) return;
  writer.text(prefix + "-curve", end.curve);
  writer.number(prefix + "-at", end.at);
}

SurfaceStroke read_surface_stroke(Fields& fields) {
  SurfaceStroke step;
  for (const std::vector<double>& place : fields.number_lists("points")) {
    if (place.size() != 3) throw Mistake{"\"points\" must be a list of places of three numbers"};
    step.points.emplace_back(place[0], place[1], place[2]);
  }
  step.unit = fields.number("unit");
  if (!(step.unit > 0)) throw Mistake{"\"unit\" must be a number above 0"};
  step.start = read_end(fields, "start");
  step.end = read_end(fields, "end");
  step.face = fields.text("face", "");
  return step;
}

void write_surface_stroke(const SurfaceStroke& step, FieldWriter& writer) {
  std::vector<std::vector<double>> points;
  for (const Vec3& place : step.points) points.push_back({place.x(), place.y(), place.z()});
  writer.number_lists("points", points);
  writer.number("unit", step.unit);
  write_end(writer, "start", step.start);
  write_end(writer, "end", step.end);
  if (!step.face.empty()) writer.text("face", step.face);
}

SurfaceDrag read_surface_drag(Fields& fields) {
  SurfaceDrag step{read_elements(fields), {}, fields.triple("by"), fields.text("into", "")};
  if (fields.has("handle"))
    step.handle = ControlHandle{fields.text("handle"), static_cast<std::size_t>(fields.count("control"))};
  if (step.elements.empty() && !step.handle) throw Mistake{"nothing is dragged: give elements or a \"handle\""};
  return step;
}

void write_surface_drag(const SurfaceDrag& step, FieldWriter& writer) {
  write_elements(writer, step.elements);
  if (step.handle) {
    writer.text("handle", step.handle->curve);
    writer.count("control", static_cast<std::int64_t>(step.handle->control));
  }
  writer.triple("by", step.by);
  if (!step.into.empty()) writer.text("into", step.into);
}

SurfacePatch read_surface_patch(Fields& fields) { return {fields.names("curves")}; }
void write_surface_patch(const SurfacePatch& step, FieldWriter& writer) { writer.names("curves", step.curves); }

SurfacePoint read_surface_point(Fields& fields) {
  SurfacePoint step;
  step.point.face = fields.text("face");
  step.point.point = fields.triple("at");
  if (fields.has("corner"))
    step.point.fan =
        FanPlace{static_cast<std::size_t>(fields.count("corner")), fields.pair("fan").x(), fields.pair("fan").y()};
  step.point.radius = read_radius(fields).value_or(std::nullopt);
  step.point.profile = read_surface_word<PointProfile>(fields, "profile", tip_words).value_or(step.point.profile);
  return step;
}

void write_surface_point(const SurfacePoint& step, FieldWriter& writer) {
  writer.text("face", step.point.face);
  writer.triple("at", step.point.point);
  if (step.point.fan) {
    writer.count("corner", static_cast<std::int64_t>(step.point.fan->corner));
    writer.pair("fan", {step.point.fan->a, step.point.fan->b});
  }
  if (step.point.radius) write_radius(writer, step.point.radius);
  write_surface_word(writer, "profile", tip_words, std::optional(step.point.profile));
}

SurfacePointSetting read_point_setting(Fields& fields) {
  SurfacePointSetting step{fields.names("points"), {}};
  step.setting.point = read_triple_if_any(fields, "at");
  step.setting.radius = read_radius(fields);
  step.setting.profile = read_surface_word<PointProfile>(fields, "profile", tip_words);
  if (fields.has("automatic-normal") && fields.flag("automatic-normal")) step.setting.normal = std::optional<Vec3>();
  if (fields.has("normal")) step.setting.normal = std::optional(fields.triple("normal"));
  if (!step.setting.any()) throw Mistake{"nothing is set: give \"at\", \"radius\", \"profile\" or \"normal\""};
  return step;
}

void write_point_setting(const SurfacePointSetting& step, FieldWriter& writer) {
  writer.names("points", step.points);
  if (step.setting.point) writer.triple("at", *step.setting.point);
  write_radius(writer, step.setting.radius);
  write_surface_word(writer, "profile", tip_words, step.setting.profile);
  if (step.setting.normal && *step.setting.normal) writer.triple("normal", **step.setting.normal);
  if (step.setting.normal && !*step.setting.normal) writer.flag("automatic-normal", true);
}

SurfaceJoin read_surface_join(Fields& fields) {
  SurfaceJoin step{fields.names("curves"), {}};
  fields.text("join");
  step.join = *read_surface_word<CurveJoin>(fields, "join", join_words);
  return step;
}

void write_surface_join(const SurfaceJoin& step, FieldWriter& writer) {
  writer.names("curves", step.curves);
  write_surface_word(writer, "join", join_words, std::optional(step.join));
}

SurfaceFaceSetting read_face_setting(Fields& fields) {
  SurfaceFaceSetting step{fields.names("faces"), {}, false};
  step.setting.mode = read_surface_word<AttributeMode>(fields, "mode", blend_words);
  step.setting.domain = read_surface_word<AttributeDomain>(fields, "domain", domain_words);
  step.setting.fullness = read_number_if_any(fields, "fullness");
  if (fields.has("turned")) step.turned = fields.flag("turned");
  if (!step.setting.any() && !step.turned) throw Mistake{"nothing is set: give \"mode\", \"domain\" or \"fullness\""};
  return step;
}

void write_face_setting(const SurfaceFaceSetting& step, FieldWriter& writer) {
  writer.names("faces", step.faces);
  write_surface_word(writer, "mode", blend_words, step.setting.mode);
  write_surface_word(writer, "domain", domain_words, step.setting.domain);
  if (step.setting.fullness) writer.number("fullness", *step.setting.fullness);
  if (step.turned) writer.flag("turned", true);
}

SurfaceSlope read_surface_slope(Fields& fields) {
  SurfaceSlope step{{fields.text("curve"), fields.text("face", "")}, {}};
  if (!fields.has("at")) return step;
  step.handle = SlopeHandle{read_fraction(fields, "at"), read_triple_if_any(fields, "normal"),
                            read_number_if_any(fields, "magnitude")};
  return step;
}

void write_surface_slope(const SurfaceSlope& step, FieldWriter& writer) {
  writer.text("curve", step.side.curve);
  if (!step.side.face.empty()) writer.text("face", step.side.face);
  if (!step.handle) return;
  writer.number("at", step.handle->at);
  if (step.handle->normal) writer.triple("normal", *step.handle->normal);
  if (step.handle->magnitude) writer.number("magnitude", *step.handle->magnitude);
}

SurfaceInner read_surface_inner(Fields& fields) {
  SurfaceInner step{fields.text("curve"), fields.text("face", ""), false, {}};
  if (fields.has("removed")) step.removed = fields.flag("removed");
  step.setting.profile = read_surface_word<InnerProfile>(fields, "profile", ridge_words);
  step.setting.radius = read_radius(fields);
  return step;
}

void write_surface_inner(const SurfaceInner& step, FieldWriter& writer) {
  writer.text("curve", step.curve);
  if (!step.face.empty()) writer.text("face", step.face);
  if (step.removed) writer.flag("removed", true);
  write_surface_word(writer, "profile", ridge_words, step.setting.profile);
  write_radius(writer, step.setting.radius);
}

SurfaceSplit read_surface_split(Fields& fields) {
  SurfaceSplit step{fields.text("curve"), {}, fields.text("face", "")};
  if (step.face.empty()) step.at = read_fraction(fields, "at");
  return step;
}

void write_surface_split(const SurfaceSplit& step, FieldWriter& writer) {
  writer.text("curve", step.curve);
  if (!step.face.empty()) writer.text("face", step.face);
  if (step.at) writer.number("at", *step.at);
}

SurfaceMerge read_surface_merge(Fields& fields) { return {fields.text("curve")}; }
void write_surface_merge(const SurfaceMerge& step, FieldWriter& writer) { writer.text("curve", step.curve); }

SurfaceDelete read_surface_delete(Fields& fields) {
  SurfaceDelete step{read_elements(fields)};
  if (step.elements.empty()) throw Mistake{"nothing is deleted: give \"nodes\", \"curves\", \"faces\" or \"points\""};
  return step;
}
void write_surface_delete(const SurfaceDelete& step, FieldWriter& writer) { write_elements(writer, step.elements); }

SymmetryPlane read_plane(Fields& fields) {
  const SymmetryPlane plane{fields.triple("point"), fields.triple("normal")};
  if (!(plane.normal.norm() > 0)) throw Mistake{"\"normal\" must point somewhere"};
  return plane;
}

void write_plane(FieldWriter& writer, const SymmetryPlane& plane) {
  writer.triple("point", plane.point);
  writer.triple("normal", plane.normal);
}

SurfaceMirror read_surface_mirror(Fields& fields) { return {read_plane(fields)}; }
void write_surface_mirror(const SurfaceMirror& step, FieldWriter& writer) { write_plane(writer, step.plane); }

SurfaceSymmetry read_surface_symmetry(Fields& fields) {
  if (!fields.has("point") && !fields.has("normal")) return {};
  return {read_plane(fields)};
}

void write_surface_symmetry(const SurfaceSymmetry& step, FieldWriter& writer) {
  if (step.plane) write_plane(writer, *step.plane);
}

SurfaceChoice read_surface_choice(Fields& fields) { return {read_elements(fields)}; }
void write_surface_choice(const SurfaceChoice& step, FieldWriter& writer) { write_elements(writer, step.elements); }

}  // namespace

const StepKind& SurfaceStroke::step_kind() {
  static const StepKind kind = make_step_kind({"surface-stroke"}, read_surface_stroke, write_surface_stroke);
  return kind;
}

const StepKind& SurfaceDrag::step_kind() {
  static const StepKind kind = make_step_kind({"surface-drag"}, read_surface_drag, write_surface_drag);
  return kind;
}

const StepKind& SurfacePatch::step_kind() {
  static const StepKind kind = make_step_kind({"surface-patch"}, read_surface_patch, write_surface_patch);
  return kind;
}

const StepKind& SurfacePoint::step_kind() {
  static const StepKind kind = make_step_kind({"surface-point"}, read_surface_point, write_surface_point);
  return kind;
}

const StepKind& SurfacePointSetting::step_kind() {
  static const StepKind kind = make_step_kind({"surface-set-points"}, read_point_setting, write_point_setting);
  return kind;
}

const StepKind& SurfaceJoin::step_kind() {
  static const StepKind kind = make_step_kind({"surface-join"}, read_surface_join, write_surface_join);
  return kind;
}

const StepKind& SurfaceFaceSetting::step_kind() {
  static const StepKind kind = make_step_kind({"surface-set-faces"}, read_face_setting, write_face_setting);
  return kind;
}

const StepKind& SurfaceSlope::step_kind() {
  static const StepKind kind = make_step_kind({"surface-slope"}, read_surface_slope, write_surface_slope);
  return kind;
}

const StepKind& SurfaceInner::step_kind() {
  static const StepKind kind = make_step_kind({"surface-inner"}, read_surface_inner, write_surface_inner);
  return kind;
}

const StepKind& SurfaceSplit::step_kind() {
  static const StepKind kind = make_step_kind({"surface-split"}, read_surface_split, write_surface_split);
  return kind;
}

const StepKind& SurfaceMerge::step_kind() {
  static const StepKind kind = make_step_kind({"surface-merge"}, read_surface_merge, write_surface_merge);
  return kind;
}

const StepKind& SurfaceDelete::step_kind() {
  static const StepKind kind = make_step_kind({"surface-delete"}, read_surface_delete, write_surface_delete);
  return kind;
}

const StepKind& SurfaceMirror::step_kind() {
  static const StepKind kind = make_step_kind({"surface-mirror"}, read_surface_mirror, write_surface_mirror);
  return kind;
}

const StepKind& SurfaceSymmetry::step_kind() {
  static const StepKind kind = make_step_kind({"surface-symmetry"}, read_surface_symmetry, write_surface_symmetry);
  return kind;
}

const StepKind& SurfaceChoice::step_kind() {
  static const StepKind kind = make_step_kind({"surface-select"}, read_surface_choice, write_surface_choice);
  return kind;
}

const Vocabulary& surface_steps() {
  static const Vocabulary vocabulary = [] {
    Vocabulary made;
    for (const StepKind* kind :
         {&SurfaceStroke::step_kind(), &SurfaceDrag::step_kind(), &SurfacePatch::step_kind(),
          &SurfacePoint::step_kind(), &SurfacePointSetting::step_kind(), &SurfaceJoin::step_kind(),
          &SurfaceFaceSetting::step_kind(), &SurfaceSlope::step_kind(), &SurfaceInner::step_kind(),
          &SurfaceSplit::step_kind(), &SurfaceMerge::step_kind(), &SurfaceDelete::step_kind(),
          &SurfaceMirror::step_kind(), &SurfaceSymmetry::step_kind(), &SurfaceChoice::step_kind()})
      made.add(*kind);
    for (const char* count : {"surface-nodes", "surface-curves", "surface-faces", "surface-points", "surface-selected",
                              "surface-patches-made", "surface-nearer-dents"})
      made.add_count(count);
    for (const char* range : {"surface-boundary-error", "surface-point-errors"}) made.add_range(range);
    return made;
  }();
  return vocabulary;
}

}  // namespace croquis::recorded
