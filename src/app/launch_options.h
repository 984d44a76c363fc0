// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

namespace croquis::app {

/// The studio's command line options.
struct LaunchOptions {
  QStringList files;
  QString new_kind;    ///< --new: "silhouette", "perspective", "surface", or empty
  QString screenshot;  ///< --screenshot: evaluate, save the window's picture, quit
  QString replay;      ///< --replay: play, then quit unless `stay`
  QString record;      ///< --record: append what is done to this recording
  bool stay = false;
  bool software_gl = false;
};

/// Answers --help and --version by itself.
/// @return nothing after that, or after wrong usage, with `exit_code` set (0 or 2)
std::optional<LaunchOptions> parse_command_line(const QStringList& arguments, int& exit_code);

}  // namespace croquis::app
