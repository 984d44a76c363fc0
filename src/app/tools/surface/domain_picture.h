// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "app/tools/surface/uniform_ghost.h"

namespace croquis::app {

/// The domain of a face with what lies in it.
struct DomainPicture {
  struct Side {
    QString name;         ///< of its curve
    bool smooth = false;  ///< the patch beside it goes on there
  };
  struct Point {
    QString name;
    Vec2 place = Vec2::Zero();
    double radius = 0;  ///< parts of the perimeter
    bool selected = false;
  };
  DomainPolygon polygon;
  std::vector<Side> sides;  ///< one for each side of the polygon
  std::vector<Point> points;
  std::vector<std::vector<Vec2>> curves;  ///< footprints of inner curves
  std::optional<Vec2> pointer;            ///< the place under the pointer, or being dragged
};

/// What numbers tell of a face and its domain.
struct DomainNumbers {
  double anisotropy = 1;  ///< >= 1
};

/// Of a face as it was computed last; none where it failed or isn't there.
std::optional<DomainPicture> domain_picture(const AttributeNetwork& network, const AttributeSurface& surface,
                                            const std::string& face, const NetworkElements& selected);
std::optional<DomainNumbers> domain_numbers(const AttributeNetwork& network, const SurfaceMeasures& measures,
                                            const std::string& face);

}  // namespace croquis::app
