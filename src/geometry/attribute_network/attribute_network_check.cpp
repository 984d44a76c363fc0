// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "croquis/base/limits.h"
#include "croquis/geometry/attribute_network.h"

namespace croquis {
namespace {

/// An element as sentences and findings name it: curve "c3".
struct ElementName {
  SubjectKind kind;
  std::string id;

  std::string text() const {
    std::string word = to_string(kind);
    word[0] = static_cast<char>(word[0] - 'a' + 'A');
    return word + " \"" + id + '"';
  }
};

class AttributeNetworkCheck {
 public:
  explicit AttributeNetworkCheck(const AttributeNetwork& network) : network_(network) {}

  Findings run() {
    check_ids(network_.nodes, SubjectKind::Node);
    check_ids(network_.curves, SubjectKind::Curve);
    check_ids(network_.faces, SubjectKind::Face);
    check_ids(network_.points, SubjectKind::Point);
    if (network_.tolerance && !is_positive(*network_.tolerance))
      complain("E_SYNTAX", "The network", "has a tolerance that is not above 0", {});
    for (const AttributeNode& node : network_.nodes) check_place({SubjectKind::Node, node.id}, node.point);
    for (const AttributeCurve& curve : network_.curves) check_curve(curve);
    for (const AttributeFace& face : network_.faces) check_face(face);
    for (const PointAttribute& point : network_.points) check_point(point);
    for (const SlopeAttribute& slope : network_.slopes) check_slope(slope);
    return std::move(findings_);
  }

 private:
  static constexpr std::size_t most_findings = 100;

  static bool is_positive(double number) { return is_usable_number(number) && number > 0; }

  void complain(const char* code, const std::string& who, const std::string& what, std::vector<Subject> subjects) {
    if (findings_.size() >= most_findings) return;
    findings_.push_back(make_error(Category::Malformed, code, who + " " + what + ".", std::move(subjects)));
  }

  void complain(const char* code, const ElementName& element, const std::string& what) {
    complain(code, element.text(), what, {{element.kind, element.id, {}, {}, {}}});
  }

  void refuse_number(const ElementName& element, const std::string& what) {
    complain("E_NOT_FINITE", element, "has a " + what + " that " + unusable_words);
  }

  template <typename Element>
  void check_ids(const std::vector<Element>& elements, SubjectKind kind) {
    std::set<std::string_view> ids;
    for (const Element& element : elements) {
      if (element.id.empty()) complain("E_DUP_ID", std::string("A ") + to_string(kind), "has no id", {});
      if (!ids.insert(element.id).second)
        complain("E_DUP_ID", {kind, element.id},
                 std::string("is there twice: give each ") + to_string(kind) + " an id of its own");
    }
  }

  void check_place(const ElementName& element, const Vec3& place) {
    if (!are_usable_numbers(place)) refuse_number(element, "coordinate");
  }

  void check_direction(const ElementName& element, const Vec3& direction) {
    if (!are_usable_numbers(direction)) return refuse_number(element, "normal");
    if (!(direction.norm() > 0)) complain("E_SYNTAX", element, "has a normal without length");
  }

  void check_radius(const ElementName& element, const std::optional<double>& radius) {
    if (radius && !is_positive(*radius)) complain("E_SYNTAX", element, "has a radius that is not above 0");
  }

  bool has_curve(const ElementName& element, Index curve) {
    if (curve < network_.curves.size()) return true;
    complain("E_NO_CURVE", element, "refers to a curve that isn't there");
    return false;
  }

  void check_curve(const AttributeCurve& curve) {
    const ElementName name{SubjectKind::Curve, curve.id};
    const auto absent = [&](Index node) { return node != no_index && node >= network_.nodes.size(); };
    if (absent(curve.from) || absent(curve.to)) complain("E_NO_NODE", name, "ends at a node that isn't there");
    const bool has_nodes = curve.from != no_index && curve.to != no_index;
    if (curve.control.empty() && !has_nodes)
      complain("E_NO_NODE", name, "has neither control points nor a node at both ends");
    if (curve.control.size() == 1) complain("E_SYNTAX", name, "has one control point: it needs two or more");
    if (!std::ranges::all_of(curve.control, are_usable_numbers<Vec3>)) refuse_number(name, "coordinate");
  }

  void check_face(const AttributeFace& face) {
    const ElementName name{SubjectKind::Face, face.id};
    std::set<Index> seen;
    for (const AttributeSide& side : face.loop) {
      if (!has_curve(name, side.curve) || seen.insert(side.curve).second) continue;
      complain("E_DUP_CURVE", name, "has curve \"" + network_.curves[side.curve].id + "\" twice in its loop");
    }
    if (!(face.fullness >= -1 && face.fullness <= 2))
      complain("E_SYNTAX", name, "has a fullness that is not between -1 and 2");
    for (const InnerCurve& inner : face.inner) {
      has_curve(name, inner.curve);
      check_radius(name, inner.radius);
    }
  }

  void check_point(const PointAttribute& point) {
    const ElementName name{SubjectKind::Point, point.id};
    check_place(name, point.point);
    check_radius(name, point.radius);
    if (point.normal) check_direction(name, *point.normal);
    if (point.face >= network_.faces.size()) return complain("E_NO_FACE", name, "lies in a face that isn't there");
    if (!point.fan) return;
    if (!is_usable_number(point.fan->a) || !is_usable_number(point.fan->b)) refuse_number(name, "fan place");
    if (point.fan->corner >= domain_corners(network_.faces[point.face]))
      complain("E_SYNTAX", name, "has a fan place at a corner that its face's domain doesn't have");
  }

  void check_slope(const SlopeAttribute& slope) {
    const bool known = slope.curve < network_.curves.size();
    const ElementName name{SubjectKind::Curve, known ? network_.curves[slope.curve].id : "?"};
    if (!known) return complain("E_NO_CURVE", "A slope", "refers to a curve that isn't there", {});
    if (slope.face != no_index && slope.face >= network_.faces.size())
      complain("E_NO_FACE", name, "has a slope for a face that isn't there");
    if (slope.at.empty() || slope.at.size() != slope.normals.size())
      complain("E_SYNTAX", name, "has a slope without one normal for each place");
    const bool in_range = std::ranges::all_of(slope.at, [](double at) { return at >= 0 && at <= 1; });
    if (!in_range || !std::ranges::is_sorted(slope.at))
      complain("E_SYNTAX", name, "has a slope whose places don't ascend from 0 to 1");
    for (const Vec3& normal : slope.normals) check_direction(name, normal);
    if (!is_usable_number(slope.magnitude)) refuse_number(name, "slope of a magnitude");
  }

  const AttributeNetwork& network_;
  Findings findings_;
};

}  // namespace

Findings validate(const AttributeNetwork& network) { return AttributeNetworkCheck(network).run(); }

}  // namespace croquis
