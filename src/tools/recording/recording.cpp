// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording/recording.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "tools/recording/recording_reader.h"

namespace croquis::recorded {
namespace {

using Json = nlohmann::ordered_json;

Finding finding_of(const Mistake& mistake, const std::string& file, std::int64_t line) {
  return make_error(Category::Malformed, "E_REPLAY",
                    "Line " + std::to_string(line) + " of the recording can't be replayed: " + mistake.sentence + '.',
                    {{SubjectKind::Line, std::to_string(line), file, line, {}}});
}

// ---- Writing

Json numbers(const Vec2& pair) { return Json::array({pair.x(), pair.y()}); }

Json numbers(const Vec3& triple) { return Json::array({triple.x(), triple.y(), triple.z()}); }

Json numbers(const Vec2& sketch, const ModelPlace& model) { return model ? numbers(*model) : numbers(sketch); }

Json json_of_sharpness(double sharpness) { return std::isinf(sharpness) ? Json("inf") : Json(sharpness); }

Json to_json(const StrokeDrawn& step) {
  Json json = {{"do", "stroke"}, {"view", step.view}, {"points", Json::array()}, {"device", step.device}};
  for (const StrokeSample& sample : step.points)
    json["points"].push_back({sample.position.x(), sample.position.y(), sample.pressure, sample.time});
  if (step.scale > 0) json["scale"] = step.scale;
  return json;
}

Json to_json(const Drag& step) {
  Json json = {{"do", "drag"}, {"stroke", step.stroke}};
  if (step.anchor) json["anchor"] = *step.anchor;
  json["by"] = numbers(step.by);
  return json;
}

Json to_json(const Action& step) { return {{"do", "action"}, {"name", step.name}}; }

Json to_json(const Set& step) {
  Json json = {{"do", "set"}, {"node", step.node}, {"parameter", step.parameter}};
  std::visit([&](const auto& value) { json["value"] = value; }, step.value);
  return json;
}

Json to_json(const Wait& step) { return {{"do", "wait"}, {"for", step.what}}; }
Json to_json(const Screenshot& step) { return {{"do", "screenshot"}, {"file", step.file}}; }
Json to_json(const File& step) { return {{"do", step.verb}, {"file", step.file}}; }

void add_modifiers(Json& json, const std::vector<std::string>& modifiers) {
  if (!modifiers.empty()) json["modifiers"] = modifiers;
}

Json to_json(const Click& step) {
  Json json = {{"do", "click"}, {"view", step.view}, {"at", numbers(step.at, step.place)}};
  if (step.clicks != 1) json["clicks"] = step.clicks;
  add_modifiers(json, step.modifiers);
  return json;
}

Json to_json(const Box& step) {
  Json json = {{"do", "box"},
               {"view", step.view},
               {"from", numbers(step.from, step.from_place)},
               {"to", numbers(step.to, step.to_place)}};
  add_modifiers(json, step.modifiers);
  return json;
}

Json to_json(const Navigate& step) {
  return {{"do", "navigate"}, {"view", step.view}, {"motion", step.motion}, {"by", numbers(step.by)}};
}

Json to_json(const ModelDrag& step) {
  Json json = {{"do", "drag"}, {"view", step.view}, {"from", numbers(step.from)}, {"to", numbers(step.to)}};
  add_modifiers(json, step.modifiers);
  return json;
}

Json to_json(const Pick& step) {
  return {{"do", "pick"}, {"node", step.node}, {"kind", step.kind}, {"elements", step.elements}, {"how", step.how}};
}

Json to_json(const Move& step) { return {{"do", "move"}, {"node", step.node}, {"by", numbers(step.by)}}; }

Json to_json(const Rotate& step) {
  Json json = {{"do", "rotate"}, {"node", step.node}, {"axis", numbers(step.axis)}, {"degrees", step.degrees}};
  if (step.pivot) json["pivot"] = numbers(*step.pivot);
  return json;
}

Json to_json(const Scale& step) {
  Json json = {{"do", "scale"}, {"node", step.node}, {"factors", numbers(step.factors)}};
  if (step.pivot) json["pivot"] = numbers(*step.pivot);
  return json;
}

Json to_json(const Tag& step) {
  Json json = {{"do", "tag"}, {"node", step.node}, {"edges", step.edges}};
  if (step.edges == "sharper-than") json["degrees"] = step.degrees;
  if (step.change) json["change"] = *step.change;
  if (step.sharpness) json["sharpness"] = json_of_sharpness(*step.sharpness);
  return json;
}

Json to_json(const Pin& step) { return {{"do", "pin"}, {"node", step.node}, {"pinned", step.pinned}}; }

Json to_json(const TagSet& step) {
  Json json = {{"do", "tag-set"}, {"node", step.node}, {"how", step.how}, {"name", step.name}};
  if (!step.other.empty()) json["other"] = step.other;
  if (step.sharpness) json["sharpness"] = json_of_sharpness(*step.sharpness);
  return json;
}

Json to_json(const Extrude& step) { return {{"do", "extrude"}, {"node", step.node}, {"by", numbers(step.by)}}; }

Json to_json(const LoopCut& step) {
  return {{"do", "loop-cut"}, {"node", step.node}, {"edge", step.edge}, {"at", step.at}};
}

Json to_json(const FaceSetChoice& step) { return {{"do", "face-set"}, {"node", step.node}, {"names", step.names}}; }

Json to_json(const HoleChoice& step) {
  Json json = {{"do", "hole"}};
  if (!step.up_to) json["holes"] = step.holes;
  json["action"] = step.action;
  if (step.up_to) json["up-to"] = *step.up_to;
  if (!step.node.empty()) json["node"] = step.node;
  return json;
}

Json to_json(const HoleWay& step) {
  Json json = {{"do", "hole-way"}, {"holes", step.holes}};
  if (step.fairness) json["fairness"] = *step.fairness;
  if (step.kernel) json["kernel"] = *step.kernel;
  if (step.bulge) json["bulge"] = *step.bulge;
  if (step.trim_rim) json["trim-rim"] = *step.trim_rim;
  if (!step.node.empty()) json["node"] = step.node;
  return json;
}

Json to_json(const HolePoint& step) {
  Json json = {{"do", "hole-point"}, {"hole", step.hole}};
  if (step.from) json["from"] = numbers(*step.from);
  if (step.to) json["to"] = numbers(*step.to);
  if (!step.node.empty()) json["node"] = step.node;
  return json;
}

Json to_json(const Expect& step) {
  Json json = {{"do", "expect"}, {"what", step.what}};
  if (step.value) json["value"] = *step.value;
  if (step.to) json["to"] = *step.to;
  if (!step.value) json["count"] = step.count;
  if (!step.node.empty()) json["node"] = step.node;
  return json;
}

}  // namespace

std::vector<Line> parse(std::string_view text, const std::string& name) {
  std::vector<Line> lines;
  Findings findings;
  std::int64_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line[first] == '#') continue;
    try {
      lines.push_back({read_line(line), number});
    } catch (const Mistake& mistake) {
      findings.push_back(finding_of(mistake, name, number));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return lines;
}

std::string to_line(const Step& step) {
  const Json json = std::visit([](const auto& value) { return to_json(value); }, step);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace croquis::recorded
