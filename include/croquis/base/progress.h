// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace croquis {

/// Where a long computation reports how far it is, and sees that it should stop.
///
/// A progress owns a range of the whole (0..1) and hands parts of it to the steps below. The fraction that the sink
/// sees never goes backwards. `check()` is called between phases and at least every 50 ms of work.
/// One thread reports; any thread may raise the cancel flag.
class Progress {
 public:
  /// Receives the fraction of the whole in [0,1] and the name of the step under way.
  using Sink = std::function<void(double fraction, const std::string& step)>;

  /// Reports nothing and can't be cancelled.
  Progress() = default;

  /// @param sink   called from the computing thread; may be empty
  /// @param cancel raised by the host to stop; not owned, may be null
  explicit Progress(Sink sink, const std::atomic<bool>* cancel = nullptr);

  /// The next `share` (0..1) of this progress' own range, for one step. A step that ends early or is skipped leaves no
  /// gap: its successor starts where the share ends.
  Progress step(const std::string& name, double share);

  /// This step is done to `fraction` (0..1) of its own range.
  /// @throws Cancelled when the host asked to stop
  void report(double fraction);

  /// The same for things that can be counted, whose count follows the step's name: "make patches 12 of 40".
  /// @throws Cancelled when the host asked to stop
  void report(std::size_t done, std::size_t count);

  /// Cancelled along with this one, and reports nothing: for threads that help.
  Progress silent() const { return Progress({}, cancel_); }

  /// @throws Cancelled when the host asked to stop
  void check() const;

  bool cancelled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }

 private:
  struct Shared {
    Sink sink;
    double highest = 0;
  };

  void notify(double fraction, const std::string& name);

  std::shared_ptr<Shared> shared_;
  const std::atomic<bool>* cancel_ = nullptr;
  std::string name_;
  double begin_ = 0;
  double end_ = 1;
  double handed_out_ = 0;
};

}  // namespace croquis
