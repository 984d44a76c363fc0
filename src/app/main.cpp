// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QDir>
#include <QSurfaceFormat>
#include <algorithm>

#include "app/launch_options.h"
#include "app/replay/replay_player.h"
#include "app/window/icons.h"
#include "app/window/main_window.h"
#include "app/window/theme.h"
#include "croquis/base/error.h"

namespace {

using namespace croquis::app;

/// Before the application object: later it has no effect.
void choose_graphics(int argc, char** argv) {
  const bool software = std::any_of(argv, argv + argc, [](const char* a) { return QByteArray(a) == "--software-gl"; });
  if (software) qputenv("LIBGL_ALWAYS_SOFTWARE", "1");
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setSwapInterval(1);
  QSurfaceFormat::setDefaultFormat(format);
}

QString state_folder() {
  const QString given = qEnvironmentVariable("XDG_STATE_HOME");
  const QString base = given.isEmpty() ? QDir::homePath() + "/.local/state" : given;
  return base + "/croquis";
}

int save_screenshot(MainWindow& window, const QString& path) {
  try {
    wait_until_settled(window);
    save_window_picture(window, path);
  } catch (const croquis::Error& error) {
    return print_findings(error.findings());
  }
  return 0;
}

int run(const LaunchOptions& options) {
  MainWindow window(state_folder());
  const bool unattended = !options.screenshot.isEmpty() || !options.replay.isEmpty();
  if (unattended) {
    window.set_unattended();
  } else {
    window.remember_layout();
  }
  window.show();
  if (!options.record.isEmpty() && !window.attempt([&] { window.record_to(options.record); })) {
    return print_findings(window.last_findings());
  }
  if (options.new_kind == "silhouette")
    window.start_sketch();
  else if (!options.new_kind.isEmpty())
    window.action("new-" + options.new_kind)->trigger();
  for (const QString& file : options.files) {
    if (!window.open(file) && unattended) return print_findings(window.last_findings());
  }
  if (unattended) print_findings(window.files().warnings());
  int exit_code = 0;
  if (!options.replay.isEmpty()) exit_code = play_file(window, options.replay, options.stay);
  if (exit_code == 0 && !options.screenshot.isEmpty()) exit_code = save_screenshot(window, options.screenshot);
  if (!unattended) exit_code = QApplication::exec();
  window.files().close_cleanly();
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  choose_graphics(argc, argv);
  QStringList arguments;
  for (int i = 0; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
  QCoreApplication::setApplicationName("croquis");
  QCoreApplication::setOrganizationName("croquis");
  QCoreApplication::setApplicationVersion(CROQUIS_VERSION);
  int exit_code = 0;
  // Help and wrong usage need no display.
  const auto options = parse_command_line(arguments, exit_code);
  if (!options) return exit_code;
  QApplication application(argc, argv);
  QApplication::setWindowIcon(program_icon());
  apply_theme(application);
  return run(*options);
}
