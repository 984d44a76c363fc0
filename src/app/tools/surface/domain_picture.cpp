// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/domain_picture.h"

#include <algorithm>

#include "croquis/attribute_surface/network_elements.h"

namespace croquis::app {

std::optional<DomainPicture> domain_picture(const AttributeNetwork& network, const AttributeSurface& surface,
                                            const std::string& id, const NetworkElements& selected) {
  const Index face = find_element(network, NetworkElement::Face, id);
  if (face == no_index || !surface.faces[face].surface) return std::nullopt;
  const FaceSurface& made = *surface.faces[face].surface;
  DomainPicture picture;
  picture.polygon = made.domain();
  const std::vector<AttributeSide>& loop = network.faces[face].loop;
  const std::size_t corners = made.domain().corners.size();
  for (std::size_t k = 0; k < corners; ++k) {
    const Index curve = loop[k * loop.size() / corners].curve;  // the two of a face of two sides are two sides each
    picture.sides.push_back({QString::fromStdString(network.curves[curve].id), surface.curves[curve].smooth});
  }
  for (Index i = 0; i < network.points.size(); ++i) {
    const auto placed = network.points[i].face == face ? placed_index(network, surface, i) : std::nullopt;
    if (!placed) continue;
    const PlacedPoint& point = made.points()[*placed];
    picture.points.push_back({QString::fromStdString(network.points[i].id), point.place,
                              point.radius.value_or(0) / made.sigma(),
                              selected.has(NetworkElement::Point, network.points[i].id)});
  }
  for (const PlacedCurve& curve : made.curves()) picture.curves.push_back(curve.places);
  return picture;
}

std::optional<DomainNumbers> domain_numbers(const AttributeNetwork& network, const SurfaceMeasures& measures,
                                            const std::string& id) {
  const Index face = find_element(network, NetworkElement::Face, id);
  const auto patch = std::ranges::find(measures.patches, face, &PatchMeasures::face);
  if (face == no_index || patch == measures.patches.end()) return std::nullopt;
  return DomainNumbers{patch->anisotropy};
}

}  // namespace croquis::app
