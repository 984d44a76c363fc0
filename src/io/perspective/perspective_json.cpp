// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/io/json.h"
#include "croquis/io/perspective_drawing_file.h"
#include "io/json/report_reader.h"
#include "io/perspective/perspective_strokes.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr const char* not_finite_word = "nan";

// ---- Writing

Report point_report(const Vec2& point) {
  Report list = Report::array();
  for (const double value : point) list.push(std::isfinite(value) ? Report(value) : Report(not_finite_word));
  return list;
}

Report piece_report(const PictureCubic& piece) {
  Report list = Report::array();
  for (const Vec2& point : piece) list.push(point_report(point));
  return list;
}

Report stroke_report(const PerspectiveStroke& stroke) {
  Report report;
  report.set("id", stroke.id).set("role", word_of(stroke.role, stroke_role_words));
  if (stroke.group != StrokeGroup::Unknown) report.set("group", static_cast<int>(stroke.group));
  Report points = Report::array();
  if (stroke.straight) {
    points.push(point_report(stroke.start()));
    points.push(point_report(stroke.end()));
  } else {
    for (const PictureCubic& piece : stroke.pieces) points.push(piece_report(piece));
  }
  report.set(stroke.straight ? "points" : "pieces", std::move(points));
  if (!stroke.colour.empty()) report.set("colour", stroke.colour);
  each_set_field(stroke, [&](const StrokeField& field, const auto& value) { report.set(field.name, value); });
  return report;
}

Report drawing_report(const PerspectiveDrawing& drawing) {
  Report image, report;
  image.set("x", drawing.origin.x()).set("y", drawing.origin.y());
  image.set("width", drawing.image_size.x()).set("height", drawing.image_size.y());
  report.set("format", perspective_format).set("image", std::move(image));
  if (drawing.known_point) {
    Report known;
    known.set("at", Report::list(drawing.known_point->at)).set("point", Report::list(drawing.known_point->point));
    report.set("known_point", std::move(known));
  }
  Report lengths = Report::array();
  for (const KnownLength& known : drawing.known_lengths) {
    Report length;
    lengths.push(length.set("stroke", known.stroke).set("length", known.length));
  }
  if (!drawing.known_lengths.empty()) report.set("known_lengths", std::move(lengths));
  if (drawing.field_of_view) report.set("fov_x_deg", degrees_of(*drawing.field_of_view));
  if (drawing.principal_point) report.set("principal_point", Report::list(*drawing.principal_point));
  if (!drawing.unit.empty()) report.set("unit", drawing.unit);
  if (drawing.shells) report.set("shells", *drawing.shells);
  Report strokes = Report::array();
  for (const PerspectiveStroke& stroke : drawing.strokes) strokes.push(stroke_report(stroke));
  return std::move(report.set("strokes", std::move(strokes)));
}

// ---- Reading

class PerspectiveJsonReader : ReportNotes {
 public:
  explicit PerspectiveJsonReader(const std::string& file)
      : ReportNotes(in_quotes(file), perspective_format, {{SubjectKind::File, file, file, {}, {}}}) {
    drawing_.file = file;
  }

  PerspectiveReadResult read(const Report& report) {
    const auto* format = report_as<std::string>(member_of(report, "format"));
    if (format == nullptr || *format != perspective_format) {
      refuse("format", std::string("it is not \"") + perspective_format + "\"");
    } else {
      read_sheet(report);
      read_facts(report);
      read_strokes(report);
    }
    Findings warnings = finish();
    return {std::move(drawing_), std::move(warnings)};
  }

 private:
  void refuse(const std::string& place, const std::string& what, const char* code = "E_SYNTAX") {
    ReportNotes::refuse(code, place, what);
  }

  /// Reads a member that may be absent.
  template <typename Read>
  void maybe(const Report& report, const char* key, const std::string& place, const char* expected, const Read& read) {
    const Report* value = member_of(report, key);
    if (value != nullptr && !read(value)) refuse(place + key, std::string("it is not ") + expected);
  }

