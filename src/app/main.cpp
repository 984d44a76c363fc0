// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCommandLineParser>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QSurfaceFormat>
#include <QWindow>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <optional>

#include <unistd.h>

#include "app/replay/replay_player.h"
#include "app/views/viewport.h"
#include "app/window/language.h"
#include "app/window/main_window.h"
#include "app/window/preferences.h"
#include "app/window/theme.h"
#include "croquis/base/error.h"

namespace {

using namespace croquis::app;

/// The studio's command line options.
struct LaunchOptions {
  QStringList files;
  QString new_kind;    ///< --new: "silhouette", "perspective", "surface", or empty
  QString screenshot;  ///< --screenshot: evaluate, save the window's picture, quit
  QString replay;      ///< --replay: play, then quit unless `stay`
  QString record;      ///< --record: append what is done to this recording
  bool stay = false;
  bool stalls = false;          ///< --stalls: print the longest ones at the end
  bool startup_report = false;  ///< --startup-report: print how long the start took, quit
};

constexpr int wrong_usage = 2;

void describe(QCommandLineParser& parser) {
  parser.setApplicationDescription(
      "Draw with a pen and watch it become solid.\n\nExample:\n  croquis --new silhouette");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(
      "FILE", "Projects (.croq), drawings (.svg), networks of curves (.json), meshes or pictures to open.", "[FILE…]");
  parser.addOption({"new", "Start with an empty drawing of this kind: silhouette, perspective or surface.", "kind"});
  parser.addOption({"screenshot", "Open, evaluate, save the window's picture here, quit.", "png"});
  parser.addOption({"replay", "Replay recorded actions and pen strokes, then quit.", "file"});
  parser.addOption({"record", "Append whatever is done to this recording.", "file"});
  parser.addOption({"stay", "Keep the window open after a replay."});
  parser.addOption({"stalls", "At the end, print how long the window was busy at most, and with what, as JSON."});
  parser.addOption({"startup-report", "Print how many milliseconds the start took, as JSON, then quit."});
  parser.addOption({"software-gl", "Draw without the graphics card."});
}

void refuse(const QString& sentence) {
  std::fprintf(stderr, "croquis: %s\n", qPrintable(sentence));
  std::fprintf(stderr, "Try croquis --help.\n");
}

/// Answers --help and --version by itself.
/// @return nothing after that, or after wrong usage, with `exit_code` set (0 or 2)
std::optional<LaunchOptions> parse_command_line(const QStringList& arguments, int& exit_code) {
  QCommandLineParser parser;
  describe(parser);
  exit_code = 0;
  if (!parser.parse(arguments)) {
    refuse(parser.errorText());
    exit_code = wrong_usage;
    return std::nullopt;
  }
  if (parser.isSet("help")) {
    std::fputs(qPrintable(parser.helpText()), stdout);
    return std::nullopt;
  }
  if (parser.isSet("version")) {
    std::printf("croquis %s\n", qPrintable(QCoreApplication::applicationVersion()));
    return std::nullopt;
  }
  LaunchOptions options{parser.positionalArguments(), parser.value("new"),           parser.value("screenshot"),
                        parser.value("replay"),       parser.value("record"),        parser.isSet("stay"),
                        parser.isSet("stalls"),       parser.isSet("startup-report")};
  const QStringList kinds{"silhouette", "perspective", "surface"};
  if (!options.new_kind.isEmpty() && !kinds.contains(options.new_kind)) {
    refuse("--new takes silhouette, perspective or surface; \"" + options.new_kind + "\" is not built yet");
    exit_code = wrong_usage;
    return std::nullopt;
  }
  return options;
}

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

/// Before the application object, too. What the environment says comes before the preferences.
void apply_scale() {
  const int percent = kept_scale();
  if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR") || qEnvironmentVariableIsSet("QT_FONT_DPI")) return;
  // Qt 6.4 leaves panels beside OpenGL views empty where a point is less than a pixel; so letters get smaller alone.
  constexpr int letters_dpi = 96;
  if (percent < 100) qputenv("QT_FONT_DPI", QByteArray::number(letters_dpi * percent / 100));
  if (percent > 100) qputenv("QT_SCALE_FACTOR", QByteArray::number(percent / 100.0));
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

/// Since the system began this process, in steps of 10 ms: loading its libraries counts, too.
double process_ms() {
  QFile file("/proc/self/stat");
  const QByteArray text = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  constexpr qsizetype start_field = 19;  // of those that follow the program's name in brackets
  const double ticks = text.mid(text.lastIndexOf(')') + 2).split(' ').value(start_field).toDouble();
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return 1e3 * (static_cast<double>(now.tv_sec) - ticks / static_cast<double>(sysconf(_SC_CLK_TCK))) +
         1e-6 * static_cast<double>(now.tv_nsec);
}

/// When they were first seen, in milliseconds from the process's start; 0: not yet.
struct Startup {
  double window = 0, view = 0;
};

void follow_startup(MainWindow& window, Startup& startup) {
  while (!window.windowHandle()->isExposed()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  startup.window = process_ms();
  QObject::connect(&window.viewport(), &QOpenGLWidget::frameSwapped, &window, [&] {
    if (startup.view == 0 && window.shows_views()) startup.view = process_ms();
  });
}

/// Waits until all is there that a stroke needs. A sketch is begun where nothing else was.
int report_startup(MainWindow& window, const Startup& startup) {
  if (!window.shows_views()) window.start_with();
  try {
    wait_until_settled(window);
    if (startup.view == 0) {
      throw croquis::Error(make_error(croquis::Category::Internal, "E_GL", "No view was drawn; try --software-gl"));
    }
  } catch (const croquis::Error& error) {
    return print_findings(error.findings());
  }
  std::printf("{\"window_ms\": %.0f, \"view_ms\": %.0f, \"ready_ms\": %.0f}\n", startup.window, startup.view,
              process_ms());
  return 0;
}

int run(const LaunchOptions& options) {
  Startup startup;
  MainWindow window(state_folder());
  const bool unattended = !options.screenshot.isEmpty() || !options.replay.isEmpty() || options.startup_report;
  if (unattended) {
    window.set_unattended();
  } else {
    remember_layout(window);
  }
  window.show();
  if (options.startup_report) follow_startup(window, startup);
  if (!options.record.isEmpty() && !window.attempt([&] { window.record_to(options.record); })) {
    return print_findings(window.last_findings());
  }
  if (options.new_kind == "silhouette")
    window.start_with();
  else if (!options.new_kind.isEmpty())
    window.action("new-" + options.new_kind)->trigger();
  for (const QString& file : options.files) {
    if (!window.open(file) && unattended) return print_findings(window.last_findings());
  }
  if (unattended) print_findings(window.files().warnings());
  int exit_code = 0;
  if (!options.replay.isEmpty()) exit_code = play_file(window, options.replay, options.stay);
  if (exit_code == 0 && !options.screenshot.isEmpty()) exit_code = save_screenshot(window, options.screenshot);
  if (exit_code == 0 && options.startup_report) exit_code = report_startup(window, startup);
  if (!unattended) {
    offer_first_choices(window);
    exit_code = QApplication::exec();
  }
  window.files().keeper().close_cleanly();
  if (options.stalls) std::fputs(QJsonDocument(to_json(window.parts().stalls.longest())).toJson().constData(), stdout);
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
  apply_scale();
  QApplication application(argc, argv);
  QApplication::setWindowIcon(program_icon());
  apply_theme(application);
  use_language(kept_language());
  return run(*options);
}
