// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/edits/element_removal.h"

#include <cstddef>

namespace croquis {
namespace {

/// Drops elements from a list. @return for each old index its new one, or no_index
template <typename Element>
std::vector<Index> drop(std::vector<Element>& elements, const std::vector<bool>& removed) {
  std::vector<Index> renumbered(elements.size(), no_index);
  Index count = 0;
  for (Index i = 0; i < elements.size(); ++i) {
    if (removed[i]) continue;
    renumbered[i] = count;
    if (count != i) elements[count] = std::move(elements[i]);
    ++count;
  }
  elements.resize(count);
  return renumbered;
}

void renumber(Index& index, const std::vector<Index>& numbers) {
  if (index != no_index) index = numbers[index];
}

void renumber_curves(AttributeFace& face, const std::vector<Index>& numbers) {
  for (AttributeSide& side : face.loop) renumber(side.curve, numbers);
  for (InnerCurve& inner : face.inner) renumber(inner.curve, numbers);
  std::erase_if(face.inner, [](const InnerCurve& inner) { return inner.curve == no_index; });
}

}  // namespace

AttributeNetwork without_elements(AttributeNetwork network, const RemovedElements& removed) {
  RemovedElements gone = removed;
  for (std::size_t i = 0; i < network.points.size(); ++i) {
    if (removed.faces[network.points[i].face]) gone.points[i] = true;
  }
  std::erase_if(network.slopes, [&](const SlopeAttribute& slope) {
    return gone.curves[slope.curve] || (slope.face != no_index && gone.faces[slope.face]);
  });
  const std::vector<Index> nodes = drop(network.nodes, gone.nodes);
  const std::vector<Index> curves = drop(network.curves, gone.curves);
  const std::vector<Index> faces = drop(network.faces, gone.faces);
  drop(network.points, gone.points);
  for (AttributeCurve& curve : network.curves) {
    renumber(curve.from, nodes);
    renumber(curve.to, nodes);
  }
  for (AttributeFace& face : network.faces) renumber_curves(face, curves);
  for (PointAttribute& point : network.points) renumber(point.face, faces);
  for (SlopeAttribute& slope : network.slopes) {
    renumber(slope.curve, curves);
    renumber(slope.face, faces);
  }
  return network;
}

void forget_places(AttributeNetwork& network, Index face) {
  for (PointAttribute& point : network.points) {
    if (point.face == face) point.fan.reset();
  }
}

}  // namespace croquis
