// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tools/tool.h"
#include "app/views/object_picker.h"
#include "croquis/tools/measure/measure_steps.h"
#include "croquis/tools/measure/measure_tool.h"

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
  ViewUse use_of(int) const override { return {.works = active(), .cursor = Qt::CrossCursor}; }
  ToolWords words() const override;
  ToolState state() const override { return {.has_selection = active() && !tool_.places().empty()}; }
  bool command(EditCommand command) override;

  void add_to(render::Scene& scene, int view) override;
  void place_chips(ChipPlaces& places) override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void make_replays(Replays& replays) override;

 protected:
  void feed(const std::vector<PenStep>& steps) override;
  void hover(const PointerEvent& event) override;

 private:
  bool active() const { return mode_ == "measure"; }
  void measured_anew();
  std::optional<Vec3> place_under(const ViewFrame& frame, const Vec2& pixel);

  MeasureTool tool_;
  ObjectPicker objects_;
  int view_ = 0;  ///< that the pointer is in
  ChipSet chips_;
};

}  // namespace croquis::app
