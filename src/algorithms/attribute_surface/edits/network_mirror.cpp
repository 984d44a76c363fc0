// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/network_mirror.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "algorithms/attribute_surface/edits/element_removal.h"
#include "algorithms/attribute_surface/edits/network_image.h"

namespace croquis {
namespace {

bool is_close(const Vec3& a, const Vec3& b, double tolerance) { return (a - b).norm() <= tolerance; }

/// Finds images by place: the candidates are sorted by x.
class PlaceIndex {
 public:
  explicit PlaceIndex(std::vector<Vec3> places) : places_(std::move(places)), order_(places_.size()) {
    for (Index i = 0; i < order_.size(); ++i) order_[i] = i;
    std::ranges::sort(order_, {}, [&](Index i) { return std::pair(places_[i].x(), i); });
  }

  /// The lowest element near a place that fits, or no_index.
  template <typename Fits>
  Index find(const Vec3& place, double tolerance, Fits fits) const {
    Index found = no_index;
    auto it = std::ranges::lower_bound(order_, place.x() - tolerance, {}, [&](Index i) { return places_[i].x(); });
    for (; it != order_.end() && places_[*it].x() <= place.x() + tolerance; ++it) {
      if (*it < found && is_close(places_[*it], place, tolerance) && fits(*it)) found = *it;
    }
    return found;
  }

 private:
  std::vector<Vec3> places_;
  std::vector<Index> order_;
};

bool same_polygon(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double tolerance) {
  return a.size() == b.size() &&
         std::ranges::equal(a, b, [&](const Vec3& p, const Vec3& q) { return is_close(p, q, tolerance); });
}

/// Curves at one place have different partners: a loop has no curve twice, and its image mustn't either.
std::vector<Index> curve_partners(const AttributeNetwork& network, const Affine3& map, double tolerance) {
  std::vector<std::vector<Vec3>> polygons;
  std::vector<Vec3> middles;
  for (const AttributeCurve& curve : network.curves) {
    polygons.push_back(control_polygon(network, curve));
    middles.push_back((polygons.back().front() + polygons.back().back()) / 2);
  }
  const PlaceIndex index(middles);
  std::vector<Index> partners;
  std::vector<std::uint8_t> taken(polygons.size(), 0);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    std::vector<Vec3> image = polygons[i];
    for (Vec3& point : image) point = map(point);
    const std::vector<Vec3> backwards(image.rbegin(), image.rend());
    const auto is_image = [&](Index other) {
      return taken[other] == 0 &&
             (same_polygon(polygons[other], image, tolerance) || same_polygon(polygons[other], backwards, tolerance));
    };
    const Vec3 middle = map(middles[i]);
    const bool itself = is_close(middle, middles[i], tolerance) && is_image(static_cast<Index>(i));
    partners.push_back(itself ? static_cast<Index>(i) : index.find(middle, tolerance, is_image));
    if (partners.back() != no_index) taken[partners.back()] = 1;
  }
  return partners;
}

/// Faces by the curves of their loops.
std::vector<Index> face_partners(const AttributeNetwork& network, const std::vector<Index>& curves) {
  std::map<std::set<Index>, Index> by_curves;
  for (Index i = static_cast<Index>(network.faces.size()); i-- > 0;) {
    std::set<Index> own;
    for (const AttributeSide& side : network.faces[i].loop) own.insert(side.curve);
    by_curves[own] = i;
  }
  std::vector<Index> partners;
  for (const AttributeFace& face : network.faces) {
    std::set<Index> image;
    for (const AttributeSide& side : face.loop) image.insert(curves[side.curve]);
    const auto found = by_curves.find(image);
    partners.push_back(found == by_curves.end() || image.contains(no_index) ? no_index : found->second);
  }
  return partners;
}

std::vector<Index> point_partners(const AttributeNetwork& network, const std::vector<Index>& faces, const Affine3& map,
                                  double tolerance) {
  std::vector<Vec3> places;
  for (const PointAttribute& point : network.points) places.push_back(point.point);
  const PlaceIndex index(places);
  std::vector<Index> partners;
  for (const PointAttribute& point : network.points) {
    const auto fits = [&](Index other) { return network.points[other].face == faces[point.face]; };
    partners.push_back(index.find(map(point.point), tolerance, fits));
  }
  return partners;
}

bool has_other(const std::vector<Index>& partners) {
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (partners[i] != no_index && partners[i] != i) return true;
  }
  return false;
}

