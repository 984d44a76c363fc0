// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"

namespace croquis::recorded {
namespace {

using Json = nlohmann::ordered_json;

/// What is wrong with a line; becomes a finding with the line's number.
struct Mistake {
  std::string sentence;
};

/// The fields of one line. Every field is asked for once; what nobody asked for is a mistake.
class Fields {
 public:
  explicit Fields(const Json& object) : object_(object) {}

  const Json* find(const std::string& name) {
    known_.insert(name);
    const auto found = object_.find(name);
    return found == object_.end() ? nullptr : &*found;
  }

  const Json& get(const std::string& name) {
    const Json* found = find(name);
    if (found == nullptr) throw Mistake{"\"" + name + "\" is missing"};
    return *found;
  }

  std::string text(const std::string& name) {
    const Json& value = get(name);
    if (!value.is_string()) throw Mistake{"\"" + name + "\" must be a text"};
    return value.get<std::string>();
  }

  std::string text(const std::string& name, const std::string& otherwise) {
    return find(name) == nullptr ? otherwise : text(name);
  }

  std::string one_of(const std::string& name, const std::vector<std::string>& choices) {
    std::string value = text(name);
    if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
    std::string list;
    for (const std::string& choice : choices) list += (list.empty() ? "" : ", ") + choice;
    throw Mistake{"\"" + name + "\" must be one of " + list};
  }

  std::int64_t count(const std::string& name) {
    const Json& value = get(name);
    if (!value.is_number_integer() || value.get<double>() < 0 || value.get<double>() > 1e15)
      throw Mistake{"\"" + name + "\" must be a whole number of at least 0"};
    return value.get<std::int64_t>();
  }

  Vec2 pair(const std::string& name) {
    const std::vector<double> numbers = number_list(get(name), name);
    if (numbers.size() != 2) throw Mistake{"\"" + name + "\" must be a pair of numbers"};
    return {numbers[0], numbers[1]};
  }

  std::vector<std::string> modifiers() {
    std::vector<std::string> names;
    const Json* list = find("modifiers");
    if (list == nullptr) return names;
    static const std::set<std::string> allowed = {"shift", "ctrl", "alt", "super"};
    if (!list->is_array()) throw Mistake{"\"modifiers\" must be a list of names"};
    for (const Json& name : *list) {
      if (!name.is_string() || !allowed.contains(name.get<std::string>()))
        throw Mistake{"\"modifiers\" may hold shift, ctrl, alt and super"};
      names.push_back(name.get<std::string>());
    }
    return names;
  }

  static std::vector<double> number_list(const Json& value, const std::string& name) {
    if (!value.is_array()) throw Mistake{"\"" + name + "\" must be a list of numbers"};
    std::vector<double> numbers;
    for (const Json& number : value) {
      if (!number.is_number() || !std::isfinite(number.get<double>()))
        throw Mistake{"\"" + name + "\" may hold finite numbers only"};
      numbers.push_back(number.get<double>());
    }
    return numbers;
  }

  void refuse_unknown() const {
    for (const auto& [name, value] : object_.items()) {
      if (!known_.contains(name)) throw Mistake{"\"" + name + "\" means nothing here"};
    }
  }

