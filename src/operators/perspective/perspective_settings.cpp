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
    throw Error(
        refused_value("known-point", text, "a place of the drawing and its coordinates, such as 314,527=0,0,0"));
  return {{at[0], at[1]}, {point[0], point[1], point[2]}};
}

/// "e03=4".
KnownLength read_known_length(const std::string& text) {
  const std::size_t sign = text.rfind('=');
  const bool is_pair = sign != std::string::npos && sign > 0;
  const auto length = is_pair ? usable_number(std::string_view(text).substr(sign + 1)) : std::nullopt;
  if (!length || *length <= 0) throw Error(refused_value("scale", text, "a stroke and its length, such as e03=4"));
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

void require_stroke(const PerspectiveDrawing& drawing, const std::string& id, const std::string& parameter) {
  if (std::ranges::any_of(drawing.strokes, [&](const PerspectiveStroke& stroke) { return stroke.id == id; })) return;
  throw Error(make_error(Category::Usage, "E_PARAMETER",
                         "There is no stroke '" + id + "' in the drawing: " + parameter + " takes names of strokes.",
                         {{SubjectKind::Parameter, parameter, {}, {}, {}}}));
}

}  // namespace

void list_perspective_parameters(PerspectiveSettings& settings, ParameterList& list) {
  const auto strokes = [&](const char* name, const char* sentence, ParameterList::Read read) {
    list.list(name, sentence, std::move(read)).at(ParameterPlace::Nowhere);  // people set it at the strokes themselves
  };
  // What the drawing itself says of its camera has fields in its own panel.
  list.choice("mode", settings.network.camera.mode, {"auto", "1", "2", "3"},
              "How many vanishing points aren't at infinity; auto takes the simplest that the lines agree with.")
      .titled("Vanishing points", {"found", "1", "2", "3"})
      .at(ParameterPlace::Nowhere);
  list.angle("smooth-angle", settings.smooth_angle, 2, 30,
             "Strokes and faces that turn less go on smoothly into each other.")
      .titled("Smooth below", {"sharp", "round"});
  list.number("tolerance", settings.solid.tessellation.chord_tolerance, 0.00001, 0.01,
              {"× the solid's diagonal", ParameterLength::Output},
              "Greatest distance of the mesh from the surfaces: smaller is finer.")
      .titled("Detail", {"fine", "coarse"});
  list.text("known-point", "", "A place of the drawing and its coordinates in space: U,V=X,Y,Z.",
            [&](const std::string& text) {
              if (!text.empty()) settings.known_point = read_known_point(text);
            })
      .at(ParameterPlace::Nowhere);
  strokes("scale", "The length of a stroke in space: STROKE=LENGTH.", [&](const std::string& text) {
    for (const std::string& item : items_of(text)) settings.known_lengths.push_back(read_known_length(item));
  });
  list.number("field-of-view", settings.field_of_view, 170, "degrees",
              "Across the width of the sheet, where it is known; 0 where it isn't.")
      .at(ParameterPlace::Nowhere);
  list.flag("flip", settings.network.camera.turn_round, "x and y point the other way; a drawing doesn't show which.")
      .titled("Turn x and y round")
      .at(ParameterPlace::Nowhere);
  strokes("ignore", "A stroke that is left out.", [&](const std::string& text) { settings.ignored = items_of(text); });
  list.flag("fix", settings.fix, "Makes the first proposed change of a stroke that contradicts the others.")
      .at(ParameterPlace::Nowhere);
  strokes("faces", "Faces that must be there, each by its strokes: e1+e2+e3.",
          [&](const std::string& text) { settings.faces.fixed = read_face_names(text); });
  strokes("no-faces", "Faces that must not be there, each by its strokes: e1+e2+e3.",
          [&](const std::string& text) { settings.faces.forbidden = read_face_names(text); });
  strokes("sharp", "Strokes along which faces stay sharp.",
          [&](const std::string& text) { settings.solid.continuity.sharp = items_of(text); });
  list.integer("search-limit", settings.faces.node_limit, 10, 100000000, "",
               "Steps of the search for faces, for each part of the drawing.")
      .titled("Steps of the search for faces")
      .at(ParameterPlace::Expert);
}

PerspectiveDrawing with_settings(const PerspectiveDrawing& drawing, const PerspectiveSettings& settings) {
  PerspectiveDrawing result = drawing;
  for (const std::string& id : settings.ignored) {
    require_stroke(drawing, id, "ignore");
    std::erase_if(result.strokes, [&](const PerspectiveStroke& stroke) { return stroke.id == id; });
  }
  if (settings.known_point) result.known_point = settings.known_point;
  if (!settings.known_lengths.empty()) result.known_lengths = settings.known_lengths;
  for (const KnownLength& known : settings.known_lengths) require_stroke(drawing, known.stroke, "scale");
  if (settings.field_of_view) result.field_of_view = *settings.field_of_view * std::numbers::pi / 180;
  return result;
}

}  // namespace croquis
