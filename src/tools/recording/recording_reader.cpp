// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/recording/recording_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/geometry/mesh_tags.h"

namespace croquis::recorded {
namespace {

using Json = nlohmann::ordered_json;

/// The fields of one line. Every field is read once; one that isn't read is a mistake.
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

  bool has(const std::string& name) { return find(name) != nullptr; }

  double number(const std::string& name) {
    const Json& value = get(name);
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      throw Mistake{"\"" + name + "\" must be a finite number"};
    return value.get<double>();
  }

  bool flag(const std::string& name) {
    const Json& value = get(name);
    if (!value.is_boolean()) throw Mistake{"\"" + name + "\" must be true or false"};
    return value.get<bool>();
  }

  Vec3 triple(const std::string& name) {
    const std::vector<double> numbers = number_list(get(name), name);
    if (numbers.size() != 3) throw Mistake{"\"" + name + "\" must be three numbers"};
    return {numbers[0], numbers[1], numbers[2]};
  }

  ModelPlace model_place(const std::string& name) { return has(name) ? ModelPlace(triple(name)) : std::nullopt; }

  /// A place of the sketch (two numbers) or of the model (three).
  void place(const std::string& name, Vec2& sketch, ModelPlace& model) {
    const Json& value = get(name);
    if (value.is_array() && value.size() == 3) {
      model = triple(name);
    } else {
      sketch = pair(name);
    }
  }

  /// A sharpness of 0 or more, or "inf".
  double sharpness(const std::string& name) {
    const Json& value = get(name);
    if (value.is_string() && value.get<std::string>() == "inf") return infinite_sharpness;
    if (!value.is_number() || !std::isfinite(value.get<double>()) || value.get<double>() < 0)
      throw Mistake{"\"" + name + "\" must be a number of at least 0, or \"inf\""};
    return value.get<double>();
  }

  Index index(const std::string& name) { return as_index(get(name), name); }

  std::vector<Index> indices(const std::string& name) {
    const Json& list = get(name);
    if (!list.is_array()) throw Mistake{"\"" + name + "\" must be a list of whole numbers"};
    std::vector<Index> values;
    for (const Json& value : list) values.push_back(as_index(value, name));
    return values;
  }

