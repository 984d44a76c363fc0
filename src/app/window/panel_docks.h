// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QPointF>
#include <QSize>
#include <QString>
#include <QStringList>
#include <QVariantMap>
#include <optional>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace croquis::app {

/// The panels beside the views. A panel is seen while people want it, while there is something to show in it, and
/// while the views are shown: closing a panel lasts, hiding it for a while does not.
class PanelDocks : public QObject {
  Q_OBJECT

 public:
  explicit PanelDocks(QMainWindow& window);

  /// At the right, below the others. Named "NAME-dock".
  QDockWidget* add(const QString& title, QWidget* content, const QString& name);

  /// The same for a panel of several parts below each other, the first one narrow; and a further part, which gets the
  /// rest of the room.
  QDockWidget* add_column(const QString& title, QWidget* content, const QString& name);
  void add_to_column(const QString& name, QWidget* more);

  /// Moves a panel below another one, or into its place with a tab. @param name of the other one
  void split_below(const QString& name, QDockWidget* dock);
  void tabify(const QString& name, QDockWidget* dock);

  /// The panel of that name, or null.
  QDockWidget* find(const QString& name) const;

  /// Of the panels that share its place, it is the one in front when the views appear, until people keep a layout.
  void keep_in_front(QDockWidget* dock);

  /// The panel of a tool, which shares a place with others: it comes to the front when there begins to be something to
  /// show in it. The first time it gets that much width and most of the height; people's own sizes are kept.
  void show_tool_panel(QDockWidget* dock, bool useful, int width);
  void set_room_given(bool given);

  /// The sizes that the panels of the window itself, which were added first, have before people give them others.
  void give_first_sizes();

  /// In the order they were added.
  QList<QDockWidget*> all() const;

  /// There is something to show in it (so it is unless this was called).
  void set_useful(QDockWidget* dock, bool useful);

  void set_wanted(QDockWidget* dock, bool wanted);

  /// Names of the panels that were closed.
  QStringList closed() const;
  void set_closed(const QStringList& names);

  /// After it has changed which panels have something to show: all lie as they last did while the same ones had.
  /// Sketches, scans and networks of curves have different ones.
  void follow_layout();
  void note_layout();  ///< how they lie now; by itself before that changes

  /// QMainWindow::saveState, by the names of the panels that have something to show.
  const QVariantMap& layouts() const { return layouts_; }
  void set_layouts(const QVariantMap& layouts) { layouts_ = layouts; }

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
    bool in_front = false;
  };

  Panel* panel_of(const QDockWidget* dock);
  void apply(const Panel& panel);
  QString useful() const;  ///< names of the tools' own ones that have something to show; others come and go

  QMainWindow& window_;
  QList<Panel> panels_;
  bool shown_ = false;
  bool room_given_ = false;         ///< to all of them
  QList<QDockWidget*> roomy_ = {};  ///< those that got theirs
  QVariantMap layouts_;
  QString noted_;  ///< the name in `layouts_` of how they lie
};

/// How the window lay when it was closed, as the user's settings keep it.
struct WindowLayout {
  QByteArray geometry;        ///< QWidget::saveGeometry
  QByteArray panels;          ///< QMainWindow::saveState, of the views
  QStringList closed_panels;  ///< their names
  QVariantMap layouts;        ///< PanelDocks::layouts
  QPointF pane_shares;        ///< PaneLayout::shares
};

/// Nothing when none was kept.
std::optional<WindowLayout> kept_layout();
void keep_layout(const WindowLayout& layout);
void forget_layout();

/// Makes a window no larger than the free part of its screen, its frame included, and moves it in there.
void fit_to_screen(QWidget& window);

}  // namespace croquis::app
