// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>

#include "app/studio/studio.h"
#include "app/tools/silhouette/outline_choices.h"
#include "app/tools/silhouette/sketch_chip.h"
#include "croquis/tools/silhouette/sketch_steps.h"

namespace croquis::app {

class Viewport;

/// How far the part of that name of a solid reaches along a direction, model units.
struct PartReach {
  Vec3 front = Vec3::Zero();  ///< its farthest place in that direction
  double depth = 0;           ///< from the farthest place behind to the front
};

/// @param direction unit; @return nothing if the mesh has no such part
std::optional<PartReach> part_reach(const PolyMesh& mesh, const std::string& part, const Vec3& direction);

/// The factor of depth that moves a part's front by so many pixels in a view.
/// @param from  the factor it has
/// @param depth where pixels go when the part's half depth is added to its front, logical pixels, y down; where that is
///              too short to aim at, as in a view from the front, the way up counts instead
double thickness_after(double from, const Vec2& by, const Vec2& depth);

/// The thickness of the selected part, as a chip above its outline in the sketch and at its front in the view of the
/// solid: dragged, or clicked and typed.
class ThicknessHandle : public QObject {
  Q_OBJECT

 public:
  ThicknessHandle(Studio& studio, Viewport& views);

  /// @param name how the part is called
  void follow(const ChosenPart& part, const QString& name);

  void place(ChipPlaces& places, bool shown);

 signals:
  void wanted(const croquis::recorded::StrokeReading& setting, bool dragging);

 private:
  struct Drag {
    double factor = 1;
    Vec2 depth = Vec2::Zero();  ///< pixels of half the part's depth
  };

  /// How far a part reaches in a result.
  struct Found {
    std::weak_ptr<const Evaluation> result;
    std::string part;
    Vec3 forwards = Vec3::Zero();
    std::optional<PartReach> reach;
  };

  void connect_to_chips();
  void drag(const QPointF& by, bool in_solid);
  void ask(SketchChip& chip);
  double factor() const;
  Vec2 depth_in_view();
  /// Of the part in the present result. The mesh is searched once per result, and not before somebody asks.
  const std::optional<PartReach>& reach();
  std::optional<Vec2> pixel_of(const Vec3& place) const;
  void place_in_solid(ChipPlaces& places, bool shown);

  Studio& studio_;
  Viewport& views_;
  ChipRow in_sketch_;
  SketchChip* in_solid_;
  ChosenPart part_;
  Found found_;
  Vec3 forwards_ = Vec3::UnitZ();  ///< of the sketch's plane, unit
  int view_ = -1;                  ///< that shows the solid
  std::optional<Drag> dragged_from_;
};

}  // namespace croquis::app
