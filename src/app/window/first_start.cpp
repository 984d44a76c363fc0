// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QButtonGroup>
#include <QComboBox>
#include <QDialog>
#include <QElapsedTimer>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QSettings>
#include <QTabletEvent>
#include <array>
#include <vector>

#include "app/window/hotkeys.h"
#include "app/window/main_window.h"
#include "app/window/preferences.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr const char* shown_key = "first-start";
constexpr QSize mouse_size(26, 38);
constexpr QSize use_size(58, 78);  // of a mouse with its words
constexpr int card_title_height = 24;
constexpr int card_inset = 8;

/// The keys that are held while a view is rotated, panned and zoomed.
std::array<QString, 3> keys_held(NavigationPreset preset) {
  if (preset == NavigationPreset::Maya) return {"Alt", "Alt", "Alt"};
  if (preset == NavigationPreset::Blender) return {"", "Shift", "Ctrl"};
  return {"", "Ctrl", "Shift"};
}

/// The buttons that are pressed meanwhile.
std::array<Qt::MouseButton, 3> buttons_pressed(NavigationPreset preset) {
  if (preset == NavigationPreset::Maya) return {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton};
  return {Qt::MiddleButton, Qt::MiddleButton, Qt::MiddleButton};
}

void paint_mouse(QPainter& painter, const QRectF& place, Qt::MouseButton pressed) {
  const ThemeColors& theme = theme_colors();
  const QRectF wheel(place.center().x() - 2.5, place.top() + 6, 5, 10);
  QPainterPath body;
  body.addRoundedRect(place, place.width() / 2, place.width() / 2);
  painter.fillPath(body, theme.window);
  QPainterPath button;
  button.addRect(pressed == Qt::LeftButton ? place.left() : place.center().x(), place.top(), place.width() / 2,
                 place.height() / 2);
  if (pressed != Qt::MiddleButton) painter.fillPath(button.intersected(body), theme.accent);
  painter.setPen(QPen(theme.text, 1.4));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(body);
  painter.drawLine(QPointF(place.left(), place.center().y()), QPointF(place.right(), place.center().y()));
  painter.drawLine(QPointF(place.center().x(), place.top()), place.center());
  painter.setBrush(pressed == Qt::MiddleButton ? theme.accent : theme.window);
  painter.drawRoundedRect(wheel, 2.5, 2.5);
}

/// A way to navigate to choose: its name and a mouse for each of its motions, with the button that is pressed coloured.
class NavigationCard : public QAbstractButton {
 public:
  NavigationCard(const NavigationChoice& choice, QWidget* parent) : QAbstractButton(parent), preset_(choice.preset) {
    setObjectName(QStringLiteral("navigate-") + choice.name);
    setText(choice.title);
    setAccessibleName(choice.title);
    setAccessibleDescription(choice.sentence);
    setCheckable(true);
    setFixedSize(3 * use_size.width() + 2 * card_inset, use_size.height() + card_title_height + 2 * card_inset);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    const ThemeColors& theme = theme_colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(isChecked() ? theme.accent : theme.line, hasFocus() ? 3 : 1));
    painter.setBrush(isChecked() ? theme.checked : theme.base);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), 6, 6);
    const QStringList motions{tr("rotate"), tr("pan"), tr("zoom")};
    painter.setPen(theme.text);
    painter.drawText(QRect(0, card_inset, width(), card_title_height), Qt::AlignCenter, text());
    for (std::size_t i = 0; i < 3; ++i) {
      const QRect room(QPoint(card_inset + static_cast<int>(i) * use_size.width(), card_inset + card_title_height),
                       use_size);
      painter.setPen(theme.text);
      painter.drawText(room, Qt::AlignHCenter | Qt::AlignTop, keys_held(preset_)[i]);
      painter.drawText(room, Qt::AlignHCenter | Qt::AlignBottom, motions[static_cast<qsizetype>(i)]);
      QRectF mouse(QPointF(), mouse_size);
      mouse.moveCenter(QRectF(room).center());
      paint_mouse(painter, mouse, buttons_pressed(preset_)[i]);
    }
  }

 private:
  NavigationPreset preset_;
};

/// Shows what is drawn on it, as wide as the pressure, and says what draws.
class PenStrip : public QWidget {
 public:
  PenStrip(QLabel& found, QWidget* parent) : QWidget(parent), found_(found) {
    setObjectName("pen-strip");
    setCursor(Qt::CrossCursor);
    setMinimumHeight(76);
  }

