// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <QToolButton>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/studio.h"
#include "app/views/view_chips.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/vector.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/tools/silhouette/sketch_steps.h"

namespace croquis::app {

// Readings of outlines that people may change: hole or part, in front or behind. They follow what the drawing says
// now, which may be newer than the result.

/// The inner outlines of strokes that are still there.
std::vector<NestedStroke> nested_outlines(const InflateResult& inflated, const Drawing& drawing);

/// The pairs of strokes that cross in full view and are still there, each once.
std::vector<StrokesInView> crossings_in_view(const InflateResult& inflated, const Drawing& drawing);

/// What a stroke was read as.
struct ReadStroke {
  std::string stroke;
  silhouette::StrokeKind kind = silhouette::StrokeKind::Contour;
  bool chosen = false;  ///< by the drawing
  Vec2 at = Vec2::Zero();
};

/// Strokes that are no plain outlines, as long as they are few, and those that are selected.
std::vector<ReadStroke> read_strokes(const InflateResult& inflated, const Drawing& drawing,
                                     const std::vector<std::string>& selected);

/// The part that the selected strokes belong to; its thickness is set at the first of its strokes.
struct ChosenPart {
  std::string stroke;
  std::string object;      ///< its name in the result
  Vec2 at = Vec2::Zero();  ///< the middle of its upper border, sketch units
};

/// Nothing where strokes of several parts are selected, or of none: then `stroke` is empty.
ChosenPart chosen_part(const InflateResult& inflated, const Drawing& drawing, const std::vector<std::string>& selected);

/// A small button over the sketch, about one place of it. It is clicked, or dragged away from where it stays.
class SketchChip : public QToolButton {
  Q_OBJECT

 public:
  explicit SketchChip(QWidget* views);

  /// What it shows: an icon by its name, words beside it, and how strongly it stands out.
  struct Look {
    enum class Strength { Plain, Half, Full, Warning };
    QString icon;
    QString text;  ///< empty for the icon alone
    QString tooltip;
    Strength strength = Strength::Plain;
  };
  void set_look(const Look& look);

  /// Without this a drag is a click.
  void set_draggable(bool draggable) { draggable_ = draggable; }

 signals:
  void dragged(const QPointF& by);  ///< logical pixels from where it was pressed
  void dropped();                   ///< the drag has ended
  void asked();                     ///< clicked with the right button

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  bool draggable_ = false;
  std::optional<QPointF> pressed_at_;
  bool dragging_ = false;
};

/// As many chips of one kind as are needed; those that aren't wait hidden.
class ChipRow : public QObject {
  Q_OBJECT

 public:
  struct Chip {
    Vec2 at = Vec2::Zero();  ///< sketch units, where its middle is wanted
    SketchChip::Look look;
    double above = 0;  ///< logical pixels that it stands above that place
  };

  /// @param views that they stand on
  /// @param name  chips are called by it and their numbers
  ChipRow(QWidget* views, const QString& name, bool draggable);

  void show(std::vector<Chip> chips);

  /// @param shown false while a stroke is under way: nothing covers it
  /// @param drawn_through the pointer goes through them, so that a stroke can begin there
  void place(ChipPlaces& places, bool shown, bool drawn_through = false);

  SketchChip* chip(std::size_t number) const { return buttons_.at(number); }

 signals:
  void clicked(std::size_t number);
  void dragged(std::size_t number, const QPointF& by);
  void dropped(std::size_t number);
  void asked(std::size_t number);

 private:
  void add_button();

  QWidget* views_;
  QString name_;
  bool draggable_;
  std::vector<Chip> chips_;
  std::vector<SketchChip*> buttons_;
};

/// Numbers of chips have two decimals.
double chip_number(double value);
QString chip_text(double value);

/// Asks for a number in a small window below a chip. It takes every change, and goes with Enter, Escape or a click
/// elsewhere.
/// @param name of the field, by which tests find it
void ask_number(SketchChip& chip, const QString& name, double value, double low, double high,
                const std::function<void(double)>& take);

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
