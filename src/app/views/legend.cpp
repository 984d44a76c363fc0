// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/legend.h"

#include <utility>

#include "app/window/language.h"

namespace croquis::app {
namespace {

constexpr int legend_width = 96;
constexpr int text_left = 40;
constexpr int card_margin = 4;
constexpr int card_radius = 6;
constexpr int font_pixels = 11;
constexpr QColor legend_ink(60, 66, 76);
constexpr QColor card_color(255, 255, 255, 190);

}  // namespace

Legend::Legend(QWidget* views, const QString& name, const std::string& title, const QString& meaning,
               std::vector<Row> rows)
    : QWidget(views), title_(title), rows_(std::move(rows)) {
  setObjectName(name);
  setAccessibleName(meaning);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFixedSize(legend_width, row_height * (static_cast<int>(rows_.size()) + 1) + 2 * card_margin);
  hide();
}

void Legend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(card_color);
  painter.drawRoundedRect(rect(), card_radius, card_radius);
  QFont font = painter.font();
  font.setPixelSize(font_pixels);
  painter.setFont(font);
  painter.setPen(legend_ink);
  painter.drawText(QRect(8, card_margin, width() - 8, row_height), Qt::AlignVCenter, shown_text(title_));
  int y = card_margin;
  for (const Row& row : rows_) {
    y += row_height;
    row.draw(painter, y);
    painter.setPen(legend_ink);
    painter.drawText(QRect(text_left, y, width() - text_left, row_height), Qt::AlignVCenter, shown_text(row.label));
  }
}

}  // namespace croquis::app
