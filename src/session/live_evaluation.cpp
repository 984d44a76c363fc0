// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/session/live_evaluation.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {
namespace {

/// How much of the progress a draft gets: it is meant to take a small part of the time.
constexpr double draft_share = 0.2;

using Clock = std::chrono::steady_clock;

/// While requests follow each other faster than this, as when a point is dragged, …
constexpr std::chrono::milliseconds burst{300};
/// … the final result waits so long for the next one: begun at once, it would take the processor from that one's draft.
constexpr std::chrono::milliseconds burst_pause{150};

struct Job {
  Document document;
  NodeId node = 0;
  bool in_burst = false;
  std::atomic<bool> cancelled = false;
};

std::shared_ptr<const Evaluation> internal_failure(const char* reason) {
  Evaluation evaluation;
  evaluation.failed = true;
  evaluation.findings.push_back(
      make_error(Category::Internal, "E_INTERNAL",
                 "Internal error (" + std::string(reason) + "); please report it with the input."));
  return std::make_shared<const Evaluation>(std::move(evaluation));
}

}  // namespace

/// What owner and workers share. Methods named deliver_… run on the owner's thread.
struct LiveEvaluation::State : std::enable_shared_from_this<LiveEvaluation::State> {
  using Result = std::shared_ptr<const Evaluation>;

  State(Evaluator& evaluator_, Post post_, Callbacks callbacks_)
      : evaluator(evaluator_), post(std::move(post_)), callbacks(std::move(callbacks_)) {}

  Evaluator& evaluator;
  const Post post;
  const Callbacks callbacks;
  bool reported_busy = false;  ///< owner's thread only

  std::mutex mutex;  ///< over all that follows; never held while anything is called
  std::condition_variable wake;
  bool closing = false;
  std::shared_ptr<Job> current;  ///< the newest request until it is answered or cancelled
  std::shared_ptr<Job> pending;  ///< the same, until a worker takes it
  std::size_t running = 0;       ///< workers with a job, abandoned ones included
  double fraction = 0;           ///< of the current request
  std::string step;
  bool progress_posted = false;
  Clock::time_point last_request = Clock::now() - 2 * burst;

  void replace(std::shared_ptr<Job> job) {
    if (current) current->cancelled = true;
    current = job;
    pending = std::move(job);
    fraction = 0;
    step.clear();
  }

  void work() {
    while (const std::shared_ptr<Job> job = take()) {
      compute(job);
      const std::lock_guard lock(mutex);
      --running;
    }
  }

  std::shared_ptr<Job> take() {
    std::unique_lock lock(mutex);
    wake.wait(lock, [this] { return closing || pending; });
    if (closing) return nullptr;
    ++running;
    return std::exchange(pending, nullptr);
  }

  void compute(const std::shared_ptr<Job>& job) {
    try {
      Progress whole([this, &job](double done, const std::string& name) { report_progress(job, done, name); },
                     &job->cancelled);
      Progress drafting = whole.step("draft", draft_share);
      Result result = evaluator.evaluate(job->document, job->node, Quality::Draft, drafting);
      if (result->quality == Quality::Draft) {
        post_result(job, std::move(result), Quality::Draft);
        if (job->in_burst) pause(job);
        Progress finishing = whole.step("final", 1 - draft_share);
        result = evaluator.evaluate(job->document, job->node, Quality::Final, finishing);
      }
      whole.report(1);
      post_result(job, std::move(result), Quality::Final);
    } catch (const Cancelled&) {
      // This job's result isn't needed any more.
    } catch (const std::exception& exception) {
      post_result(job, internal_failure(exception.what()), Quality::Final);
    }
  }

  void pause(const std::shared_ptr<Job>& job) {
    std::unique_lock lock(mutex);
    wake.wait_for(lock, burst_pause, [this, &job] { return closing || job->cancelled; });
    if (job->cancelled) throw Cancelled();
  }

  void report_progress(const std::shared_ptr<Job>& job, double done, const std::string& name) {
    {
      const std::lock_guard lock(mutex);
      if (job != current) return;
      fraction = done;
      step = name;
      // One at a time: computations report far more often than a window can show.
      if (std::exchange(progress_posted, true)) return;
    }
    post([self = shared_from_this()] { self->deliver_progress(); });
  }

  void deliver_progress() {
    double done = 0;
    std::string name;
    {
      const std::lock_guard lock(mutex);
      progress_posted = false;
      if (closing || !current) return;
      done = fraction;
      name = step;
    }
    if (callbacks.progress) callbacks.progress(done, name);
  }

  void post_result(const std::shared_ptr<Job>& job, Result result, Quality quality) {
    post([self = shared_from_this(), job, result = std::move(result), quality] {
      self->deliver_result(job, result, quality);
    });
  }

  void deliver_result(const std::shared_ptr<Job>& job, const Result& result, Quality quality) {
    {
      const std::lock_guard lock(mutex);
      if (closing || job != current) return;
      if (quality == Quality::Final) current = nullptr;
    }
    if (callbacks.result) callbacks.result(job->node, result, quality);
    deliver_busy();
  }

  void deliver_busy() {
    bool busy = false;
    {
      const std::lock_guard lock(mutex);
      if (closing) return;
      busy = current != nullptr;
    }
    if (std::exchange(reported_busy, busy) != busy && callbacks.busy) callbacks.busy(busy);
  }

  void post_busy() {
    post([self = shared_from_this()] { self->deliver_busy(); });
  }
};

LiveEvaluation::LiveEvaluation(Evaluator& evaluator, Post post, Callbacks callbacks)
    : state_(std::make_shared<State>(evaluator, std::move(post), std::move(callbacks))) {}

LiveEvaluation::~LiveEvaluation() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->replace(nullptr);
    state_->closing = true;
  }
  state_->wake.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void LiveEvaluation::request(Document document, NodeId node) {
  auto job = std::make_shared<Job>();
  job->document = std::move(document);
  job->node = node;
  bool all_taken = false;
  {
    const std::lock_guard lock(state_->mutex);
    const Clock::time_point now = Clock::now();
    job->in_burst = now - state_->last_request < burst;
    state_->last_request = now;
    state_->replace(std::move(job));
    all_taken = state_->running == workers_.size();
  }
  state_->post_busy();
  if (all_taken && workers_.size() < max_workers) start_worker();
  state_->wake.notify_all();  // the one that pauses, too
}

void LiveEvaluation::start_worker() {
  try {
    workers_.emplace_back([state = state_] { state->work(); });
  } catch (const std::system_error& error) {
    if (!workers_.empty()) return;  // the ones there are take it when they end
    cancel();
    throw Error(make_error(
        Category::Limit, "E_THREAD",
        std::string("The system gives no thread to compute on (") + error.what() + "); close other programs."));
  }
}

void LiveEvaluation::cancel() {
  {
    const std::lock_guard lock(state_->mutex);
    if (!state_->current) return;
    state_->replace(nullptr);
  }
  state_->post_busy();
}

bool LiveEvaluation::busy() const {
  const std::lock_guard lock(state_->mutex);
  return state_->current != nullptr;
}

}  // namespace croquis
