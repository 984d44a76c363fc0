// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/progress.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {

Progress::Progress(Sink sink, const std::atomic<bool>* cancel)
    : shared_(std::make_shared<Shared>(Shared{std::move(sink), 0})), cancel_(cancel) {}

Progress Progress::step(const std::string& name, double share) {
  Progress part = *this;
  const double length = end_ - begin_;
  part.name_ = name;
  part.begin_ = begin_ + length * handed_out_;
  if (share > 0) handed_out_ = std::min(handed_out_ + share, 1.0);  // false for NaN too
  part.end_ = begin_ + length * handed_out_;
  part.handed_out_ = 0;
  part.report(0);
  return part;
}

void Progress::report(double fraction) { notify(fraction, name_); }

void Progress::report(std::size_t done, std::size_t count) {
  const double fraction = count == 0 ? 1 : static_cast<double>(done) / static_cast<double>(count);
  notify(fraction, name_ + ' ' + std::to_string(done) + " of " + std::to_string(count));
}

void Progress::notify(double fraction, const std::string& name) {
  check();
  if (!shared_ || !shared_->sink) return;
  const double whole = begin_ + (end_ - begin_) * std::clamp(fraction, 0.0, 1.0);
  shared_->highest = std::max(shared_->highest, std::min(whole, 1.0));
  shared_->sink(shared_->highest, name);
}

void Progress::check() const {
  if (cancelled()) throw Cancelled();
}

}  // namespace croquis
