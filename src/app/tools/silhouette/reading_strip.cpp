// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/reading_strip.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <algorithm>
#include <utility>

#include "app/views/offscreen_pictures.h"
#include "app/views/viewport.h"
#include "app/window/language.h"
#include "croquis/document/operation.h"
#include "croquis/document/registry.h"
#include "croquis/operators/drawing_readings.h"
#include "croquis/render/scene.h"

namespace croquis::app {
namespace {

constexpr std::size_t most_readings_shown = 5;
constexpr QSize reading_picture(112, 84);
constexpr double strip_above_edge = 8;  // logical pixels
constexpr const char* strip_style =
    "QFrame#readings { background: rgba(255, 255, 255, 230); border: 1px solid #7a8698; border-radius: 6px }"
    "QFrame#readings QLabel { color: #3c4654 }"
    "QFrame#readings QToolButton { background: white; border: 2px solid transparent; border-radius: 4px }"
    "QFrame#readings QToolButton:focus { border: 2px solid #3a6fc4; background: #dbe8fb }"
    "QFrame#readings QToolButton:hover { background: #dbe8fb }";

/// What strokes say in a reading and don't now.
recorded::ReadingChosen saying_of(const Drawing& now, const Drawing& reading) {
  recorded::ReadingChosen chosen;
  for (std::size_t s = 0; s < std::min(now.strokes.size(), reading.strokes.size()); ++s) {
    const auto &before = now.strokes[s].data, &after = reading.strokes[s].data;
    for (const auto& [key, value] : after) {
      const auto known = before.find(key);
      if (known == before.end() || known->second != value) chosen.says.push_back({now.strokes[s].id, key, value});
    }
    for (const auto& [key, value] : before) {
      if (!after.contains(key)) chosen.says.push_back({now.strokes[s].id, key, ""});
    }
  }
  return chosen;
}

/// The solid of a drawing; none where there is none.
std::optional<render::MeshItemPtr> solid_of_reading(const Operation& inflate, const Drawing& drawing,
                                                    const ParameterValues& parameters, Progress& progress) {
  try {
    Context context{progress};
    const Values inputs{{inflate.describe().inputs.front().name, std::make_shared<const Drawing>(drawing)}};
    const OperationResult result = run(inflate, inputs, parameters, context);
    const auto& mesh = result.outputs.at(inflate.describe().outputs.front().name).get<PolyMesh>();
    if (mesh.face_count() > 0) return render::make_mesh_item(mesh);
  } catch (const Error&) {  // then that is no reading
  }
  return std::nullopt;
}

}  // namespace

ReadingStrip::ReadingStrip(ToolHost& host) : QFrame(&host.viewport()), host_(host), state_(new QLabel(this)) {
  setObjectName("readings");
  setAccessibleName(tr("Other readings of the sketch"));
  setStyleSheet(strip_style);
  setLayout(new QHBoxLayout);
  layout()->addWidget(state_);
  layout()->setContentsMargins(4, 4, 4, 4);
  layout()->setSpacing(2);
  hide();
  connect(&host.studio(), &Studio::changed, this, [this] {
    if (host_.studio().session().state() != document_state_) shut();
  });
}

void ReadingStrip::open() {
  if (is_open()) return go(1);
  const Node* operation = host_.studio().solid_operation();
  if (operation == nullptr) return;
  document_state_ = host_.studio().session().state();
  host_.attempt([&] {
    readings_ =
        std::make_shared<silhouette::DrawingReadings>(readings_of(host_.studio().drawing(), operation->parameters));
  });
  if (is_open()) look_for_next();
}

void ReadingStrip::shut() {
  if (!is_open()) return;
  job_.cancel();
  readings_.reset();
  found_.clear();
  const bool had_focus = isAncestorOf(window()->focusWidget());
  for (QToolButton* button : std::exchange(buttons_, {})) {
    button->hide();
    button->setObjectName({});  // it may have been clicked just now: it goes later
    button->deleteLater();
  }
  hide();
  if (had_focus) parentWidget()->setFocus();
}

void ReadingStrip::look_for_next() {
  state_->setText(found_.size() < 2 ? tr("Looking for other readings…") : tr("Looking for more…"));
  state_->show();
  const Node* node = host_.studio().solid_operation();
  const Operation* inflate = node == nullptr ? nullptr : host_.studio().registry().find(node->operation);
  if (inflate == nullptr) return shut();
  const auto work = [readings = readings_, inflate, parameters = node->parameters,
                     &pictures = host_.pictures()](Progress& progress) -> std::optional<Found> {
    while (auto reading = readings->next(progress)) {
      const auto solid = solid_of_reading(*inflate, reading->drawing, parameters, progress);
      if (!solid) continue;
      return Found{*std::move(reading),
                   pictures.draw_small({*solid}, render::NamedView::Perspective, 2 * reading_picture)};
    }
    return std::nullopt;
  };
  job_.start(work, [this](std::optional<std::optional<Found>> found) {
    const bool any = found.has_value() && found->has_value();
    if (any) add(**std::move(found));
    if (any && found_.size() < most_readings_shown) return look_for_next();
    state_->setText(tr("No other reading"));
    state_->setVisible(found_.size() < 2);
    emit size_changed();
  });
  emit size_changed();
}

void ReadingStrip::add(Found found) {
  const std::size_t number = buttons_.size();
  auto* button = new QToolButton(this);
  button->setObjectName(QString("reading-%1").arg(number + 1));
  button->setIconSize(reading_picture);
  button->setIcon(QPixmap::fromImage(found.picture));
  QStringList differs;
  for (const std::string& sentence : found.reading.differs) differs << localized(sentence);
  const QString words = differs.isEmpty() ? tr("As it is read now") : differs.join("\n");
  button->setToolTip(words);
  button->setAccessibleName(words);
  button->installEventFilter(this);
  connect(button, &QToolButton::clicked, this, [this, number] { choose(number); });
  static_cast<QHBoxLayout*>(layout())->insertWidget(static_cast<int>(number), button);
  buttons_.push_back(button);
  found_.push_back(std::move(found));
  button->show();
  if (number == 0) button->setFocus();
}

void ReadingStrip::go(int by) {
  if (buttons_.empty()) return;
  const auto count = static_cast<int>(buttons_.size());
  const auto now =
      std::ranges::find_if(buttons_, [&](const QToolButton* button) { return button == window()->focusWidget(); });
  const int at = now == buttons_.end() ? -by : static_cast<int>(now - buttons_.begin());
  buttons_[static_cast<std::size_t>((at + by + count) % count)]->setFocus();
}

void ReadingStrip::choose(std::size_t number) {
  const recorded::ReadingChosen reading = saying_of(host_.studio().drawing(), found_.at(number).reading.drawing);
  shut();
  if (!reading.says.empty()) emit chosen(reading);
}

bool ReadingStrip::eventFilter(QObject* button, QEvent* event) {
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool backwards = key->key() == Qt::Key_Backtab;
  const bool accepts = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if (!backwards && !accepts && key->key() != Qt::Key_Tab && key->key() != Qt::Key_Escape) return false;
  event->accept();
  if (event->type() == QEvent::ShortcutOverride) return true;
  if (accepts) {
    static_cast<QToolButton*>(button)->click();
  } else if (key->key() == Qt::Key_Escape) {
    shut();
  } else {
    go(backwards ? -1 : 1);
  }
  return true;
}

void ReadingStrip::place(const ViewPane& pane, bool shown) {
  if (!is_open() || !shown || !pane.visible()) return hide();
  // All that may come fit into the view.
  constexpr int around_picture = 8, around_all = 16;
  const int room = static_cast<int>(pane.rect.width()) - around_all;
  const int wide = room / static_cast<int>(most_readings_shown) - around_picture - layout()->spacing();
  const QSize picture = reading_picture.boundedTo({wide, wide * reading_picture.height() / reading_picture.width()});
  for (QToolButton* button : buttons_) {
    button->setIconSize(picture);
    button->setFixedSize(picture + QSize(around_picture, around_picture));
  }
  layout()->activate();
  adjustSize();
  const QPointF middle = pane.rect.center();
  move(QPointF(middle.x() - width() / 2.0, pane.rect.bottom() - height() - strip_above_edge).toPoint());
  show();
  raise();
}

}  // namespace croquis::app
