// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/domain_panel.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panels/number_box.h"
#include "app/window/language.h"
#include "app/window/theme.h"
#include "croquis/attribute_surface/network_elements.h"
#include "croquis/attribute_surface/surface_tessellation.h"

namespace croquis::app {
namespace {

using ComparedPtr = std::shared_ptr<const UniformGhost::Compared>;

ComparedPtr compare(const ShownSurface& shown, Progress& progress) {
  auto made = std::make_shared<UniformGhost::Compared>();
  made->shown = shown;
  made->comparison = compare_with_uniform(shown.network(), shown.surface(), progress);
  made->measures = measure(made->comparison.network, made->comparison.surface);
  const SurfaceTessellation triangles = tessellate(made->comparison.network, made->comparison.surface, progress);
  if (triangles.mesh.face_count() == 0) return made;
  render::MeshItemOptions options;
  options.use_normal_channel = true;
  const Affine3 onward = composed(shown.to_world, inverse_of(shown.to_result));
  made->item = render::make_mesh_item(transformed(triangles.mesh, onward), options);
  return made;
}

constexpr double domain_margin = 20;  // logical pixels: room for the names of sides …
constexpr double name_share = 0.22;   // … which take at most that much of the width on either side
constexpr double name_distance = 9;
constexpr double title_height = 18;
constexpr double dot_size = 4;

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
  painter.setBrush(theme_colors().raised);
  painter.drawPolygon(outline);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const QPointF a = fit(corners[k]), b = fit(corners[(k + 1) % corners.size()]);
    const bool smooth = picture.sides[k].smooth;
    painter.setPen(QPen(smooth ? theme_colors().link : theme_colors().text, smooth ? 1.4 : 2.4));
    painter.drawLine(a, b);
  }
}

/// Outside of the polygon, upright.
void paint_names(QPainter& painter, const DomainPicture& picture, const DomainFit& fit, int most_width) {
  const std::vector<Vec2>& corners = picture.polygon.corners;
  painter.setPen(theme_colors().text);
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
  painter.setPen(QPen(theme_colors().good, 1.6));
  for (const std::vector<Vec2>& curve : picture.curves) {
    QPolygonF line;
    for (const Vec2& place : curve) line << fit(place);
    painter.drawPolyline(line);
  }
  for (const DomainPicture::Point& point : picture.points) {
    const double radius = point.radius * fit.scale();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(
        QPen(theme_colors().accent, point.selected ? 1.6 : 0.8, point.selected ? Qt::SolidLine : Qt::DotLine));
    painter.drawEllipse(fit(point.place), radius, radius);
    painter.setBrush(theme_colors().accent);
    painter.setPen(QPen(point.selected ? theme_colors().text : theme_colors().base, 1));
    painter.drawEllipse(fit(point.place), dot_size, dot_size);
  }
  if (!picture.pointer) return;
  painter.setPen(QPen(theme_colors().link, 1));
  const QPointF at = fit(*picture.pointer);
  painter.drawLine(at - QPointF(2 * dot_size, 0), at + QPointF(2 * dot_size, 0));
  painter.drawLine(at - QPointF(0, 2 * dot_size), at + QPointF(0, 2 * dot_size));
}

/// Where a domain is drawn, and how.
struct DomainRoom {
  QRectF rect;
  QString title;
  std::size_t below = 0;  ///< the side that lies below
};

