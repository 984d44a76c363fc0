// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/replay_player.h"

#include <QApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/files/file_reader.h"
#include "app/replay/replays.h"
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
constexpr int longest_name = 60;  // letters of a step, where it is named

}  // namespace

void play_step(const Replays& replays, const recorded::Step& step) {
  const auto plays = replays.plays.find(&step.kind());
  const bool is_played =
      plays != replays.plays.end() && std::ranges::any_of(plays->second, [&](const auto& does) { return does(step); });
  if (!is_played) refuse_replay("The window can't replay this step");
}

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
  settle(window.viewport().pictures(), true);
  QApplication::processEvents();
  if (!window.grab().save(path, "PNG")) {
    throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
  }
}

void play(MainWindow& window, const std::vector<recorded::Line>& lines) {
  window.set_unattended();
  const Replays replays = replays_of(window);
  for (const recorded::Line& line : lines) {
    window.parts().stalls.note(QString::fromStdString(recorded::to_line(line.step)).left(longest_name));
    try {
      play_step(replays, line.step);
    } catch (const Error& error) {
      Findings findings = error.findings();
      findings.front().message = "Line " + std::to_string(line.number) + ": " + findings.front().message;
      throw Error(std::move(findings));
    }
    QApplication::processEvents();
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
    const std::string name = local_name(file);
    play(window, recorded::parse(read_file(name), name, recorded::all_steps()));
  } catch (const Error& error) {
    return print_findings(error.findings());
  }
  return stay ? QApplication::exec() : 0;
}

}  // namespace croquis::app
