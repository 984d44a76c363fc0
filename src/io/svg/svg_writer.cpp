// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/svg_writer.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "io/svg/svg_text.h"

namespace croquis {
namespace {

void append_number(std::string& text, double value) {
  char buffer[32];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value + 0.0).ptr);
}

void append_point(std::string& text, const Vec2& point) {
  append_number(text, point.x());
  text += ' ';
  append_number(text, -point.y());
}

struct Box {
  Vec2 min = Vec2::Zero();
  Vec2 max = Vec2::Zero();
};

Box bounding_box(const Drawing& drawing) {
  Box box;
  bool first = true;
  for (const Stroke& stroke : drawing.strokes) {
    for (const StrokeSample& sample : stroke.samples) {
      const Vec2 page(sample.position.x(), -sample.position.y());
      box.min = first ? page : Vec2(box.min.cwiseMin(page));
      box.max = first ? page : Vec2(box.max.cwiseMax(page));
      first = false;
    }
  }
  return box;
}

/// Where the sheet lies in space; sheets at z = 0 have none.
void append_plane(std::string& text, const DrawingPlane& plane) {
  if (plane.is_default()) return;
  text += " data-plane=\"";
  for (const Vec3& vector : {plane.origin, plane.u, plane.v}) {
    for (const double value : vector) {
      if (text.back() != '"') text += ' ';
      append_number(text, value);
    }
  }
  text += '"';
}

void append_header(std::string& text, const Box& box, const DrawingPlane& plane) {
  const Vec2 size = box.max - box.min;
  const double margin = 0.03 * std::max(size.x(), size.y()) + 1e-9;
  text += "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
  for (const double value : {box.min.x() - margin, box.min.y() - margin, size.x() + 2 * margin}) {
    append_number(text, value);
    text += ' ';
  }
  append_number(text, size.y() + 2 * margin);
  text += '"';
  append_plane(text, plane);
  text += ">\n<g fill=\"none\" stroke=\"#222\" stroke-width=\"";
  append_number(text, 0.1 * margin);
  text += "\">\n";
}

void append_stroke(std::string& text, const Stroke& stroke, double dash) {
  text += "<path";
  append_svg_attribute(text, "id", stroke.id);
  for (const auto& [name, value] : stroke.data) append_svg_attribute(text, "data-" + name, value);
  const auto visible = stroke.data.find("visible");
  if (visible != stroke.data.end() && visible->second == "false") {
    text += " stroke-dasharray=\"";
    append_number(text, dash);
    text += "\"";
  }
  text += " d=\"";
  const char* command = "M ";
  for (const StrokeSample& sample : stroke.samples) {
    text += command;
    append_point(text, sample.position);
    command = " L ";
  }
  text += stroke.closed ? " Z\"/>\n" : "\"/>\n";
}

/// What belongs to an object is in a group of its own, so that strokes keep their order.
void append_group_start(std::string& text, const Drawing& drawing, const std::string& object) {
  text += "<g";
  append_svg_attribute(text, "data-object", object);
  const auto found = drawing.object_data.find(object);
  if (found != drawing.object_data.end()) {
    for (const auto& [name, value] : found->second) append_svg_attribute(text, "data-" + name, value);
  }
  text += ">\n";
}

}  // namespace

std::string write_svg_drawing(const Drawing& drawing) {
  const Box box = bounding_box(drawing);
  std::string text;
  append_header(text, box, drawing.plane);
  const double dash = 0.008 * (box.max - box.min).norm();
  for (const Stroke& stroke : drawing.strokes) {
    if (!stroke.object.empty()) append_group_start(text, drawing, stroke.object);
    append_stroke(text, stroke, dash);
    if (!stroke.object.empty()) text += "</g>\n";
  }
  return text + "</g>\n</svg>\n";
}

}  // namespace croquis
