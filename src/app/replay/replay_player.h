// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/tools/recording/recording.h"

namespace croquis::app {

class MainWindow;
struct Replays;

/// Plays recorded steps in a window, as a user would: docs/replays.md. The tools play the steps that are theirs.
/// @throws Error (E_REPLAY naming the line) when a step can't be done or an expectation fails
void play(MainWindow& window, const std::vector<recorded::Line>& lines);

/// Does one step. @throws Error (E_REPLAY …) when it can't be done
void play_step(const Replays& replays, const recorded::Step& step);

/// Waits until the solid of the document as it is now is final; keeps the window alive meanwhile.
/// @throws Error (E_LIMIT) after a minute
void wait_until_settled(MainWindow& window);

/// The window as people see it.
/// @throws Error (E_WRITE)
void save_window_picture(MainWindow& window, const QString& path);

/// Plays a file and returns the process' exit code; with `stay` the window stays open afterwards.
int play_file(MainWindow& window, const QString& file, bool stay);

/// Prints the findings as the command line does. @return their exit code
int print_findings(const Findings& findings);

}  // namespace croquis::app
