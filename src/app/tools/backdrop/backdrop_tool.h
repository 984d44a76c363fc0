// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tools/backdrop/picture_items.h"
#include "app/tools/tool.h"
#include "croquis/tools/backdrop/backdrop_editor.h"
#include "croquis/tools/pointer/pen.h"

class QDockWidget;

namespace croquis::app {

class BackdropPanel;

/// The picture behind the drawing that the sketch view shows: a photo or a scan to trace.
class BackdropTool final : public Tool {
  Q_OBJECT

 public:
  explicit BackdropTool(ToolHost& host);

  BackdropEditor& editor() { return editor_; }

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& docks) override;
  void refresh() override;

  void set_mode(const QString& mode) override;
  bool works_in(int view) const override { return view == SketchView && moves(); }
  void take(const PointerEvent& event) override;
  bool down() const override { return pen_.down(); }
  bool abandon() override;
  QString help_topic() const override { return QStringLiteral("Pictures to trace"); }
  QString help() const override;
  Qt::CursorShape cursor(int) const override { return Qt::SizeAllCursor; }

  void add_to(render::Scene& scene, int view) override;
  render::Bounds bounds_in(int view) const override;
  bool busy() const override { return items_.busy(); }

  void follow_document() override;

  std::vector<const recorded::StepKind*> steps() const override;
  bool replay(const recorded::Step& step) override;
  Expectations expectations() override;

 private:
  bool moves() const { return mode() == "move-picture" && editor_.backdrop() != nullptr; }
  void do_and_record(Verdict verdict);
  void add_behind_solid(render::Scene& scene);
  void change(const QString& label, const std::function<void(Backdrop&)>& edit);
  void ask_picture();

  BackdropEditor editor_;
  PictureItems items_;
  PenInput pen_;
  BackdropPanel* panel_ = nullptr;
  PanelDocks* docks_ = nullptr;
  QDockWidget* dock_ = nullptr;
  std::weak_ptr<const PictureFile> shown_;  ///< that was there last
};

}  // namespace croquis::app
