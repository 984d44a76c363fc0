// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

#include "app/tools/subdivision/comparison.h"
#include "app/tools/tool.h"

class QAction;
class QMenu;

namespace croquis::app {

class ChainTable;

/// Subdivision: cages become smooth surfaces, of this or that scheme, side by side.
class SubdivisionTool final : public Tool {
  Q_OBJECT

 public:
  explicit SubdivisionTool(ToolHost& host);

  Comparison& comparison() { return comparison_; }

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& panels) override;
  void refresh() override;
  QString offer(const WorkObject& object) const override;
  QString status() const override;

  void adjust(ObjectScenes::Wanted& wanted, int view) const override;
  QString view_title(int view) const override;
  bool busy() const override { return comparison_.busy(); }
  void follow_document() override { comparison_.follow(); }
  Expectations expectations() override;

 private:
  void make_scheme_actions(ActionList& actions, QMenu* schemes, QMenu* compared);
  void compare(bool shown);  ///< another scheme's result beside the active object, or no longer
  void select_chain(int chain);

  Comparison comparison_;
  QList<QAction*> actions_;  ///< that need a mesh
  ChainTable* chains_ = nullptr;
};

}  // namespace croquis::app
