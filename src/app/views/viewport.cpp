// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/viewport.h"

#include <QCoreApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <memory>
#include <utility>

#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr QSize least_size(502, 240);  // two views beside each other can be worked in

}  // namespace

Viewport::Viewport(Studio& studio, QWidget* parent)
    : QOpenGLWidget(parent), views_(studio, *this), pictures_(views_), chips_(views_), input_(views_) {
  setObjectName("viewport");
  setAccessibleName(tr("Views"));
  setMouseTracking(true);
  setTabletTracking(true);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(least_size);
  // What isn't drawn again stays as it was.
  setUpdateBehavior(QOpenGLWidget::PartialUpdate);
  // On X11 Qt drops all waiting moves but the last one, and a circle becomes a polygon. The platform of the application
  // object turns that on, so it can't be turned off before.
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
}

Viewport::~Viewport() {
  makeCurrent();
  pictures_.renderer.reset();
  doneCurrent();
}

QString Viewport::graphics() {
  makeCurrent();
  QOpenGLContext* graphics = QOpenGLContext::currentContext();
  const auto* words = graphics == nullptr ? nullptr : graphics->functions()->glGetString(GL_RENDERER);
  const QString text = words == nullptr ? tr("unknown") : QString::fromUtf8(reinterpret_cast<const char*>(words));
  doneCurrent();
  return text;
}

void Viewport::initializeGL() {
  try {
    pictures_.renderer = std::make_unique<render::Renderer>();
  } catch (const Error& error) {
    chips_.say(QString::fromStdString(error.what()) + tr(". Try croquis --software-gl"));
  }
}

void Viewport::resizeGL(int, int) { lay_out(views_); }

/// By itself it would draw at each of the sizes that it gets while panels come and go; now it does at the last one.
void Viewport::resizeEvent(QResizeEvent* event) {
  setUpdatesEnabled(false);
  QOpenGLWidget::resizeEvent(event);
  setUpdatesEnabled(true);
}

void Viewport::paintGL() {
  if (draw(pictures_)) chips_.place(views_);
  const double since = std::exchange(input_.waiting_since_ms, -1);
  if (since >= 0) latency_ms_ = static_cast<double>(input_.clock.nsecsElapsed()) * 1e-6 - since;
}

bool Viewport::event(QEvent* event) { return take(input_, *event) || QOpenGLWidget::event(event); }

}  // namespace croquis::app
