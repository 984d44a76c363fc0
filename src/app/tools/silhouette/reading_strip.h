// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QImage>
#include <QLabel>
#include <QToolButton>
#include <memory>
#include <optional>
#include <vector>

#include "app/tools/background_job.h"
#include "app/tools/tool.h"
#include "app/views/view_pane.h"
#include "croquis/silhouette/drawing_readings.h"
#include "croquis/tools/silhouette/sketch_steps.h"

namespace croquis::app {

/// Other readings of the sketch, as small pictures of their solids at the lower edge of its view. They are looked for
/// one after the other in the background. Tab and Shift+Tab go through them, Return or a click chooses, Escape closes.
class ReadingStrip final : public QFrame {
  Q_OBJECT

 public:
  explicit ReadingStrip(ToolHost& host);

  /// Begins to look for them; where it is open already, goes to the next one.
  void open();
  /// What is still looked for is given up.
  void shut();
  bool is_open() const { return readings_ != nullptr; }
  bool busy() const { return job_.runs(); }

  void place(const ViewPane& pane, bool shown);

 signals:
  /// What the strokes are to say then.
  void chosen(const croquis::recorded::ReadingChosen& reading);
  void size_changed();

 protected:
  bool eventFilter(QObject* button, QEvent* event) override;

 private:
  /// A reading that gives a solid.
  struct Found {
    silhouette::DrawingReading reading;
    QImage picture;
  };

  void look_for_next();
  void add(Found found);
  void go(int by);
  void choose(std::size_t number);

  ToolHost& host_;
  std::shared_ptr<silhouette::DrawingReadings> readings_;  ///< null: the strip is closed
  std::uint64_t document_state_ = 0;                       ///< that they were looked for in
  std::vector<Found> found_;
  std::vector<QToolButton*> buttons_;
  QLabel* state_;
  BackgroundJob job_;  ///< last: it uses the above
};

}  // namespace croquis::app
