// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <string_view>

#include "croquis/base/text.h"
#include "croquis/io/perspective_drawing_file.h"
#include "io/perspective/perspective_strokes.h"
#include "io/text.h"

namespace croquis {
namespace {

template <typename Vector>
std::string point_text(const Vector& point) {
  std::string text;
  for (const double coordinate : point) text += (text.empty() ? "" : " ") + number_text(coordinate);
  return text;
}

void append_root(std::string& text, const PerspectiveDrawing& drawing) {
  text += "<svg xmlns=\"http://www.w3.org/2000/svg\"";
  append_xml_attribute(text, "xmlns:cq", perspective_namespace);
  append_xml_attribute(text, "cq:profile", perspective_format);
  append_xml_attribute(text, "width", number_text(drawing.image_size.x()));
  append_xml_attribute(text, "height", number_text(drawing.image_size.y()));
  append_xml_attribute(text, "viewBox", point_text(drawing.origin) + " " + point_text(drawing.image_size));
  text += ">\n";
}

void append_fact(std::string& text, std::string_view name, std::string_view value) {
  text.append("<cq:").append(name);
  append_xml_attribute(text, "value", value);
  text += "/>\n";
}

void append_metadata(std::string& text, const PerspectiveDrawing& drawing) {
  text += "<metadata>\n";
  if (drawing.known_point) {
    text += "<cq:known";
    append_xml_attribute(text, "at", point_text(drawing.known_point->at));
    append_xml_attribute(text, "point", point_text(drawing.known_point->point));
    text += "/>\n";
  }
  for (const KnownLength& known : drawing.known_lengths) {
    text += "<cq:length";
    append_xml_attribute(text, "stroke", known.stroke);
    append_xml_attribute(text, "value", number_text(known.length));
    text += "/>\n";
  }
  if (drawing.field_of_view) append_fact(text, "fov_x_deg", number_text(degrees_of(*drawing.field_of_view)));
  if (drawing.principal_point) {
    text += "<cq:principal";
    append_xml_attribute(text, "at", point_text(*drawing.principal_point));
    text += "/>\n";
  }
  if (!drawing.unit.empty()) append_fact(text, "unit", drawing.unit);
  if (drawing.shells) append_fact(text, "shells", std::to_string(*drawing.shells));
  text += "</metadata>\n";
}

void append_path_data(std::string& text, const PerspectiveStroke& stroke) {
  text += " d=\"M " + point_text(stroke.start());
  if (stroke.straight) {
    text += " L " + point_text(stroke.end());
  } else {
    for (const PictureCubic& piece : stroke.pieces) {
      text += " C " + point_text(piece[1]) + " " + point_text(piece[2]) + " " + point_text(piece[3]);
    }
  }
  text += "\"";
}

void append_stroke(std::string& text, const PerspectiveStroke& stroke) {
  text += "<path";
  append_xml_attribute(text, "id", stroke.id);
  const bool unknown = stroke.group == StrokeGroup::Unknown;
  append_xml_attribute(text, "cq:group", unknown ? "unknown" : std::to_string(static_cast<int>(stroke.group)));
  each_set_field(stroke, [&]<typename T>(const StrokeField& field, const T& value) {
    std::string name = std::string("cq:") + field.name;
    std::ranges::replace(name, '_', '-');
    if constexpr (std::is_same_v<T, bool>) {
      append_xml_attribute(text, name, "true");
    } else if constexpr (std::is_same_v<T, double>) {
      append_xml_attribute(text, name, number_text(value));
    } else {
      append_xml_attribute(text, name, value);
    }
  });
  append_xml_attribute(text, "stroke", stroke.colour.empty() ? colour_of_group(stroke.group) : stroke.colour);
  if (stroke.hidden) append_xml_attribute(text, "stroke-dasharray", "2 3");
  append_path_data(text, stroke);
  text += "/>\n";
}

/// A group for each run of strokes of one role, so that their order stays.
void append_strokes(std::string& text, const PerspectiveDrawing& drawing) {
  for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
    const StrokeRole role = drawing.strokes[i].role;
    if (i == 0 || drawing.strokes[i - 1].role != role) {
      text += i == 0 ? "" : "</g>\n";
      text.append("<g cq:role=\"").append(word_of(role, stroke_role_words)).append("\" fill=\"none\"");
      text += role == StrokeRole::Edge ? " stroke-width=\"2\" stroke-linecap=\"round\">\n"
                                       : " stroke-width=\"0.8\" stroke-dasharray=\"6 4\">\n";
    }
    append_stroke(text, drawing.strokes[i]);
  }
  if (!drawing.strokes.empty()) text += "</g>\n";
}

}  // namespace

std::string write_perspective_svg(const PerspectiveDrawing& drawing) {
  std::string text;
  append_root(text, drawing);
  append_metadata(text, drawing);
  append_strokes(text, drawing);
  return text + "</svg>\n";
}

}  // namespace croquis
