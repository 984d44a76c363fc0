// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/domain_panel.h"

#include <QAction>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/panels/number_box.h"

namespace croquis::app {
namespace {

QString short_number(double value) { return number_words(value, 3); }

QString length_text(double value, const std::string& units) {
  return units.empty() ? short_number(value) : short_number(value) + " " + QString::fromStdString(units);
}

}  // namespace

DomainPanel::DomainPanel(NetworkInteraction& network, const UniformGhost& ghost, QAction* compare)
    : network_(network),
      ghost_(ghost),
      view_(new DomainView(this)),
      title_(new QLabel(this)),
      numbers_(new QLabel(this)) {
  setObjectName("domain-panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 6, 8, 6);
  auto* row = new QHBoxLayout;
  row->addWidget(title_, 1);
  auto* button = new QToolButton(this);
  button->setDefaultAction(compare);
  button->setObjectName("domain-compare");
  button->setFocusPolicy(Qt::NoFocus);
  row->addWidget(button);
  column->addLayout(row);
  column->addWidget(view_, 1);
  numbers_->setObjectName("domain-numbers");
  numbers_->setWordWrap(true);
  numbers_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(numbers_);
}

std::string DomainPanel::wanted_face() const {
  const AttributeNetwork& network = network_.network();
  const NetworkElements selected = network_.tool().selected();
  if (!selected.faces.empty()) return selected.faces.front();
  for (const std::string& id : selected.points) {
    const Index point = find_element(network, NetworkElement::Point, id);
    if (point != no_index) return network.faces[network.points[point].face].id;
  }
  if (const auto& hit = network_.tool().preview().hit) return hit->face;
  const bool is_there = find_element(network, NetworkElement::Face, face_) != no_index;
  if (is_there) return face_;
  return network.faces.empty() ? std::string() : network.faces.front().id;
}

void DomainPanel::follow() {
  face_ = wanted_face();
  const ShownSurface& shown = network_.shown();
  const NetworkElements selected = network_.tool().selected();
  std::optional<DomainPicture> own, uniform;
  if (shown) own = domain_picture(shown.network(), shown.surface(), face_, selected);
  const auto& hit = network_.tool().preview().hit;
  if (own && hit && hit->face == face_ && hit->fan.corner < own->polygon.corners.size())
    own->pointer = place_in(own->polygon, hit->fan);
  if (const UniformGhost::Compared* compared = ghost_.compared(); own && compared != nullptr)
    uniform = domain_picture(compared->comparison.network, compared->comparison.surface, face_, selected);
  view_->show_domains(std::move(own), std::move(uniform));
  title_->setText(face_.empty() ? tr("No patch yet") : tr("Patch %1").arg(QString::fromStdString(face_)));
  numbers_->setText(QStringList{numbers_text(), points_text()}.join('\n').trimmed());
}

/// The comparison's numbers stand in brackets behind the own ones.
QString DomainPanel::numbers_text() const {
  const ShownSurface& shown = network_.shown();
  const auto own = shown ? domain_numbers(shown.network(), shown.found->measures, face_) : std::nullopt;
  if (!own) return {};
  const UniformGhost::Compared* compared = ghost_.compared();
  const auto uniform =
      compared == nullptr ? std::nullopt : domain_numbers(compared->comparison.network, compared->measures, face_);
  const QString text = tr("Stretch %1×").arg(short_number(own->anisotropy));
  return uniform ? text + tr(" (uniform %1×)").arg(short_number(uniform->anisotropy)) : text;
}

/// How far off the dents of points lie.
QString DomainPanel::points_text() const {
  const UniformGhost::Compared* compared = ghost_.compared();
  const AttributeNetwork& network = network_.network();
  const std::string& units = network.units;
  QStringList lines;
  for (const ComparedPoint& point : compared == nullptr ? std::vector<ComparedPoint>() : compared->comparison.points) {
    const Index index = find_element(network, NetworkElement::Point, point.id);
    const bool is_here = index != no_index && network.faces[network.points[index].face].id == face_;
    if (!is_here || !point.own || !point.uniform) continue;
    lines << tr("Dent of %1: off by %2 (uniform %3), %4 times as long as wide (uniform %5)")
                 .arg(QString::fromStdString(point.id), length_text(point.own->offset, units),
                      length_text(point.uniform->offset, units), short_number(point.own->anisotropy),
                      short_number(point.uniform->anisotropy));
  }
  return lines.join('\n');
}

}  // namespace croquis::app
