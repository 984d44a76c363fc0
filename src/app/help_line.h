// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QWidget>

namespace croquis::app {

/// The line below the views: what can be done next, and beside it what has just been told. Where both don't fit, what
/// was told is shown alone: nothing is cut off as long as the window is wide enough for it.
class HelpLine : public QWidget {
  Q_OBJECT

 public:
  enum class Tone { Plain, Warning, Error };

  explicit HelpLine(QWidget* parent);

  void show_help(const QString& text);

  /// Stays until `clear`. @param more shown when the pointer rests on it, where the sentence isn't all
  void tell(const QString& sentence, Tone tone = Tone::Plain, const QString& more = {});
  void clear() { tell({}); }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  QLabel* help_;
  QLabel* message_;
};

}  // namespace croquis::app
