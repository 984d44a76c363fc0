// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/lists.h"

#include <QSignalBlocker>

#include "app/window/theme.h"

namespace croquis::app {

FindingsList::FindingsList(QWidget* parent) : QListWidget(parent) {
  setObjectName("findings");
  setAccessibleName(tr("Findings"));
  setWordWrap(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
    const auto place = static_cast<std::size_t>(row(item));
    if (place >= rows_.size()) return;
    const Row chosen = rows_[place];  // receivers show all rows again
    if (chosen.fix == nullptr) return emit finding_chosen(chosen.finding);
    emit fix_chosen(chosen.finding, chosen.fix);
  });
}

void FindingsList::show_findings(const std::vector<NodeFinding>& findings,
                                 const std::function<QString(const NodeFinding&)>& owner,
                                 const std::function<std::vector<QAction*>(const NodeFinding&)>& fixes) {
  clear();
  rows_.clear();
  for (const NodeFinding& found : findings) {
    const QString sentence = QString::fromStdString(found.finding.message);
    const QString name = owner(found);
    auto* row = new QListWidgetItem(name.isEmpty() ? sentence : tr("%1: %2").arg(name, sentence), this);
    row->setForeground(sentence_color(found.finding.severity));
    row->setToolTip(QString::fromStdString(found.finding.code));
    rows_.push_back({found});
    for (QAction* fix : fixes(found)) {
      auto* offer = new QListWidgetItem(QStringLiteral("→ ") + fix->text().remove('&'), this);
      offer->setForeground(colors::hover);
      offer->setToolTip(fix->toolTip());
      rows_.push_back({found, fix});
    }
  }
}

HistoryList::HistoryList(QWidget* parent) : QListWidget(parent) {
  setObjectName("history");
  setAccessibleName(tr("History"));
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) { emit step_chosen(row(item)); });
}

void HistoryList::show_history(const std::vector<std::string>& done, const std::vector<std::string>& undone) {
  const QSignalBlocker quiet(this);
  clear();
  addItem(tr("Start"));
  for (const std::string& label : done) addItem(QString::fromStdString(label));
  setCurrentRow(count() - 1);
  for (const std::string& label : undone) {
    addItem(QString::fromStdString(label));
    item(count() - 1)->setForeground(colors::guide);
  }
  scrollToItem(currentItem());
}

}  // namespace croquis::app
