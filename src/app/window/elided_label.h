// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace croquis::app {

/// One line of plain text that never widens what it stands in: what doesn't fit ends in "…", and the whole text is
/// shown when the pointer rests on it.
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  /// @param more shown when the pointer rests on it, also where all of the text is seen
  void show_text(const QString& text, const QString& more = {});

  /// What is seen of it at its width now.
  QString seen() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void follow_width();

  QString more_;
};

}  // namespace croquis::app
