// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>
#include <vector>

#include "croquis/base/text.h"
#include "croquis/io/curve_network_file.h"

namespace croquis {
namespace {

std::vector<Vec3> points_on(const NetworkCurve& curve) {
  if (curve.straight) return {curve.pieces.front().points[0], curve.pieces.back().points[3]};
  std::vector<Vec3> points{curve.pieces.front().points[0]};
  for (const RationalCubic& piece : curve.pieces) {
    for (int span = 1; span <= curve_file_spans; ++span) points.push_back(piece.at(double(span) / curve_file_spans));
  }
  return points;
}

/// Names end with the line.
std::string one_line(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return name;
}

}  // namespace

std::string write_curve_network_obj(const CurveNetwork& network) {
  std::string text;
  std::size_t written = 0;  // OBJ counts points of the whole file, from 1
  for (const NetworkCurve& curve : network.curves) {
    const std::vector<Vec3> points = points_on(curve);
    text += "o " + one_line(curve.id) + "\n";
    for (const Vec3& point : points) {
      text += "v " + number_text(point.x()) + ' ' + number_text(point.y()) + ' ' + number_text(point.z()) + "\n";
    }
    text += 'l';
    for (std::size_t i = 0; i < points.size(); ++i) text += ' ' + std::to_string(++written);
    text += "\n";
  }
  return text;
}

}  // namespace croquis
