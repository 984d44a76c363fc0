// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tools/surface/curve_taking.h"
#include "app/tools/surface/network_interaction.h"
#include "app/tools/surface/surface_chips.h"
#include "app/tools/surface/uniform_ghost.h"
#include "app/tools/tool.h"

class QDockWidget;

namespace croquis::app {

class DomainPanel;
class SurfacePanel;

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
  bool needs_every_move() const override;
  bool down() const override { return network_.down(); }
  bool abandon() override { return network_.abandon(); }
  QString help_topic() const override { return QStringLiteral("Surfaces from curves"); }
  QString help() const override;
  QString tooltip() const override { return network_.told_finding(); }
  Qt::CursorShape cursor(int view) const override;

  bool select_all() override;
  bool select_none() override;
  bool delete_selection() override;
  bool has_selection() const override;
  bool accept() override;
  bool takes_key(int key) const override;
  void press_key(int key) override;
  bool open_step(const Node& step) override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  void add_to(render::Scene& scene, int view) override;
  render::Bounds bounds_in(int view) const override;
  std::optional<SelectionFrame> selection_frame(int view) const override;
  void place_chips(ChipPlaces& places) override;
  bool busy() const override { return ghost_.busy() || taking_.busy(); }

  void follow_document() override;
  void follow_result() override;
  void opened() override;
  bool show_finding(const NodeFinding& found) override;
  QString status() const override;

  std::vector<const recorded::StepKind*> steps() const override;
  bool replay(const recorded::Step& step) override;
  Expectations expectations() override;

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
  void follow_surfaces();
  SymmetryPlane mirror_plane() const;

  NetworkInteraction network_;
  UniformGhost ghost_;
  CurveTaking taking_;
  SurfaceChips chips_;
  SurfacePanel* panel_ = nullptr;
  DomainPanel* domain_panel_ = nullptr;
  PanelDocks* docks_ = nullptr;
  QDockWidget* dock_ = nullptr;
  QDockWidget* domain_dock_ = nullptr;
  NodeId opened_ = 0;
};

}  // namespace croquis::app