 protected:
  void tabletEvent(QTabletEvent* event) override {
    since_pen_.start();
    const double pressure = event->pressure();
    if (pressure > 0 && pressure < 1) found_.setText(tr("Pen with pressure"));
    if (event->type() == QEvent::TabletPress && !(pressure < 1)) found_.setText(tr("Pen without pressure"));
    if (event->buttons() != Qt::NoButton) add(event->position(), pressure, event->type() == QEvent::TabletPress);
    event->accept();  // else a mouse event is made of it
  }
  void mousePressEvent(QMouseEvent* event) override { take_mouse(*event, true); }
  void mouseMoveEvent(QMouseEvent* event) override { take_mouse(*event, false); }

  void paintEvent(QPaintEvent*) override {
    const ThemeColors& theme = theme_colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme.base);
    for (const auto& [line, pressure] : drawn_) {
      painter.setPen(QPen(theme.text, 1 + 9 * pressure, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(line);
    }
    painter.setPen(theme.line);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }

 private:
  void take_mouse(const QMouseEvent& event, bool first) {
    constexpr double mouse_pressure = 0.2;
    constexpr int copy_ms = 250;  // of what a pen did, X11 may send a copy as a mouse's
    if (since_pen_.isValid() && !since_pen_.hasExpired(copy_ms)) return;
    found_.setText(tr("Mouse"));
    add(event.position(), mouse_pressure, first);
  }

  void add(const QPointF& at, double pressure, bool first) {
    if (!first) drawn_.emplace_back(QLineF(last_, at), pressure);
    last_ = at;
    update();
  }

  QLabel& found_;
  QElapsedTimer since_pen_;
  QPointF last_;
  std::vector<std::pair<QLineF, double>> drawn_;  ///< with its pressure
};

QWidget* make_navigation_cards(MainWindow& window, QLabel* sentence, QWidget* parent) {
  auto* cards = new QWidget(parent);
  auto* row = new QHBoxLayout(cards);
  row->setContentsMargins({});
  auto* group = new QButtonGroup(cards);
  sentence->setText(kept_navigation().sentence);
  for (const NavigationChoice& choice : navigation_choices()) {
    auto* card = new NavigationCard(choice, cards);
    card->setChecked(choice.preset == kept_navigation().preset);
    group->addButton(card);
    row->addWidget(card);
    QObject::connect(card, &QAbstractButton::clicked, cards, [&window, sentence, name = choice.name] {
      choose_navigation(window, name);
      sentence->setText(kept_navigation().sentence);
    });
  }
  return cards;
}

}  // namespace

void offer_first_choices(MainWindow& window) {
  if (is_anything_chosen() || QSettings().value(shown_key).toBool()) return;
  auto* dialog = new QDialog(&window);
  dialog->setObjectName("first-start");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(QObject::tr("Welcome to Croquis"));
  QObject::connect(dialog, &QDialog::finished, dialog, [] { QSettings().setValue(shown_key, true); });
  auto* form = new QFormLayout(dialog);
  form->setContentsMargins(20, 20, 20, 20);
  form->setVerticalSpacing(10);
  form->addRow(new QLabel(QObject::tr("Choose what you are used to. Edit > Preferences changes it later."), dialog));
  auto* sentence = new QLabel(dialog);
  const auto take_keys = [&window](const QString& preset) {
    keep_keys({preset});
    apply_preferences(window);
  };
  form->addRow(QObject::tr("&Language"), make_language_field(window, dialog));
  form->addRow(QObject::tr("&Theme"), make_theme_field(window, dialog));
  form->addRow(QObject::tr("&Keys as in"),
               make_choice_field("key-preset", key_presets(), kept_keys().preset, take_keys, dialog));
  form->addRow(QObject::tr("&Navigation as in"), make_navigation_cards(window, sentence, dialog));
  form->addRow(QString(), sentence);
  auto* found = new QLabel(QObject::tr("Draw on the strip"), dialog);
  found->setObjectName("pen-found");
  form->addRow(QObject::tr("Pen"), new PenStrip(*found, dialog));
  form->addRow(QString(), found);
  auto* begin = new QPushButton(QObject::tr("Begin"), dialog);
  begin->setObjectName("begin");
  begin->setDefault(true);
  QObject::connect(begin, &QPushButton::clicked, dialog, &QDialog::accept);
  form->addRow(begin);
  dialog->open();
  begin->setFocus();
}

}  // namespace croquis::app
