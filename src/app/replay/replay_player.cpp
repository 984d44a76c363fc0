// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/replay_player.h"

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/replay/expectations.h"
#include "app/replay/replay_lookup.h"
#include "app/views/viewport.h"
#include "app/window/main_window.h"
#include "croquis/base/error.h"
#include "croquis/base/exit_code.h"
#include "croquis/io/file.h"
#include "croquis/tools/all_steps.h"

namespace croquis::app {
namespace {

constexpr int longest_wait_ms = 60'000;
constexpr int replay_pause_ms = 20;
constexpr double recorded_view_height = 1000;  // pixels in which motions are recorded

CameraMotion::Kind kind_of(const std::string& motion) {
  if (motion == "track") return CameraMotion::Kind::Track;
  return motion == "dolly" ? CameraMotion::Kind::Dolly : CameraMotion::Kind::Tumble;
}

void expect_count(MainWindow& window, const recorded::Expect& step) {
  const Expectations all = expectations_of(window);
  const auto found = all.counts.find(step.what);
  if (found == all.counts.end()) refuse_replay("The window can't count " + step.what);
  const std::size_t count = found->second(step.node);
  if (static_cast<std::int64_t>(count) == step.count) return;
  refuse_replay("Expected " + std::to_string(step.count) + " " + step.what + ", but there are " +
                std::to_string(count));
}

void expect_range(MainWindow& window, const recorded::Expect& step) {
  constexpr double tolerance = 1e-3;  // degrees
  const Expectations all = expectations_of(window);
  const auto found = all.ranges.find(step.what);
  if (found == all.ranges.end()) refuse_replay("The window can't measure " + step.what);
  const auto [least, greatest] = found->second(step.node);
  const double wanted_least = *step.value;
  const double wanted_greatest = step.to.value_or(wanted_least);
  if (std::abs(least - wanted_least) <= tolerance && std::abs(greatest - wanted_greatest) <= tolerance) return;
  refuse_replay("Expected angles from " + std::to_string(wanted_least) + " to " + std::to_string(wanted_greatest) +
                " degrees, but they are from " + std::to_string(least) + " to " + std::to_string(greatest));
}

MeshExport mesh_export_of(const recorded::File& step) {
  using Objects = MeshExport::Objects;
  const Objects objects = step.objects == "all"       ? Objects::All
                          : step.objects == "visible" ? Objects::Visible
                                                      : Objects::Picked;
  return {objects, step.unit};
}

}  // namespace

void wait_until_settled(MainWindow& window) {
  QElapsedTimer watch;
  watch.start();
  do {
    QApplication::processEvents(QEventLoop::AllEvents, replay_pause_ms);
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
  window_.set_unattended();
  for (const recorded::Line& line : lines) play(line);
}

void ReplayPlayer::play(const recorded::Line& line) {
  try {
    play(line.step);
  } catch (const Error& error) {
    Findings findings = error.findings();
    findings.front().message = "Line " + std::to_string(line.number) + ": " + findings.front().message;
    throw Error(std::move(findings));
  }
  QApplication::processEvents();
}

template <typename T>
bool ReplayPlayer::play_if(const recorded::Step& step) {
  const T* general = step.as<T>();
  if (general != nullptr) play(*general);
  return general != nullptr;
}

void ReplayPlayer::play(const recorded::Step& step) {
  const bool general = play_if<recorded::Action>(step) || play_if<recorded::Set>(step) ||
                       play_if<recorded::Wait>(step) || play_if<recorded::Screenshot>(step) ||
                       play_if<recorded::File>(step) || play_if<recorded::Navigate>(step) ||
                       play_if<recorded::Expect>(step) || play_if<recorded::FaceSetChoice>(step) ||
                       play_if<recorded::NodeChoice>(step) || play_if<recorded::Place>(step);
  if (general) return;
  for (const auto& tool : window_.tools()) {
    const auto kinds = tool->steps();
    if (std::ranges::count(kinds, &step.kind()) > 0 && tool->replay(step)) return;
  }
  refuse_replay("The window can't replay this step");
}

void ReplayPlayer::play(const recorded::NodeChoice& step) {
  std::vector<NodeId> nodes;
  for (const std::string& name : step.nodes) nodes.push_back(node_named(window_.studio(), name));
  window_.select_nodes(nodes);
}

void ReplayPlayer::play(const recorded::Place& step) {
  std::vector<PlacedObject> placed;
  for (std::size_t i = 0; i < step.nodes.size(); ++i)
    placed.push_back({object_named(window_.studio(), step.nodes[i]).node, step.places[i]});
  window_.studio().place_objects(placed);
}

void ReplayPlayer::play(const recorded::FaceSetChoice& step) {
  wait_until_settled(window_);
  window_.select_face_sets(object_named(window_.studio(), step.node).node, step.names);
}

void ReplayPlayer::play(const recorded::Action& step) {
  QAction* action = window_.action(QString::fromStdString(step.name));
  if (action == nullptr) refuse_replay("The window has no action \"" + step.name + "\"");
  // Nothing acts on what the start page hides.
  if (!action->isEnabled() && window_.shows_start_page()) window_.show_views();
  if (!action->isEnabled()) refuse_replay("The action \"" + step.name + "\" can't be used now");
  action->trigger();
}

void ReplayPlayer::play(const recorded::Set& step) {
  window_.studio().set_parameter(node_named(window_.studio(), step.node), step.parameter, step.value, false);
}

void ReplayPlayer::play(const recorded::Wait&) { wait_until_settled(window_); }

void ReplayPlayer::play(const recorded::Screenshot& step) {
  save_window_picture(window_, QString::fromStdString(step.file));
}

void ReplayPlayer::play(const recorded::File& step) {
  const QString file = QString::fromStdString(step.file);
  if (step.verb == "open") {
    window_.files().open(file, step.replaces, step.traces ? PictureUse::Lines : PictureUse::Backdrop);
  } else if (step.verb == "save") {
    window_.files().save(file);
  } else if (file.endsWith(".png")) {
    window_.export_picture(file);
  } else if (file.endsWith(".svg") || (file.endsWith(".json") && window_.studio().network_node() != 0)) {
    window_.files().export_drawing(file);
  } else if (file.endsWith(".json")) {
    wait_until_settled(window_);
    window_.files().export_result(*window_.files().exports().front(), file);
  } else if (is_step_path(step.file)) {
    wait_until_settled(window_);
    window_.files().export_step(file);
    wait_until_settled(window_);
  } else {
    wait_until_settled(window_);
    window_.files().export_solid(file, mesh_export_of(step));
  }
}

void ReplayPlayer::play(const recorded::Navigate& step) {
  const int view = view_of(step.view);
  const ViewPane& pane = window_.viewport().pane(view);
  CameraMotion motion;
  motion.kind = kind_of(step.motion);
  motion.delta = step.by * (pane.rect.height() / recorded_view_height);
  motion.factor = std::exp((step.by.x() - step.by.y()) * NavigationOptions().dolly_per_pixel);
  motion.about = Vec2(pane.rect.width() / 2, pane.rect.height() / 2);
  window_.viewport().move_camera(view, motion);
  window_.viewport().redraw_all();
}

void ReplayPlayer::play(const recorded::Expect& step) {
  wait_until_settled(window_);
  if (step.value) {
    expect_range(window_, step);
  } else {
    expect_count(window_, step);
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
    ReplayPlayer(window).play(recorded::parse(read_file(name), name, recorded::all_steps()));
  } catch (const Error& error) {
    return print_findings(error.findings());
  }
  return stay ? QApplication::exec() : 0;
}

}  // namespace croquis::app