void paint_domain(QPainter& painter, const DomainPicture& picture, const DomainRoom& where) {
  const QRectF& room = where.rect;
  painter.setPen(theme_colors().faint);
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

/// Of a face as it was computed last; none where it failed or isn't there.
std::optional<DomainPicture> domain_picture(const AttributeNetwork& network, const AttributeSurface& surface,
                                            const std::string& id, const NetworkElements& selected) {
  const Index face = find_element(network, NetworkElement::Face, id);
  if (face == no_index || !surface.faces[face].surface) return std::nullopt;
  const FaceSurface& made = *surface.faces[face].surface;
  DomainPicture picture;
  picture.polygon = made.domain();
  const std::vector<AttributeSide>& loop = network.faces[face].loop;
  const std::size_t corners = made.domain().corners.size();
  for (std::size_t k = 0; k < corners; ++k) {
    const Index curve = loop[k * loop.size() / corners].curve;  // the two of a face of two sides are two sides each
    picture.sides.push_back({with_numbers(network.curves[curve].id, network_ids), surface.curves[curve].smooth});
  }
  for (Index i = 0; i < network.points.size(); ++i) {
    const auto placed = network.points[i].face == face ? placed_index(network, surface, i) : std::nullopt;
    if (!placed) continue;
    const PlacedPoint& point = made.points()[*placed];
    picture.points.push_back({QString::fromStdString(network.points[i].id), point.place,
                              point.radius.value_or(0) / made.sigma(),
                              selected.has(NetworkElement::Point, network.points[i].id)});
  }
  for (const PlacedCurve& curve : made.curves()) picture.curves.push_back(curve.places);
  return picture;
}

/// How much longer than wide the map of a face is, >= 1.
std::optional<double> domain_anisotropy(const AttributeNetwork& network, const SurfaceMeasures& measures,
                                        const std::string& id) {
  const Index face = find_element(network, NetworkElement::Face, id);
  const auto patch = std::ranges::find(measures.patches, face, &PatchMeasures::face);
  if (face == no_index || patch == measures.patches.end()) return std::nullopt;
  return patch->anisotropy;
}

QString short_number(double value) { return number_words(value, 3); }

QString length_text(double value, const std::string& units) {
  return units.empty() ? short_number(value) : short_number(value) + " " + QString::fromStdString(units);
}

/// The face whose domain is shown: the selected one, that of the selected point, the one under the pointer, else the
/// one shown last; empty for none.
std::string wanted_face(const DrawnNetwork& drawn, const std::string& before) {
  const AttributeNetwork& network = drawn.network();
  const NetworkElements selected = drawn.tool.selected();
  if (!selected.faces.empty()) return selected.faces.front();
  for (const std::string& id : selected.points) {
    const Index point = find_element(network, NetworkElement::Point, id);
    if (point != no_index) return network.faces[network.points[point].face].id;
  }
  if (const auto& hit = drawn.tool.preview().hit) return hit->face;
  const bool is_there = find_element(network, NetworkElement::Face, before) != no_index;
  if (is_there) return before;
  return network.faces.empty() ? std::string() : network.faces.front().id;
}

void show_domains(DomainView& view, const DrawnNetwork& drawn, const UniformGhost& ghost, const std::string& face) {
  const ShownSurface& shown = drawn.shown;
  const NetworkElements selected = drawn.tool.selected();
  std::optional<DomainPicture> own, uniform;
  if (shown) own = domain_picture(shown.network(), shown.surface(), face, selected);
  const auto& hit = drawn.tool.preview().hit;
  if (own && hit && hit->face == face && hit->fan.corner < own->polygon.corners.size())
    own->pointer = place_in(own->polygon, hit->fan);
  if (const UniformGhost::Compared* compared = ghost.compared(); own && compared != nullptr)
    uniform = domain_picture(compared->comparison.network, compared->comparison.surface, face, selected);
  view.show_domains(std::move(own), std::move(uniform));
}

/// The comparison's numbers stand in brackets behind the own ones.
QString numbers_text(const ShownSurface& shown, const UniformGhost& ghost, const std::string& face) {
  const auto own = shown ? domain_anisotropy(shown.network(), shown.found->measures, face) : std::nullopt;
  if (!own) return {};
  const UniformGhost::Compared* compared = ghost.compared();
  const auto uniform =
      compared == nullptr ? std::nullopt : domain_anisotropy(compared->comparison.network, compared->measures, face);
  const QString text = Panel::tr("Stretch %1×").arg(short_number(*own));
  return uniform ? text + Panel::tr(" (uniform %1×)").arg(short_number(*uniform)) : text;
}

/// How far off the dents of points lie.
QString points_text(const AttributeNetwork& network, const UniformGhost& ghost, const std::string& face) {
  const UniformGhost::Compared* compared = ghost.compared();
  const std::string& units = network.units;
  QStringList lines;
  for (const ComparedPoint& point : compared == nullptr ? std::vector<ComparedPoint>() : compared->comparison.points) {
    const Index index = find_element(network, NetworkElement::Point, point.id);
    const bool is_here = index != no_index && network.faces[network.points[index].face].id == face;
    if (!is_here || !point.own || !point.uniform) continue;
    lines << Panel::tr("Dent of point %1: off by %2 (uniform %3), %4 times as long as wide (uniform %5)")
                 .arg(with_numbers(point.id, network_ids), length_text(point.own->offset, units),
                      length_text(point.uniform->offset, units), short_number(point.own->anisotropy),
                      short_number(point.uniform->anisotropy));
  }
  return lines.join('\n');
}

}  // namespace

void UniformGhost::set_on(bool on) {
  on_ = on;
  if (on) {
    begin();
  } else {
    compared_.reset();
  }
  emit changed();
}

void UniformGhost::follow(const ShownSurface& shown) {
  wanted_ = shown;
  if (!shown) compared_.reset();
  begin();
}

void UniformGhost::begin() {
  const bool is_there =
      compared_ && compared_->shown.result == wanted_.result && compared_->shown.to_world == wanted_.to_world;
  if (!on_ || job_.runs() || !wanted_ || is_there) return;
  // What is wrong with the network is said by its own surfaces.
  job_.start([shown = wanted_](Progress& progress) { return compare(shown, progress); },
             [this](const std::optional<ComparedPtr>& made) { take(made.value_or(nullptr)); });
}

void UniformGhost::take(const std::shared_ptr<const Compared>& made) {
  if (on_ && made) compared_ = made;
  const bool is_old = on_ && made && made->shown.result != wanted_.result;
  emit changed();
  if (is_old) begin();
}

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
    painter.setPen(theme_colors().faint);
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

Panel* make_domain_panel(DrawnNetwork& drawn, const UniformGhost& ghost) {
  auto* panel = new Panel("domain-panel");
  QLabel* title = panel->label({});
  auto* compare = new QToolButton(panel);
  compare->setDefaultAction(drawn.host.action("compare-uniform"));
  compare->setObjectName("domain-compare");
  compare->setFocusPolicy(Qt::NoFocus);
  panel->row({{title, 1}, compare});
  auto* view = new DomainView(panel);
  panel->column()->addWidget(view, 1);
  QLabel* numbers = panel->label({});
  numbers->setObjectName("domain-numbers");
  numbers->setWordWrap(true);
  numbers->setTextInteractionFlags(Qt::TextSelectableByMouse);
  panel->column()->addWidget(numbers);
  panel->also([&drawn, &ghost, title, view, numbers, face = std::string()]() mutable {
    face = wanted_face(drawn, face);
    show_domains(*view, drawn, ghost, face);
    title->setText(face.empty() ? Panel::tr("No patch yet")
                                : Panel::tr("Patch %1").arg(with_numbers(face, network_ids)));
    const QStringList lines{numbers_text(drawn.shown, ghost, face), points_text(drawn.network(), ghost, face)};
    numbers->setText(lines.join('\n').trimmed());
  });
  return panel;
}

}  // namespace croquis::app
