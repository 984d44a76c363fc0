// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/sharpness_legend.h"

#include "croquis/render/sharpness_color.h"

namespace croquis::app {

SharpnessLegend::SharpnessLegend(QWidget* views)
    : Legend(views, "sharpness-legend", tr("Sharpness"), tr("Colours of tagged edges by sharpness"),
             static_cast<int>(render::sharpness_legend().size())) {}

void SharpnessLegend::draw_row(QPainter& painter, int row, int y) {
  const render::SharpnessSample sample = render::sharpness_legend()[static_cast<std::size_t>(row)];
  const QColor color(sample.color.r, sample.color.g, sample.color.b);
  painter.setPen(QPen(color, render::sharpness_width(sample.sharpness), Qt::SolidLine, Qt::RoundCap));
  const double middle = y + row_height / 2.0;
  painter.drawLine(QPointF(10, middle), QPointF(32, middle));
  draw_label(painter, y, QString::fromStdString(sample.label));
}

}  // namespace croquis::app
