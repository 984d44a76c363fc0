// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <map>
#include <memory>

#include "app/panels/panel.h"
#include "app/tools/tool.h"
#include "croquis/geometry/picture_file.h"
#include "croquis/render/picture_item.h"
#include "croquis/tools/backdrop/backdrop_editor.h"

class QDockWidget;

namespace croquis::app {

/// Pictures made ready for the renderer, beside the window's thread, for as long as somebody holds them.
class PictureItems : public QObject {
  Q_OBJECT

 public:
  PictureItems() { thread_.setMaxThreadCount(1); }
  ~PictureItems() override { thread_.waitForDone(); }

  /// Null while it is being made, and for a picture that can't be read.
  render::PictureItemPtr item(const std::shared_ptr<const PictureFile>& picture);

  bool busy() const { return making_ > 0; }

 signals:
  void ready();

 private:
  using Key = std::weak_ptr<const PictureFile>;

  std::map<Key, render::PictureItemPtr, std::owner_less<>> items_;
  int making_ = 0;
  QThreadPool thread_;
};

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
  ViewUse use_of(int view) const override;
  ToolWords words() const override;
  ToolState state() const override { return {.busy = items_.busy()}; }

  void add_to(render::Scene& scene, int view) override;

  void follow(Change change) override;
  void make_replays(Replays& replays) override;

 protected:
  void feed(const std::vector<PenStep>& steps) override;

 private:
  bool moves() const { return mode_ == "move-picture" && editor_.backdrop() != nullptr; }
  void do_and_record(Verdict verdict);
  void add_behind_solid(render::Scene& scene);
  void change(const QString& label, const std::function<void(Backdrop&)>& edit);
  void ask_picture();
  Panel* make_panel();
  void add_opacity(Panel& panel);

  BackdropEditor editor_;
  PictureItems items_;
  Panel* panel_ = nullptr;
  PanelDocks* docks_ = nullptr;
  QDockWidget* dock_ = nullptr;
  std::weak_ptr<const PictureFile> shown_;  ///< that was there last
};

}  // namespace croquis::app