bool lacks_image(const NetworkPartners& partners, Index face) {
  return face != no_index && partners.faces[face] == no_index;
}

/// Curves that cross the plane, and what is to be said about them.
Findings crossing_findings(const AttributeNetwork& network, const NetworkPartners& partners, const SymmetryPlane& plane,
                           double tolerance) {
  Findings findings;
  const Vec3 normal = plane.normal.normalized();
  for (std::size_t i = 0; i < network.curves.size(); ++i) {
    if (partners.curves[i] != no_index) continue;
    double low = 0, high = 0;
    for (const Vec3& place : traced_curve(network, static_cast<Index>(i))) {
      const double height = (place - plane.point).dot(normal);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    if (low >= -tolerance || high <= tolerance) continue;
    const std::string& id = network.curves[i].id;
    findings.push_back(make_warning(Category::Geometry, "W_MIRROR_CROSSING",
                                    "Curve \"" + id +
                                        "\" crosses the mirror plane, and so does its image: split it "
                                        "there and delete one part to have one side mirrored alone.",
                                    {named_curve(id)}));
  }
  return findings;
}

}  // namespace

Vec3 mirrored(const Vec3& place, const SymmetryPlane& plane) { return reflection_at(plane)(place); }

bool NetworkPartners::any() const {
  return has_other(nodes) || has_other(curves) || has_other(faces) || has_other(points);
}

NetworkPartners find_partners(const AttributeNetwork& network, const SymmetryPlane& plane, double tolerance) {
  require_finite(plane.point);
  require_direction(plane.normal);
  const Affine3 map = reflection_at(plane);
  std::vector<Vec3> places;
  for (const AttributeNode& node : network.nodes) places.push_back(node.point);
  const PlaceIndex index(places);
  NetworkPartners partners;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3 image = map(places[i]);
    const bool itself = is_close(image, places[i], 2 * tolerance);
    partners.nodes.push_back(itself ? static_cast<Index>(i) : index.find(image, tolerance, [](Index) { return true; }));
  }
  partners.curves = curve_partners(network, map, 2 * tolerance);
  partners.faces = face_partners(network, partners.curves);
  partners.points = point_partners(network, partners.faces, map, tolerance);
  return partners;
}

MirroredNetwork mirror_network(const AttributeNetwork& network, const SymmetryPlane& plane, double tolerance) {
  const NetworkPartners partners = find_partners(network, plane, tolerance);
  MirroredNetwork result;
  result.findings = crossing_findings(network, partners, plane, tolerance);
  NetworkImage image(network, plane, partners);
  for (Index i = 0; i < network.nodes.size(); ++i) {
    if (partners.nodes[i] == i) image.centre_node(i);
    image.node(i);
  }
  for (Index i = 0; i < network.curves.size(); ++i) {
    if (partners.curves[i] == i) image.centre_curve(i);
    image.curve(i);
  }
  for (Index i = 0; i < network.faces.size(); ++i) image.face(i);
  for (Index i = 0; i < network.points.size(); ++i) {
    if (partners.points[i] == i) image.centre_point(i);
    image.point(i);
  }
  for (std::size_t i = 0; i < network.slopes.size(); ++i) {
    const SlopeAttribute& slope = network.slopes[i];
    if (partners.curves[slope.curve] == no_index || lacks_image(partners, slope.face)) image.add_slope(i);
  }
  image.meet_nodes();
  result.added = image.added();
  result.network = std::move(image.network());
  return result;
}

}  // namespace croquis
