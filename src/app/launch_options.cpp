// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/launch_options.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <cstdio>

namespace croquis::app {
namespace {

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
  parser.addOption({"software-gl", "Draw without the graphics card."});
}

void refuse(const QString& sentence) {
  std::fprintf(stderr, "croquis: %s\n", qPrintable(sentence));
  std::fprintf(stderr, "Try croquis --help.\n");
}

}  // namespace

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
  LaunchOptions options{parser.positionalArguments(), parser.value("new"),    parser.value("screenshot"),
                        parser.value("replay"),       parser.value("record"), parser.isSet("stay"),
                        parser.isSet("software-gl")};
  const QStringList kinds{"silhouette", "perspective", "surface"};
  if (!options.new_kind.isEmpty() && !kinds.contains(options.new_kind)) {
    refuse("--new takes silhouette, perspective or surface; \"" + options.new_kind + "\" is not built yet");
    exit_code = wrong_usage;
    return std::nullopt;
  }
  return options;
}

}  // namespace croquis::app
