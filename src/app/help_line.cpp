// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_line.h"

#include <QHBoxLayout>

namespace croquis::app {
namespace {

constexpr int words_gap = 12;  // between the two

const char* color_of(HelpLine::Tone tone) {
  switch (tone) {
    case HelpLine::Tone::Error: return "color: #f0a09a";
    case HelpLine::Tone::Warning: return "color: #ffb65c";
    case HelpLine::Tone::Plain: break;
  }
  return "color: #9fd6c3";
}

}  // namespace

HelpLine::HelpLine(QWidget* parent) : QWidget(parent), help_(new QLabel(this)), message_(new QLabel(this)) {
  help_->setObjectName("help-line");
  message_->setObjectName("message");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(words_gap);
  row->addWidget(help_);
  row->addWidget(message_, 1);
  for (QLabel* label : {help_, message_}) {
    label->setTextFormat(Qt::PlainText);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // a long sentence doesn't widen the window
  }
  help_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  help_->setMinimumWidth(0);
}

void HelpLine::show_help(const QString& text) {
  help_->setText(text);
  fit();
}

void HelpLine::tell(const QString& sentence, Tone tone, const QString& more) {
  message_->setText(sentence);
  message_->setToolTip(more);
  message_->setStyleSheet(color_of(tone));
  fit();
}

void HelpLine::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void HelpLine::fit() {
  const auto width_of = [](const QLabel* label) { return label->fontMetrics().horizontalAdvance(label->text()); };
  const bool told = !message_->text().isEmpty();
  help_->setVisible(!told || width_of(help_) + words_gap + width_of(message_) <= width());
}

}  // namespace croquis::app