  void read_sheet(const Report& report) {
    const Report* image = member_of(report, "image");
    if (image == nullptr) return refuse("image", "the size of the sheet is missing");
    const auto width = number_of(member_of(*image, "width")), height = number_of(member_of(*image, "height"));
    if (!width || !height || *width <= 0 || *height <= 0) return refuse("image", "width and height are not positive");
    drawing_.image_size = {*width, *height};
    drawing_.origin = {number_of(member_of(*image, "x")).value_or(0), number_of(member_of(*image, "y")).value_or(0)};
  }

  void read_facts(const Report& report) {
    maybe(report, "known_point", "", "an object with at and point", [&](const Report* known) {
      const auto at = numbers_of<2>(member_of(*known, "at"));
      const auto point = numbers_of<3>(member_of(*known, "point"));
      if (at && point) drawing_.known_point = {Vec2((*at)[0], (*at)[1]), Vec3((*point)[0], (*point)[1], (*point)[2])};
      return at && point;
    });
    maybe(report, "known_lengths", "", "a list of strokes with their lengths above 0", [&](const Report* lengths) {
      const auto* list = report_as<Report::Array>(lengths);
      return list != nullptr && std::ranges::all_of(*list, [&](const Report& known) { return add_length(known); });
    });
    maybe(report, "fov_x_deg", "", "a number between 0 and 180", [&](const Report* value) {
      const auto degrees = number_of(value);
      const bool good = degrees && *degrees > 0 && *degrees < 180;
      if (good) drawing_.field_of_view = radians_of(*degrees);
      return good;
    });
    maybe(report, "principal_point", "", "a list of two numbers", [&](const Report* value) {
      const auto at = numbers_of<2>(value);
      if (at) drawing_.principal_point = Vec2((*at)[0], (*at)[1]);
      return at.has_value();
    });
    maybe(report, "unit", "", "a text", [&](const Report* value) { return take(value, drawing_.unit); });
    maybe(report, "shells", "", "a whole number above 0", [&](const Report* value) {
      const auto* shells = report_as<std::int64_t>(value);
      const bool good = shells != nullptr && *shells > 0 && *shells < 1'000'000;
      if (good) drawing_.shells = static_cast<int>(*shells);
      return good;
    });
  }

  bool add_length(const Report& known) {
    const auto* stroke = report_as<std::string>(member_of(known, "stroke"));
    const auto length = number_of(member_of(known, "length"));
    if (stroke == nullptr || !length || *length <= 0) return false;
    drawing_.known_lengths.push_back({*stroke, *length});
    return true;
  }

  /// Takes a value over if it is of the member's kind.
  static bool take(const Report* value, std::string& target) {
    const auto* text = report_as<std::string>(value);
    if (text != nullptr) target = *text;
    return text != nullptr;
  }
  static bool take(const Report* value, bool& target) {
    const auto* flag = report_as<bool>(value);
    if (flag != nullptr) target = *flag;
    return flag != nullptr;
  }
  static bool take(const Report* value, double& target) {
    target = number_of(value).value_or(0);
    return target > 0;
  }
  static bool take(const Report* value, EndLock& target) { return take_word(value, end_lock_words, target); }

  template <typename Enum, std::size_t N>
  static bool take_word(const Report* value, const std::array<const char*, N>& words, Enum& target) {
    const auto* word = report_as<std::string>(value);
    const std::optional<Enum> known = word == nullptr ? std::nullopt : value_of_word<Enum>(*word, words);
    if (known) target = *known;
    return known.has_value();
  }

  void read_strokes(const Report& report) {
    const auto* list = report_as<Report::Array>(member_of(report, "strokes"));
    if (list == nullptr) return refuse("strokes", "it is not a list");
    if (list->empty()) return refuse("strokes", "there are none: there is nothing to make a solid of", "E_NO_STROKES");
    for (std::size_t i = 0; i < list->size(); ++i) {
      PerspectiveStroke stroke;
      const std::string place = "strokes[" + std::to_string(i) + "].";
      read_stroke((*list)[i], place, stroke);
      if (!ids_.insert(stroke.id).second) refuse(place + "id", "another stroke has the name " + in_quotes(stroke.id));
      drawing_.strokes.push_back(std::move(stroke));
    }
  }

