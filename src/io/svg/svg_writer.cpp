// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/svg_writer.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "io/text.h"

namespace croquis {
namespace {

// Adding 0 makes 0 of -0.
void append_point(std::string& text, const Vec2& point) {
  append_number(text, 0.0 + point.x());
  text += ' ';
  append_number(text, 0.0 + -point.y());
}

Eigen::AlignedBox2d page_of(const Drawing& drawing) {
  Eigen::AlignedBox2d box;
  for (const Stroke& stroke : drawing.strokes) {
    for (const StrokeSample& sample : stroke.samples) box.extend(Vec2(sample.position.x(), -sample.position.y()));
  }
  return box.isEmpty() ? Eigen::AlignedBox2d(Vec2(0, 0)) : box;
}

/// Where the sheet lies in space; sheets at z = 0 have none.
void append_plane(std::string& text, const DrawingPlane& plane) {
  if (plane.is_default()) return;
  text += " data-plane=\"";
  for (const Vec3& vector : {plane.origin, plane.u, plane.v}) {
    for (const double value : vector) {
      if (text.back() != '"') text += ' ';
      append_number(text, 0.0 + value);
    }
  }
  text += '"';
}

void append_header(std::string& text, const Eigen::AlignedBox2d& box, const DrawingPlane& plane) {
  const Vec2 size = box.sizes();
  const double margin = 0.03 * std::max(size.x(), size.y()) + 1e-9;
  text += "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
  for (const double value : {box.min().x() - margin, box.min().y() - margin, size.x() + 2 * margin}) {
    append_number(text, 0.0 + value);
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
  append_xml_attribute(text, "id", stroke.id);
  for (const auto& [name, value] : stroke.data) append_xml_attribute(text, "data-" + name, value);
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
  append_xml_attribute(text, "data-object", object);
  const auto found = drawing.object_data.find(object);
  if (found != drawing.object_data.end()) {
    for (const auto& [name, value] : found->second) append_xml_attribute(text, "data-" + name, value);
  }
  text += ">\n";
}

}  // namespace

std::string write_svg_drawing(const Drawing& drawing) {
  const Eigen::AlignedBox2d box = page_of(drawing);
  std::string text;
  append_header(text, box, drawing.plane);
  const double dash = 0.008 * box.sizes().norm();
  for (const Stroke& stroke : drawing.strokes) {
    if (!stroke.object.empty()) append_group_start(text, drawing, stroke.object);
    append_stroke(text, stroke, dash);
    if (!stroke.object.empty()) text += "</g>\n";
  }
  return text + "</g>\n</svg>\n";
}

}  // namespace croquis
