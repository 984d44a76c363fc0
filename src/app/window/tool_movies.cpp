// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/tool_movies.h"

#include <QAction>
#include <QEvent>
#include <QFile>
#include <QFrame>
#include <QLabel>
#include <QMovie>
#include <QScreen>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace croquis::app {
namespace {

QString movie_of(const QToolButton& button) {
  const QAction* action = button.defaultAction();
  return action == nullptr ? QString() : QStringLiteral(":/movies/%1.gif").arg(action->objectName());
}

/// One for all buttons, whose events it watches.
class ToolMovie : public QFrame {
 public:
  explicit ToolMovie(QWidget& window) : QFrame(&window, Qt::ToolTip) {
    setObjectName("tool-movie");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_ShowWithoutActivating);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(text_);
    column->addWidget(picture_);
    picture_->setMovie(&movie_);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* button = static_cast<QToolButton*>(watched);
    if (event->type() == QEvent::ToolTip) {
      show_for(*button);
      return true;
    }
    const QEvent::Type type = event->type();
    if (type == QEvent::Leave || type == QEvent::MouseButtonPress || type == QEvent::Hide ||
        type == QEvent::WindowDeactivate) {
      movie_.stop();
      hide();
    }
    return QFrame::eventFilter(watched, event);
  }

 private:
  /// At the side of the button where the screen has more room.
  void show_for(const QToolButton& button) {
    movie_.stop();
    movie_.setFileName(movie_of(button));
    movie_.start();
    text_->setText(button.toolTip());
    picture_->setFixedSize(movie_.currentPixmap().deviceIndependentSize().toSize());
    adjustSize();
    const QRect free = button.screen()->availableGeometry();
    const QPoint right = button.mapToGlobal(QPoint(button.width() + 4, 0));
    const QPoint left = button.mapToGlobal(QPoint(-4 - width(), 0));
    move(right.x() + width() <= free.right() ? right.x() : std::max(free.left(), left.x()),
         std::clamp(right.y(), free.top(), std::max(free.top(), free.bottom() - height())));
    show();
  }

  QMovie movie_;
  QLabel* text_ = new QLabel(this);
  QLabel* picture_ = new QLabel(this);
};

}  // namespace

void add_tool_movies(QWidget& window) {
  auto* movie = new ToolMovie(window);
  for (QToolButton* button : window.findChildren<QToolButton*>())
    if (QFile::exists(movie_of(*button))) button->installEventFilter(movie);
}

}  // namespace croquis::app
