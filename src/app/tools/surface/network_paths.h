// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <string>
#include <vector>

#include "croquis/attribute_surface/network_elements.h"
#include "croquis/geometry/affine3.h"
#include "croquis/render/line_item.h"
#include "croquis/render/mark_item.h"

/// Elements of a network as lines and marks of the renderer.
namespace croquis::app {

glm::dvec3 world_place(const Vec3& place);

/// Along a curve.
render::LinePath curve_path(const AttributeNetwork& network, Index curve, const Affine3& to_world);

render::LinePath path_through(const std::vector<Vec3>& places, const Affine3& to_world, bool closed = false);

render::Mark place_mark(const Vec3& world, render::MarkShape shape, float size, const QColor& color);

/// Null where there is nothing to draw: items of nothing cost draw calls.
render::LineItemPtr lines_of(const std::vector<render::LinePath>& paths, const render::LineStyle& style);
render::MarkItemPtr marks_of(const std::vector<render::Mark>& marks);

/// Squares on the plane z = 0 of the network's own space, around what is drawn: what strokes lie on that begin on
/// nothing.
render::LineItemPtr ground_lines(const render::Bounds& drawn, const Affine3& to_world);

/// Halfway along a curve, or where its control points are, if it is of no length. World.
Vec3 middle_of(const AttributeNetwork& network, Index curve, const Affine3& to_world);

/// The mean of a face's corners. World.
Vec3 middle_of_face(const AttributeNetwork& network, Index face, const Affine3& to_world);

}  // namespace croquis::app
