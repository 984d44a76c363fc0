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

/// Another document beside the present one, with the same camera, and both with their numbers.
class DocumentComparison : public QObject {
  Q_OBJECT

 public:
  explicit DocumentComparison(ToolHost& host) : host_(host), own_(host.studio().registry(), std::size_t{1} << 28) {}

  bool shown() const { return name_.has_value(); }
  bool busy() const { return job_.runs(); }
  void start(const QString& name, const Document& document);
  void stop();

  /// The present document is another one, or its results have come.
  void follow();

  QString title(int view) const;                                   ///< empty for other views
  const render::MeshItemPtr& item() const { return other_.item; }  ///< of the other document

 signals:
  void changed();

 private:
  struct Side {
    render::MeshItemPtr item;           ///< null without faces
    std::optional<MeshReport> figures;  ///< of all that it shows
  };
  static Side side_of(const Document& document, const Workspace& known, Evaluator& own, Progress& progress);

  ToolHost& host_;
  std::optional<QString> name_;  ///< while it is shown
  Document document_, now_;
  Side other_, present_;
  bool made_ = false;                          ///< both sides are, of now_
  std::pair<Arrangement, int> layout_before_;  ///< with the view that was alone
  Evaluator own_;      ///< computes what isn't known: the studio's last good results stay those of its document
  BackgroundJob job_;  ///< last: it uses the above
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
  ToolState state() const override { return {.busy = comparison_.busy()}; }
  void adjust(ObjectScenes::Wanted& wanted, int view) const override;

  /// Of a document of the history, by Session::state; null where none was taken.
  QImage picture(std::uint64_t state) const;

 private:
  void go_to(int step, bool dragging);
  void take_picture();
  void keep_picture(std::uint64_t state, const Document& document, const QImage& image);
  void show_versions();
  void show_menu(const QListWidget& list, const QPoint& at);
  void ask_name();
  void save_version(const QString& name);
  void show_version(int version);
  void rename_version(int version, const QString& name);
  void delete_version(int version);
  void compare(int version, int step);
  void toggle_comparing();

  StepSlider* slider_ = nullptr;
  HistoryList* steps_ = nullptr;
  QListWidget* versions_ = nullptr;
  std::uint64_t versions_state_ = 0;          ///< Versions::state of those that are shown
  std::map<std::uint64_t, QImage> pictures_;  ///< a null image where none can be taken
  QTimer pause_;                              ///< after it a picture is taken
  DocumentComparison comparison_;
  BackgroundJob picturing_;  ///< last: it uses the above
};

}  // namespace croquis::app
