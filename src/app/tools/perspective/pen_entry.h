// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <functional>

namespace croquis::app {

/// A field for one value at the pen. Enter takes what was typed, Escape and a click elsewhere leave everything as it
/// was. What can't be read stays, with a red frame.
class PenEntry : public QLineEdit {
  Q_OBJECT

 public:
  /// @return whether the text could be read
  using Take = std::function<bool(const QString& text)>;

  explicit PenEntry(QWidget* views);

  /// @param at logical pixels of the views, where the pen is
  /// @param title what is asked for, shown while the field is empty and as its tooltip
  void ask(const QPointF& at, const QString& title, const QString& text, Take take);

 signals:
  void finished();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void close_entry();
  void show_wrong(bool wrong);

  Take take_;
};

}  // namespace croquis::app
