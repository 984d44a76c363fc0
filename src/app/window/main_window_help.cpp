// SPDX-License-Identifier: GPL-3.0-or-later
// The menu Help.
#include <QApplication>
#include <QClipboard>
#include <QMenu>

#include "app/views/viewport.h"
#include "app/window/help_pages.h"
#include "app/window/main_window.h"

namespace croquis::app {

void MainWindow::make_help_actions() {
  QMenu* menu = actions_->menu(tr("&Help"));
  const auto add = [&](const QString& name, const QString& text, const QList<QKeySequence>& keys,
                       std::function<void()> work) {
    actions_->add(menu, name, text, keys, std::move(work), Recorded::ByItself);
  };
  add("help", tr("&Help for the present tool"), {QKeySequence(Qt::Key_F1)},
      [this] { show_manual(*this, shows_start_page() ? QString() : viewport_->help_topic()); });
  add("help-keys", tr("&Keys of the present tool"), {}, [this] { show_keys(*this, actions()); });
  add("help-examples", tr("&Examples"), {}, [this] {
    if (!shows_start_page()) show_start_page();
  });
  menu->addSeparator();
  add("help-diagnostics", tr("&Copy diagnostics"), {}, [this] {
    QApplication::clipboard()->setText(diagnostics());
    tell(tr("Version, graphics and what is open were copied: paste them where you ask"));
  });
  add("help-about", tr("&About Croquis"), {}, [this] { show_about(*this); });
}

/// What somebody who helps asks for first. No names, no shapes.
QString MainWindow::diagnostics() {
  QStringList lines{tr("Croquis %1").arg(QCoreApplication::applicationVersion()),
                    tr("Qt %1, %2, %3").arg(qVersion(), QSysInfo::prettyProductName(), QGuiApplication::platformName()),
                    tr("Graphics: %1").arg(viewport_->graphics()),
                    tr("Window %1 × %2, scale %3").arg(width()).arg(height()).arg(devicePixelRatioF()),
                    tr("Objects: %1").arg(studio_.objects().size())};
  for (const WorkObject& object : studio_.objects()) {
    QStringList chain;
    for (const NodeId id : object.chain) {
      const Node* node = studio_.session().document().find(id);
      if (node != nullptr) chain << (node->operation.empty() ? tr("source") : QString::fromStdString(node->operation));
    }
    const auto mesh = object.shown();
    lines << tr("- %1: %2 vertices, %3 faces")
                 .arg(chain.join(QStringLiteral(" > ")))
                 .arg(mesh ? mesh->vertex_count() : 0)
                 .arg(mesh ? mesh->face_count() : 0);
  }
  for (const NodeFinding& found : studio_.findings()) lines << "- " + QString::fromStdString(found.finding.code);
  return lines.join('\n') + '\n';
}

}  // namespace croquis::app
