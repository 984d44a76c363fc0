// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/theme.h"

#include <QApplication>
#include <QFile>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QSettings>
#include <QStyleFactory>
#include <QStyleOption>
#include <QSvgRenderer>
#include <QWidget>
#include <algorithm>
#include <array>
#include <memory>

namespace croquis::app {
namespace {

constexpr const char* theme_key = "theme";
constexpr const char* scale_key = "scale";

using Theme = std::pair<QString, ThemeColors>;  ///< with its name in the settings

const std::array<Theme, 3>& all_themes() {
  static const std::array<Theme, 3> made{
      {{"dark",
        {0x383a3f, 0x2b2d31, 0x46494f, 0x303237, 0x5c6068, 0xe2e4e8, 0xb2b8c1, 0x92979f, 0x82b4f2, 0x9fd6c3, 0xffb65c,
         0xf0a09a, 0xf28c28, 0x18181a, 0x4b4e55, 0x6a4a26}},
       {"light",
        {0xeceef1, 0xffffff, 0xf7f8f9, 0xdde0e5, 0xb0b6bf, 0x1e2126, 0x525965, 0x757c87, 0x1a5fb4, 0x1b6b45, 0x8a5000,
         0xb3261e, 0xb85600, 0xffffff, 0xd5d9df, 0xfbdcbc}},
       {"contrast",
        {Qt::black, Qt::black, 0x1c1c1c, 0x1c1c1c, 0xffffff, 0xffffff, 0xdcdcdc, 0xa0a0a0, 0x8ecbff, 0x7df0b0, 0xffd34d,
         0xff9d94, 0xffd800, Qt::black, 0x3c3c3c, 0x4d4100, true}}}};
  return made;
}

const Theme* theme_in_use = &all_themes().front();

QPalette palette_of(const ThemeColors& theme) {
  QPalette palette(theme.text, theme.raised, theme.line, theme.bar, theme.faint, theme.text, theme.text, theme.base,
                   theme.window);
  for (const auto& [role, color] : {std::pair{QPalette::AlternateBase, theme.window},
                                    {QPalette::ToolTipBase, theme.base},
                                    {QPalette::ToolTipText, theme.text},
                                    {QPalette::PlaceholderText, theme.faint},
                                    {QPalette::Highlight, theme.accent},
                                    {QPalette::HighlightedText, theme.on_accent},
                                    {QPalette::Link, theme.link},
                                    {QPalette::LinkVisited, theme.link}})
    palette.setColor(role, color);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, theme.disabled);
  return palette;
}

/// Icons are drawn for the dark theme: elsewhere each of its colours is replaced by the one that means the same.
QByteArray in_theme_colors(QByteArray svg, bool selected) {
  const ThemeColors& theme = theme_colors();
  const std::array<std::pair<const char*, QColor>, 6> meanings{
      {{"#e2e4e8", selected ? theme.on_accent : theme.text},
       {"#b9c0cb", theme.text},
       {"#9aa0a8", theme.faint},
       {"#6b7078", selected ? theme.on_accent : theme.disabled},
       {"#2b2d31", theme.base},
       {"#f28c28", theme.accent}}};
  for (const auto& [drawn, color] : meanings) svg.replace(drawn, color.name().toLatin1());
  return svg;
}

/// Read once for each theme: lists draw their icons in every row.
QSvgRenderer& renderer_of(const QString& file, bool selected) {
  static QHash<QString, std::shared_ptr<QSvgRenderer>> read;
  auto& renderer = read[file + (selected ? "/selected/" : "/") + theme_in_use->first];
  if (renderer) return *renderer;
  QFile svg(file);
  renderer = std::make_shared<QSvgRenderer>(svg.open(QIODevice::ReadOnly) ? in_theme_colors(svg.readAll(), selected)
                                                                          : QByteArray());
  return *renderer;
}

/// An icon that follows the theme: it is drawn anew whenever it is shown.
class ThemeIcon : public QIconEngine {
 public:
  explicit ThemeIcon(const QString& file) : file_(file) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    constexpr double disabled_strength = 0.4;
    if (mode == QIcon::Disabled) painter->setOpacity(disabled_strength * painter->opacity());
    const double side = std::min(rect.width(), rect.height());
    const QPointF corner = QRectF(rect).center() - QPointF(side, side) / 2;
    renderer_of(file_, mode == QIcon::Selected).render(painter, QRectF(corner, QSizeF(side, side)));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paint(&painter, picture.rect(), mode, state);
    return picture;
  }
  QIconEngine* clone() const override { return new ThemeIcon(*this); }

 private:
  QString file_;
};

/// Fusion, with the eyes of the list of objects, borders where the theme has them, and without the light shadow below
/// disabled text: on dark panels that is bolder than text that is not disabled.
class StudioStyle : public QProxyStyle {
 public:
  StudioStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* result) const override {
    if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton;  // a click beside the handle takes it there
    return hint == SH_EtchDisabledText ? 0 : QProxyStyle::styleHint(hint, option, widget, result);
  }

  QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override {
    if (which == SP_TitleBarCloseButton) return action_icon(QStringLiteral("close"));
    return QProxyStyle::standardIcon(which, option, widget);
  }

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    if (element == PE_IndicatorItemViewItemCheck && widget != nullptr && widget->objectName() == "objects")
      return action_icon(option->state & State_On ? "eye" : "eye_off")
          .paint(painter, option->rect, Qt::AlignCenter,
                 option->state & State_Selected ? QIcon::Selected : QIcon::Normal);
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_PanelButtonCommand || element == PE_FrameLineEdit || element == PE_IndicatorCheckBox)
      draw_border(*option, *painter);
  }

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control == CC_ComboBox || control == CC_SpinBox) draw_border(*option, *painter);
  }

 private:
  static void draw_border(const QStyleOption& option, QPainter& painter) {
    if (!theme_colors().outlined) return;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(option.state & State_HasFocus  ? theme_colors().accent
                   : option.state & State_Enabled ? theme_colors().line
                                                  : theme_colors().disabled);
    painter.drawRect(option.rect.adjusted(0, 0, -1, -1));
  }
};

