// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/attribute_network_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/io/json.h"
#include "croquis/io/surface_places_file.h"
#include "io/json/report_reader.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr const char* attribute_network_format = "croquis-abs/1";

constexpr std::array<const char*, 2> join_words = {"crease", "smooth"};
constexpr std::array<const char*, 3> mode_words = {"smooth", "position", "paper"};
constexpr std::array<const char*, 2> domain_words = {"chordlength", "uniform"};
constexpr std::array<const char*, 2> point_profile_words = {"smooth", "cone"};
constexpr std::array<const char*, 2> inner_profile_words = {"smooth", "sharp"};

bool is_not_finite_word(const Report& report) {
  const auto* word = report_as<std::string>(&report);
  std::string lower = word == nullptr ? "" : lower_case(*word);
  if (lower.starts_with('-') || lower.starts_with('+')) lower.erase(0, 1);
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

/// "smooth", "position" or "paper"
template <std::size_t N>
std::string listed(const std::array<const char*, N>& words) {
  std::string all;
  for (const char* word : words)
    all += (all.empty() ? "\"" : word == words.back() ? " or \"" : ", \"") + std::string(word) + '"';
  return all;
}

/// What no network can hold, as findings about the file.
Findings faults_of(const AttributeNetwork& network, const std::string& file) {
  Findings faults = validate(network);
  for (Finding& finding : faults) {
    finding.message = in_quotes(file) + ": " + finding.message;
    if (finding.subjects.empty()) finding.subjects = {{SubjectKind::File, file, file, {}, {}}};
    for (Subject& subject : finding.subjects) subject.file = file;
  }
  return faults;
}

// ---- Reading

/// Reads one report, noting all that is wrong with it. What can't be understood is left out: an error is noted then,
/// so nobody sees the rest.
class AttributeNetworkReader : ReportNotes {
 public:
  explicit AttributeNetworkReader(const std::string& file)
      : ReportNotes(in_quotes(file), attribute_network_format, {{SubjectKind::File, file, file, {}, {}}}),
        file_(file) {}

  AttributeNetworkReadResult read(const Report& report) {
    subject_ = {SubjectKind::File, file_, file_, {}, {}};
    const auto* format = report_as<std::string>(member_of(report, "format"));
    if (format == nullptr || *format != attribute_network_format) {
      refuse("E_SYNTAX", std::string("its format is not \"") + attribute_network_format + "\"");
    } else {
      read_root(report);
    }
    for (Finding& fault : faults_of(network_, file_)) add(std::move(fault));
    Findings warnings = finish();
    return {std::move(network_), std::move(warnings)};
  }

 private:
  void refuse(const char* code, const std::string& what) {
    const bool is_file = subject_.kind == SubjectKind::File;
    const std::string who = is_file ? "" : std::string(to_string(subject_.kind)) + " \"" + subject_.id + "\": ";
    add(make_error(Category::Malformed, code, in_quotes(file_) + ": " + who + what + ".", {subject_}));
  }

  /// Calls `read` with each object of a list, which may be absent. The subject is the element with its id.
  template <typename Read>
  void each(const Report& report, const char* key, SubjectKind kind, const Read& read) {
    const Report* member = report.find(key);
    if (member == nullptr) return;
    const Subject outside = subject_;
    const auto* list = report_as<Report::Array>(member);
    if (list == nullptr) return refuse("E_SYNTAX", std::string(key) + " is not a list");
    for (std::size_t i = 0; i < list->size(); ++i) {
      subject_ = {kind, std::string(key) + "[" + std::to_string(i) + "]", file_, {}, {}};
      if (report_as<Report::Object>(&(*list)[i]) == nullptr) {
        refuse("E_SYNTAX", "it is not an object");
        continue;
      }
      read((*list)[i]);
    }
    subject_ = outside;
  }

  /// The element's own name, which findings use from here on.
  std::string read_id(const Report& report) {
    const auto* id = report_as<std::string>(report.find("id"));
    if (id == nullptr || id->empty()) {
      refuse("E_SYNTAX", "its id is not a text");
      return subject_.id;
    }
    subject_.id = *id;
    return *id;
  }

  /// A number, or NaN with an error.
  double read_value(const Report* report, const std::string& what) {
    if (const auto number = number_of(report)) return *number;
    const bool not_finite = is_number(report) || (report != nullptr && is_not_finite_word(*report));
    refuse(not_finite ? "E_NOT_FINITE" : "E_SYNTAX", what + " " + (not_finite ? unusable_words : "is not a number"));
    return 0;
  }

  std::optional<double> read_optional(const Report& report, const char* key) {
    const Report* member = report.find(key);
    if (member == nullptr) return std::nullopt;
    const std::size_t before = error_count();
    const double value = read_value(member, std::string("its ") + key);
    return error_count() == before ? std::optional(value) : std::nullopt;
  }

  Vec3 read_place(const Report* report, const std::string& what) {
    const auto* list = report_as<Report::Array>(report);
    if (list == nullptr || list->size() != 3) {
      refuse("E_SYNTAX", what + " is not a list of three numbers");
      return Vec3::UnitZ();
    }
    return {read_value(&(*list)[0], "x of " + what), read_value(&(*list)[1], "y of " + what),
            read_value(&(*list)[2], "z of " + what)};
  }

  std::vector<Vec3> read_places(const Report* report, const std::string& what) {
    const auto* list = report_as<Report::Array>(report);
    if (list == nullptr) {
      refuse("E_SYNTAX", what + " is not a list of points");
      return {};
    }
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < list->size(); ++i)
      places.push_back(read_place(&(*list)[i], what + "[" + std::to_string(i) + "]"));
    return places;
  }

  template <typename Enum, std::size_t N>
  void read_word(const Report& report, const char* key, const std::array<const char*, N>& words, Enum& target) {
    const Report* member = report.find(key);
    if (member == nullptr) return;
    const auto* word = report_as<std::string>(member);
    if (const auto value = word == nullptr ? std::nullopt : value_of_word<Enum>(*word, words)) {
      target = *value;
      return;
    }
    refuse("E_SYNTAX", std::string("its ") + key + " is not " + listed(words));
  }

  std::string read_text(const Report& report, const char* key) {
    const Report* member = report.find(key);
    if (member == nullptr) return "";
    if (const auto* text = report_as<std::string>(member)) return *text;
    refuse("E_SYNTAX", std::string("its ") + key + " is not a text");
    return "";
  }

  /// The element that a member names; no_index with an error where it isn't there.
  Index find(const std::map<std::string, Index>& known, const std::string& id, const char* code, const char* kind) {
    if (const auto found = known.find(id); found != known.end()) return found->second;
    refuse(code,
           std::string("it refers to ") + kind + " \"" + id + "\", which isn't there: add it or correct the name");
    return no_index;
  }

  Index read_reference(const Report& report, const char* key, const std::map<std::string, Index>& known,
                       const char* code) {
    const auto* id = report_as<std::string>(report.find(key));
    const std::string_view name = key;
    if (id != nullptr) return find(known, *id, code, name == "face" || name == "curve" ? key : "node");
    refuse("E_SYNTAX", std::string("its ") + key + " is not an id");
    return no_index;
  }

  void read_root(const Report& report) {
    note_unknown(report, "the network",
                 {"format", "name", "units", "tolerance", "nodes", "curves", "faces", "points", "slopes"});
    network_.name = read_text(report, "name");
    network_.units = read_text(report, "units");
    network_.tolerance = read_optional(report, "tolerance");
    each(report, "nodes", SubjectKind::Node, [&](const Report& node) { read_node(node); });
    each(report, "curves", SubjectKind::Curve, [&](const Report& curve) { read_curve(curve); });
    each(report, "faces", SubjectKind::Face, [&](const Report& face) { read_face(face); });
    each(report, "points", SubjectKind::Point, [&](const Report& point) { read_point(point); });
    each(report, "slopes", SubjectKind::Curve, [&](const Report& slope) { read_slope(slope); });
  }

  void read_node(const Report& report) {
    note_unknown(report, "nodes", {"id", "p"});
    const std::string id = read_id(report);
    nodes_.emplace(id, static_cast<Index>(network_.nodes.size()));
    network_.nodes.push_back({id, read_place(report.find("p"), "p")});
  }

  void read_curve(const Report& report) {
    note_unknown(report, "curves", {"id", "from", "to", "ctrl", "join"});
    AttributeCurve curve;
    curve.id = read_id(report);
    const std::size_t before = error_count();
    if (report.find("from") != nullptr) curve.from = read_reference(report, "from", nodes_, "E_NO_NODE");
    if (report.find("to") != nullptr) curve.to = read_reference(report, "to", nodes_, "E_NO_NODE");
    if (report.find("ctrl") != nullptr) curve.control = read_places(report.find("ctrl"), "ctrl");
    if (report.find("ctrl") != nullptr && curve.control.empty() && error_count() == before)
      refuse("E_SYNTAX", "its ctrl has no points");
    if (error_count() > before) curve.control = {Vec3::Zero(), Vec3::UnitX()};  // one finding is enough
    read_word(report, "join", join_words, curve.join);
    curves_.emplace(curve.id, static_cast<Index>(network_.curves.size()));
    network_.curves.push_back(std::move(curve));
  }

  void read_side(const Report& report, AttributeFace& face) {
    const auto* text = report_as<std::string>(&report);
    if (text == nullptr || text->empty()) return refuse("E_SYNTAX", "its loop is not a list of curves with signs");
    const bool has_sign = text->front() == '+' || text->front() == '-';
    const Index curve = find(curves_, has_sign ? text->substr(1) : *text, "E_NO_CURVE", "curve");
    if (curve != no_index) face.loop.push_back({curve, text->front() == '-'});
  }

  void read_face(const Report& report) {
    note_unknown(report, "faces", {"id", "loop", "mode", "fullness", "domain", "inner"});
    AttributeFace face;
    face.id = read_id(report);
    const auto* loop = report_as<Report::Array>(report.find("loop"));
    if (loop == nullptr) refuse("E_SYNTAX", "its loop is not a list of curves with signs");
    for (std::size_t i = 0; loop != nullptr && i < loop->size(); ++i) read_side((*loop)[i], face);
    complete_loops_.push_back(loop != nullptr && face.loop.size() == loop->size());
    read_word(report, "mode", mode_words, face.mode);
    face.fullness = read_optional(report, "fullness").value_or(face.fullness);
    read_word(report, "domain", domain_words, face.domain);
    const Subject face_subject = subject_;
    each(report, "inner", SubjectKind::Face, [&](const Report& entry) {
      subject_ = face_subject;
      note_unknown(entry, "inner curves", {"curve", "profile", "radius"});
      InnerCurve inner;
      inner.curve = read_reference(entry, "curve", curves_, "E_NO_CURVE");
      read_word(entry, "profile", inner_profile_words, inner.profile);
      inner.radius = read_optional(entry, "radius");
      if (inner.curve != no_index) face.inner.push_back(inner);
    });
    faces_.emplace(face.id, static_cast<Index>(network_.faces.size()));
    network_.faces.push_back(std::move(face));
  }

  void read_point(const Report& report) {
    note_unknown(report, "points", {"id", "face", "p", "fan", "radius", "profile", "normal"});
    PointAttribute point;
    point.id = read_id(report);
    point.face = read_reference(report, "face", faces_, "E_NO_FACE");
    point.point = read_place(report.find("p"), "p");
    if (const Report* fan = report.find("fan")) point.fan = read_fan(*fan);
    point.radius = read_optional(report, "radius");
    read_word(report, "profile", point_profile_words, point.profile);
    if (const Report* normal = report.find("normal")) point.normal = read_place(normal, "normal");
    if (point.face == no_index) return;
    if (!complete_loops_[point.face]) point.fan.reset();  // how many corners there are isn't known
    network_.points.push_back(std::move(point));
  }

  std::optional<FanPlace> read_fan(const Report& report) {
    const auto* list = report_as<Report::Array>(&report);
    const auto* corner = list == nullptr || list->size() != 3 ? nullptr : report_as<std::int64_t>(&(*list)[0]);
    if (corner == nullptr || *corner < 0) {
      refuse("E_SYNTAX", "its fan is not a list of a corner and two numbers");
      return std::nullopt;
    }
    return FanPlace{static_cast<std::size_t>(*corner), read_value(&(*list)[1], "a of fan"),
                    read_value(&(*list)[2], "b of fan")};
  }

  void read_slope(const Report& report) {
    note_unknown(report, "slopes", {"curve", "face", "at", "normal", "magnitude"});
    SlopeAttribute slope;
    slope.curve = read_reference(report, "curve", curves_, "E_NO_CURVE");
    if (slope.curve == no_index) return;
    subject_.id = network_.curves[slope.curve].id;
    const std::size_t before = error_count();
    if (report.find("face") != nullptr) slope.face = read_reference(report, "face", faces_, "E_NO_FACE");
    const auto* at = report_as<Report::Array>(report.find("at"));
    if (at == nullptr) refuse("E_SYNTAX", "at of its slope is not a list of numbers");
    if (at != nullptr) {
      for (const Report& place : *at) slope.at.push_back(read_value(&place, "at of its slope"));
    }
    slope.normals = read_places(report.find("normal"), "normal of its slope");
    slope.magnitude = read_optional(report, "magnitude").value_or(slope.magnitude);
    if (error_count() == before) network_.slopes.push_back(std::move(slope));
  }

  const std::string& file_;
  AttributeNetwork network_;
  Subject subject_;  ///< what is being read
  std::map<std::string, Index> nodes_, curves_, faces_;
  std::vector<char> complete_loops_;  ///< per face: every side was understood
};

