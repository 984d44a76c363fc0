// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_table.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "app/panels/number_box.h"
#include "app/tools/holes/hole_overlay.h"
#include "app/window/language.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double margin = 7;  // the handle's half width
constexpr double key_step = 0.04;

enum Column { Number, StateColumn, Kind, Diameter, Edges, Confidence, Jump, Method, Area, column_count };

constexpr int value_role = Qt::UserRole;
constexpr int hole_role = Qt::UserRole + 1;

/// Sorts by its value, where that isn't its text.
class Cell : public QTableWidgetItem {
 public:
  bool operator<(const QTableWidgetItem& other) const override {
    const QVariant own = data(value_role);
    const QVariant others = other.data(value_role);
    if (own.isValid() && others.isValid()) return own.toDouble() < others.toDouble();
    return own.isValid() != others.isValid() ? others.isValid() : text() < other.text();
  }
};

constexpr int hole_row_height = 22;
constexpr int least_hole_rows = 5;  // fewer are no list

QIcon state_icon(const HoleRow& hole) {
  QPixmap picture(32, 32);
  picture.setDevicePixelRatio(2);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = hole_color(hole).lighter(130);
  painter.setPen(QPen(color, 2));
  if (hole.state == FillAction::Fill) painter.setBrush(color);
  painter.drawEllipse(QRectF(3, 3, 10, 10));
  painter.setPen(QPen(hole.state == FillAction::Fill ? QColor(Qt::white) : color, 1.6));
  if (hole.state == FillAction::Fill) painter.drawPolyline(QPolygonF{{5.5, 8.2}, {7.4, 10}, {10.6, 6}});
  if (hole.state == FillAction::Failed) {
    painter.drawLine(QPointF(5.5, 5.5), QPointF(10.5, 10.5));
    painter.drawLine(QPointF(10.5, 5.5), QPointF(5.5, 10.5));
  }
  return picture;
}

QString words_for(hole_filling::HoleClass kind) {
  using hole_filling::HoleClass;
  switch (kind) {
    case HoleClass::Small: return HoleTable::tr("small");
    case HoleClass::Simple: return HoleTable::tr("hole");
    case HoleClass::Islands: return HoleTable::tr("with island");
    case HoleClass::Tunnel: return HoleTable::tr("tunnel end");
    case HoleClass::Outer: return HoleTable::tr("open edge");
    case HoleClass::Slit: return HoleTable::tr("slit");
    case HoleClass::BowTie: return HoleTable::tr("touches another");
  }
  return {};
}

QString words_for(FillAction state) {
  if (state == FillAction::Fill) return HoleTable::tr("filled");
  return state == FillAction::Failed ? HoleTable::tr("failed") : HoleTable::tr("open");
}

QString degrees(const std::optional<double>& angle) {
  return angle ? QString::number(*angle * 180 / std::numbers::pi, 'f', 1) + QStringLiteral("°") : QString();
}

QString percent_words(const std::optional<double>& share) {
  return share ? QString::number(std::lround(*share * 100)) + QStringLiteral(" %") : QString();
}

bool same_cells(const HoleRow& a, const HoleRow& b) {
  return a.id == b.id && a.kind == b.kind && a.edges == b.edges && a.diameter == b.diameter && a.area == b.area &&
         a.state == b.state && a.method == b.method && a.reason == b.reason && a.angle == b.angle &&
         a.confidence == b.confidence && a.companions == b.companions;
}

QString tip_of(const HoleRow& hole) {
  QStringList lines;
  lines << HoleTable::tr("Hole %1: %2 edges, %3 round").arg(hole.id).arg(hole.edges).arg(number_words(hole.perimeter));
  if (!hole.companions.empty()) {
    const std::set<Index> others(hole.companions.begin(), hole.companions.end());
    lines << HoleTable::tr("Filled together with %1").arg(numbers_of(others));
  }
  if (!hole.reason.empty()) lines << localized(hole.reason);
  return lines.join("\n");
}

}  // namespace