  void read_stroke(const Report& report, const std::string& place, PerspectiveStroke& stroke) {
    if (!take(member_of(report, "id"), stroke.id) || stroke.id.empty()) refuse(place + "id", "it is not a text");
    maybe(report, "role", place, "\"edge\" or \"construction\"",
          [&](const Report* value) { return take_word(value, stroke_role_words, stroke.role); });
    maybe(report, "group", place, "a number from 0 to 5", [&](const Report* value) {
      const auto* group = report_as<std::int64_t>(value);
      const bool good = group != nullptr && *group >= 0 && *group <= 5;
      if (good) stroke.group = static_cast<StrokeGroup>(*group);
      return good;
    });
    maybe(report, "colour", place, "a text", [&](const Report* value) { return take(value, stroke.colour); });
    for (const StrokeField& field : stroke_fields) {
      maybe(report, field.name, place, field.expected, [&](const Report* value) {
        return std::visit([&](auto member) { return take(value, stroke.*member); }, field.member);
      });
    }
    read_points(report, place, stroke);
  }

  void read_points(const Report& report, const std::string& place, PerspectiveStroke& stroke) {
    const Report* points = member_of(report, "points");
    const Report* pieces = member_of(report, "pieces");
    const auto* list = report_as<Report::Array>(points != nullptr ? points : pieces);
    const std::string where = place + (points != nullptr ? "points" : "pieces");
    if (list == nullptr || list->empty()) return refuse(where, "it is not a list of points");
    if (points != nullptr) {
      const auto from = point_of((*list)[0]), to = point_of(list->back());
      if (list->size() != 2 || !from || !to) return refuse(where, "it is not a list of two points");
      stroke.pieces = {straight_piece(*from, *to)};
      stroke.straight = true;
      return;
    }
    for (const Report& piece : *list) {
      const auto cubic = cubic_of(piece);
      if (!cubic) return refuse(where, "it is not a list of cubics with four points each");
      const bool follows = stroke.pieces.empty() || (*cubic)[0] == stroke.end() || !(*cubic)[0].allFinite();
      if (!follows) return refuse(where, "a piece doesn't begin where the one before ended");
      stroke.pieces.push_back(*cubic);
    }
  }

  /// Any number: strokes that can't be used are left out by who works with the drawing, one by one.
  static std::optional<double> coordinate_of(const Report& report) {
    const auto* word = report_as<std::string>(&report);
    if (word != nullptr && *word == not_finite_word) return std::numeric_limits<double>::quiet_NaN();
    return is_number(&report) ? std::optional(report.as_number()) : std::nullopt;
  }

  static std::optional<Vec2> point_of(const Report& report) {
    const auto* list = report_as<Report::Array>(&report);
    if (list == nullptr || list->size() != 2) return std::nullopt;
    const auto x = coordinate_of((*list)[0]), y = coordinate_of((*list)[1]);
    return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
  }

  static std::optional<PictureCubic> cubic_of(const Report& report) {
    const auto* list = report_as<Report::Array>(&report);
    if (list == nullptr || list->size() != 4) return std::nullopt;
    PictureCubic cubic;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto point = point_of((*list)[i]);
      if (!point) return std::nullopt;
      cubic[i] = *point;
    }
    return cubic;
  }

  PerspectiveDrawing drawing_;
  std::set<std::string> ids_;
};

}  // namespace

std::string write_perspective_json(const PerspectiveDrawing& drawing) { return write_json(drawing_report(drawing)); }

PerspectiveReadResult read_perspective_json(std::string_view bytes, const std::string& file_name) {
  return PerspectiveJsonReader(file_name).read(read_json(bytes, file_name));
}

}  // namespace croquis
