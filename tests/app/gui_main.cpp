// SPDX-License-Identifier: GPL-3.0-or-later
#define CATCH_CONFIG_RUNNER
#include <QApplication>
#include <QSurfaceFormat>
#include <QTemporaryDir>

#include <catch2/catch.hpp>

#include "app/window/theme.h"

int main(int argc, char** argv) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
  // Nobody's own settings: every run begins as on a new machine.
  const QTemporaryDir home;
  qputenv("XDG_CONFIG_HOME", home.path().toLocal8Bit());
  qputenv("XDG_STATE_HOME", home.path().toLocal8Bit());
  QApplication application(argc, argv);
  QCoreApplication::setApplicationName("croquis");
  QCoreApplication::setOrganizationName("croquis");
  croquis::app::apply_theme(application);
  return Catch::Session().run(argc, argv);
}