  static Index as_index(const Json& value, const std::string& name) {
    if (!value.is_number_integer() || value.get<double>() < 0 || value.get<double>() >= no_index)
      throw Mistake{"\"" + name + "\" must hold whole numbers of at least 0"};
    return value.get<Index>();
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

Step read_model_drag(Fields& fields) {
  ModelDrag step;
  step.view = fields.text("view", step.view);
  step.from = fields.triple("from");
  step.to = fields.triple("to");
  step.modifiers = fields.modifiers();
  return step;
}

Step read_drag(Fields& fields) {
  if (fields.has("from")) return read_model_drag(fields);
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
  fields.place("at", step.at, step.place);
  if (fields.has("clicks")) step.clicks = static_cast<int>(fields.count("clicks"));
  if (step.clicks < 1 || step.clicks > 2) throw Mistake{"\"clicks\" must be 1 or 2"};
  step.modifiers = fields.modifiers();
  return step;
}

Step read_box(Fields& fields) {
  Box step;
  step.view = fields.text("view", step.view);
  fields.place("from", step.from, step.from_place);
  fields.place("to", step.to, step.to_place);
  if (step.from_place.has_value() != step.to_place.has_value())
    throw Mistake{"\"from\" and \"to\" must both have two numbers, or both three"};
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

// ---- Meshes

Step read_pick(Fields& fields) {
  static const std::vector<std::string> hows = {"replace", "add",  "remove",    "toggle", "loop",
                                                "ring",    "path", "connected", "chain",  "all"};
  Pick step;
  step.node = fields.text("node");
  step.kind = fields.one_of("kind", {"vertex", "edge", "face"});
  step.elements = fields.indices("elements");
  if (fields.has("how")) step.how = fields.one_of("how", hows);
  return step;
}

Step read_move(Fields& fields) { return Move{fields.text("node"), fields.triple("by")}; }

Step read_rotate(Fields& fields) {
  Rotate step{fields.text("node"), fields.triple("axis"), fields.number("degrees"), fields.model_place("pivot")};
  if (step.axis.isZero(0)) throw Mistake{"\"axis\" may not be zero"};
  return step;
}

Step read_scale(Fields& fields) {
  return Scale{fields.text("node"), fields.triple("factors"), fields.model_place("pivot")};
}

Step read_tag(Fields& fields) {
  Tag step;
  step.node = fields.text("node");
  if (fields.has("edges")) step.edges = fields.one_of("edges", {"selected", "boundary", "tagged", "sharper-than"});
  if (step.edges == "sharper-than") step.degrees = fields.number("degrees");
  if (fields.has("change")) {
    step.change = fields.number("change");
  } else {
    step.sharpness = fields.sharpness("sharpness");
  }
  return step;
}

Step read_pin(Fields& fields) {
  Pin step{fields.text("node"), true};
  if (fields.has("pinned")) step.pinned = fields.flag("pinned");
  return step;
}

Step read_tag_set(Fields& fields) {
  TagSet step;
  step.node = fields.text("node");
  step.how = fields.one_of("how", {"make", "rename", "sharpness", "select", "merge", "remove", "untag"});
  step.name = fields.text("name");
  if (step.how == "rename" || step.how == "merge") step.other = fields.text("other");
  if (step.how == "sharpness" || (step.how == "make" && fields.has("sharpness")))
    step.sharpness = fields.sharpness("sharpness");
  return step;
}

Step read_extrude(Fields& fields) { return Extrude{fields.text("node"), fields.triple("by")}; }

Step read_loop_cut(Fields& fields) {
  LoopCut step{fields.text("node"), fields.index("edge"), 0.5};
  if (fields.has("at")) step.at = fields.number("at");
  if (!(step.at > 0 && step.at < 1)) throw Mistake{"\"at\" must be between 0 and 1"};
  return step;
}

Step read_face_set(Fields& fields) {
  FaceSetChoice step{fields.text("node"), {}};
  const Json& names = fields.get("names");
  if (!names.is_array() || names.empty()) throw Mistake{"\"names\" must be a list of names"};
  for (const Json& name : names) {
    if (!name.is_string()) throw Mistake{"\"names\" must be a list of names"};
    step.names.push_back(name.get<std::string>());
  }
  return step;
}

// ---- Holes

Step read_hole(Fields& fields) {
  HoleChoice step;
  if (fields.has("up-to")) {
    step.action = fields.one_of("action", {"fill"});
    step.up_to = fields.number("up-to");
    if (!(*step.up_to > 0)) throw Mistake{"\"up-to\" must be greater than 0"};
    step.node = fields.text("node", "");
    return step;
  }
  step.holes = fields.has("hole") ? std::vector<Index>{fields.index("hole")} : fields.indices("holes");
  if (fields.has("action"))
    step.action = fields.one_of("action", {"select", "add", "remove", "toggle", "fill", "leave"});
  if (step.holes.empty() && step.action != "select")
    throw Mistake{"\"holes\" must name a hole for \"" + step.action + "\""};
  step.node = fields.text("node", "");
  return step;
}

Step read_hole_way(Fields& fields) {
  HoleWay step{fields.has("holes") ? fields.indices("holes") : std::vector<Index>{}};
  if (fields.has("fairness")) step.fairness = fields.one_of("fairness", {"auto", "rbf", "smooth", "flat"});
  if (fields.has("kernel")) step.kernel = fields.text("kernel");
  if (fields.has("bulge")) step.bulge = fields.number("bulge");
  if (fields.has("trim-rim")) step.trim_rim = fields.count("trim-rim");
  if (step.bulge && std::abs(*step.bulge) > 1) throw Mistake{"\"bulge\" must be from -1 to 1"};
  if (!step.fairness && !step.kernel && !step.bulge && !step.trim_rim)
    throw Mistake{"\"fairness\", \"kernel\", \"bulge\" or \"trim-rim\" is missing"};
  step.node = fields.text("node", "");
  return step;
}

Step read_hole_point(Fields& fields) {
  HolePoint step{fields.index("hole"), fields.model_place("from"), fields.model_place("to"), fields.text("node", "")};
  if (!step.from && !step.to) throw Mistake{"\"from\", \"to\" or both are missing"};
  return step;
}

Step read_expect(Fields& fields) {
  Expect step;
  step.what = fields.one_of("what", {"objects", "findings", "strokes", "faces", "vertices", "edges", "sharp-edges",
                                     "selected", "holes", "patches", "dihedral"});
  step.node = fields.text("node", "");
  if (step.what == "dihedral") {
    step.value = fields.number("value");
    if (fields.has("to")) step.to = fields.number("to");
  } else {
    step.count = fields.count("count");
  }
  return step;
}

/// Steps that work on a mesh.
std::optional<Step> read_mesh_step(const std::string& verb, Fields& fields) {
  if (verb == "pick") return read_pick(fields);
  if (verb == "move") return read_move(fields);
  if (verb == "rotate") return read_rotate(fields);
  if (verb == "scale") return read_scale(fields);
  if (verb == "tag") return read_tag(fields);
  if (verb == "pin") return read_pin(fields);
  if (verb == "tag-set") return read_tag_set(fields);
  if (verb == "extrude") return read_extrude(fields);
  if (verb == "loop-cut") return read_loop_cut(fields);
  return std::nullopt;
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
  if (verb == "expect") return read_expect(fields);
  if (verb == "face-set") return read_face_set(fields);
  if (verb == "hole") return read_hole(fields);
  if (verb == "hole-way") return read_hole_way(fields);
  if (verb == "hole-point") return read_hole_point(fields);
  if (std::optional<Step> step = read_mesh_step(verb, fields)) return *std::move(step);
  throw Mistake{"there is no step \"" + verb + "\""};
}

}  // namespace

Step read_line(std::string_view text) {
  const Json object = Json::parse(text, nullptr, false);
  if (!object.is_object()) throw Mistake{"it is no JSON object"};
  Fields fields(object);
  Step step = read_step(fields);
  fields.refuse_unknown();
  return step;
}

}  // namespace croquis::recorded
