// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help_pages.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QDockWidget>
#include <QFile>
#include <QHash>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWhatsThis>
#include <algorithm>

#include "app/tours/tour_bar.h"
#include "app/views/viewport.h"
#include "app/window/command_palette.h"
#include "app/window/language.h"
#include "app/window/main_window.h"
#include "app/window/report.h"

namespace croquis::app {
namespace {

constexpr QSize help_size(760, 620);
const QString menus_section = QStringLiteral("Menus");

QString help_words(const char* words) { return QCoreApplication::translate("Help", words); }

/// A page in a window of its own, which takes the place of an earlier one.
QTextBrowser* open_page(QWidget& parent, const QString& name, const QString& title) {
  delete parent.findChild<QDialog*>(name);
  auto* page = new QDialog(&parent);
  page->setObjectName(name);
  page->setAttribute(Qt::WA_DeleteOnClose);
  page->setWindowTitle(title);
  page->resize(help_size);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  auto* text = new QTextBrowser(page);
  text->setOpenLinks(false);
  column->addWidget(text);
  return text;
}

/// Links lead to pages that the program doesn't have.
QString without_links(QString text) {
  static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)"));
  return text.replace(link, QStringLiteral("\\1"));
}

/// @param folder of a language, "ko/"; empty for English
QString manual_text(const QString& folder) {
  static QHash<QString, QString> read;
  QString& text = read[folder];
  QFile manual(QStringLiteral(":/docs/%1studio.md").arg(folder));
  if (text.isEmpty() && manual.open(QIODevice::ReadOnly)) text = without_links(QString::fromUtf8(manual.readAll()));
  return text;
}

QString language_folder() { return kept_language() == "en" ? QString() : kept_language() + '/'; }

/// @param folder as above
QStringList headings_in(const QString& folder) {
  static const QRegularExpression heading(QStringLiteral("^#{2,3} +(.+)$"), QRegularExpression::MultilineOption);
  static QHash<QString, QStringList> read;
  QStringList& found = read[folder];
  if (!found.isEmpty()) return found;
  for (const auto& each : heading.globalMatch(manual_text(folder))) found << each.captured(1);
  return found;
}

/// Tools know the English headings; other languages have theirs in the same order.
QString own_heading(const QString& heading) {
  const auto place = headings_in({}).indexOf(heading);
  return place < 0 ? heading : manual_headings().value(place, heading);
}

/// The sentences and the rows of tables below a heading, in the language in use. @param heading in English
QStringList passages_of(const QString& heading) {
  static const QRegularExpression any_heading(QStringLiteral("^#+ .*$"), QRegularExpression::MultilineOption);
  static const QRegularExpression end(QStringLiteral("\\|\\n\\||(?<=\\.) "));
  static QHash<QString, QStringList> read;
  QStringList& passages = read[language_folder() + heading];
  if (!passages.isEmpty()) return passages;
  const QString text = manual_text(language_folder());
  const auto begin = text.indexOf(' ' + own_heading(heading) + '\n');
  const auto length = text.indexOf(any_heading, begin + 1) - begin;
  for (QString& part : text.mid(begin, begin < 0 ? 0 : length).split(QStringLiteral("\n\n")).mid(1)) {
    if (!part.startsWith('|')) part.replace('\n', ' ');
    for (QString& passage : part.split(end))
      passages << passage.remove('*').remove('`').replace('|', QStringLiteral(" – ")).trimmed();
  }
  return passages;
}

/// The first of the words that one of the sections has. @param headings in English, the best first
HelpPlace place_of(const QStringList& words, const QStringList& headings) {
  for (const QString& word : words) {
    for (const QString& heading : headings) {
      const QStringList passages = passages_of(heading);
      if (std::ranges::any_of(passages, [&](const QString& each) { return each.contains(word); }))
        return {heading, word};
    }
  }
  return {headings.back(), {}};
}

/// What the pointer is on, in words of HTML, and where the manual is about it.
struct About {
  QString text;
  HelpPlace place;
};

About about(const QString& title, const QString& keys, const QString& tooltip, const HelpPlace& place) {
  QString text = QStringLiteral("<b>%1</b>").arg(title.toHtmlEscaped());
  if (!keys.isEmpty()) text += " (" + keys.toHtmlEscaped() + ')';
  if (!tooltip.isEmpty() && tooltip != title) text += "<p>" + tooltip.toHtmlEscaped() + "</p>";
  const QStringList passages = passages_of(place.heading);
  const auto found = std::ranges::find_if(passages, [&](const QString& each) { return each.contains(place.words); });
  if (found != passages.end()) text += "<p>" + found->toHtmlEscaped() + "</p>";
  return {text + "<p><i>" + help_words("Help") + ": " + own_heading(place.heading).toHtmlEscaped() + "</i></p>", place};
}

About about(const QAction& action) {
  return about(plain_text(action), keys_of(action), action.toolTip().section(QStringLiteral(" ("), 0, 0),
               help_place_of(action));
}

/// A widget is explained by what its tooltip or that of what it lies in says, and by its panel or the tool in hand.
About about(MainWindow& window, const QWidget& widget) {
  const auto* button = qobject_cast<const QToolButton*>(&widget);
  if (button != nullptr && button->defaultAction() != nullptr) return about(*button->defaultAction());
  QString title = widget.accessibleName();
  QString tooltip;
  for (const QWidget* each = &widget; each != nullptr && each != &window; each = each->parentWidget()) {
    if (tooltip.isEmpty()) tooltip = each->toolTip();
    const auto* panel = qobject_cast<const QDockWidget*>(each);
    if (panel == nullptr) continue;
    // Where the section about its tool doesn't name it, another one does.
    const QStringList headings = QStringList{panel->property("topic").toString()} + headings_in({});
    const HelpPlace place = place_of({panel->windowTitle()}, headings);
    return about(title.isEmpty() ? panel->windowTitle() : title, {}, tooltip, place);
  }
  const QString topic = window.shows_views() ? help_topic_of(window.views()) : QString();
  return about(title.isEmpty() ? own_heading(topic) : title, {}, tooltip, {topic, {}});
}

/// What Shift+F1 shows, from one rule for all.
void explain_everything(MainWindow& window) {
  for (QWidget* widget : window.findChildren<QWidget*>()) widget->setWhatsThis(about(window, *widget).text);
  for (QAction* action : window.actions()) action->setWhatsThis(about(*action).text);
}

/// Of what is under the pointer, else of what has the keyboard.
HelpPlace place_in_hand(MainWindow& window) {
  const QWidget* widget = QApplication::widgetAt(QCursor::pos());
  if (widget == nullptr || widget->window() != &window) widget = QApplication::focusWidget();
  return widget == nullptr ? HelpPlace() : about(window, *widget).place;
}

}  // namespace