SizeSlider::SizeSlider(QWidget* parent) : QWidget(parent) {
  setObjectName("size-slider");
  setAccessibleName(tr("Greatest width of holes to fill"));
  setToolTip(tr("Drag: open holes up to this diameter are selected and previewed"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SizeSlider::show_sizes(const std::vector<double>& diameters) {
  if (diameters == diameters_) return;
  diameters_ = diameters;
  histogram_ = HoleHistogram(diameters);
  diameter_ = std::min(diameter_, histogram_.greatest() * 2);
  setEnabled(!histogram_.empty());
  update();
}

void SizeSlider::set_diameter(double diameter) {
  diameter_ = diameter;
  update();
}

QRectF SizeSlider::track() const { return QRectF(rect()).adjusted(margin, 3, -margin, -12); }

void SizeSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = track();
  painter.setPen(Qt::NoPen);
  const double highest = static_cast<double>(std::max<std::size_t>(histogram_.highest(), 1));
  for (const HoleHistogram::Bin& bin : histogram_.bins()) {
    if (bin.count == 0) continue;
    const double left = area.left() + area.width() * histogram_.position(bin.low);
    const double right = std::max(area.left() + area.width() * histogram_.position(bin.high), left + 4);
    const double height = std::max(3.0, area.height() * std::sqrt(static_cast<double>(bin.count) / highest));
    painter.setBrush(bin.low <= diameter_ ? theme_colors().accent : theme_colors().faint);
    painter.drawRect(QRectF(left, area.bottom() - height, right - left - 1, height));
  }
  painter.setPen(QPen(theme_colors().faint, 2));
  painter.drawLine(area.bottomLeft() + QPointF(0, 4), area.bottomRight() + QPointF(0, 4));
  if (histogram_.empty()) return;
  const double at = area.left() + area.width() * (diameter_ > 0 ? histogram_.position(diameter_) : 0);
  painter.setPen(QPen(hasFocus() ? theme_colors().link : theme_colors().text, 1.5));
  painter.setBrush(diameter_ > 0 ? theme_colors().accent : theme_colors().raised);
  painter.drawEllipse(QPointF(at, area.bottom() + 4), 5.5, 5.5);
}

void SizeSlider::move_to(double position) {
  if (histogram_.empty()) return;
  const double wanted = histogram_.snapped(std::clamp(position, 0.0, 1.0));
  if (wanted == diameter_) return;
  set_diameter(wanted);
  emit moved(wanted);
}

void SizeSlider::mousePressEvent(QMouseEvent* event) {
  move_to((event->position().x() - track().left()) / track().width());
}

void SizeSlider::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) {
    move_to((event->position().x() - track().left()) / track().width());
  }
}

void SizeSlider::keyPressEvent(QKeyEvent* event) {
  const double now = diameter_ > 0 ? histogram_.position(diameter_) : 0;
  switch (event->key()) {
    case Qt::Key_Left: return move_to(now - key_step);
    case Qt::Key_Right: return move_to(now + key_step);
    case Qt::Key_Home: return move_to(0);
    case Qt::Key_End: return move_to(1);
    default: QWidget::keyPressEvent(event);
  }
}

HoleTable::HoleTable(QWidget* parent) : QTableWidget(parent) {
  setObjectName("holes");
  setAccessibleName(tr("Holes"));
  setColumnCount(column_count);
  setHorizontalHeaderLabels(
      {tr("No."), tr("State"), tr("Class"), {}, tr("Edges"), tr("Confidence"), tr("Angle"), tr("Method"), {}});
  name_unit({});
  const QStringList tips{tr("Number, as pins in the views and the command line have it"),
                         tr("Open, filled, or no method gave a valid patch"),
                         tr("What the rim looks like"),
                         tr("Greatest distance between two places of the rim, in the model's own units"),
                         tr("Edges of the rim"),
                         tr("Confidence: near 100 % for small gaps, low where the middle is far from anything known"),
                         tr("Greatest angle between patch and scan at the rim"),
                         tr("How the patch was made"),
                         tr("Area of the flattest patch")};
  for (int column = 0; column < tips.size(); ++column) horizontalHeaderItem(column)->setToolTip(tips[column]);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setMinimumSectionSize(26);
  horizontalHeader()->setSortIndicatorShown(false);
  horizontalHeader()->setHighlightSections(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(hole_row_height);
  setMinimumHeight((least_hole_rows + 2) * hole_row_height);  // with the header and the bar below
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setShowGrid(false);
  setTabKeyNavigation(false);  // the Tab key leads on, arrows lead to other rows
  setIconSize({16, 16});
  setSortingEnabled(true);
  sortByColumn(Number, Qt::AscendingOrder);
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    if (showing_) return;
    std::vector<Index> holes;
    for (const QModelIndex& index : selectionModel()->selectedRows()) holes.push_back(hole_of(index.row()));
    std::sort(holes.begin(), holes.end());
    emit holes_chosen(holes);
  });
  connect(this, &QTableWidget::cellDoubleClicked, this, [this](int row, int) { emit hole_opened(hole_of(row)); });
}

