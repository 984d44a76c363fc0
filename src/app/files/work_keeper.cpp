// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/work_keeper.h"

#include <utility>

#include "app/files/file_reader.h"
#include "app/window/language.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr int autosave_delay_ms = 300;
constexpr int thumbnail_pause_ms = 10'000;   // pictures cost more than commits
constexpr std::size_t most_kept_steps = 50;  // that undo leads back to after a crash
constexpr QSize thumbnail_size(320, 240);

}  // namespace

WorkKeeper::WorkKeeper(Studio& studio, OffscreenPictures& pictures, const QString& state_folder)
    : studio_(studio), pictures_(pictures), state_folder_(state_folder) {
  disk_.setMaxThreadCount(1);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &WorkKeeper::save);
  connect(&studio_, &Studio::loaded, this, &WorkKeeper::forget);
  connect(&studio_, &Studio::changed, this, &WorkKeeper::follow_session);
  connect(&studio_, &Studio::busy_changed, this, [this](bool busy) {
    if (!busy) timer_.start(autosave_delay_ms);
  });
}

WorkKeeper::~WorkKeeper() { disk_.waitForDone(); }

void WorkKeeper::follow_session() {
  const Session& session = studio_.session();
  touched_ = touched_ || session.modified();
  const bool same = same_nodes(session.document(), saved_) && saved_versions_ == session.versions.state();
  if (!touched_ || same || timer_.isActive()) return;
  timer_.start(autosave_delay_ms);
}

void WorkKeeper::forget() {
  timer_.stop();
  touched_ = false;
  saved_ = Document();
  saved_results_.clear();
  has_thumbnail_ = false;
  disk_.start([this] {
    if (working_copy_) working_copy_->close_cleanly();
    working_copy_.reset();
  });
}

void WorkKeeper::close_cleanly() {
  forget();
  disk_.waitForDone();
}

void WorkKeeper::save_now() {
  save();
  disk_.waitForDone();
}

void WorkKeeper::save() {
  timer_.stop();
  if (!touched_) return;
  const Session& session = studio_.session();
  const Document& document = session.document();
  const auto items = !studio_.busy() ? shown_items() : std::vector<render::Shown<render::MeshItem>>();
  const bool wants_picture = !items.empty() && (!has_thumbnail_ || since_thumbnail_.hasExpired(thumbnail_pause_ms));
  KeptWork kept{kept_results(studio_), past_of(session, most_kept_steps), session.versions.list()};
  const bool same =
      same_nodes(document, saved_) && kept.results == saved_results_ && saved_versions_ == session.versions.state();
  if (same && !(wants_picture && !has_thumbnail_)) return;
  saved_ = document;
  saved_results_ = kept.results;
  saved_versions_ = session.versions.state();
  if (wants_picture) {
    has_thumbnail_ = true;
    since_thumbnail_.start();
  }
  disk_.start([this, document, path = local_name(project_), folder = local_name(state_folder_), kept = std::move(kept),
               items = wants_picture ? items : std::vector<render::Shown<render::MeshItem>>()] {
    try {
      if (!working_copy_) working_copy_ = std::make_unique<WorkingCopy>(WorkingCopy::create(folder));
      working_copy_->commit(document, path, {}, kept);
      if (!items.empty())
        working_copy_->commit(document, path, thumbnail_of(items), kept);  // later: pictures take longer
    } catch (const Error& error) {
      emit failed(tr("Your work is not being backed up: %1.").arg(localized(error.what())));
    }
  });
}

std::vector<render::Shown<render::MeshItem>> WorkKeeper::shown_items() const {
  return items_ ? items_() : std::vector<render::Shown<render::MeshItem>>();
}

std::vector<std::uint8_t> WorkKeeper::thumbnail_of(const std::vector<render::Shown<render::MeshItem>>& items) const {
  if (items.empty()) return {};
  try {
    return png_bytes(pictures_.draw_small(items, render::NamedView::Perspective, thumbnail_size));
  } catch (const Error&) {
    return {};  // a project without a picture is a project
  }
}

}  // namespace croquis::app