// ---- Writing

Report places_report(const std::vector<Vec3>& points) {
  Report list = Report::array();
  for (const Vec3& point : points) list.push(Report::list(point));
  return list;
}

Report report_of(const AttributeNetwork&, const AttributeNode& node) {
  Report report;
  return report.set("id", node.id).set("p", Report::list(node.point));
}

Report report_of(const AttributeNetwork& network, const AttributeCurve& curve) {
  Report report;
  report.set("id", curve.id);
  if (curve.from != no_index) report.set("from", network.nodes[curve.from].id);
  if (curve.to != no_index) report.set("to", network.nodes[curve.to].id);
  if (!curve.control.empty()) report.set("ctrl", places_report(curve.control));
  return report.set("join", word_of(curve.join, join_words));
}

Report report_of(const AttributeNetwork& network, const AttributeFace& face) {
  Report report, loop = Report::array(), inner = Report::array();
  for (const AttributeSide& side : face.loop) loop.push((side.reversed ? "-" : "+") + network.curves[side.curve].id);
  for (const InnerCurve& curve : face.inner) {
    Report entry;
    entry.set("curve", network.curves[curve.curve].id).set("profile", word_of(curve.profile, inner_profile_words));
    if (curve.radius) entry.set("radius", *curve.radius);
    inner.push(std::move(entry));
  }
  report.set("id", face.id).set("loop", std::move(loop)).set("mode", word_of(face.mode, mode_words));
  report.set("fullness", face.fullness).set("domain", word_of(face.domain, domain_words));
  if (!face.inner.empty()) report.set("inner", std::move(inner));
  return report;
}