void HoleTable::name_unit(const QString& unit) {
  const QString shown = unit.isEmpty() ? tr("units") : unit;
  horizontalHeaderItem(Diameter)->setText(tr("Diameter (%1)").arg(shown));
  horizontalHeaderItem(Area)->setText(tr("Area (%1)").arg(shown + "²"));
}

void HoleTable::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    emit accepted();
    return;
  }
  QTableWidget::keyPressEvent(event);
}

Index HoleTable::hole_of(int row) const { return static_cast<Index>(item(row, Number)->data(hole_role).toUInt()); }

std::vector<Index> HoleTable::order() const {
  std::vector<Index> holes;
  for (int row = 0; row < rowCount(); ++row) holes.push_back(hole_of(row));
  return holes;
}

void HoleTable::show_holes(const std::vector<HoleRow>& holes) {
  if (std::equal(holes.begin(), holes.end(), shown_.begin(), shown_.end(), same_cells)) return;
  shown_ = holes;
  showing_ = true;
  // Widths are computed once, not for every cell.
  horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  std::map<QString, QIcon> icons;
  setSortingEnabled(false);  // rows would move while they are written
  setRowCount(static_cast<int>(holes.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const HoleRow& hole = holes[static_cast<std::size_t>(row)];
    const auto write = [&](Column column, const QString& text, const QVariant& value = {}) {
      if (item(row, column) == nullptr) setItem(row, column, new Cell);
      QTableWidgetItem* cell = item(row, column);
      cell->setText(text);
      cell->setData(value_role, value);
      cell->setToolTip(tip_of(hole));
      if (value.isValid() && column != Number) cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    };
    const auto optional = [](const std::optional<double>& value) { return value ? QVariant(*value) : QVariant(); };
    write(Number, QString::number(hole.id), hole.id);
    item(row, Number)->setData(hole_role, hole.id);
    write(StateColumn, words_for(hole.state));
    QIcon& icon = icons[words_for(hole.state) + (hole.is_border() ? "|" : "")];
    if (icon.isNull()) icon = state_icon(hole);
    item(row, StateColumn)->setIcon(icon);
    write(Kind, words_for(hole.kind));
    write(Diameter, number_words(hole.diameter), hole.diameter);
    write(Edges, QString::number(hole.edges), static_cast<qulonglong>(hole.edges));
    write(Area, number_words(hole.area), hole.area);
    write(Method, QString::fromStdString(hole.method));
    write(Confidence, percent_words(hole.confidence), optional(hole.confidence));
    write(Jump, degrees(hole.angle), optional(hole.angle));
  }
  setSortingEnabled(true);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  showing_ = false;
}

void HoleTable::show_selection(const std::vector<Index>& holes) {
  QItemSelection wanted;
  int first = -1;
  for (int row = 0; row < rowCount(); ++row) {
    if (!std::binary_search(holes.begin(), holes.end(), hole_of(row))) continue;
    wanted.select(model()->index(row, 0), model()->index(row, column_count - 1));
    if (first < 0) first = row;
  }
  showing_ = true;
  selectionModel()->select(wanted, QItemSelectionModel::ClearAndSelect);
  showing_ = false;
  if (first >= 0 && holes.size() == 1) scrollToItem(item(first, Number));
}

}  // namespace croquis::app
