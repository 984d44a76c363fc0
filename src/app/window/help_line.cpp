// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help_line.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPainter>
#include <QStyle>
#include <QToolButton>
#include <QUrl>
#include <algorithm>

#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr int words_gap = 12;     // between two of them
constexpr int least_status = 60;  // less is no word

QString words_of(HelpLine::Tone tone) {
  switch (tone) {
    case HelpLine::Tone::Error: return QStringLiteral("error");
    case HelpLine::Tone::Warning: return QStringLiteral("warning");
    case HelpLine::Tone::Plain: break;
  }
  return QStringLiteral("good");
}

}  // namespace

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setMinimumWidth(1);  // else the whole text is the least width
}

void ElidedLabel::show_text(const QString& text, const QString& more) {
  more_ = more;
  setText(text);
  follow_width();
}

QString ElidedLabel::seen() const { return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()); }

void ElidedLabel::follow_width() { setToolTip(more_.isEmpty() && seen() != text() ? text() : more_); }

void ElidedLabel::resizeEvent(QResizeEvent* event) {
  QLabel::resizeEvent(event);
  follow_width();
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment()), palette(), isEnabled(), seen(),
                        foregroundRole());
}

HelpLine::HelpLine(QWidget* parent)
    : QWidget(parent),
      help_(new ElidedLabel(this)),
      message_(new ElidedLabel(this)),
      folder_(new QToolButton(this)),
      status_(new ElidedLabel(this)) {
  help_->setObjectName("help-line");
  message_->setObjectName("message");
  folder_->setObjectName("open-folder");
  folder_->setText(tr("Open folder"));
  folder_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);  // the views keep their height when it comes
  folder_->hide();
  status_->setObjectName("status");
  set_tone(*status_, QStringLiteral("faint"));
  connect(folder_, &QToolButton::clicked, this,
          [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder_path_)); });
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(words_gap);
  row->addWidget(help_);
  row->addWidget(message_, 1);
  row->addWidget(folder_);
  row->addWidget(status_, 0, Qt::AlignRight);
  help_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  message_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void HelpLine::show_help(const QString& text) {
  help_->show_text(text);
  fit();
}

void HelpLine::show_status(const QString& text) {
  status_->show_text(text);
  fit();
}

void HelpLine::say(const QString& sentence, Tone tone, const QString& more) {
  folder_->hide();
  message_->show_text(sentence, more);
  set_tone(*message_, words_of(tone));
  fit();
}

void HelpLine::say_written(const QString& path, const QString& sentence, Tone tone) {
  say(sentence, tone, sentence);
  folder_path_ = QFileInfo(path).absolutePath();
  folder_->setToolTip(folder_path_);
  folder_->show();
  fit();
}

void HelpLine::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

void HelpLine::fit() {
  const auto width_of = [](const QLabel* label) { return label->sizeHint().width(); };
  const bool has_message = !message_->text().isEmpty();
  const int button = folder_->isHidden() ? 0 : words_gap + folder_->sizeHint().width();
  const int message = has_message ? width_of(message_) + button : 0;
  const bool helps = !has_message || width_of(help_) + words_gap + message <= width();
  help_->setVisible(helps);
  message_->setVisible(has_message);
  const int room = width() - (helps ? width_of(help_) + words_gap : 0) - (has_message ? message + words_gap : 0);
  status_->setMaximumWidth(std::max(room, least_status));
  status_->setVisible(!status_->text().isEmpty() && room >= least_status);
}

}  // namespace croquis::app
