// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/surface_places_file.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/text.h"
#include "io/json/report_reader.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr const char* places_format = "croquis-abs-places/1";

/// Reads one report, noting all that is wrong with it.
class SurfacePlacesReader : ReportNotes {
 public:
  SurfacePlacesReader() : ReportNotes("Places", places_format) {}

  SurfacePlacesReadResult read(const Report& report) {
    const auto* format =
        report_as<Report::Object>(&report) == nullptr ? nullptr : report_as<std::string>(report.find("format"));
    if (format == nullptr || *format != places_format) {
      refuse("E_SYNTAX", "", std::string("their format is not \"") + places_format + "\"");
    } else {
      note_unknown(report, "the list", {"format", "places"});
      read_list(report.find("places"));
    }
    result_.warnings = finish();
    return std::move(result_);
  }

 private:
  void read_list(const Report* member) {
    const auto* list = report_as<Report::Array>(member);
    if (list == nullptr) return refuse("E_SYNTAX", "", "places is not a list");
    for (std::size_t i = 0; i < list->size(); ++i) read_place((*list)[i], "places[" + std::to_string(i) + "]");
  }

  void read_place(const Report& report, const std::string& place) {
    if (report_as<Report::Object>(&report) == nullptr) return refuse("E_SYNTAX", place, "it is not an object");
    note_unknown(report, "places", {"face", "fan"});
    const auto* face = report_as<std::string>(report.find("face"));
    if (face == nullptr || face->empty()) return refuse("E_SYNTAX", place, "its face is not a text");
    if (const auto fan = read_fan(report.find("fan"), place)) result_.places.push_back({*face, *fan});
  }

  std::optional<FanPlace> read_fan(const Report* report, const std::string& place) {
    const auto* list = report_as<Report::Array>(report);
    const auto* corner = list == nullptr || list->size() != 3 ? nullptr : report_as<std::int64_t>(&(*list)[0]);
    const bool shaped = corner != nullptr && *corner >= 0;
    if (shaped && (names_no_number((*list)[1]) || names_no_number((*list)[2]))) {
      refuse("E_NOT_FINITE", place, std::string("a number of its fan ") + unusable_words);
      return std::nullopt;
    }
    const auto a = shaped ? number_of(&(*list)[1]) : std::nullopt;
    const auto b = shaped ? number_of(&(*list)[2]) : std::nullopt;
    if (!a || !b) {
      refuse("E_SYNTAX", place, "its fan is not a list of a corner and two numbers");
      return std::nullopt;
    }
    return FanPlace{static_cast<std::size_t>(*corner), *a, *b};
  }

  /// A number that can't be used. JSON has no NaN and no infinity: some programs write their names.
  static bool names_no_number(const Report& report) {
    if (is_number(&report)) return !is_usable_number(report.as_number());
    const auto* text = report_as<std::string>(&report);
    double number = 0;
    return text != nullptr && croquis::read_number(*text, number) && !is_usable_number(number);
  }

  SurfacePlacesReadResult result_;
};

}  // namespace

Report report_of(const FanPlace& fan) {
  Report list = Report::array();
  list.push(fan.corner);
  list.push(fan.a);
  list.push(fan.b);
  return list;
}

Report report_of(const std::vector<SurfacePlaceQuestion>& places) {
  Report list = Report::array();
  for (const SurfacePlaceQuestion& place : places) {
    Report entry;
    entry.set("face", place.face).set("fan", report_of(place.fan));
    list.push(std::move(entry));
  }
  Report report;
  report.set("format", places_format).set("places", std::move(list));
  return report;
}

SurfacePlacesReadResult read_surface_places(const Report& report) { return SurfacePlacesReader().read(report); }

}  // namespace croquis
