// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lists.h"

#include <QSignalBlocker>
#include <algorithm>
#include <set>

#include "app/theme.h"

namespace croquis::app {
namespace {

constexpr int strokes_role = Qt::UserRole;

std::vector<std::string> strokes_of(const QListWidgetItem* item) {
  std::vector<std::string> strokes;
  for (const QString& stroke : item->data(strokes_role).toStringList()) strokes.push_back(stroke.toStdString());
  return strokes;
}

QStringList names_of(const Report& list) {
  QStringList names;
  for (const Report& name : list.as_array()) names << QString::fromStdString(name.as_string());
  return names;
}

bool is_selected(const Selection& selection, const QStringList& strokes) {
  return !strokes.isEmpty() && std::any_of(selection.begin(), selection.end(), [&](const SelectedItem& item) {
    return strokes.contains(QString::fromStdString(item.part));
  });
}

/// The details of an inflated drawing, or null.
const Report* details_of(const Evaluation* evaluation) {
  if (evaluation == nullptr) return nullptr;
  const auto details = evaluation->outputs.find("details");
  if (details == evaluation->outputs.end()) return nullptr;
  return std::get<std::shared_ptr<const Report>>(details->second).get();
}

}  // namespace

ObjectList::ObjectList(QWidget* parent) : QListWidget(parent) {
  setObjectName("objects");
  setAccessibleName(tr("Objects"));
  connect(this, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { emit strokes_chosen(strokes_of(item)); });
}

void ObjectList::show_objects(const Drawing& drawing, const Evaluation* evaluation, const Selection& selection) {
  const QSignalBlocker quiet(this);
  clear();
  std::set<std::string> used;
  const auto add_row = [&](const QString& text, const QStringList& strokes, bool solid) {
    auto* row = new QListWidgetItem(text, this);
    row->setData(strokes_role, strokes);
    if (!solid) row->setForeground(colors::guide);
    row->setSelected(is_selected(selection, strokes));
    for (const QString& stroke : strokes) used.insert(stroke.toStdString());
  };
  const Report* details = details_of(evaluation);
  const Report* objects = details == nullptr ? nullptr : details->find("objects");
  if (objects != nullptr) {
    for (const Report& object : objects->as_array()) {
      const QStringList strokes = names_of(object.at("strokes"));
      const QString name = QString::fromStdString(object.at("name").as_string());
      const QString count = strokes.size() == 1 ? tr("1 stroke") : tr("%1 strokes").arg(strokes.size());
      add_row(name + " — " + count, strokes, true);
    }
  }
  for (const Stroke& stroke : drawing.strokes) {
    if (used.count(stroke.id) == 0) {
      const QString name = QString::fromStdString(stroke.id);
      add_row(name, {name}, false);
    }
  }
}

FindingsList::FindingsList(QWidget* parent) : QListWidget(parent) {
  setObjectName("findings");
  setAccessibleName(tr("Findings"));
  setWordWrap(true);
  connect(this, &QListWidget::itemClicked, this,
          [this](QListWidgetItem* item) { emit strokes_chosen(strokes_of(item)); });
}

void FindingsList::show_findings(const Findings& findings) {
  clear();
  for (const Finding& finding : findings) {
    const bool error = finding.severity == Severity::Error;
    auto* row = new QListWidgetItem(QString::fromStdString(finding.message), this);
    row->setForeground(error ? colors::error.lighter(140) : colors::warning.lighter(120));
    row->setToolTip(QString::fromStdString(finding.code));
    QStringList strokes;
    for (const Subject& subject : finding.subjects) {
      if (subject.kind == SubjectKind::Stroke) strokes << QString::fromStdString(subject.id);
    }
    row->setData(strokes_role, strokes);
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
