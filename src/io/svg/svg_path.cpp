// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "croquis/base/limits.h"
#include "io/svg/svg_shapes.h"
#include "io/text.h"

namespace croquis {
namespace {

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

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
  void fail(std::string message) {
    if (!outline_.error) outline_.error = SvgTextError{std::move(message), scanner_.position()};
  }

  void fail_too_long() {
    fail("has too many pieces");
    outline_.error->limit = true;
  }

  void read_command() {
    const char letter = scanner_.peek();
    if (std::string_view("MLHVCSQTAZ").find(upper(letter)) == std::string_view::npos) {
      return fail("has " + in_quotes(std::string_view(&letter, 1)) + " where a command must stand");
    }
    if (outline_.subpaths.empty() && upper(letter) != 'M') return fail("must begin with a moveto (M or m)");
    scanner_.take();
    command_ = upper(letter);
    relative_ = letter != command_;
    if (command_ == 'Z') return close();
    scanner_.skip_blanks();
    do {
      apply();
      previous_ = command_;
      if (command_ == 'M') command_ = 'L';  // further pairs after a moveto are lines
    } while (!outline_.error && another_set_follows());
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

  void apply() {
    switch (command_) {
      case 'M': return move();
      case 'L': return line();
      case 'H': return horizontal();
      case 'V': return vertical();
      case 'C': return cubic();
      case 'S': return smooth_cubic();
      case 'Q': return quadratic();
      case 'T': return smooth_quadratic();
      default: return arc();
    }
  }

  double number() {
    if (outline_.error) return 0;
    if (!first_) scanner_.skip_separators();
    first_ = false;
    const std::optional<double> value = scanner_.number();
    if (!value)
      fail(std::string("lacks a number for its command ") +
           (relative_ ? lower_case({&command_, 1}) : std::string(1, command_)));
    return value.value_or(0);
  }

  bool flag() {
    if (outline_.error) return false;
    scanner_.skip_separators();
    const std::optional<bool> value = scanner_.flag();
    if (!value) fail("has an arc flag that is neither 0 nor 1");
    return value.value_or(false);
  }

  Vec2 place() {
    const double x = number();
    const double y = number();
    return relative_ ? Vec2(current_ + Vec2(x, y)) : Vec2(x, y);
  }

  void start(const Vec2& at) {
    if (++segments_ > most_curve_pieces) return fail_too_long();
    outline_.subpaths.emplace_back();
    outline_.subpaths.back().start = at;
    current_ = at;
  }

  /// @param handle the control point that S or T would mirror
  void append(const SvgSegment& segment, const Vec2& handle) {
    if (outline_.error) return;
    if (outline_.subpaths.back().closed) start(current_);  // drawing goes on after a Z
    if (outline_.error) return;
    if (++segments_ > most_curve_pieces) return fail_too_long();
    outline_.subpaths.back().segments.push_back(segment);
    current_ = segment.end;
    handle_ = handle;
  }

  void append_line(const Vec2& end) { append(svg_line(end), end); }

  void move() {
    first_ = true;
    const Vec2 at = place();
    if (outline_.error) return;
    start(at);
    handle_ = at;
  }

  void line() {
    first_ = true;
    append_line(place());
  }

  void horizontal() {
    first_ = true;
    const double x = number();
    append_line({relative_ ? current_.x() + x : x, current_.y()});
  }

  void vertical() {
    first_ = true;
    const double y = number();
    append_line({current_.x(), relative_ ? current_.y() + y : y});
  }

  void cubic() {
    first_ = true;
    const Vec2 a = place();
    const Vec2 b = place();
    append(svg_cubic(a, b, place()), b);
  }

  void smooth_cubic() {
    first_ = true;
    const bool goes_on = previous_ == 'C' || previous_ == 'S';
    const Vec2 a = goes_on ? Vec2(2 * current_ - handle_) : current_;
    const Vec2 b = place();
    append(svg_cubic(a, b, place()), b);
  }

  /// A quadratic is the cubic whose handles lie two thirds towards its control point.
  void append_quadratic(const Vec2& control, const Vec2& end) {
    append(svg_cubic(current_ + 2.0 / 3 * (control - current_), end + 2.0 / 3 * (control - end), end), control);
  }

  void quadratic() {
    first_ = true;
    const Vec2 control = place();
    append_quadratic(control, place());
  }

  void smooth_quadratic() {
    first_ = true;
    const bool goes_on = previous_ == 'Q' || previous_ == 'T';
    append_quadratic(goes_on ? Vec2(2 * current_ - handle_) : current_, place());
  }

  void arc() {
    first_ = true;
    SvgArcShape shape;
    shape.radius_x = number();
    shape.radius_y = number();
    shape.rotation = number();
    shape.large = flag();
    shape.positive = flag();
    const Vec2 end = place();
    if (outline_.error || end == current_) return;  // F.6.2: an arc to where it begins is left out
    append(svg_arc(current_, shape, end), end);
  }

  void close() {
    SvgSubpath& subpath = outline_.subpaths.back();
    subpath.closed = true;
    current_ = subpath.start;
    handle_ = current_;
    previous_ = 'Z';
  }

  SvgScanner scanner_;
  SvgOutline outline_;
  char command_ = 'M';
  char previous_ = 'M';
  bool relative_ = false;
  bool first_ = true;  ///< the next number is the first of its command: no comma before it
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

}  // namespace croquis
