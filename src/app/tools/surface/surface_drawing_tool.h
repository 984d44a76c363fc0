// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "app/panels/panel.h"
#include "app/studio/studio.h"
#include "app/tools/surface/domain_panel.h"
#include "app/tools/surface/network_interaction.h"
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

  /// Operations that make networks, in the registry's order.
  std::vector<const OperationDescription*> ways() const;

  /// Whether the active object, or a step of its chain, is something that the operation takes.
  bool can_take(const OperationDescription& operation) const;

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

/// Attribute surfaces: curves drawn in space become smooth patches, which points and curves inside them pull.
class SurfaceDrawingTool final : public Tool {
  Q_OBJECT

 public:
  explicit SurfaceDrawingTool(ToolHost& host);

  NetworkInteraction& network() { return network_; }
  const UniformGhost& ghost() const { return ghost_; }
  const DomainPanel& domain_panel() const { return *domain_panel_; }

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& docks) override;
  void refresh() override;
  QStringList marking_menu(int view) const override;

  void set_mode(const QString& mode) override;
  bool works_in(int view) const override;
  void take(const PointerEvent& event) override;
  bool down() const override { return network_.down(); }
  bool abandon() override { return network_.abandon(); }
  QString help() const override;
  QString tooltip() const override { return network_.told_finding(); }

  bool command(EditCommand command) override;
  bool has_selection() const override;
  bool open_step(const Node& step) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  render::Bounds bounds_in(int view) const override;
  ViewUse use_of(int view) const override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void place_chips(ChipPlaces& places) override;
  bool busy() const override { return ghost_.busy() || taking_.busy(); }

  void follow(Change change) override;
  bool show_finding(const NodeFinding& found) override;
  QString status() const override;

  void make_replays(Replays& replays) override;

 private:
  bool is_there() const { return studio().network_node() != 0; }
  void begin_new();
  void show_in_space();
  void make_mode_actions(ActionList& actions);
  void make_element_actions(ActionList& actions);
  void make_view_actions(ActionList& actions);
  void make_source_actions(ActionList& actions);
  void split_selected();
  void toggle_symmetry();
  void draw_through_selected();
  static QString no_patch_help();
  void look_at(const NetworkElements& elements);
  void follow_panels();
  void show_opened();
  void add_counts(Replays& replays);
  SymmetryPlane mirror_plane() const;

  NetworkInteraction network_;
  UniformGhost ghost_;
  CurveTaking taking_;
  SurfaceChips chips_;
  Panel* panel_ = nullptr;
  DomainPanel* domain_panel_ = nullptr;
  PanelDocks* docks_ = nullptr;
  QDockWidget* dock_ = nullptr;
  QDockWidget* domain_dock_ = nullptr;
  NodeId opened_ = 0;
};

}  // namespace croquis::app
