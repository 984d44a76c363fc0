// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QString>
#include <QTimer>
#include <vector>

namespace croquis::bench {

/// A time in which the window's thread took no event.
struct Wait {
  double ms = 0;
  double processor_ms = 0;  ///< of that thread alone: less than `ms` where others had the processor, or drew
  double handling_ms = 0;   ///< without pictures: what is drawn by software takes long for that alone
  QString longest;          ///< the receiver and the kind of the event that took most of it
};

/// An application that notes how long its thread is busy, as somebody notices it whose pen isn't answered.
class WatchedApplication : public QApplication {
 public:
  WatchedApplication(int& argc, char** argv);

  /// Forgets what was noted, and goes on from now.
  void begin();

  /// Since then, those of 20 ms and more.
  const std::vector<Wait>& waits();

  bool notify(QObject* receiver, QEvent* event) override;

 private:
  void tick();

  QTimer ticks_;
  QElapsedTimer clock_;
  double last_processor_ms_ = 0;
  double drawing_ms_ = 0;  ///< since the last tick
  double longest_ms_ = 0;  ///< of one event since the last tick
  QString longest_;
  int depth_ = 0;
  std::vector<Wait> waits_;
};

}  // namespace croquis::bench
