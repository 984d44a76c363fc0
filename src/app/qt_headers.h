// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Compiled once for the whole studio: Qt's headers are most of what its sources read.
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QImage>
#include <QLabel>
#include <QLayout>
#include <QMainWindow>
#include <QMouseEvent>
#include <QObject>
#include <QOpenGLWidget>
#include <QPushButton>
#include <QString>
#include <QTimer>
#include <QWidget>
