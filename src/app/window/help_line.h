// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QWidget>

class QToolButton;

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

/// The line below the views: what can be done next, and beside it the newest message. Where both don't fit, the
/// message is shown alone; what doesn't fit even then ends in "…", with the whole sentence in the tooltip. What is open
/// is described at the right, in the room that these leave.
class HelpLine : public QWidget {
  Q_OBJECT

 public:
  enum class Tone { Plain, Warning, Error };

  explicit HelpLine(QWidget* parent);

  void show_help(const QString& text);

  /// Stays until `clear`. @param more shown when the pointer rests on it, where the sentence isn't all
  void say(const QString& sentence, Tone tone = Tone::Plain, const QString& more = {});

  /// The same about a file that was written, with a button that opens its folder.
  void say_written(const QString& path, const QString& sentence, Tone tone = Tone::Plain);
  void clear() { say({}); }

  void show_status(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  ElidedLabel* help_;
  ElidedLabel* message_;
  QToolButton* folder_;
  ElidedLabel* status_;
  QString folder_path_;
};

}  // namespace croquis::app
