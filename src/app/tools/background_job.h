// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaObject>
#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <memory>
#include <optional>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/progress.h"

namespace croquis::app {

/// One computation at a time on a thread of its own. Lives in the window's thread, where results are taken.
class BackgroundJob {
 public:
  BackgroundJob() { thread_.setMaxThreadCount(1); }
  ~BackgroundJob() {
    cancel();
    thread_.waitForDone();
  }
  BackgroundJob(const BackgroundJob&) = delete;
  BackgroundJob& operator=(const BackgroundJob&) = delete;

  bool runs() const { return stop_ != nullptr; }

  /// What is being computed is given up: nothing of it is taken.
  void cancel() {
    if (stop_) *stop_ = true;
    stop_.reset();
  }

  /// Instead of what is being computed.
  /// @param work (Progress&) -> Result, on the other thread; it may throw
  /// @param take (std::optional<Result>), in the window's thread: nothing where the work threw
  template <class Work, class Take>
  void start(Work work, Take take) {
    cancel();
    stop_ = std::make_shared<std::atomic<bool>>(false);
    thread_.start([this, stop = stop_, work = std::move(work), take = std::move(take)] {
      Progress progress({}, stop.get());
      std::optional<decltype(work(progress))> result;
      try {
        result = work(progress);
      } catch (const Cancelled&) {
        // Nobody waits for it any more.
      } catch (const Error&) {
        // What can't be computed is reported where it is made.
      }
      const auto deliver = [this, stop, take, result] {
        if (*stop) return;
        stop_.reset();
        take(result);
      };
      QMetaObject::invokeMethod(&receiver_, deliver, Qt::QueuedConnection);
    });
  }

 private:
  QObject receiver_;                         ///< what hasn't been delivered goes with it
  std::shared_ptr<std::atomic<bool>> stop_;  ///< of what is being computed; null: nothing is
  QThreadPool thread_;
};

}  // namespace croquis::app
