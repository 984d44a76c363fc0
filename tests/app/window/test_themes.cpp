// SPDX-License-Identifier: GPL-3.0-or-later
// The looks of the window: themes, scales, what the first start asks, and whether everybody can read and reach it.
#include <QAccessible>
#include <QComboBox>
#include <QDialog>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTabletEvent>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "app/hole_scans.h"
#include "app/readable.h"
#include "app/tools/perspective/sheet_scene.h"
#include "app/window/language.h"
#include "app/window/preferences.h"
#include "app/window/theme.h"
#include "croquis/render/render_options.h"

using namespace croquis;
using namespace croquis::test;

namespace {

using Light = std::array<double, 3>;  ///< linear red, green and blue, or what is made of them
using Matrix = std::array<Light, 3>;

Light product(const Matrix& m, const Light& v) {
  const auto row = [&](std::size_t k) { return m[k][0] * v[0] + m[k][1] * v[1] + m[k][2] * v[2]; };
  return {row(0), row(1), row(2)};
}

Light linear(const QColor& color) {
  const auto each = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return {each(color.redF()), each(color.greenF()), each(color.blueF())};
}

constexpr Matrix xyz_of_rgb{{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
constexpr Light white{0.9505, 1, 1.089};

/// As WCAG defines it: 1 for equal colours, 21 between black and white.
double contrast(const QColor& a, const QColor& b) {
  const double first = product(xyz_of_rgb, linear(a))[1], second = product(xyz_of_rgb, linear(b))[1];
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

/// What eyes without one kind of cones see (Machado, Oliveira and Fernandes 2009, severity 1).
constexpr std::array<Matrix, 2> deutan_protan{
    {{{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}}};

/// CIE 1976, with those eyes.
double difference(const QColor& a, const QColor& b, const Matrix& eyes) {
  const auto lab = [&](const QColor& color) {
    Light seen = product(eyes, linear(color)), f{};
    for (double& part : seen) part = std::clamp(part, 0.0, 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const double t = product(xyz_of_rgb, seen)[k] / white[k];
      f[k] = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
    }
    return Light{116 * f[1], 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
  };
  const Light first = lab(a), second = lab(b);
  return std::hypot(first[0] - second[0], first[1] - second[1], first[2] - second[2]);
}

/// Settings, theme and language as on a new machine, before and after.
struct Fresh {
  Fresh() { reset(); }
  ~Fresh() { reset(); }
  static void reset() {
    QSettings().clear();
    app::use_theme(app::kept_theme());
    app::use_language("en");
  }
};

void save_picture(QWidget& widget, const QString& name) {
  if (qEnvironmentVariableIsSet("CROQUIS_PICTURES"))
    widget.grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/" + name + ".png");
}

QDialog* dialog_of(StudioFixture& hand, const char* name) {
  auto* dialog = hand.window().findChild<QDialog*>(name);
  REQUIRE(dialog != nullptr);
  REQUIRE(QTest::qWaitForWindowExposed(dialog));
  return dialog;
}

/// The average of an icon's pixels, those that are hardly there left out.
QColor ink_of(const QIcon& icon) {
  const QImage picture = icon.pixmap(26, 26).toImage();
  double red = 0, green = 0, blue = 0, count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QColor pixel = picture.pixelColor(x, y);
      if (pixel.alpha() < 128) continue;
      red += pixel.redF(), green += pixel.greenF(), blue += pixel.blueF(), ++count;
    }
  }
  REQUIRE(count > 0);
  return QColor::fromRgbF(float(red / count), float(green / count), float(blue / count));
}

bool tab_should_reach(const QWidget& widget, const QWidget& window) {
  const bool takes_part = widget.window() == &window && widget.isVisible() && widget.isEnabled();
  return takes_part && (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.focusProxy() == nullptr;
}

/// Everything that the keyboard can be in has a name for people who don't see it, and the Tab key leads there.
void check_keyboard(QWidget& window, const char* state) {
  INFO(state);
  std::set<const QWidget*> reached;
  for (int presses = 0; presses < 300; ++presses) {
    QWidget* now = window.focusWidget() == nullptr ? &window : window.focusWidget();
    reached.insert(now);
    QTest::keyClick(now, Qt::Key_Tab);
  }
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!tab_should_reach(*widget, window)) continue;
    if (qobject_cast<QTabBar*>(widget) != nullptr) continue;  // its tabs have names, and it has none
    QString name = QAccessible::queryAccessibleInterface(widget)->text(QAccessible::Name);
    for (QWidget* above = widget->parentWidget(); name.isEmpty() && above != nullptr; above = above->parentWidget())
      if (above->focusProxy() == widget) name = QAccessible::queryAccessibleInterface(above)->text(QAccessible::Name);
    INFO(widget->metaObject()->className()
         << " " << widget->objectName().toStdString() << " in " << widget->parentWidget()->objectName().toStdString());
    CHECK(!name.isEmpty());
    CHECK(reached.contains(widget));
  }
}

/// Pixels of letters in the right fifth of a window: lighter than any ground of the dark theme.
double ink_of_panels(const QImage& window) {
  constexpr int light = 150;
  int count = 0;
  for (int y = 0; y < window.height(); ++y) {
    for (int x = window.width() * 4 / 5; x < window.width(); ++x) count += qGray(window.pixel(x, y)) > light ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("each text can be read on its ground, in every theme", "[themes]") {
  const Fresh fresh;
  using Role = QPalette::ColorRole;
  for (const auto& [name, title] : app::themes()) {
    app::use_theme(name);
    const QPalette palette = QApplication::palette();
    INFO(name.toStdString());
    for (const auto& [text, ground] : {std::pair{Role::WindowText, Role::Window},
                                       {Role::Text, Role::Base},
                                       {Role::Text, Role::AlternateBase},
                                       {Role::PlaceholderText, Role::Base},
                                       {Role::ButtonText, Role::Button},
                                       {Role::ToolTipText, Role::ToolTipBase},
                                       {Role::HighlightedText, Role::Highlight},
                                       {Role::Link, Role::Base},
                                       {Role::Link, Role::Window}}) {
      INFO("roles " << text << " on " << ground);
      CHECK(contrast(palette.color(text), palette.color(ground)) >= 4.5);
      CHECK(contrast(palette.color(QPalette::Disabled, text), palette.color(QPalette::Disabled, ground)) >= 3);
    }
    const app::ThemeColors& colors = app::theme_colors();
    std::vector<QColor> words{colors.faint, colors.good, colors.warning, colors.error};
    for (const Severity severity : {Severity::Info, Severity::Warning, Severity::Error})
      words.push_back(app::sentence_color(severity));
    for (const QColor& word : words)
      for (const Role ground : {Role::Base, Role::Window}) CHECK(contrast(word, palette.color(ground)) >= 4.5);
    for (const QColor& ground : {colors.bar, colors.hovered, colors.checked})
      CHECK(contrast(colors.text, ground) >= 4.5);
    CHECK(contrast(app::colors::guide, palette.color(Role::Base)) >= 3);  // the border of swatches in menus
  }
}

TEST_CASE("icons stand out from their bar, in every theme", "[themes]") {
  const Fresh fresh;
  StudioFixture hand;
  int seen = 0;
  for (const auto& [name, title] : app::themes()) {
    app::use_theme(name);
    for (const QAction* action : hand.window().actions()) {
      const bool is_swatch = action->objectName().startsWith("group-");  // its colour is what it means
      if (action->icon().isNull() || is_swatch) continue;
      INFO(name.toStdString() << ": " << action->objectName().toStdString());
      CHECK(contrast(ink_of(action->icon()), hand.window().palette().color(QPalette::Window)) >= 3);
      ++seen;
    }
  }
  CHECK(seen > 30);
}

TEST_CASE("a theme that people choose is there at once, and at the next start", "[themes]") {
  const Fresh fresh;
  StudioFixture hand;
  hand.window().set_unattended();
  hand.open_cage("mug");
  const auto ground = [&] {
    const QImage picture = hand.window().statusBar()->grab().toImage();
    return picture.pixelColor(picture.width() / 2, picture.height() - 1);
  };
  for (const char* expected : {"light", "contrast"}) {
    const QColor before = ground();
    hand.act("preferences");
    QDialog* dialog = dialog_of(hand, "preferences");
    QTest::keyClick(dialog->findChild<QComboBox*>("theme"), Qt::Key_Down);
    CHECK(app::kept_theme() == expected);
    save_picture(*dialog, QString("preferences-in-") + expected);
    delete dialog;
    hand.settle();
    CHECK(ground() != before);
    CHECK(ground() == app::theme_colors().base);
    save_picture(hand.window(), QString("window-") + expected);
  }
  const QString picture = hand.folder() + "/window.png";
  CHECK(QProcess::execute(CROQUIS_STUDIO, {"--screenshot", picture}) == 0);
  const QImage shown(picture);
  CHECK(shown.pixelColor(shown.width() / 2, shown.height() - 1) == QColor(Qt::black));
}

TEST_CASE("the scale is kept, and applied when the program starts", "[themes]") {
  const Fresh fresh;
  StudioFixture hand;
  hand.act("preferences");
  QTest::keyClick(dialog_of(hand, "preferences")->findChild<QComboBox*>("scale"), Qt::Key_Up);
  CHECK(app::kept_scale() == 75);
  const auto shown = [&] {
    const QString picture = hand.folder() + "/window.png";
    CHECK(QProcess::execute(CROQUIS_STUDIO, {"--new", "silhouette", "--screenshot", picture}) == 0);
    return QImage(picture);
  };
  const QImage small = shown();
  qputenv("QT_SCALE_FACTOR", "1");  // comes before what is kept
  const QImage normal = shown();
  qunsetenv("QT_SCALE_FACTOR");
  qputenv("QT_FONT_DPI", "96");  // so does this one
  CHECK(ink_of_panels(shown()) > 0.9 * ink_of_panels(normal));
  qunsetenv("QT_FONT_DPI");
  app::keep_scale(150);
  const QImage large = shown();
  CHECK(small.size() == normal.size());
  const double ink = ink_of_panels(normal);
  CHECK(ink_of_panels(small) < 0.9 * ink);
  CHECK(ink_of_panels(small) > 0.4 * ink);
  CHECK(ink_of_panels(large) > 1.5 * ink);
}

TEST_CASE("the first start asks once, and what is chosen works at once and is kept", "[themes]") {
  const Fresh fresh;
  StudioFixture hand;
  app::offer_first_choices(hand.window());
  QDialog* dialog = dialog_of(hand, "first-start");
  const auto choose_next = [&](const char* field) {
    QTest::keyClick(dialog->findChild<QComboBox*>(field), Qt::Key_Down);
  };
  const auto* card = dialog->findChild<QAbstractButton*>("navigate-cad");
  const QString english = card->accessibleDescription();
  CHECK(!english.isEmpty());
  choose_next("language");
  CHECK(app::kept_language() == "ko");
  CHECK(card->accessibleDescription() != english);
  choose_next("theme");
  CHECK(hand.window().palette().color(QPalette::Window) == app::theme_colors().window);
  CHECK(app::kept_theme() == "light");
  choose_next("key-preset");
  CHECK(hand.window().action("move")->shortcut() == QKeySequence("G"));
  QTest::mouseClick(dialog->findChild<QAbstractButton*>("navigate-cad"), Qt::LeftButton);
  CHECK(app::kept_navigation().preset == NavigationPreset::Cad);
  save_picture(*dialog, "first-start-chosen");
  QTest::mouseClick(dialog->findChild<QPushButton*>("begin"), Qt::LeftButton);
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  hand.crash_and_restart();
  app::offer_first_choices(hand.window());
  CHECK(hand.window().findChild<QDialog*>("first-start") == nullptr);
  CHECK(hand.window().action("move")->shortcut() == QKeySequence("G"));
  CHECK(app::kept_navigation().preset == NavigationPreset::Cad);
  QSettings().clear();
  QSettings().setValue("theme", "light");  // chosen in an earlier version
  app::offer_first_choices(hand.window());
  CHECK(hand.window().findChild<QDialog*>("first-start") == nullptr);
}

TEST_CASE("the pen test says what draws, and lines are as wide as the pressure", "[themes]") {
  const Fresh fresh;
  StudioFixture hand;
  app::offer_first_choices(hand.window());
  QDialog* dialog = dialog_of(hand, "first-start");
  auto* strip = dialog->findChild<QWidget*>("pen-strip");
  const auto* found = dialog->findChild<QLabel*>("pen-found");
  const QPointingDevice pen("pen", 7, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                            QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
  const auto draw = [&](double y, double pressure) {
    for (const auto& [type, x] : {std::pair{QEvent::TabletPress, 20}, {QEvent::TabletMove, 120}}) {
      QTabletEvent event(type, &pen, {double(x), y}, strip->mapToGlobal(QPointF(x, y)), pressure, 0, 0, 0, 0, 0, {},
                         Qt::LeftButton, Qt::LeftButton);
      QApplication::sendEvent(strip, &event);
    }
  };
  const auto ink_at = [&](int top) {
    const QImage picture = strip->grab().toImage();
    int count = 0;
    for (int y = top; y < top + 30; ++y) count += contrast(picture.pixelColor(70, y), app::theme_colors().base) > 2;
    return count;
  };
  draw(20, 0.1);
  CHECK(found->text() == "Pen with pressure");
  draw(50, 0.9);
  CHECK(ink_at(35) > 2 * ink_at(5));
  draw(20, 1);
  CHECK(found->text() == "Pen without pressure");
  QTest::mousePress(strip, Qt::LeftButton, {}, {30, 30});  // at once: X11's copy of the pen
  CHECK(found->text() == "Pen without pressure");
  QTest::qWait(300);
  QTest::mousePress(strip, Qt::LeftButton, {}, {30, 30});
  CHECK(found->text() == "Mouse");
  save_picture(*dialog, "pen-test");
}

TEST_CASE("words have room in every theme, in the window and its dialogs", "[theme-words]") {
  const Fresh fresh;
  StudioFixture hand;
  hand.window().set_unattended();
  hand.viewport().setUpdatesEnabled(false);  // what is drawn takes nearly all the time
  const auto check = [&](QWidget& shown, const std::string& state) {
    QApplication::processEvents();
    QApplication::processEvents();
    INFO(state);
    check_not_clipped<QPushButton>(shown);
    check_not_clipped<QToolButton>(shown);
    check_not_clipped<QComboBox>(shown);
    check_labels_fit(shown);
  };
  for (const auto& [name, title] : app::themes()) {
    app::use_theme(name);
    hand.window().refresh();
    hand.window().resize(1024, 640);
    for (const char* action : {"new-perspective", "new-surface", "new"}) {
      hand.act(action);
      check(hand.window(), name.toStdString() + ", " + action);
      CHECK(hand.window().size() == QSize(1024, 640));
    }
    hand.act("start-page");
    check(hand.window(), name.toStdString() + ", start page");
    hand.act("preferences");
    check(*dialog_of(hand, "preferences"), name.toStdString() + ", preferences");
    delete dialog_of(hand, "preferences");
    app::offer_first_choices(hand.window());
    check(*dialog_of(hand, "first-start"), name.toStdString() + ", first start");
    delete dialog_of(hand, "first-start");
    hand.act("start-page");
  }
}

TEST_CASE("the keyboard reaches every field, and each has a name", "[themes]") {
  const Fresh fresh;
  StudioFixture hand;
  hand.window().set_unattended();
  hand.act("start-page");
  check_keyboard(hand.window(), "start page");
  hand.open_cage("mug");
  hand.act("show-smooth");
  hand.settle();
  check_keyboard(hand.window(), "cage");
  open_scan(hand, ball_with_holes(3));
  check_keyboard(hand.window(), "holes");
  hand.act("new-perspective");
  check_keyboard(hand.window(), "perspective");
  hand.act("preferences");
  check_keyboard(*dialog_of(hand, "preferences"), "preferences");
  delete dialog_of(hand, "preferences");
  app::offer_first_choices(hand.window());
  check_keyboard(*dialog_of(hand, "first-start"), "first start");
}

TEST_CASE("axes can be told apart by eyes that don't tell red from green", "[themes]") {
  std::vector<QColor> cross;
  for (const render::Color& color : render::AxisCrossOptions().colors) cross.emplace_back(color.r, color.g, color.b);
  const auto of_groups = [](StrokeGroup x, StrokeGroup y, StrokeGroup z) {
    return std::vector{app::group_color(x), app::group_color(y), app::group_color(z)};
  };
  using enum StrokeGroup;
  for (const std::vector<QColor>& axes :
       {cross, of_groups(ParallelX, ParallelY, ParallelZ), of_groups(NormalX, NormalY, NormalZ)}) {
    for (const Matrix& eyes : deutan_protan)
      for (std::size_t i = 0; i < 3; ++i) CHECK(difference(axes[i], axes[(i + 1) % 3], eyes) >= 15);
  }
}
