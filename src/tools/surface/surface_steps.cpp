// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/surface/surface_steps.h"

namespace croquis::recorded {
namespace {

const Words tip_words = {"smooth", "cone"};

void describe_elements(Fields& fields, NetworkElements& elements) {
  fields.seldom("nodes", elements.nodes);
  fields.seldom("curves", elements.curves);
  fields.seldom("faces", elements.faces);
  fields.seldom("points", elements.points);
}

void require_fraction(const Fields& fields, const std::string& name, double at) {
  fields.require(at >= 0 && at <= 1, '"' + name + "\" must be a fraction from 0 to 1");
}

/// A setting that may be made automatic again.
template <typename T>
void describe_automatic(Fields& fields, const std::string& name, std::optional<std::optional<T>>& setting) {
  bool automatic = setting && !*setting;
  fields.seldom("automatic-" + name, automatic);
  std::optional<T> value = setting.value_or(std::nullopt);
  if (!automatic) fields.seldom(name, value);
  if (automatic || value) setting = value;
}

void describe_radius(Fields& fields, std::optional<std::optional<double>>& radius) {
  describe_automatic(fields, "radius", radius);
  fields.require(!radius || !*radius || **radius > 0, "\"radius\" must be a number above 0");
}

void describe_end(Fields& fields, const std::string& prefix, CurveEnd& end) {
  fields.seldom(prefix + "-node", end.node);
  if (!fields.reads() && !end.node.empty()) return;
  fields.seldom(prefix + "-curve", end.curve);
  if (end.curve.empty()) return;
  fields.required(prefix + "-at", end.at);
  require_fraction(fields, prefix + "-at", end.at);
}

void describe_plane(Fields& fields, SymmetryPlane& plane) {
  fields.required("point", plane.point);
  fields.required("normal", plane.normal);
  fields.require(plane.normal.norm() > 0, "\"normal\" must point somewhere");
}

}  // namespace

void SurfaceStroke::describe(Fields& fields) {
  fields.required("points", points);
  fields.required("unit", unit);
  fields.require(unit > 0, "\"unit\" must be a number above 0");
  describe_end(fields, "start", start);
  describe_end(fields, "end", end);
  fields.seldom("face", face);
}

void SurfaceDrag::describe(Fields& fields) {
  describe_elements(fields, elements);
  if (fields.reads() && fields.has("handle")) handle.emplace();
  if (handle) {
    fields.required("handle", handle->curve);
    fields.required("control", handle->control);
  }
  fields.required("by", by);
  fields.seldom("into", into);
  fields.require(!elements.empty() || handle, "nothing is dragged: give elements or a \"handle\"");
}

void SurfacePoint::describe(Fields& fields) {
  fields.required("face", point.face);
  fields.required("at", point.point);
  if (fields.reads() && fields.has("corner")) point.fan.emplace();
  if (point.fan) {
    fields.required("corner", point.fan->corner);
    Vec2 fan(point.fan->a, point.fan->b);
    fields.required("fan", fan);
    point.fan->a = fan.x();
    point.fan->b = fan.y();
  }
  std::optional<std::optional<double>> radius;
  if (point.radius) radius = point.radius;
  describe_radius(fields, radius);
  point.radius = radius.value_or(std::nullopt);
  fields.given("profile", point.profile, tip_words);
}

void SurfacePointSetting::describe(Fields& fields) {
  fields.required("points", points);
  fields.seldom("at", setting.point);
  describe_radius(fields, setting.radius);
  fields.seldom("profile", setting.profile, tip_words);
  describe_automatic(fields, "normal", setting.normal);
  fields.require(setting.any(), "nothing is set: give \"at\", \"radius\", \"profile\" or \"normal\"");
}

void SurfaceJoin::describe(Fields& fields) {
  fields.required("curves", curves);
  fields.required("join", join, Words{"crease", "smooth"});
}

void SurfaceFaceSetting::describe(Fields& fields) {
  fields.required("faces", faces);
  fields.seldom("mode", setting.mode, Words{"smooth", "position", "paper"});
  fields.seldom("domain", setting.domain, Words{"chordlength", "uniform"});
  fields.seldom("fullness", setting.fullness);
  fields.seldom("turned", turned);
  fields.require(setting.any() || turned, "nothing is set: give \"mode\", \"domain\" or \"fullness\"");
}

void SurfaceSlope::describe(Fields& fields) {
  fields.required("curve", side.curve);
  fields.seldom("face", side.face);
  if (fields.reads() && fields.has("at")) handle.emplace();
  if (!handle) return;
  fields.required("at", handle->at);
  require_fraction(fields, "at", handle->at);
  fields.seldom("normal", handle->normal);
  fields.seldom("magnitude", handle->magnitude);
}

void SurfaceInner::describe(Fields& fields) {
  fields.required("curve", curve);
  fields.seldom("face", face);
  fields.seldom("removed", removed);
  fields.seldom("profile", setting.profile, Words{"smooth", "sharp"});
  describe_radius(fields, setting.radius);
}

void SurfaceSplit::describe(Fields& fields) {
  fields.required("curve", curve);
  fields.seldom("face", face);
  if (fields.reads() && !face.empty()) return;
  fields.required("at", at);
  require_fraction(fields, "at", at.value_or(0));
}

void SurfaceDelete::describe(Fields& fields) {
  describe_elements(fields, elements);
  fields.require(!elements.empty(), "nothing is deleted: give \"nodes\", \"curves\", \"faces\" or \"points\"");
}

void SurfaceMirror::describe(Fields& fields) { describe_plane(fields, plane); }

void SurfaceSymmetry::describe(Fields& fields) {
  if (fields.reads() && (fields.has("point") || fields.has("normal"))) plane.emplace();
  if (plane) describe_plane(fields, *plane);
}

void SurfaceChoice::describe(Fields& fields) { describe_elements(fields, elements); }

const Vocabulary& surface_steps() {
  static const Vocabulary vocabulary =
      vocabulary_of<SurfaceStroke, SurfaceDrag, SurfacePatch, SurfacePoint, SurfacePointSetting, SurfaceJoin,
                    SurfaceFaceSetting, SurfaceSlope, SurfaceInner, SurfaceSplit, SurfaceMerge, SurfaceDelete,
                    SurfaceMirror, SurfaceSymmetry, SurfaceChoice>(
          {"surface-nodes", "surface-curves", "surface-faces", "surface-points", "surface-selected",
           "surface-patches-made", "surface-nearer-dents"},
          {"surface-boundary-error", "surface-point-errors"});
  return vocabulary;
}

}  // namespace croquis::recorded
