// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

#include "app/studio/studio.h"
#include "app/tools/surface/network_scene.h"
#include "croquis/tools/mesh/mesh_pick.h"
#include "croquis/tools/pointer/pen.h"
#include "croquis/tools/surface/surface_sight.h"

namespace croquis::app {

/// The other objects' meshes, which curves can be drawn on. Pickers are kept until a mesh changes. One thread.
class DrawableMeshes {
 public:
  explicit DrawableMeshes(const Studio& studio) : studio_(studio) {}

  /// @param ray    in the world
  /// @param except an object: the one that is drawn
  std::optional<MeshHit> under(const Ray& ray, NodeId except);

 private:
  struct Kept {
    std::shared_ptr<const PolyMesh> mesh;
    std::unique_ptr<MeshPicker> picker;
  };
  MeshPicker& picker_of(const WorkObject& object);

  const Studio& studio_;
  std::map<NodeId, Kept> kept_;
};

/// The surfaces as they were computed last, for the tool that draws on them.
class NetworkSight final : public SurfaceSight {
 public:
  /// @param object whose surfaces these are. @param meshes outlive this
  NetworkSight(ShownSurface shown, NodeId object, DrawableMeshes& meshes)
      : shown_(std::move(shown)), object_(object), meshes_(meshes) {}

  std::optional<SurfaceHit> patch_under(const Ray& ray) const override;
  std::optional<MeshHit> mesh_under(const Ray& ray) const override;
  std::optional<Vec3> normal_at(const std::string& point) const override;
  std::optional<double> radius_of(const std::string& point) const override;
  std::vector<Vec3> ring_of(const std::string& point, double radius) const override;
  std::optional<SlopeFrame> slope_at(const std::string& face, const std::string& curve, double at) const override;

 private:
  /// A point attribute as its face has it.
  struct Placed {
    const FaceSurface* face = nullptr;
    std::size_t index = 0;

    const PlacedPoint& point() const { return face->points()[index]; }
  };
  std::optional<Placed> placed(const std::string& point) const;
  const FaceSurface* surface_of(Index face) const;
  MeshPicker& picker() const;
  std::optional<Vec2> domain_place(const SurfacePart& part, Index triangle, const Vec3& place) const;

  ShownSurface shown_;
  NodeId object_;
  DrawableMeshes& meshes_;
  mutable std::unique_ptr<MeshPicker> picker_;  ///< made when it is first needed
};

class Viewport;

/// Work on a network of curves: pen and mouse events of any view draw curves, pull points and fill loops, and the views
/// show what they do.
class NetworkInteraction : public QObject {
  Q_OBJECT

 public:
  /// @param views outlive this
  NetworkInteraction(Studio& studio, Viewport& views);

  SurfaceTool& tool() { return tool_; }
  const SurfaceTool& tool() const { return tool_; }

  /// Does a step of the tool; what it did is recorded, why it did nothing is shown.
  void act(const recorded::Step& step);

  void set_mode(SurfaceMode mode);
  void take(const PointerEvent& event);  ///< its place in its view's pixels
  bool down() const { return pen_.down(); }
  bool abandon();

  /// Of the active object; an empty one while there is none.
  const AttributeNetwork& network() const { return *network_; }
  const ShownSurface& shown() const { return shown_; }
  Findings findings() const;
  Affine3 to_world() const { return shown_.to_world; }
  const SurfaceSight* sight() const { return sight_.get(); }  ///< null before the first one

  /// Why the last gesture or command did nothing.
  const Findings& notes() const { return tool_.notes(); }

  /// How a view sees the network's own space.
  ViewFrame frame_of(int view) const;

  const NetworkScene& scene() const { return scene_; }
  void add_to(render::Scene& scene, int view) const;

  /// The sentences of the findings under the pointer.
  const QString& told_finding() const { return told_finding_; }

  bool shows_jumps() const { return jumps_; }
  void show_jumps(bool on);

  void follow_document();
  void follow_result();

 signals:
  void changed();  ///< what is drawn
  void state_changed();
  void committed(const croquis::recorded::Step& step);
  void told(const QString& sentence);

 private:
  void take_pen(const std::vector<PenStep>& steps);
  void feed(const PenStep& step);
  void finish(Verdict verdict);
  void hover(const PointerEvent& event);
  void show_preview();
  QString told_at(const Vec2& pixel, int view) const;

  Studio& studio_;
  Viewport& views_;
  SurfaceTool tool_;
  PenInput pen_;
  DrawableMeshes meshes_;
  NetworkScene scene_;
  std::shared_ptr<const AttributeNetwork> network_;
  ShownSurface shown_;
  std::shared_ptr<const SurfaceSight> sight_;
  bool jumps_ = false;
  int gesture_view_ = 0;
  QString told_finding_;
  QTimer pen_watch_;  ///< while a gesture is under way: a pen may vanish without an event
  double last_time_ = 0;
  QElapsedTimer since_event_;
};

}  // namespace croquis::app
