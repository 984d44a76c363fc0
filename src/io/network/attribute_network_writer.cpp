// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "croquis/io/attribute_network_file.h"
#include "croquis/io/json.h"
#include "io/network/attribute_words.h"

namespace croquis {
namespace {

class AttributeNetworkWriter {
 public:
  explicit AttributeNetworkWriter(const AttributeNetwork& network) : network_(network) {}

  Report write() const {
    Report report;
    report.set("format", attribute_network_format);
    if (!network_.name.empty()) report.set("name", network_.name);
    if (!network_.units.empty()) report.set("units", network_.units);
    if (network_.tolerance) report.set("tolerance", *network_.tolerance);
    const auto list = [&](const char* key, const auto& elements, auto to_report) {
      Report entries = Report::array();
      for (const auto& element : elements) entries.push((this->*to_report)(element));
      report.set(key, std::move(entries));
    };
    list("nodes", network_.nodes, &AttributeNetworkWriter::node);
    list("curves", network_.curves, &AttributeNetworkWriter::curve);
    list("faces", network_.faces, &AttributeNetworkWriter::face);
    list("points", network_.points, &AttributeNetworkWriter::point);
    if (!network_.slopes.empty()) list("slopes", network_.slopes, &AttributeNetworkWriter::slope);
    return report;
  }

 private:
  static Report places(const std::vector<Vec3>& points) {
    Report list = Report::array();
    for (const Vec3& point : points) list.push(Report::list(point));
    return list;
  }

  Report node(const AttributeNode& node) const {
    Report report;
    return report.set("id", node.id).set("p", Report::list(node.point));
  }

  Report curve(const AttributeCurve& curve) const {
    Report report;
    report.set("id", curve.id);
    if (curve.from != no_index) report.set("from", network_.nodes[curve.from].id);
    if (curve.to != no_index) report.set("to", network_.nodes[curve.to].id);
    if (!curve.control.empty()) report.set("ctrl", places(curve.control));
    return report.set("join", word_of(curve.join, join_words));
  }

  Report face(const AttributeFace& face) const {
    Report report, loop = Report::array(), inner = Report::array();
    for (const AttributeSide& side : face.loop) loop.push((side.reversed ? "-" : "+") + network_.curves[side.curve].id);
    for (const InnerCurve& curve : face.inner) {
      Report entry;
      entry.set("curve", network_.curves[curve.curve].id).set("profile", word_of(curve.profile, inner_profile_words));
      if (curve.radius) entry.set("radius", *curve.radius);
      inner.push(std::move(entry));
    }
    report.set("id", face.id).set("loop", std::move(loop)).set("mode", word_of(face.mode, mode_words));
    report.set("fullness", face.fullness).set("domain", word_of(face.domain, domain_words));
    if (!face.inner.empty()) report.set("inner", std::move(inner));
    return report;
  }

  Report point(const PointAttribute& point) const {
    Report report;
    report.set("id", point.id).set("face", network_.faces[point.face].id).set("p", Report::list(point.point));
    if (point.fan) {
      Report fan = Report::array();
      fan.push(point.fan->corner);
      fan.push(point.fan->a);
      fan.push(point.fan->b);
      report.set("fan", std::move(fan));
    }
    if (point.radius) report.set("radius", *point.radius);
    report.set("profile", word_of(point.profile, point_profile_words));
    if (point.normal) report.set("normal", Report::list(*point.normal));
    return report;
  }

  Report slope(const SlopeAttribute& slope) const {
    Report report;
    report.set("curve", network_.curves[slope.curve].id);
    if (slope.face != no_index) report.set("face", network_.faces[slope.face].id);
    report.set("at", Report::list(slope.at)).set("normal", places(slope.normals));
    return report.set("magnitude", slope.magnitude);
  }

  const AttributeNetwork& network_;
};

}  // namespace

std::string write_attribute_network(const AttributeNetwork& network) {
  return write_json(AttributeNetworkWriter(network).write());
}

}  // namespace croquis