QStringList manual_headings() { return headings_in(language_folder()); }

HelpPlace help_place_of(const QAction& action) {
  QStringList words = menu_place(action).split(QStringLiteral(" ▸ "), Qt::SkipEmptyParts);
  words << plain_text(action);
  std::ranges::reverse(words);
  return place_of(words, {action.property("topic").toString(), menus_section});
}

void show_manual(QWidget& parent, const HelpPlace& place) {
  QTextBrowser* text = open_page(parent, "manual", help_words("Help"));
  text->setMarkdown(manual_text(language_folder()));
  const QString own = own_heading(place.heading);
  text->window()->show();
  bool inside = false;
  for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next()) {
    const bool begins = block.blockFormat().headingLevel() != 0;
    if (inside && (begins || place.words.isEmpty())) return;
    inside = inside || (begins && block.text() == own);
    if (!inside || (!begins && !block.text().contains(place.words))) continue;
    text->setTextCursor(QTextCursor(block));
    text->verticalScrollBar()->setValue(text->verticalScrollBar()->value() + text->cursorRect().top());
    if (!begins) return;
  }
}

QString keys_of(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts()) keys << key.toString(QKeySequence::NativeText);
  if (keys.isEmpty() && action.text().contains('\t')) keys << action.text().section('\t', 1);
  static const QRegularExpression in_brackets(QStringLiteral("\\(([^() ]{1,12})\\)$"));
  if (const auto found = in_brackets.match(action.toolTip()); keys.isEmpty() && found.hasMatch())
    keys << found.captured(1);
  return keys.join(QStringLiteral(", "));
}

void show_keys(QWidget& parent, const QList<QAction*>& actions) {
  QString rows;
  for (const QAction* action : actions) {
    const QString keys = keys_of(*action);
    if (keys.isEmpty() || !action->isEnabled() || !action->isVisible()) continue;
    rows += QStringLiteral("<tr><td>%1</td><td><b>%2</b></td></tr>")
                .arg(plain_text(*action).toHtmlEscaped(), keys.toHtmlEscaped());
  }
  QTextBrowser* text = open_page(parent, "keys", help_words("Keys of the present tool"));
  text->setHtml(QStringLiteral("<table cellspacing='0' cellpadding='4'>%1</table>").arg(rows));
  text->window()->show();
}

void show_about(QWidget& parent) {
  delete parent.findChild<QMessageBox*>("about");
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, help_words("About Croquis"),
                      help_words("Croquis %1\n\nDrawings, curves, cages and scans become solids.\n\nFree software "
                                 "under the GNU General Public License, version 3 or later.")
                          .arg(QCoreApplication::applicationVersion()),
                      QMessageBox::Ok, &parent);
  box->setObjectName("about");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void add_help_menu(MainWindow& window) {
  ActionList& actions = *window.parts().actions;
  QMenu* menu = actions.menu(MenuId::Help);
  const auto add = [&](const QString& name, const QString& text, const QList<QKeySequence>& keys,
                       std::function<void()> work) {
    actions.add(menu, name, text, keys, std::move(work), Recorded::ByItself);
  };
  add("help", QObject::tr("Help for the present tool"), {QKeySequence(Qt::Key_F1)},
      [&window] { show_manual(window, place_in_hand(window)); });
  add("help-whats-this", QObject::tr("What's this?"), {QKeySequence(Qt::SHIFT | Qt::Key_F1)}, [&window] {
    explain_everything(window);
    QWhatsThis::enterWhatsThisMode();
  });
  add("help-keys", QObject::tr("Keys of the present tool"), {}, [&window] { show_keys(window, window.actions()); });
  add("help-examples", QObject::tr("Examples"), {}, [&window] {
    if (window.shows_views()) show_start_page(window);
  });
  add_tour_actions(window, menu->addMenu(QObject::tr("Tours")));
  menu->addSeparator();
  add("help-report", QObject::tr("Report a problem…"), {}, [&window] { ask_report(window); });
  add("help-about", QObject::tr("About Croquis"), {}, [&window] { show_about(window); });
}

}  // namespace croquis::app
