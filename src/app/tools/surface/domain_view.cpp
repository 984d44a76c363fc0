// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/domain_view.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double domain_margin = 20;  // logical pixels: room for the names of sides …
constexpr double name_share = 0.22;   // … which take at most that much of the width on either side
constexpr double name_distance = 9;
constexpr double title_height = 18;
constexpr double dot = 4;
const QColor domain_fill(58, 62, 70);
const QColor domain_line(222, 226, 232);
const QColor domain_smooth(126, 164, 232);
const QColor domain_curve(186, 140, 224);

std::size_t longest_side(const DomainPolygon& polygon) {
  std::size_t longest = 0;
  for (std::size_t k = 1; k < polygon.side_lengths.size(); ++k) {
    if (polygon.side_lengths[k] > polygon.side_lengths[longest] * (1 + 1e-9)) longest = k;
  }
  return longest;
}

/// Places of a domain in the widget, turned so that one side lies below.
class DomainFit {
 public:
  DomainFit(const DomainPolygon& polygon, const QRectF& room, std::size_t below) {
    const std::size_t next = (below + 1) % polygon.corners.size();
    along_ = (polygon.corners[next] - polygon.corners[below]).normalized();
    Vec2 low = turned(polygon.corners.front()), high = low;
    for (const Vec2& corner : polygon.corners) {
      low = low.cwiseMin(turned(corner));
      high = high.cwiseMax(turned(corner));
    }
    const Vec2 size = (high - low).cwiseMax(1e-9);
    scale_ = std::min(room.width() / size.x(), room.height() / size.y());
    const Vec2 middle = (low + high) / 2;
    offset_ = room.center() - scale_ * QPointF(middle.x(), -middle.y());
  }

  QPointF operator()(const Vec2& place) const {
    const Vec2 at = turned(place);
    return offset_ + scale_ * QPointF(at.x(), -at.y());
  }
  double scale() const { return scale_; }

 private:
  Vec2 turned(const Vec2& place) const { return {place.dot(along_), along_.x() * place.y() - along_.y() * place.x()}; }

  Vec2 along_ = Vec2::UnitX();
  double scale_ = 1;
  QPointF offset_;
};

void paint_polygon(QPainter& painter, const DomainPicture& picture, const DomainFit& fit) {
  const std::vector<Vec2>& corners = picture.polygon.corners;
  QPolygonF outline;
  for (const Vec2& corner : corners) outline << fit(corner);
  painter.setPen(Qt::NoPen);
  painter.setBrush(domain_fill);
  painter.drawPolygon(outline);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const QPointF a = fit(corners[k]), b = fit(corners[(k + 1) % corners.size()]);
    const bool smooth = picture.sides[k].smooth;
    painter.setPen(QPen(smooth ? domain_smooth : domain_line, smooth ? 1.4 : 2.4));
    painter.drawLine(a, b);
  }
}

/// Outside of the polygon, upright.
void paint_names(QPainter& painter, const DomainPicture& picture, const DomainFit& fit, int most_width) {
  const std::vector<Vec2>& corners = picture.polygon.corners;
  painter.setPen(domain_line);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const bool again = k > 0 && picture.sides[k].name == picture.sides[k - 1].name;
    if (again) continue;  // the second half of a side
    const QPointF a = fit(corners[k]), b = fit(corners[(k + 1) % corners.size()]);
    const QPointF way = b - a;
    const double length = std::max(1.0, std::hypot(way.x(), way.y()));
    const QPointF outward(-way.y() / length, way.x() / length);
    const QString name = painter.fontMetrics().elidedText(picture.sides[k].name, Qt::ElideRight, most_width);
    const double width = painter.fontMetrics().horizontalAdvance(name);
    const QPointF at = (a + b) / 2 + name_distance * outward + QPointF(outward.x() * width / 2, 0);
    painter.drawText(at - QPointF(width / 2, -painter.fontMetrics().ascent() / 2.0 + 1), name);
  }
}

void paint_attributes(QPainter& painter, const DomainPicture& picture, const DomainFit& fit) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(domain_curve, 1.6));
  for (const std::vector<Vec2>& curve : picture.curves) {
    QPolygonF line;
    for (const Vec2& place : curve) line << fit(place);
    painter.drawPolyline(line);
  }
  for (const DomainPicture::Point& point : picture.points) {
    const double radius = point.radius * fit.scale();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors::accent, point.selected ? 1.6 : 0.8, point.selected ? Qt::SolidLine : Qt::DotLine));
    painter.drawEllipse(fit(point.place), radius, radius);
    painter.setBrush(colors::accent);
    painter.setPen(QPen(point.selected ? Qt::white : Qt::black, 1));
    painter.drawEllipse(fit(point.place), dot, dot);
  }
  if (!picture.pointer) return;
  painter.setPen(QPen(colors::hover, 1));
  const QPointF at = fit(*picture.pointer);
  painter.drawLine(at - QPointF(2 * dot, 0), at + QPointF(2 * dot, 0));
  painter.drawLine(at - QPointF(0, 2 * dot), at + QPointF(0, 2 * dot));
}

/// Where a domain is drawn, and how.
struct DomainRoom {
  QRectF rect;
  QString title;
  std::size_t below = 0;  ///< the side that lies below
};

void paint_domain(QPainter& painter, const DomainPicture& picture, const DomainRoom& where) {
  const QRectF& room = where.rect;
  painter.setPen(colors::guide);
  painter.drawText(QRectF(room.topLeft(), QSizeF(room.width(), title_height)), Qt::AlignCenter, where.title);
  const double aside = name_share * room.width();
  const DomainFit fit(picture.polygon, room.adjusted(aside, domain_margin + title_height / 2, -aside, -domain_margin),
                      where.below);
  paint_polygon(painter, picture, fit);
  paint_names(painter, picture, fit, static_cast<int>(aside));
  painter.save();
  QPolygonF outline;
  for (const Vec2& corner : picture.polygon.corners) outline << fit(corner);
  QPainterPath inside;
  inside.addPolygon(outline);
  painter.setClipPath(inside);  // rings end where the patch does
  paint_attributes(painter, picture, fit);
  painter.restore();
}

}  // namespace

DomainView::DomainView(QWidget* parent) : QWidget(parent) { setObjectName("domain-view"); }

void DomainView::show_domains(std::optional<DomainPicture> own, std::optional<DomainPicture> uniform) {
  own_ = std::move(own);
  uniform_ = std::move(uniform);
  update();
}

void DomainView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!own_) {
    painter.setPen(colors::guide);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("Select a patch or a point to see its domain"));
    return;
  }
  const QRectF room = rect();
  const double width = uniform_ ? room.width() / 2 : room.width();
  const std::size_t below = longest_side(own_->polygon);
  paint_domain(painter, *own_,
               {QRectF(room.topLeft(), QSizeF(width, room.height())), uniform_ ? tr("by lengths") : QString(), below});
  if (!uniform_) return;
  const QRectF beside(room.left() + width, room.top(), width, room.height());
  paint_domain(painter, *uniform_, {beside, tr("uniform"), below});
}

}  // namespace croquis::app
