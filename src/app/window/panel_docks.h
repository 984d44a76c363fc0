// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QString>
#include <QStringList>

class QDockWidget;
class QMainWindow;

namespace croquis::app {

/// The panels beside the views. A panel is seen while people want it, while there is something to show in it, and
/// while the views are shown: closing a panel lasts, hiding it for a while does not.
class PanelDocks : public QObject {
  Q_OBJECT

 public:
  explicit PanelDocks(QMainWindow& window);

  /// At the right, below the others. Named "NAME-dock".
  QDockWidget* add(const QString& title, QWidget* content, const QString& name);

  /// In the order they were added.
  QList<QDockWidget*> all() const;

  /// There is something to show in it (so it is unless this was called).
  void set_useful(QDockWidget* dock, bool useful);

  void set_wanted(QDockWidget* dock, bool wanted);
  bool is_wanted(const QDockWidget* dock) const;

  /// Names of the panels that were closed.
  QStringList closed() const;
  void set_closed(const QStringList& names);

  /// Whether the views are shown, which the panels belong to.
  void show_all(bool shown);

 signals:
  void wanted_changed(QDockWidget* dock, bool wanted);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Panel {
    QDockWidget* dock = nullptr;
    bool useful = true;
    bool wanted = true;
  };

  Panel* panel_of(const QDockWidget* dock);
  void apply(const Panel& panel);

  QMainWindow& window_;
  QList<Panel> panels_;
  bool shown_ = false;
};

}  // namespace croquis::app
