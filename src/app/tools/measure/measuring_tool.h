// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <vector>

#include "app/tools/tool.h"
#include "app/views/object_picker.h"
#include "croquis/tools/measure/measure_steps.h"
#include "croquis/tools/measure/measure_tool.h"
#include "croquis/tools/pointer/pen.h"

namespace croquis::app {

/// Distances, angles and radii between places that are clicked in any view.
class MeasuringTool final : public Tool {
  Q_OBJECT

 public:
  explicit MeasuringTool(ToolHost& host);

  MeasureTool& measure() { return tool_; }

  void make_actions(ActionList& actions) override;
  void refresh() override;

  void set_mode(const QString& mode) override;
  bool works_in(int) const override { return active(); }
  void take(const PointerEvent& event) override;
  bool down() const override { return pen_.down(); }
  bool abandon() override;
  QString help() const override;
  bool command(EditCommand command) override;
  bool has_selection() const override { return active() && !tool_.places().empty(); }

  void add_to(render::Scene& scene, int view) override;
  ViewUse use_of(int) const override { return {Qt::CrossCursor}; }
  void place_chips(ChipPlaces& places) override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void make_replays(Replays& replays) override;

 private:
  bool active() const { return mode() == "measure"; }
  void feed(const PenStep& step);
  void measured_anew();
  std::optional<Vec3> place_under(const ViewFrame& frame, const Vec2& pixel);

  MeasureTool tool_;
  PenInput pen_;
  ObjectPicker objects_;
  int view_ = 0;  ///< that the pointer is in
  std::vector<QLabel*> labels_;
};

}  // namespace croquis::app