constexpr const char* style_sheet = R"(
QToolTip { color: @text; background: @base; border: 1px solid @line; padding: 4px; }
QFrame#tool-movie { background: @base; border: 1px solid @line; }
QDockWidget::title { background: @bar; padding: 5px 8px; }
QToolBar { border: none; spacing: 2px; padding: 3px; background: @window; }
QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 5px; }
QToolButton:hover { background: @hovered; }
QToolButton:checked { background: @checked; border-color: @accent; }
QTabBar::tab:selected { color: @link; }
QPushButton:checked { background: @checked; }
QStatusBar { background: @base; }
QStatusBar::item { border: none; }
QListWidget { border: none; }
QListWidget::item { padding: 4px 6px; }
QTreeWidget { border: none; }
QTreeWidget::item { padding: 2px 0; }
QTreeWidget#objects::indicator { width: 18px; height: 18px; }
QTableWidget { border: none; }
QHeaderView::section { background: @window; border: none; padding: 2px 3px; }
*[tone="faint"] { color: @faint; }
*[tone="good"] { color: @good; }
*[tone="warning"] { color: @warning; }
*[tone="error"] { color: @error; }
)";

QString style_sheet_of(const ThemeColors& theme) {
  QString sheet = style_sheet;
  const std::array<std::pair<const char*, QColor>, 13> words{{{"@text", theme.text},
                                                              {"@base", theme.base},
                                                              {"@line", theme.line},
                                                              {"@bar", theme.bar},
                                                              {"@window", theme.window},
                                                              {"@hovered", theme.hovered},
                                                              {"@checked", theme.checked},
                                                              {"@accent", theme.accent},
                                                              {"@faint", theme.faint},
                                                              {"@good", theme.good},
                                                              {"@warning", theme.warning},
                                                              {"@error", theme.error},
                                                              {"@link", theme.link}}};
  for (const auto& [word, color] : words) sheet.replace(word, color.name());
  return sheet;
}

}  // namespace

QList<std::pair<QString, QString>> themes() {
  return {{"dark", QObject::tr("Dark")}, {"light", QObject::tr("Light")}, {"contrast", QObject::tr("High contrast")}};
}

QString kept_theme() {
  const QString kept = QSettings().value(theme_key).toString();
  const bool known = std::ranges::any_of(all_themes(), [&](const Theme& theme) { return kept == theme.first; });
  return known ? kept : all_themes().front().first;
}

void keep_theme(const QString& name) { QSettings().setValue(theme_key, name); }

void use_theme(const QString& name) {
  for (const Theme& theme : all_themes()) {
    if (name == theme.first) theme_in_use = &theme;
  }
  QApplication::setPalette(palette_of(theme_colors()));
  qApp->setStyleSheet(style_sheet_of(theme_colors()));
}

const ThemeColors& theme_colors() { return theme_in_use->second; }

void apply_theme(QApplication&) {
  QApplication::setStyle(new StudioStyle);
  use_theme(kept_theme());
}

void set_tone(QWidget& label, const QString& tone) {
  if (label.property("tone").toString() == tone) return;
  label.setProperty("tone", tone);
  label.style()->unpolish(&label);  // style sheets read properties once
  label.style()->polish(&label);
}

QList<int> scales() { return {75, 100, 150, 200, 300}; }

int kept_scale() {
  const int kept = QSettings().value(scale_key).toInt();
  return scales().contains(kept) ? kept : 100;
}

void keep_scale(int percent) { QSettings().setValue(scale_key, percent); }

QColor depth_color(int depth) {
  static const std::array<QColor, 4> shades{QColor(0, 114, 178), QColor(177, 86, 0), QColor(150, 60, 140),
                                            QColor(90, 90, 90)};
  return shades[static_cast<std::size_t>(std::clamp(depth - 1, 0, 3))];
}

QColor text_color_on(const QColor& color) {
  const double light = 0.299 * color.redF() + 0.587 * color.greenF() + 0.114 * color.blueF();
  return light > 0.4 ? QColor(20, 20, 22) : QColor(255, 255, 255);
}

QColor sentence_color(Severity severity) {
  switch (severity) {
    case Severity::Error: return theme_colors().error;
    case Severity::Warning: return theme_colors().warning;
    case Severity::Info: break;
  }
  return theme_colors().text;
}

QIcon action_icon(const QString& action) {
  const QString file = ":/icons/" + action + ".svg";
  return QFile::exists(file) ? QIcon(new ThemeIcon(file)) : QIcon();
}

QIcon paper_icon(const QString& action) { return QIcon(":/icons/" + action + ".svg"); }

QIcon program_icon() { return QIcon(QStringLiteral(":/icons/croquis.svg")); }

}  // namespace croquis::app
