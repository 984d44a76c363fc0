// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay_player.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <algorithm>
#include <cstdio>
#include <utility>
#include <variant>

#include "app/main_window.h"
#include "app/viewport.h"
#include "croquis/base/error.h"
#include "croquis/base/exit_code.h"
#include "croquis/io/file.h"

namespace croquis::app {
namespace {

constexpr int longest_wait_ms = 60'000;
constexpr int pause_ms = 20;
constexpr double recorded_view_height = 1000;  // pixels in which motions are recorded

[[noreturn]] void refuse(const std::string& sentence) {
  throw Error(make_error(Category::Geometry, "E_REPLAY", sentence));
}

Modifiers modifiers_of(const std::vector<std::string>& names) {
  const auto has = [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  return {has("shift"), has("ctrl"), has("alt"), has("super")};
}

StrokeSample sample_at(const Vec2& place) {
  StrokeSample sample;
  sample.position = place;
  return sample;
}

CameraMotion::Kind kind_of(const std::string& motion) {
  if (motion == "track") return CameraMotion::Kind::Track;
  return motion == "dolly" ? CameraMotion::Kind::Dolly : CameraMotion::Kind::Tumble;
}

std::size_t count_objects(const Studio& studio) {
  const auto result = studio.result();
  if (!result || result->failed) return 0;
  const auto details = result->outputs.find("details");
  if (details == result->outputs.end()) return 0;
  return std::get<std::shared_ptr<const Report>>(details->second)->at("objects").as_array().size();
}

}  // namespace

void wait_until_settled(MainWindow& window) {
  QElapsedTimer watch;
  watch.start();
  do {
    QApplication::processEvents(QEventLoop::AllEvents, pause_ms);
    if (watch.elapsed() > longest_wait_ms) {
      throw Error(make_error(Category::Limit, "E_LIMIT", "The solid wasn't finished within a minute"));
    }
  } while (!window.settled());
  QApplication::processEvents();
}

void save_window_picture(MainWindow& window, const QString& path) {
  wait_until_settled(window);
  window.viewport().settle_now();
  QApplication::processEvents();
  if (!window.grab().save(path, "PNG")) {
    throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
  }
}

void ReplayPlayer::play(const std::vector<recorded::Line>& lines) {
  for (const recorded::Line& line : lines) play(line);
}

void ReplayPlayer::play(const recorded::Line& line) {
  try {
    std::visit(
        [this](const auto& step) {
          if constexpr (requires { this->play(step); }) {
            play(step);
          } else {
            refuse("The window can't replay this step");
          }
        },
        line.step);
  } catch (const Error& error) {
    Findings findings = error.findings();
    findings.front().message = "Line " + std::to_string(line.number) + ": " + findings.front().message;
    throw Error(std::move(findings));
  }
  QApplication::processEvents();
}

void ReplayPlayer::play(const recorded::StrokeDrawn& step) {
  if (window_.shows_start_page()) window_.start_sketch();
  window_.viewport().replay_gesture(step.points, step.device == "eraser", {}, step.scale);
}

void ReplayPlayer::play(const recorded::Drag& step) {
  window_.viewport().tool().drag(step.stroke, step.anchor, step.by);
}

void ReplayPlayer::play(const recorded::Action& step) {
  QAction* action = window_.action(QString::fromStdString(step.name));
  if (action == nullptr) refuse("The window has no action \"" + step.name + "\"");
  if (!action->isEnabled()) refuse("The action \"" + step.name + "\" can't be used now");
  action->trigger();
}

void ReplayPlayer::play(const recorded::Set& step) {
  Studio& studio = window_.studio();
  for (const auto& node : studio.session().document().nodes()) {
    if (node->name != step.node && node->operation != step.node) continue;
    studio.set_parameter(node->id, step.parameter, step.value, false);
    return;
  }
  refuse("The document has no node \"" + step.node + "\"");
}

void ReplayPlayer::play(const recorded::Wait&) { wait_until_settled(window_); }

void ReplayPlayer::play(const recorded::Screenshot& step) {
  save_window_picture(window_, QString::fromStdString(step.file));
}

void ReplayPlayer::play(const recorded::File& step) {
  const QString file = QString::fromStdString(step.file);
  if (step.verb == "open") {
    window_.files().open(file);
    window_.show_views();
  } else if (step.verb == "save") {
    window_.files().save(file);
  } else if (file.endsWith(".png")) {
    window_.export_picture(file);
  } else if (file.endsWith(".svg")) {
    window_.files().export_drawing(file);
  } else {
    wait_until_settled(window_);
    window_.files().export_solid(file);
  }
}

void ReplayPlayer::play(const recorded::Click& step) {
  window_.viewport().replay_gesture({sample_at(step.at)}, false, modifiers_of(step.modifiers), 0);
}

void ReplayPlayer::play(const recorded::Box& step) {
  const std::vector<StrokeSample> way{sample_at(step.from), sample_at((step.from + step.to) / 2), sample_at(step.to)};
  window_.viewport().replay_gesture(way, false, modifiers_of(step.modifiers), 0);
}

void ReplayPlayer::play(const recorded::Navigate& step) {
  const auto view = step.view == "sketch" ? Viewport::SketchView : Viewport::PerspectiveView;
  ViewPane& pane = window_.viewport().pane(view);
  CameraMotion motion;
  motion.kind = kind_of(step.motion);
  motion.delta = step.by * (pane.rect.height() / recorded_view_height);
  motion.factor = std::exp((step.by.x() - step.by.y()) * NavigationOptions().dolly_per_pixel);
  motion.about = Vec2(pane.rect.width() / 2, pane.rect.height() / 2);
  pane.move(motion);
  window_.viewport().redraw_all();
}

void ReplayPlayer::play(const recorded::Expect& step) {
  wait_until_settled(window_);
  const Studio& studio = window_.studio();
  std::size_t count = 0;
  if (step.what == "objects") count = count_objects(studio);
  if (step.what == "findings") count = studio.findings().size();
  if (step.what == "strokes") count = studio.drawing().strokes.size();
  if (static_cast<std::int64_t>(count) != step.count) {
    refuse("Expected " + std::to_string(step.count) + " " + step.what + ", but there are " + std::to_string(count));
  }
}

int print_findings(const Findings& findings) {
  for (const Finding& finding : findings) {
    const char* stop = finding.message.ends_with('.') ? "" : ".";
    std::fprintf(stderr, "croquis: %s: %s%s\n", finding.code.c_str(), finding.message.c_str(), stop);
  }
  return findings.empty() ? exit_internal : exit_code_of(findings.front().category);
}

int play_file(MainWindow& window, const QString& file, bool stay) {
  try {
    const std::string name = QFile::encodeName(file).toStdString();
    ReplayPlayer(window).play(recorded::parse(read_file(name), name));
  } catch (const Error& error) {
    return print_findings(error.findings());
  }
  return stay ? QApplication::exec() : 0;
}

}  // namespace croquis::app
