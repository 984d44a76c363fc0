// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help_pages.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QFile>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "app/tours/tour_bar.h"
#include "app/views/viewport.h"
#include "app/window/command_palette.h"
#include "app/window/language.h"
#include "app/window/main_window.h"

namespace croquis::app {
namespace {

constexpr QSize help_size(760, 620);

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
  QFile manual(QStringLiteral(":/docs/%1studio.md").arg(folder));
  return manual.open(QIODevice::ReadOnly) ? without_links(QString::fromUtf8(manual.readAll())) : QString();
}

QString language_folder() { return kept_language() == "en" ? QString() : kept_language() + '/'; }

QStringList headings_of(const QString& text) {
  static const QRegularExpression heading(QStringLiteral("^#{2,3} +(.+)$"), QRegularExpression::MultilineOption);
  QStringList found;
  for (const auto& each : heading.globalMatch(text)) found << each.captured(1);
  return found;
}

/// What somebody who helps asks for first. No names, no shapes.
QString diagnostics(MainWindow& window) {
  const Studio& studio = window.studio();
  QStringList lines{
      QObject::tr("Croquis %1").arg(QCoreApplication::applicationVersion()),
      QObject::tr("Qt %1, %2, %3").arg(qVersion(), QSysInfo::prettyProductName(), QGuiApplication::platformName()),
      QObject::tr("Graphics: %1").arg(window.viewport().graphics()),
      QObject::tr("Window %1 × %2, scale %3").arg(window.width()).arg(window.height()).arg(window.devicePixelRatioF()),
      QObject::tr("Objects: %1").arg(studio.objects().size())};
  for (const WorkObject& object : studio.objects()) {
    QStringList chain;
    for (const NodeId id : object.chain) {
      const Node* node = studio.session().document().find(id);
      if (node != nullptr)
        chain << (node->operation.empty() ? QObject::tr("source") : QString::fromStdString(node->operation));
    }
    const auto mesh = object.shown();
    lines << QObject::tr("- %1: %2 vertices, %3 faces")
                 .arg(chain.join(QStringLiteral(" > ")))
                 .arg(mesh ? mesh->vertex_count() : 0)
                 .arg(mesh ? mesh->face_count() : 0);
  }
  for (const NodeFinding& found : findings_of(studio)) lines << "- " + QString::fromStdString(found.finding.code);
  return lines.join('\n') + '\n';
}

}  // namespace

QStringList manual_headings() { return headings_of(manual_text(language_folder())); }

void show_manual(QWidget& parent, const QString& heading) {
  QTextBrowser* text = open_page(parent, "manual", help_words("Help"));
  text->setMarkdown(manual_text(language_folder()));
  // Tools know the English headings; other languages have theirs in the same order.
  const auto place = headings_of(manual_text({})).indexOf(heading);
  const QString own = manual_headings().value(place, heading);
  text->window()->show();
  for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || block.text() != own) continue;
    text->setTextCursor(QTextCursor(block));
    text->verticalScrollBar()->setValue(text->verticalScrollBar()->value() + text->cursorRect().top());
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
      [&window] { show_manual(window, window.shows_views() ? help_topic_of(window.views()) : QString()); });
  add("help-keys", QObject::tr("Keys of the present tool"), {}, [&window] { show_keys(window, window.actions()); });
  add("help-examples", QObject::tr("Examples"), {}, [&window] {
    if (window.shows_views()) show_start_page(window);
  });
  add_tour_actions(window, menu->addMenu(QObject::tr("Tours")));
  menu->addSeparator();
  add("help-diagnostics", QObject::tr("Copy diagnostics"), {}, [&window] {
    QApplication::clipboard()->setText(diagnostics(window));
    window.say(QObject::tr("Version, graphics and what is open were copied: paste them where you ask"));
  });
  add("help-about", QObject::tr("About Croquis"), {}, [&window] { show_about(window); });
}

}  // namespace croquis::app