 private:
  const Json& object_;
  std::set<std::string> known_;
};

// ---- One reader per kind of line

std::vector<StrokeSample> read_points(Fields& fields) {
  std::vector<StrokeSample> points;
  const Json& list = fields.get("points");
  if (!list.is_array() || list.empty()) throw Mistake{"\"points\" must be a list of at least one point"};
  for (const Json& point : list) {
    const std::vector<double> numbers = Fields::number_list(point, "points");
    if (numbers.size() < 2 || numbers.size() > 4) throw Mistake{"a point is [x, y], [x, y, pressure] or with its time"};
    StrokeSample sample;
    sample.position = {numbers[0], numbers[1]};
    if (numbers.size() > 2) sample.pressure = numbers[2];
    if (numbers.size() > 3) sample.time = numbers[3];
    if (sample.pressure < 0 || sample.pressure > 1) throw Mistake{"a point's pressure must be within 0 and 1"};
    points.push_back(sample);
  }
  return points;
}

Step read_stroke(Fields& fields) {
  StrokeDrawn step;
  step.view = fields.text("view", step.view);
  step.points = read_points(fields);
  if (fields.find("device") != nullptr) step.device = fields.one_of("device", {"mouse", "pen", "eraser"});
  if (const Json* scale = fields.find("scale")) {
    if (!scale->is_number() || !(scale->get<double>() > 0) || !std::isfinite(scale->get<double>()))
      throw Mistake{"\"scale\" must be a number above 0"};
    step.scale = scale->get<double>();
  }
  return step;
}

Step read_drag(Fields& fields) {
  Drag step;
  step.stroke = fields.text("stroke");
  if (fields.find("anchor") != nullptr) step.anchor = static_cast<std::size_t>(fields.count("anchor"));
  step.by = fields.pair("by");
  return step;
}

ParameterValue read_value(const Json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  throw Mistake{"\"value\" must be true, false, a number or a text"};
}

Step read_set(Fields& fields) {
  Set step;
  step.node = fields.text("node");
  step.parameter = fields.text("parameter");
  step.value = read_value(fields.get("value"));
  return step;
}

Step read_click(Fields& fields) {
  Click step;
  step.view = fields.text("view", step.view);
  step.at = fields.pair("at");
  step.modifiers = fields.modifiers();
  return step;
}

Step read_box(Fields& fields) {
  Box step;
  step.view = fields.text("view", step.view);
  step.from = fields.pair("from");
  step.to = fields.pair("to");
  step.modifiers = fields.modifiers();
  return step;
}

Step read_navigate(Fields& fields) {
  Navigate step;
  step.view = fields.text("view", step.view);
  step.motion = fields.one_of("motion", {"tumble", "track", "dolly"});
  step.by = fields.pair("by");
  return step;
}

Step read_step(Fields& fields) {
  const std::string verb = fields.text("do");
  if (verb == "stroke") return read_stroke(fields);
  if (verb == "drag") return read_drag(fields);
  if (verb == "action") return Action{fields.text("name")};
  if (verb == "set") return read_set(fields);
  if (verb == "wait") return Wait{fields.text("for")};
  if (verb == "screenshot") return Screenshot{fields.text("file")};
  if (verb == "save" || verb == "open" || verb == "export") return File{verb, fields.text("file")};
  if (verb == "click") return read_click(fields);
  if (verb == "box") return read_box(fields);
  if (verb == "navigate") return read_navigate(fields);
  if (verb == "expect") return Expect{fields.one_of("what", {"objects", "findings", "strokes"}), fields.count("count")};
  throw Mistake{"there is no step \"" + verb + "\""};
}

Step read_line(std::string_view text) {
  const Json object = Json::parse(text, nullptr, false);
  if (!object.is_object()) throw Mistake{"it is no JSON object"};
  Fields fields(object);
  Step step = read_step(fields);
  fields.refuse_unknown();
  return step;
}

Finding finding_of(const Mistake& mistake, const std::string& file, std::int64_t line) {
  return make_error(Category::Malformed, "E_REPLAY",
                    "Line " + std::to_string(line) + " of the recording can't be replayed: " + mistake.sentence + '.',
                    {{SubjectKind::Line, std::to_string(line), file, line, {}}});
}

// ---- Writing

Json numbers(const Vec2& pair) { return Json::array({pair.x(), pair.y()}); }

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
  Json json = {{"do", "click"}, {"view", step.view}, {"at", numbers(step.at)}};
  add_modifiers(json, step.modifiers);
  return json;
}

Json to_json(const Box& step) {
  Json json = {{"do", "box"}, {"view", step.view}, {"from", numbers(step.from)}, {"to", numbers(step.to)}};
  add_modifiers(json, step.modifiers);
  return json;
}

Json to_json(const Navigate& step) {
  return {{"do", "navigate"}, {"view", step.view}, {"motion", step.motion}, {"by", numbers(step.by)}};
}

Json to_json(const Expect& step) { return {{"do", "expect"}, {"what", step.what}, {"count", step.count}}; }

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
