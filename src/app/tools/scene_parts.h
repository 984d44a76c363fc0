// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <initializer_list>
#include <ranges>
#include <vector>

#include "app/views/render_color.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/render/scene.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis::app {

// What the tools' scenes are made of.

/// Null where there is nothing to draw: items of nothing cost draw calls.
render::LineItemPtr lines_of(const std::vector<render::LinePath>& paths, const render::LineStyle& style);
/// The polylines of a mesh.
render::LineItemPtr lines_of(const PolyMesh& mesh, const render::LineStyle& style);
render::MarkItemPtr marks_of(const std::vector<render::Mark>& marks,
                             render::MarkDepth depth = render::MarkDepth::OnTop);

/// A place of the sketch plane.
inline glm::dvec3 on_plane(const Vec2& place) { return {place.x(), place.y(), 0}; }

/// @param map where the renderer has each of the places
template <std::ranges::input_range Places, class Map>
render::LinePath path_of(const Places& places, const Map& map, bool closed = false) {
  render::LinePath path;
  path.closed = closed;
  for (const auto& place : places) path.points.push_back({map(place), 1, {}});
  return path;
}

/// The border of a box, from its corners low and high; closed.
std::vector<Vec2> corners_of_box(const Vec2& low, const Vec2& high);

/// Lines that what covers them leaves faint.
struct SeenThrough {
  render::LineItemPtr clear, faint;
};

/// Adds all but null ones.
void add_items(render::Scene& scene, std::initializer_list<render::LineItemPtr> lines,
               std::initializer_list<render::MarkItemPtr> marks = {});

/// A finding and where it stands in the model.
struct FindingMark {
  Vec3 at = Vec3::Zero();
  QString sentence;
  bool error = false;
};

/// A cross or a warning sign.
render::Mark symbol_of(const FindingMark& finding);

/// The sentences of the findings whose marks are under the pointer, each once.
QString sentences_at(const std::vector<FindingMark>& findings, const ViewFrame& frame, const Vec2& pixel);

}  // namespace croquis::app
