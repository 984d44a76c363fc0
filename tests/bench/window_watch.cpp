// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/window_watch.h"

#include <QEvent>
#include <QMetaEnum>
#include <QThread>
#include <ctime>

namespace croquis::bench {
namespace {

constexpr int tick_ms = 2;
constexpr double noted_ms = 20;

double thread_processor_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

bool is_drawing(QEvent::Type type) {
  return type == QEvent::UpdateRequest || type == QEvent::Paint || type == QEvent::Expose;
}

}  // namespace

WatchedApplication::WatchedApplication(int& argc, char** argv) : QApplication(argc, argv) {
  ticks_.setTimerType(Qt::PreciseTimer);
  QObject::connect(&ticks_, &QTimer::timeout, this, [this] { tick(); });
  ticks_.start(tick_ms);
  begin();
}

void WatchedApplication::begin() {
  waits_.clear();
  drawing_ms_ = longest_ms_ = 0;
  last_processor_ms_ = thread_processor_ms();
  clock_.start();
}

const std::vector<Wait>& WatchedApplication::waits() {
  tick();
  return waits_;
}

void WatchedApplication::tick() {
  const double ms = 1e-6 * static_cast<double>(clock_.nsecsElapsed());
  const double processor_ms = thread_processor_ms();
  if (ms >= noted_ms) waits_.push_back({ms, processor_ms - last_processor_ms_, ms - drawing_ms_, longest_});
  drawing_ms_ = longest_ms_ = 0;
  last_processor_ms_ = processor_ms;
  clock_.start();
}

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  if (depth_ > 0 || QThread::currentThread() != thread()) return QApplication::notify(receiver, event);
  // Afterwards neither of them need be there any more.
  const QEvent::Type type = event->type();
  const QString name = receiver->metaObject()->className();
  ++depth_;
  QElapsedTimer watch;
  watch.start();
  const bool taken = QApplication::notify(receiver, event);
  --depth_;
  const double ms = 1e-6 * static_cast<double>(watch.nsecsElapsed());
  if (is_drawing(type)) drawing_ms_ += ms;
  if (ms < longest_ms_) return taken;
  longest_ms_ = ms;
  longest_ = name + " " + QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
  return taken;
}

}  // namespace croquis::bench
