// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace croquis::app {

/// The drawn icon of an action, or an empty one for actions that have none.
QIcon action_icon(const QString& action);

/// The program's own.
QIcon program_icon();

}  // namespace croquis::app
