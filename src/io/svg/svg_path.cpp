// SPDX-License-Identifier: GPL-3.0-or-later
// What attributes of shapes hold: path data, points, transforms.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/limits.h"
#include "io/svg/svg_shapes.h"
#include "io/text.h"

namespace croquis {
namespace {

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

constexpr std::string_view commands = "MLHVCSQTAZ";
constexpr std::array<std::size_t, 10> number_counts = {2, 2, 1, 1, 6, 4, 4, 2, 7, 0};  // of each command
constexpr std::size_t most_numbers = 7;

/// One run over the path data. Commands append to the last subpath.
class PathParser {
 public:
  explicit PathParser(std::string_view data) : scanner_(data) {}

  SvgOutline run() {
    scanner_.skip_blanks();
    while (!outline_.error && !scanner_.at_end()) {
      read_command();
      scanner_.skip_blanks();
    }
    return std::move(outline_);
  }

 private:
  void fail(std::string message, bool limit = false) {
    if (!outline_.error) outline_.error = SvgTextError{std::move(message), scanner_.position(), limit};
  }

  void read_command() {
    const char letter = scanner_.peek();
    if (commands.find(upper(letter)) == std::string_view::npos) {
      return fail("has " + in_quotes(std::string_view(&letter, 1)) + " where a command must stand");
    }
    if (outline_.subpaths.empty() && upper(letter) != 'M') return fail("must begin with a moveto (M or m)");
    scanner_.take();
    command_ = upper(letter);
    relative_ = letter != command_;
    scanner_.skip_blanks();
    do {
      std::array<double, most_numbers> numbers{};
      if (read_numbers(numbers)) apply(numbers);
      previous_ = command_;
      if (command_ == 'M') command_ = 'L';  // further pairs after a moveto are lines
    } while (!outline_.error && command_ != 'Z' && another_set_follows());
  }

  /// The same command again when a number follows; a comma must be followed by one.
  bool another_set_follows() {
    scanner_.skip_blanks();
    const bool comma = scanner_.peek() == ',';
    if (comma) scanner_.skip_separators();
    const char next = scanner_.peek();
    // NaN and Infinity count, so that they are refused by name.
    const bool number =
        (next >= '0' && next <= '9') || std::string_view("+-.nNiI").find(next) != std::string_view::npos;
    if (comma && !number) fail("has a comma without a number after it");
    return number;
  }

  /// Those that the command takes; no comma stands before the first one. False after an error.
  bool read_numbers(std::array<double, most_numbers>& numbers) {
    const std::size_t count = number_counts[commands.find(command_)];
    for (std::size_t i = 0; i < count; ++i) {
      if (i > 0) scanner_.skip_separators();
      const bool is_flag = command_ == 'A' && (i == 3 || i == 4);
      const auto value = is_flag ? std::optional<double>(scanner_.flag()) : scanner_.number();
      if (!value) {
        const std::string letter = relative_ ? lower_case({&command_, 1}) : std::string(1, command_);
        return fail(is_flag ? "has an arc flag that is neither 0 nor 1" : "lacks a number for its command " + letter),
               false;
      }
      numbers[i] = *value;
    }
    return true;
  }

  void apply(const std::array<double, most_numbers>& numbers) {
    const auto place = [&](std::size_t i) {
      const Vec2 given(numbers[i], numbers[i + 1]);
      return relative_ ? Vec2(current_ + given) : given;
    };
    const auto goes_on = [&](char other) { return previous_ == other || previous_ == command_; };
    switch (command_) {
      case 'M': start(place(0)); return;
      case 'L': append_line(place(0)); return;
      case 'H': append_line({relative_ ? current_.x() + numbers[0] : numbers[0], current_.y()}); return;
      case 'V': append_line({current_.x(), relative_ ? current_.y() + numbers[0] : numbers[0]}); return;
      case 'C': append(svg_cubic(place(0), place(2), place(4)), place(2)); return;
      case 'S': append(svg_cubic(goes_on('C') ? mirrored() : current_, place(0), place(2)), place(0)); return;
      case 'Q': append_quadratic(place(0), place(2)); return;
      case 'T': append_quadratic(goes_on('Q') ? mirrored() : current_, place(0)); return;
      case 'A': {
        const Vec2 end = place(5);
        if (end == current_) return;  // F.6.2: an arc to where it begins is left out
        append(svg_arc(current_, {numbers[0], numbers[1], numbers[2], numbers[3] != 0, numbers[4] != 0}, end), end);
        return;
      }
      default: close();
    }
  }

  /// The first handle of a command that goes on smoothly.
  Vec2 mirrored() const { return 2 * current_ - handle_; }

  void start(const Vec2& at) {
    if (++segments_ > most_curve_pieces) return fail("has too many pieces", true);
    outline_.subpaths.emplace_back();
    outline_.subpaths.back().start = at;
    current_ = handle_ = at;
  }

  /// @param handle the control point that S or T would mirror
  void append(const SvgSegment& segment, const Vec2& handle) {
    if (outline_.subpaths.back().closed) start(current_);  // drawing goes on after a Z
    if (outline_.error) return;
    if (++segments_ > most_curve_pieces) return fail("has too many pieces", true);
    outline_.subpaths.back().segments.push_back(segment);
    current_ = segment.end;
    handle_ = handle;
  }

  void append_line(const Vec2& end) { append(svg_line(end), end); }

  /// A quadratic is the cubic whose handles lie two thirds towards its control point.
  void append_quadratic(const Vec2& control, const Vec2& end) {
    append(svg_cubic(current_ + 2.0 / 3 * (control - current_), end + 2.0 / 3 * (control - end), end), control);
  }

  void close() {
    outline_.subpaths.back().closed = true;
    current_ = handle_ = outline_.subpaths.back().start;
  }

  SvgScanner scanner_;
  SvgOutline outline_;
  char command_ = 'M';
  char previous_ = 'M';
  bool relative_ = false;
  std::size_t segments_ = 0;
  Vec2 current_ = Vec2::Zero();
  Vec2 handle_ = Vec2::Zero();
};

}  // namespace

SvgOutline parse_svg_path(std::string_view data) { return PathParser(data).run(); }

SvgOutline parse_svg_points(std::string_view points, bool closed) {
  SvgOutline outline;
  SvgScanner scanner(points);
  scanner.skip_blanks();
  for (std::size_t count = 0; !scanner.at_end() && !outline.error; ++count) {
    const std::optional<double> x = scanner.number();
    scanner.skip_separators();
    const std::optional<double> y = scanner.number();
    scanner.skip_separators();
    if (!x || !y) {
      outline.error = SvgTextError{"needs pairs of numbers", scanner.position()};
    } else if (count == most_curve_pieces) {
      outline.error = SvgTextError{"has too many points", scanner.position(), true};
    } else if (outline.subpaths.empty()) {
      outline.subpaths.emplace_back();
      outline.subpaths.back().start = Vec2(x.value_or(0), y.value_or(0));
      outline.subpaths.back().closed = closed;
    } else {
      outline.subpaths.back().segments.push_back(svg_line({x.value_or(0), y.value_or(0)}));
    }
  }
  return outline;
}

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
