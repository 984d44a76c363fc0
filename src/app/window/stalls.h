// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QEvent>
#include <QJsonArray>
#include <QObject>
#include <QString>
#include <vector>

namespace croquis::app {

/// A time in which the window took no events: whoever moved the pen saw nothing happen.
struct Stall {
  double ms = 0;
  double drawing_ms = 0;  ///< of these: painting, with software OpenGL most of it
  double longest_ms = 0;  ///< of these: the longest part …
  QString what;           ///< … and what it was: class of the receiver and type of the event, or "evaluation result"
  QString after;          ///< the last action or recorded step before its end
};

/// What ran from one event to the next.
struct StallPart {
  const char* receiver = nullptr;  ///< its class; null: code that no event called
  QEvent::Type type = QEvent::None;
};

/// Notes how long the window's thread stays away from its event loop. Lives in that thread; one event costs it less
/// than a microsecond.
class StallWatch : public QObject {
 public:
  StallWatch();

  /// What is done now. @param action an action's name, or a recorded step's
  void note(const QString& action) { action_ = action; }

  /// The ten longest ones so far, the longest first.
  const std::vector<Stall>& longest() const { return longest_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void begin_part(const StallPart& part);
  void end_turn(bool waits);

  QElapsedTimer clock_;
  double turn_began_ = 0;  ///< ms; less than 0 while the loop waits for events
  double part_began_ = 0;
  StallPart part_;
  StallPart longest_part_;
  Stall turn_;  ///< as it is so far
  QString action_;
  std::vector<Stall> longest_;
};

/// For reports: an array of objects.
QJsonArray to_json(const std::vector<Stall>& stalls);

}  // namespace croquis::app
