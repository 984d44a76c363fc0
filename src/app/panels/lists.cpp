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
    if (place < findings_.size()) emit finding_chosen(findings_[place]);
  });
}

void FindingsList::show_findings(const std::vector<NodeFinding>& findings,
                                 const std::function<QString(const NodeFinding&)>& owner) {
  clear();
  findings_ = findings;
  for (const NodeFinding& found : findings) {
    const QString sentence = QString::fromStdString(found.finding.message);
    const QString name = owner(found);
    auto* row = new QListWidgetItem(name.isEmpty() ? sentence : tr("%1: %2").arg(name, sentence), this);
    row->setForeground(sentence_color(found.finding.severity));
    row->setToolTip(QString::fromStdString(found.finding.code));
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
