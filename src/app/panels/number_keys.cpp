// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/number_keys.h"

#include <QAbstractSpinBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <algorithm>
#include <array>

namespace croquis::app {
namespace {

class KeySharer : public QObject {
 public:
  explicit KeySharer(QAbstractSpinBox* field) : QObject(field), line_(field->findChild<QLineEdit*>()) {
    field->installEventFilter(this);
    connect(field, &QAbstractSpinBox::editingFinished, this, [this] { line_->setModified(false); });
  }

  bool eventFilter(QObject* field, QEvent* event) override {
    if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(field, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    if (!is_command(*key) && (!is_history(*key) || line_->isModified())) return QObject::eventFilter(field, event);
    event->ignore();
    return true;
  }

 private:
  /// A letter, or one with Ctrl that isn't for the clipboard or the history: fields know Ctrl+E as the end of a line.
  static bool is_command(const QKeyEvent& key) {
    if (key.key() < Qt::Key_A || key.key() > Qt::Key_Z) return false;
    if (!key.modifiers().testFlag(Qt::ControlModifier)) return !key.modifiers().testFlag(Qt::AltModifier);
    constexpr std::array own{Qt::Key_A, Qt::Key_C, Qt::Key_V, Qt::Key_X, Qt::Key_Y, Qt::Key_Z};
    return std::ranges::find(own, key.key()) == own.end();
  }
  static bool is_history(const QKeyEvent& key) {
    return key.modifiers().testFlag(Qt::ControlModifier) && (key.key() == Qt::Key_Z || key.key() == Qt::Key_Y);
  }

  QLineEdit* line_;
};

}  // namespace

void share_keys(QAbstractSpinBox* field) { new KeySharer(field); }

}  // namespace croquis::app
