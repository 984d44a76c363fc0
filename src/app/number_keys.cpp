// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/number_keys.h"

#include <QAbstractSpinBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLineEdit>

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
    if (!is_letter(*key) && (!is_history(*key) || line_->isModified())) return QObject::eventFilter(field, event);
    event->ignore();
    return true;
  }

 private:
  static bool is_letter(const QKeyEvent& key) {
    const bool plain = (key.modifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
    return plain && key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z;
  }
  static bool is_history(const QKeyEvent& key) {
    return key.modifiers().testFlag(Qt::ControlModifier) && (key.key() == Qt::Key_Z || key.key() == Qt::Key_Y);
  }

  QLineEdit* line_;
};

}  // namespace

void share_keys(QAbstractSpinBox* field) { new KeySharer(field); }

}  // namespace croquis::app
