// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/picture_question.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "app/files/picture_reader.h"

namespace croquis::app {

std::optional<PictureUse> ask_picture_use(const QStringList& paths, QWidget& parent) {
  const auto count = std::ranges::count_if(paths, is_picture_name);
  if (count == 0) return PictureUse::Backdrop;
  const QString what = count == 1 ? QFileInfo(*std::ranges::find_if(paths, is_picture_name)).fileName()
                                  : QMessageBox::tr("%1 pictures").arg(count);
  QMessageBox question(QMessageBox::Question, QMessageBox::tr("Croquis"),
                       QMessageBox::tr("Trace the lines of %1 as strokes, or put it behind the drawing?").arg(what),
                       QMessageBox::Cancel, &parent);
  question.setObjectName("picture-question");
  const QPushButton* trace = question.addButton(QMessageBox::tr("&Trace lines"), QMessageBox::AcceptRole);
  QPushButton* backdrop = question.addButton(QMessageBox::tr("&Backdrop"), QMessageBox::AcceptRole);
  question.setDefaultButton(backdrop);
  question.exec();
  if (question.clickedButton() == trace) return PictureUse::Lines;
  return question.clickedButton() == backdrop ? std::optional(PictureUse::Backdrop) : std::nullopt;
}

}  // namespace croquis::app
