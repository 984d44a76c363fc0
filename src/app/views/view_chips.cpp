// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_chips.h"

#include <QLocale>

#include "app/panels/object_names.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr const char* name_style = "color: #5c6470; background: transparent; font-size: 12px";
constexpr const char* message_style = "color: #8a93a0; background: transparent; font-size: 15px";
constexpr int lines_at_most = 8;

QString faces(std::size_t count) {
  return count == 1 ? ViewChips::tr("1 face") : ViewChips::tr("%1 faces").arg(QLocale().toString(qulonglong(count)));
}

}  // namespace

ViewChips::ViewChips(Studio& studio, QWidget* views)
    : QObject(views),
      studio_(studio),
      views_(views),
      message_(make_chip_label(*views, message_style)),
      counts_(make_chip_label(*views, name_style)) {
  counts_->setObjectName("counts");
  for (QLabel*& name : names_) name = make_chip_label(*views, name_style);
}

void ViewChips::say(const QString& sentence) {
  message_->setText(sentence);
  message_->adjustSize();
}

void ViewChips::place(ChipPlaces& places, const std::array<QString, view_count>& titles) {
  const std::array<QString, view_count> plain{tr("Front"), tr("Perspective"), tr("Top"), tr("Side"), QString()};
  for (std::size_t view = 0; view < view_count; ++view) {
    const ViewPane& pane = places.layout().pane(static_cast<int>(view));
    names_[view]->setText(titles[view].isEmpty() ? plain[view] : titles[view]);
    names_[view]->adjustSize();
    if (pane.visible())
      places.put(*names_[view], pane.rect.topLeft() + QPointF(10, 8), pane.rect);
    else
      names_[view]->hide();
  }
  place_counts(places);
  const QPointF middle = QRectF(views_->rect()).center();
  if (!message_->text().isEmpty()) places.put(*message_, middle - QPointF(message_->width() / 2.0, 0));
}

void ViewChips::place_counts(ChipPlaces& places) {
  counts_->setText(counts());
  counts_->setAlignment(Qt::AlignRight);
  counts_->adjustSize();
  const ViewPane& pane = places.scene_pane();
  if (counts_->text().isEmpty() || !pane.visible()) return counts_->hide();
  places.put(*counts_, QPointF(pane.rect.right() - counts_->width() - 10, pane.rect.top() + 8));
}

QString ViewChips::counts() const {
  QStringList lines;
  for (const WorkObject& object : studio_.objects()) {
    if (!object.visible || !object.shown()) continue;
    const QString name = shown_name(object);
    QString line = name + ": " + faces(object.shown()->face_count());
    if (object.cage_mesh && object.shown()->face_count() != object.cage_mesh->face_count()) {
      line += tr(" from %1").arg(faces(object.cage_mesh->face_count()));
    }
    lines << line;
  }
  if (lines.size() > lines_at_most) {
    const auto more = lines.size() - lines_at_most;
    lines = lines.mid(0, lines_at_most) << tr("and %1 more").arg(more);
  }
  return lines.join("\n");
}

}  // namespace croquis::app
