// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <cstddef>
#include <vector>

#include "app/replay/replays.h"
#include "app/tours/tour.h"

class QAction;
class QLabel;
class QMenu;
class QPushButton;

namespace croquis::app {

class MainWindow;
class TourGuide;

/// A tour under way, in a bar above the views: what to do next, and where. It follows what people do and hinders
/// nothing; when it ends, the document stays as it is.
class TourBar : public QFrame {
  Q_OBJECT

 public:
  TourBar(MainWindow& window, Tour tour);
  ~TourBar() override;

  const Tour& tour() const { return tour_; }

  /// The step that is asked for, from 0; as many as there are steps once all are done.
  std::size_t at() const { return at_; }

  /// Does what is left of the step, as a replay does, and goes on.
  void show_me();

  /// Goes on without it.
  void skip();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void make_widgets();
  void begin_step(std::size_t step);
  void note(const recorded::Step& done);
  void look();
  void place_marks();
  bool is_done() const;
  std::vector<recorded::Step> left() const;

  MainWindow& window_;
  Tour tour_;
  Replays replays_;
  std::size_t at_ = 0;
  std::vector<bool> done_;  ///< of what the step asks for
  bool shows_ = false;      ///< show_me is under way
  QLabel* count_;
  QLabel* caption_;
  QPushButton* show_;
  QPushButton* skip_;
  QPushButton* end_;
  TourGuide* guide_;
  QFrame* frame_;  ///< around the button or the menu of an action that is asked for
};

/// Begins a tour with a new document, unless people keep theirs. One that is under way ends.
void start_tour(MainWindow& window, const QString& name);

/// Below a menu: an entry for each tour.
void add_tour_actions(MainWindow& window, QMenu* menu);

}  // namespace croquis::app