Report report_of(const AttributeNetwork& network, const PointAttribute& point) {
  Report report;
  report.set("id", point.id).set("face", network.faces[point.face].id).set("p", Report::list(point.point));
  if (point.fan) report.set("fan", croquis::report_of(*point.fan));
  if (point.radius) report.set("radius", *point.radius);
  report.set("profile", word_of(point.profile, point_profile_words));
  if (point.normal) report.set("normal", Report::list(*point.normal));
  return report;
}

Report report_of(const AttributeNetwork& network, const SlopeAttribute& slope) {
  Report report;
  report.set("curve", network.curves[slope.curve].id);
  if (slope.face != no_index) report.set("face", network.faces[slope.face].id);
  report.set("at", Report::list(slope.at)).set("normal", places_report(slope.normals));
  return report.set("magnitude", slope.magnitude);
}

}  // namespace

AttributeNetworkReadResult read_attribute_network(std::string_view bytes, const std::string& file_name) {
  return AttributeNetworkReader(file_name).read(read_json(bytes, file_name));
}

std::string write_attribute_network(const AttributeNetwork& network) {
  Report report;
  report.set("format", attribute_network_format);
  if (!network.name.empty()) report.set("name", network.name);
  if (!network.units.empty()) report.set("units", network.units);
  if (network.tolerance) report.set("tolerance", *network.tolerance);
  const auto list = [&](const char* key, const auto& elements) {
    Report entries = Report::array();
    for (const auto& element : elements) entries.push(report_of(network, element));
    report.set(key, std::move(entries));
  };
  list("nodes", network.nodes);
  list("curves", network.curves);
  list("faces", network.faces);
  list("points", network.points);
  if (!network.slopes.empty()) list("slopes", network.slopes);
  return write_json(report);
}

}  // namespace croquis
