// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QListWidget>
#include <QSlider>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "app/panels/lists.h"
#include "app/tools/background_job.h"
#include "app/tools/tool.h"
#include "croquis/geometry/mesh_report.h"

class QLabel;

namespace croquis::app {

/// Goes through the steps of the history. While the pointer is over it, the picture of the step is above its handle.
class StepSlider : public QSlider {
  Q_OBJECT

 public:
  /// @param picture of a step; null without one
  explicit StepSlider(std::function<QImage(int)> picture);

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void sliderChange(SliderChange change) override;

 private:
  QRect handle() const;
  void show_picture();

  std::function<QImage(int)> picture_of_;
  QLabel* picture_ = nullptr;  ///< over whatever lies above
};

/// What was: the steps of the history with pictures, versions that people save under names, and two states of the model
/// beside each other.
class HistoryTool final : public Tool {
  Q_OBJECT

 public:
  explicit HistoryTool(ToolHost& host);

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& panels) override;
  void refresh() override;
  void follow(Change change) override;
  ViewUse use_of(int view) const override;
  ToolState state() const override { return {.busy = comparing_.runs()}; }
  void adjust(ObjectScenes::Wanted& wanted, int view) const override;

  /// Of a document of the history, by Session::state; null where none was taken.
  QImage picture(std::uint64_t state) const;

 private:
  /// One of two documents that are compared.
  struct Side {
    render::MeshItemPtr item;           ///< null without faces
    std::optional<MeshReport> figures;  ///< of all that it shows
  };
  struct Compared {
    QString name;
    Document document, now;
    std::optional<std::pair<Side, Side>> sides;  ///< of both, as soon as they are made
  };

  void go_to(int step, bool dragging);
  void take_picture();
  void keep_picture(std::uint64_t state, const QImage& image);
  void show_versions();
  void show_menu(const QListWidget& list, const QPoint& at);
  QString free_name(const QString& wanted, int except = -1) const;
  void ask_name();
  void save_version(const QString& name);
  void show_version(int version);
  void rename_version(int version, const QString& name);
  void delete_version(int version);
  void compare(int version, int step);
  void toggle_comparing();
  void stop_comparing();
  void make_sides();
  static Side side_of(const Document& document, const Workspace& known, Evaluator& own, Progress& progress);

  StepSlider* slider_ = nullptr;
  HistoryList* steps_ = nullptr;
  QListWidget* versions_ = nullptr;
  std::uint64_t versions_state_ = 0;          ///< Session::versions_state of those that are shown
  std::map<std::uint64_t, QImage> pictures_;  ///< a null image where none can be taken
  QTimer pause_;                              ///< after it a picture is taken
  std::optional<Compared> compared_;
  std::pair<Arrangement, int> layout_before_;  ///< of comparing, with the view that was alone
  Evaluator own_;  ///< computes what is compared: the studio's last good results stay those of its document
  BackgroundJob picturing_, comparing_;  ///< last: they use the above
};

}  // namespace croquis::app
