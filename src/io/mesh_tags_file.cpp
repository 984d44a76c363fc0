// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/mesh_tags_file.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "croquis/base/error.h"
#include "io/json/report_reader.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr const char* format_name = "croquis-tags-1";
constexpr const char* infinite_word = "inf";

Report sharpness_report(double sharpness) {
  return sharpness == infinite_sharpness ? Report(infinite_word) : Report(sharpness);
}

/// Reads one report, noting what is wrong with it.
class TagsReader : ReportNotes {
 public:
  TagsReader() : ReportNotes("Tags", format_name) {}

  MeshTagsReadResult read(const Report& report) {
    MeshTagsReadResult result;
    if (report_as<Report::Object>(&report) != nullptr) {
      read_root(report, result.tags);
    } else {
      refuse("E_SYNTAX", "", "they are not an object");
    }
    result.warnings = finish();
    return result;
  }

 private:
  void read_root(const Report& report, MeshTags& tags) {
    const auto* format = report_as<std::string>(report.find("format"));
    if (format == nullptr || *format != format_name) {
      return refuse("E_SYNTAX", "format", std::string("it is not \"") + format_name + "\"");
    }
    note_unknown(report, "tags", {"format", "index_base", "edges", "pins", "sets"});
    read_base(report);
    each(report.find("edges"), "edges", [&](const Report& edge, const std::string& at) { read_edge(edge, at, tags); });
    tags.pins = read_pins(report.find("pins"), "pins");
    each(report.find("sets"), "sets", [&](const Report& set, const std::string& at) { read_set(set, at, tags); });
  }

  void read_base(const Report& report) {
    const Report* member = report.find("index_base");
    if (member == nullptr) return;
    const auto* base = report_as<std::int64_t>(member);
    if (base == nullptr || *base < 0 || *base > 1) return refuse("E_SYNTAX", "index_base", "it is neither 0 nor 1");
    base_ = *base;
  }

  void read_edge(const Report& report, const std::string& place, MeshTags& tags) {
    if (report_as<Report::Object>(&report) == nullptr)
      return refuse("E_SYNTAX", place, "it is not an object with v and sharpness");
    note_unknown(report, "edges", {"v", "sharpness"});
    const auto vertices = read_pair(report.find("v"), place + ".v");
    const auto sharpness = read_sharpness(report.find("sharpness"), place + ".sharpness");
    if (vertices && sharpness) tags.creases.push_back({*vertices, *sharpness});
  }

  void read_set(const Report& report, const std::string& place, MeshTags& tags) {
    if (report_as<Report::Object>(&report) == nullptr) return refuse("E_SYNTAX", place, "it is not an object");
    note_unknown(report, "sets", {"name", "sharpness", "edges", "pins"});
    CreaseSet set;
    const auto* name = report_as<std::string>(report.find("name"));
    if (name == nullptr) refuse("E_SYNTAX", place + ".name", "it is not a text");
    if (name != nullptr) set.name = *name;
    set.sharpness = read_sharpness(report.find("sharpness"), place + ".sharpness").value_or(0);
    each(report.find("edges"), place + ".edges", [&](const Report& edge, const std::string& at) {
      if (const auto vertices = read_pair(&edge, at)) set.edges.push_back(*vertices);
    });
    set.pins = read_pins(report.find("pins"), place + ".pins");
    tags.sets.push_back(std::move(set));
  }

  std::optional<std::array<Index, 2>> read_pair(const Report* report, const std::string& place) {
    const auto* list = report_as<Report::Array>(report);
    if (list == nullptr || list->size() != 2) {
      refuse("E_SYNTAX", place, "it is not a list of two vertices");
      return std::nullopt;
    }
    const auto a = read_vertex((*list)[0], place + "[0]");
    const auto b = read_vertex((*list)[1], place + "[1]");
    if (!a || !b) return std::nullopt;
    return std::array<Index, 2>{*a, *b};
  }

  std::optional<double> read_sharpness(const Report* report, const std::string& place) {
    if (const auto* word = report_as<std::string>(report); word != nullptr && *word == infinite_word)
      return infinite_sharpness;
    if (const auto number = number_of(report)) return number;
    refuse("E_SYNTAX", place, "it is neither a number nor \"inf\"");
    return std::nullopt;
  }

  std::optional<Index> read_vertex(const Report& report, const std::string& place) {
    const auto* number = report_as<std::int64_t>(&report);
    if (number == nullptr) {
      refuse("E_SYNTAX", place, "it is not the number of a vertex");
      return std::nullopt;
    }
    if (*number < base_ || *number - base_ > std::int64_t{no_index}) {
      refuse("E_INDEX", place, "no vertex has the number " + std::to_string(*number));
      return std::nullopt;
    }
    return static_cast<Index>(*number - base_);
  }

  std::vector<Index> read_pins(const Report* report, const std::string& place) {
    std::vector<Index> pins;
    each(report, place, [&](const Report& pin, const std::string& at) {
      if (const auto vertex = read_vertex(pin, at)) pins.push_back(*vertex);
    });
    return pins;
  }

  /// Calls `read` with each element of a list and its place. A list may be absent.
  template <typename Read>
  void each(const Report* report, const std::string& place, const Read& read) {
    if (report == nullptr) return;
    const auto* list = report_as<Report::Array>(report);
    if (list == nullptr) return refuse("E_SYNTAX", place, "it is not a list");
    for (std::size_t i = 0; i < list->size(); ++i) read((*list)[i], place + "[" + std::to_string(i) + "]");
  }

  std::int64_t base_ = 0;
};

Report set_report(const CreaseSet& set) {
  Report edges = Report::array();
  for (const auto& edge : set.edges) edges.push(Report::list(edge));
  Report report;
  report.set("name", set.name)
      .set("sharpness", sharpness_report(set.sharpness))
      .set("edges", std::move(edges))
      .set("pins", Report::list(set.pins));
  return report;
}

}  // namespace

Report report_of(const MeshTags& tags) {
  Report edges = Report::array();
  for (const Crease& crease : tags.creases) {
    Report edge;
    edges.push(edge.set("v", Report::list(crease.vertices)).set("sharpness", sharpness_report(crease.sharpness)));
  }
  Report report;
  report.set("format", format_name).set("index_base", 0).set("edges", std::move(edges));
  report.set("pins", Report::list(tags.pins));
  if (tags.sets.empty()) return report;
  Report sets = Report::array();
  for (const CreaseSet& set : tags.sets) sets.push(set_report(set));
  return std::move(report.set("sets", std::move(sets)));
}

MeshTagsReadResult read_mesh_tags(const Report& report) { return TagsReader().read(report); }

}  // namespace croquis
