// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <string>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/silhouette/sketch_chip.h"
#include "app/views/object_scenes.h"
#include "croquis/operators/attach_text.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/tools/recording/step.h"
#include "croquis/tools/silhouette/sketch_tool.h"

namespace croquis::app {

// The parts of a sketch's solid. Documents, recordings and reports call them by their first strokes.

struct Body {
  QString name;                      ///< see part_names
  std::vector<std::string> strokes;  ///< that it is made of
};

/// Of a solid's newest result, in its order; empty without one.
std::vector<Body> bodies_of(const Drawing& drawing, const Evaluation* solid);

/// What people call a kind of stroke.
QString word_of(silhouette::StrokeKind kind);

/// The body that some of these strokes belong to, or null.
const Body* body_with(const std::vector<Body>& bodies, const std::vector<std::string>& strokes);

/// Bodies that were joined get one colour, without lines where they meet. Null for what is no solid of a sketch.
LiveItem::Paint paint_of_bodies(const WorkObject& object);

// How pairs of parts are held: what a solid suggests, and what its parameter "attach" says.

/// Two parts that overlap as limb and body do.
struct Joint {
  std::string a;  ///< names of objects
  std::string b;
  Vec2 at = Vec2::Zero();                                ///< sketch units
  silhouette::Hold hold = silhouette::Hold::Apart;       ///< as it is wanted
  silhouette::Hold by_itself = silhouette::Hold::Apart;  ///< without an entry of its own
  double blend = 0;                                      ///< of joined ones: radius of the seam, 0 to 1
  bool held = true;                                      ///< false: the newest solid couldn't be made so
};

/// With the names of objects for those strokes by which entries may name them.
AttachText with_object_names(AttachText attach, const InflateResult& inflated);

/// Of a solid's newest result. @param attach with names of objects; @param is_final it is no draft: then what isn't
/// held is known
std::vector<Joint> joints_of(const InflateResult& inflated, const AttachText& attach, bool is_final);

/// Apart, resting, joined, and apart again.
silhouette::Hold next_hold(silhouette::Hold hold);

/// With the pair held so; without an entry where it is by itself.
AttachText with_hold(AttachText attach, const Joint& joint, silhouette::Hold hold);

/// With the pair joined with a seam of this radius, limited to 0 to 1.
AttachText with_blend(AttachText attach, const Joint& joint, double blend);

/// Buttons over the views for how the drawing is read: how two parts are held, what a stroke is, whether an inner
/// outline is a hole or a part, which of two outlines that cross lies in front, and how thick the selected part is.
class SketchChips : public QObject {
  Q_OBJECT

 public:
  /// @param views that they stand on; @param tool outlives this
  SketchChips(Studio& studio, SketchTool& tool, Viewport& views);

  /// What the newest result and the drawing as it is now offer.
  void follow();

  /// Joins every pair that is offered.
  void join_all();

  void place(ChipPlaces& places, bool shown);

  /// Nothing for a stroke that isn't there any more.
  void set(const recorded::StrokeReading& setting, bool dragging = false);

 signals:
  void committed(const croquis::recorded::Step& step);

 private:
  void connect_rows();
  QString name_of(const std::string& object_or_stroke) const;
  QString pair_name(const Joint& joint) const;
  ChipRow::Chip chip_of(const Joint& joint) const;
  ChipRow::Chip chip_of(const NestedStroke& nested) const;
  ChipRow::Chip chip_of(const StrokesInView& crossing) const;
  ChipRow::Chip chip_of(const TubeSwap& swap) const;
  void ask_kind(const ReadStroke& read, QWidget& chip);

  AttachText attach() const;
  void set_attach(const AttachText& attach, const QString& step, bool dragging);
  QString seam_step(const Joint& joint) const;

  Studio& studio_;
  SketchTool& tool_;
  ChipRow joint_row_, nested_row_, crossing_row_, tube_row_, kind_row_;
  ThicknessHandle thickness_;
  std::vector<Body> bodies_;
  std::vector<Joint> joints_;
  std::vector<NestedStroke> nested_;
  std::vector<StrokesInView> crossings_;
  std::vector<TubeSwap> swaps_;
  std::vector<ReadStroke> kinds_;
  std::optional<double> dragged_from_;  ///< the number that the chip under way began with
};

}  // namespace croquis::app
