// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/shown_surface.h"

#include <Eigen/LU>

#include "croquis/attribute_surface/network_elements.h"

namespace croquis::app {

Index ShownSurface::face(const std::string& id) const { return find_element(network(), NetworkElement::Face, id); }

Index ShownSurface::curve(const std::string& id) const { return find_element(network(), NetworkElement::Curve, id); }

Index ShownSurface::point(const std::string& id) const { return find_element(network(), NetworkElement::Point, id); }

Affine3 inverse_of(const Affine3& map) {
  if (map.is_identity()) return map;
  Affine3 inverse;
  inverse.linear = map.linear.inverse();
  inverse.offset = -inverse.linear * map.offset;
  return inverse;
}

Affine3 placement_of(const Document& document, NodeId network, NodeId operation) {
  const Node* source = document.find(network);
  const Node* step = document.find(operation);
  const Affine3 own = source == nullptr ? Affine3() : source->transform;
  return step == nullptr ? own : composed(step->transform, own);
}

ShownSurface shown_surface(const Studio& studio, NodeId network, NodeId operation) {
  const Document& document = studio.session().document();
  ShownSurface shown;
  shown.to_mesh = shown.to_world = placement_of(document, network, operation);
  if (const Node* source = document.find(network)) {
    shown.to_result = source->transform;
    shown.to_world = composed(source->placement.map(), shown.to_mesh);
  }
  shown.result = operation == 0 ? nullptr : studio.result(operation);
  shown.found = result_of<SurfaceResult>(shown.result.get());
  shown.mesh = shown.found == nullptr ? nullptr : studio.mesh_at(operation);
  return shown;
}

}  // namespace croquis::app
