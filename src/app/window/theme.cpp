// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/theme.h"

#include <QApplication>
#include <QFile>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <algorithm>
#include <array>

namespace croquis::app {
namespace {

const QColor window_grey(56, 58, 63);
const QColor base(43, 45, 49);
const QColor raised(70, 73, 79);
const QColor light_text(226, 228, 232);
const QColor faint(140, 145, 153);

QPalette dark_palette() {
  QPalette palette;
  palette.setColor(QPalette::Window, window_grey);
  palette.setColor(QPalette::WindowText, light_text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window_grey);
  palette.setColor(QPalette::Text, light_text);
  palette.setColor(QPalette::Button, raised);
  palette.setColor(QPalette::ButtonText, light_text);
  palette.setColor(QPalette::ToolTipBase, base);
  palette.setColor(QPalette::ToolTipText, light_text);
  palette.setColor(QPalette::PlaceholderText, faint);
  palette.setColor(QPalette::Highlight, colors::accent);
  palette.setColor(QPalette::HighlightedText, QColor(24, 24, 26));
  palette.setColor(QPalette::Link, colors::hover);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, QColor(122, 126, 133));
  }
  return palette;
}

/// Fusion draws a light shadow below disabled text: on dark panels that is bolder than text that is not disabled.
class FlatDisabledStyle : public QProxyStyle {
 public:
  FlatDisabledStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* result) const override {
    return hint == SH_EtchDisabledText ? 0 : QProxyStyle::styleHint(hint, option, widget, result);
  }
};

constexpr const char* style_sheet = R"(
QToolTip { border: 1px solid #5c6068; padding: 4px; }
QDockWidget { titlebar-close-icon: url(:/icons/close.svg); }
QDockWidget::title { background: #303237; padding: 5px 8px; }
QToolBar { border: none; spacing: 2px; padding: 3px; background: #383a3f; }
QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 5px; }
QToolButton:hover { background: #4b4e55; }
QToolButton:checked { background: #6a4a26; border-color: #f28c28; }
QStatusBar { background: #2b2d31; }
QStatusBar::item { border: none; }
QListWidget { border: none; }
QListWidget::item { padding: 4px 6px; }
QTreeWidget { border: none; }
QTreeWidget::item { padding: 2px 0; }
QTreeWidget#objects::indicator { width: 18px; height: 18px; }
QTreeWidget#objects::indicator:checked { image: url(:/icons/eye.svg); }
QTreeWidget#objects::indicator:unchecked { image: url(:/icons/eye_off.svg); }
QTableWidget { border: none; }
QHeaderView::section { background: #383a3f; border: none; padding: 2px 3px; }
)";

}  // namespace

void apply_theme(QApplication& application) {
  QApplication::setStyle(new FlatDisabledStyle);
  QApplication::setPalette(dark_palette());
  application.setStyleSheet(style_sheet);
}

QColor depth_color(int depth) {
  static const std::array<QColor, 4> shades{QColor(0, 114, 178), QColor(177, 86, 0), QColor(150, 60, 140),
                                            QColor(90, 90, 90)};
  return shades[static_cast<std::size_t>(std::clamp(depth - 1, 0, 3))];
}

QColor sentence_color(Severity severity) {
  switch (severity) {
    case Severity::Error: return colors::error.lighter(140);
    case Severity::Warning: return colors::warning.lighter(120);
    case Severity::Info: break;
  }
  return light_text;
}

QIcon action_icon(const QString& action) {
  const QString file = ":/icons/" + action + ".svg";
  return QFile::exists(file) ? QIcon(file) : QIcon();
}

QIcon program_icon() { return QIcon(QStringLiteral(":/icons/croquis.svg")); }

}  // namespace croquis::app
