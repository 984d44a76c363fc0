// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/icons.h"

#include <QFile>

namespace croquis::app {

QIcon action_icon(const QString& action) {
  const QString file = ":/icons/" + action + ".svg";
  return QFile::exists(file) ? QIcon(file) : QIcon();
}

QIcon program_icon() { return QIcon(QStringLiteral(":/icons/croquis.svg")); }

}  // namespace croquis::app
