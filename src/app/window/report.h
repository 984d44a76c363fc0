// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>

namespace croquis::app {

class MainWindow;

/// What goes into a report beside what it always has.
struct ReportParts {
  bool steps = false;     ///< what was done since the document was opened, and the sentences of findings
  bool document = false;  ///< the project's file
};

/// What somebody who helps asks for first: version, system, graphics, settings, how large the objects are, kinds of
/// findings, the longest stalls. Without the parts it has no names and no shapes.
/// @throws Error (E_WRITE) when the document can't be written
QJsonObject report_of(MainWindow& window, const ReportParts& parts);

/// Asks for the parts and the file, and writes it. Nothing is sent.
void ask_report(MainWindow& window);

}  // namespace croquis::app
