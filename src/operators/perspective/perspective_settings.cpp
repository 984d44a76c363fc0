// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/perspective/perspective_settings.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// What people set at the strokes themselves.
ParameterDescription stroke_list(const std::string& name, const std::string& sentence) {
  return list_parameter(name, sentence).at(ParameterPlace::Nowhere);
}

[[noreturn]] void refuse_value(const std::string& name, std::string_view value, const std::string& instead) {
  throw Error(make_error(Category::Usage, "E_PARAMETER",
                         "'" + std::string(value) + "' is no value for " + name + ": it takes " + instead + ".",
                         {{SubjectKind::Parameter, name, {}, {}, {}}}));
}

/// The numbers between separators; none where one of them can't be read.
std::vector<double> numbers_in(std::string_view text, std::string_view separators) {
  std::vector<double> numbers;
  for (const std::string_view part : text_parts(text, separators)) {
    const auto number = usable_number(part);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/// Items of a list that ';' separates.
std::vector<std::string> items_of(const std::string& list) {
  const std::vector<std::string_view> items = text_parts(list, ";");
  return {items.begin(), items.end()};
}

/// "314,527=0,0,0".
KnownPoint read_known_point(const std::string& text) {
  const std::size_t sign = std::min(text.find('='), text.size());
  const std::vector<double> at = numbers_in(std::string_view(text).substr(0, sign), ",");
  const std::vector<double> point = numbers_in(sign < text.size() ? std::string_view(text).substr(sign + 1) : "", ",");
  if (at.size() != 2 || point.size() != 3)
    refuse_value("known-point", text, "a place of the drawing and its coordinates, such as 314,527=0,0,0");
  return {{at[0], at[1]}, {point[0], point[1], point[2]}};
}

/// "e03=4".
KnownLength read_known_length(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  const bool is_pair = sign != std::string::npos && sign > 0;
  const auto length = is_pair ? usable_number(std::string_view(text).substr(sign + 1)) : std::nullopt;
  if (!length || *length <= 0) refuse_value("scale", text, "a stroke and its length, such as e03=4");
  return {text.substr(0, sign), *length};
}

/// Faces by their strokes: "e1+e2+e3".
std::vector<FaceName> read_face_names(const std::string& list) {
  std::vector<FaceName> names;
  for (const std::string& item : items_of(list)) {
    FaceName name;
    for (const std::string_view stroke : text_parts(item, "+")) name.emplace_back(stroke);
    names.push_back(std::move(name));
  }
  return names;
}

/// How the solid's faces are chosen.
std::vector<ParameterDescription> face_parameters() {
  return {stroke_list("faces", "Faces that must be there, each by its strokes: e1+e2+e3."),
          stroke_list("no-faces", "Faces that must not be there, each by its strokes: e1+e2+e3."),
          stroke_list("sharp", "Strokes along which faces stay sharp."),
          integer_parameter("search-limit", 200000, 10, 100000000, "",
                            "Steps of the search for faces, for each part of the drawing.")
              .titled("Steps of the search for faces")
              .at(ParameterPlace::Expert)};
}

PerspectiveMode mode_of(const std::string& name) {
  return name == "auto" ? PerspectiveMode::Automatic : static_cast<PerspectiveMode>(name[0] - '0');
}

void require_stroke(const PerspectiveDrawing& drawing, const std::string& id, const std::string& parameter) {
  if (std::ranges::any_of(drawing.strokes, [&](const PerspectiveStroke& stroke) { return stroke.id == id; })) return;
  throw Error(make_error(Category::Usage, "E_PARAMETER",
                         "There is no stroke '" + id + "' in the drawing: " + parameter + " takes names of strokes.",
                         {{SubjectKind::Parameter, parameter, {}, {}, {}}}));
}

}  // namespace

std::vector<ParameterDescription> perspective_parameters() {
  std::vector<ParameterDescription> parameters = {
      choice_parameter(
          "mode", {"auto", "1", "2", "3"},
          "How many vanishing points aren't at infinity; auto takes the simplest that the lines agree with.")
          .titled("Vanishing points", {"found", "1", "2", "3"}),
      number_parameter("smooth-angle", 15, 2, 30, "degrees",
                       "Strokes and faces that turn less go on smoothly into each other.")
          .titled("Smooth below"),
      number_parameter("tolerance", 0.0005, 0.00001, 0.01, "× the solid's diagonal",
                       "Greatest distance of the mesh from the surfaces: smaller is finer.")
          .titled("Detail"),
      text_parameter("known-point", "", "A place of the drawing and its coordinates in space: U,V=X,Y,Z.")
          .at(ParameterPlace::Nowhere),
      stroke_list("scale", "The length of a stroke in space: STROKE=LENGTH."),
      number_parameter("field-of-view", 0, 0, 170, "degrees",
                       "Across the width of the sheet, where it is known; 0 where it isn't.")
          .at(ParameterPlace::Expert),
      flag_parameter("flip", false, "x and y point the other way; a drawing doesn't tell which.")
          .titled("Turn x and y round")
          .at(ParameterPlace::Expert),
      stroke_list("ignore", "A stroke that is left out."),
      flag_parameter("fix", false, "Makes the first proposed change of a stroke that contradicts the others.")
          .at(ParameterPlace::Nowhere)};
  for (ParameterDescription& parameter : face_parameters()) parameters.push_back(std::move(parameter));
  return parameters;
}

PerspectiveSettings read_perspective_settings(const ParameterValues& parameters) {
  PerspectiveSettings settings;
  settings.network.camera.mode = mode_of(text_of(parameters, "mode"));
  settings.network.camera.turn_round = flag_of(parameters, "flip");
  const double angle = number_of(parameters, "smooth-angle") * degree;
  settings.network.continuity.angle = angle;
  settings.solid.continuity.angle = angle;
  settings.solid.continuity.sharp = items_of(text_of(parameters, "sharp"));
  settings.solid.tessellation.chord_tolerance = number_of(parameters, "tolerance");
  settings.faces.fixed = read_face_names(text_of(parameters, "faces"));
  settings.faces.forbidden = read_face_names(text_of(parameters, "no-faces"));
  settings.faces.node_limit = static_cast<std::size_t>(integer_of(parameters, "search-limit"));
  settings.fix = flag_of(parameters, "fix");
  return settings;
}

PerspectiveDrawing with_parameters(const PerspectiveDrawing& drawing, const ParameterValues& parameters) {
  PerspectiveDrawing result = drawing;
  for (const std::string& id : items_of(text_of(parameters, "ignore"))) {
    require_stroke(drawing, id, "ignore");
    std::erase_if(result.strokes, [&](const PerspectiveStroke& stroke) { return stroke.id == id; });
  }
  if (const std::string& known = text_of(parameters, "known-point"); !known.empty())
    result.known_point = read_known_point(known);
  const std::vector<std::string> lengths = items_of(text_of(parameters, "scale"));
  if (!lengths.empty()) result.known_lengths.clear();
  for (const std::string& item : lengths) {
    result.known_lengths.push_back(read_known_length(item));
    require_stroke(drawing, result.known_lengths.back().stroke, "scale");
  }
  if (const double field = number_of(parameters, "field-of-view"); field > 0) result.field_of_view = field * degree;
  return result;
}

}  // namespace croquis
