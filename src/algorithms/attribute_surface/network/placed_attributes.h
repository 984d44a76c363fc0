// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "algorithms/attribute_surface/network/loop_curves.h"
#include "croquis/attribute_surface/attribute_surface.h"

namespace croquis {

/// What lies on a face, with its places in the domain.
struct PlacedAttributes {
  std::vector<PlacedPoint> points;
  std::vector<PlacedCurve> curves;
};

/// Finds the footprints of points and inner curves: as their fan coordinates say, else nearest to them on the surface
/// of the sides. Those that can't be placed are left out.
class AttributePlacing {
 public:
  AttributePlacing(const AttributeNetwork& network, const LoopCurves& curves, StageCache* cache, Findings& findings)
      : network_(network), curves_(curves), cache_(cache), findings_(findings) {}

  /// @param base    the surface of the face's sides
  /// @param content what that depends on
  /// @param places  is given the places of the network's points
  PlacedAttributes place(Index face, const FaceSurface& base, const std::string& content,
                         std::vector<SurfacePoint>& places);

 private:
  struct Footprint {
    Vec2 place = Vec2::Zero();
    bool moved_inside = false;
  };

  Footprint footprint_of(const PointAttribute& point, const FaceSurface& base, const std::string& content);
  Footprint nearest(const PointAttribute& point, const FaceSurface& base, const std::string& content);
  bool conflicts(const std::vector<PlacedPoint>& before, const std::vector<Index>& ids, Index point, const Vec2& place);
  std::optional<PlacedCurve> place_inner(const AttributeFace& face, const InnerCurve& inner, const FaceSurface& base,
                                         const std::string& content);
  void report_moved(const PointAttribute& point, const AttributeFace& face);

  const AttributeNetwork& network_;
  const LoopCurves& curves_;
  StageCache* cache_;
  Findings& findings_;
};

}  // namespace croquis
