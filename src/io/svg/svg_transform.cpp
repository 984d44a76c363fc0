// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <vector>

#include "croquis/geometry/vector.h"
#include "io/svg/svg_shapes.h"
#include "io/text.h"

namespace croquis {
namespace {

using Map = Eigen::Affine2d;

double radians(double degrees) { return std::remainder(degrees, 360.0) * std::numbers::pi / 180; }

Map linear(double a, double b, double c, double d) {
  Map map = Map::Identity();
  map.linear() << a, c, b, d;
  return map;
}

Map translation(double x, double y) { return Map(Eigen::Translation2d(x, y)); }

Map rotation(const std::vector<double>& v) {
  const Map turn(Eigen::Rotation2Dd(radians(v[0])));
  return v.size() == 1 ? turn : translation(v[1], v[2]) * turn * translation(-v[1], -v[2]);
}

/// Nothing when there is no such function of so many arguments.
std::optional<Map> named_map(std::string_view name, const std::vector<double>& v) {
  const std::size_t count = v.size();
  if (name == "matrix" && count == 6) return translation(v[4], v[5]) * linear(v[0], v[1], v[2], v[3]);
  if (name == "translate" && (count == 1 || count == 2)) return translation(v[0], count == 2 ? v[1] : 0);
  if (name == "translateX" && count == 1) return translation(v[0], 0);
  if (name == "translateY" && count == 1) return translation(0, v[0]);
  if (name == "scaleX" && count == 1) return linear(v[0], 0, 0, 1);
  if (name == "scaleY" && count == 1) return linear(1, 0, 0, v[0]);
  if (name == "scale" && (count == 1 || count == 2)) return linear(v[0], 0, 0, v[count - 1]);
  if (name == "rotate" && (count == 1 || count == 3)) return rotation(v);
  if (name == "skew" && (count == 1 || count == 2)) {
    return linear(1, count == 2 ? std::tan(radians(v[1])) : 0, std::tan(radians(v[0])), 1);
  }
  if (name == "skewX" && count == 1) return linear(1, 0, std::tan(radians(v[0])), 1);
  if (name == "skewY" && count == 1) return linear(1, std::tan(radians(v[0])), 0, 1);
  return std::nullopt;
}

/// What a number with this unit is in user units, degrees or, for factors, as such; nothing for other units.
std::optional<double> unit_factor(std::string_view unit) {
  if (unit.empty() || unit == "px" || unit == "deg") return 1;
  if (unit == "rad") return 180 / std::numbers::pi;
  if (unit == "turn") return 360;
  if (unit == "grad") return 0.9;
  if (unit == "in") return 96;
  if (unit == "mm") return 96 / 25.4;
  if (unit == "cm") return 96 / 2.54;
  if (unit == "pt") return 96.0 / 72;
  return std::nullopt;
}

/// "(1 2, 3)" or, as CSS writes it, "(10px, 45deg)"; at most six numbers.
std::optional<std::vector<double>> arguments(SvgScanner& scanner) {
  scanner.skip_blanks();
  if (scanner.peek() != '(') return std::nullopt;
  scanner.take();
  scanner.skip_blanks();
  std::vector<double> values;
  while (scanner.peek() != ')') {
    const std::optional<double> value = scanner.number();
    if (!value || values.size() == 6) return std::nullopt;
    const std::optional<double> factor = unit_factor(scanner.word());
    if (!factor) return std::nullopt;
    values.push_back(*value * *factor);
    scanner.skip_separators();
  }
  scanner.take();
  return values;
}

}  // namespace

SvgTransform parse_svg_transform(std::string_view text) {
  SvgTransform transform;
  SvgScanner scanner(text);
  scanner.skip_blanks();
  while (!scanner.at_end()) {
    const std::size_t begin = scanner.position();
    const std::string_view name = scanner.word();
    if (name == "none" && scanner.at_end()) return transform;
    const auto values = arguments(scanner);
    const std::optional<Map> map = values ? named_map(name, *values) : std::nullopt;
    if (!map) {
      transform.error =
          SvgTextError{"has a transform that is not understood, " + in_quotes(text.substr(begin, 40)), begin};
      return transform;
    }
    transform.map = transform.map * *map;
    scanner.skip_separators();
  }
  return transform;
}

}  // namespace croquis
