// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "app/panels/panel.h"
#include "app/tools/surface/domain_panel.h"
#include "app/tools/surface/network.h"
#include "app/tools/surface/surface_chips.h"
#include "app/tools/tool.h"

class QDockWidget;

namespace croquis::app {

/// Curves taken from the active object by an operation: of its strokes, its edges. They become a network of their own,
/// to be worked on. Computed beside the document, on another thread.
class CurveTaking : public QObject {
  Q_OBJECT

 public:
  explicit CurveTaking(Studio& studio) : studio_(studio) {}

  /// Whether the active object, or a step of its chain, is something that the operation takes.
  bool can_take(const OperationDescription& operation) const { return source_for(operation).has_value(); }

  /// Begins; what an earlier call began is given up.
  void take(const std::string& operation);

  bool busy() const { return live_ != nullptr; }

 signals:
  void taken();  ///< the network is in the document
  void failed(const croquis::Findings& findings);

 private:
  std::optional<Link> source_for(const OperationDescription& operation) const;
  void follow();

  Studio& studio_;
  std::string name_;     ///< of the network that comes …
  Placement placement_;  ///< … and where it stands
  std::unique_ptr<LiveNode> live_;
};

/// The box of what is selected.
render::Bounds bounds_of_selected(const DrawnNetwork& network);

/// The actions of menus, keys and buttons, and which of them are enabled and checked now.
void add_surface_actions(DrawnNetwork& network, UniformGhost& ghost, CurveTaking& taking, ActionList& actions,
                         ToolKeys& keys);
void refresh_surface_actions(const DrawnNetwork& network, const UniformGhost& ghost, const CurveTaking& taking);

/// What is selected of a network, in numbers: patches, curves with their slopes, points; and how well the surfaces keep
/// to it all.
Panel* make_surface_panel(DrawnNetwork& network);

/// Attribute surfaces: curves drawn in space become smooth patches, which points and curves inside them pull.
class SurfaceDrawingTool final : public Tool {
  Q_OBJECT

 public:
  explicit SurfaceDrawingTool(ToolHost& host);

  DrawnNetwork& network() { return network_; }
  const UniformGhost& ghost() const { return ghost_; }

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& docks) override;
  void make_replays(Replays& replays) override;
  void refresh() override;
  void set_mode(const QString& mode) override;
  void follow(Change change) override;

  ViewUse use_of(int view) const override;
  ToolWords words() const override;
  ToolState state() const override;

  void take(const PointerEvent& event) override;
  bool command(EditCommand command) override;
  bool show(const Target& target) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void place_chips(ChipPlaces& places) override;

 protected:
  void feed(const std::vector<PenStep>& steps) override;
  void hover(const PointerEvent& event) override;

 private:
  void follow_panels();
  void show_in_space();

  DrawnNetwork network_;
  UniformGhost ghost_;
  CurveTaking taking_;
  SurfaceChips chips_;
  Panel* panel_ = nullptr;
  Panel* domain_panel_ = nullptr;
  PanelDocks* docks_ = nullptr;
  QDockWidget* dock_ = nullptr;
  QDockWidget* domain_dock_ = nullptr;
  NodeId opened_ = 0;
  int gesture_view_ = 0;
  QString under_pointer_;  ///< the sentences of the findings whose marks are there
};

}  // namespace croquis::app
