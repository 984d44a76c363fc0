// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/subdivision/chain_table.h"

#include <QHeaderView>
#include <algorithm>

namespace croquis::app {
namespace {

const Report::Array* chains_of(const StudioObject* object) {
  const Report* details = object == nullptr ? nullptr : report_of(object->result.get(), "details");
  const Report* chains = details == nullptr ? nullptr : details->find("chains");
  return chains == nullptr ? nullptr : &chains->as_array();
}

bool flag(const Report& report, const char* name) {
  const Report* found = report.find(name);
  return found != nullptr && std::holds_alternative<bool>(found->value()) && std::get<bool>(found->value());
}

QString degrees(const Report& report, const char* name) {
  const Report* found = report.find(name);
  return found == nullptr || found->is_null() ? QString("–") : QString::number(found->as_number(), 'f', 3) + "°";
}

std::vector<std::array<Index, 2>> cage_edges_of(const Report& chain) {
  std::vector<std::array<Index, 2>> edges;
  const Report* list = chain.find("cage_edges");
  if (list == nullptr) return edges;
  for (const Report& edge : list->as_array()) {
    const Report::Array& ends = edge.as_array();
    edges.push_back({static_cast<Index>(ends.at(0).as_integer()), static_cast<Index>(ends.at(1).as_integer())});
  }
  return edges;
}

}  // namespace

ChainTable::ChainTable(QWidget* parent) : QTableWidget(parent) {
  setObjectName("chains");
  setAccessibleName(tr("Chains of sharp edges"));
  setToolTip(tr("Angles at which the surface folds along the chain, on the level that is seen"));
  setColumnCount(5);
  setHorizontalHeaderLabels({tr("Chain"), tr("Edges"), tr("Closed"), tr("Least"), tr("Greatest")});
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setStretchLastSection(true);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(22);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setShowGrid(false);
  connect(this, &QTableWidget::cellClicked, this, [this](int row, int) { emit chain_chosen(row); });
}

void ChainTable::show_chains(const StudioObject* object) {
  const Report::Array* chains = chains_of(object);
  setRowCount(chains == nullptr ? 0 : static_cast<int>(chains->size()));
  cage_edges_.clear();
  for (int row = 0; row < rowCount(); ++row) {
    const Report& chain = (*chains)[static_cast<std::size_t>(row)];
    cage_edges_.push_back(cage_edges_of(chain));
    const QStringList cells{QString::number(row + 1), QString::number(chain.at("edges").as_integer()),
                            flag(chain, "closed") ? tr("yes") : tr("no"), degrees(chain, "dihedral_min"),
                            degrees(chain, "dihedral_max")};
    for (int column = 0; column < cells.size(); ++column) {
      if (item(row, column) == nullptr) setItem(row, column, new QTableWidgetItem);
      item(row, column)->setText(cells[column]);
    }
  }
}

std::vector<std::array<Index, 2>> ChainTable::cage_edges(int chain) const {
  return cage_edges_.at(static_cast<std::size_t>(chain));
}

QString ChainTable::summary(const StudioObject* object) {
  const Report::Array* chains = chains_of(object);
  if (chains == nullptr || chains->empty()) return {};
  QStringList parts;
  constexpr std::size_t chains_at_most = 2;
  for (std::size_t i = 0; i < std::min(chains->size(), chains_at_most); ++i) {
    const Report& chain = (*chains)[i];
    QString part = tr("chain %1: %2 edges, %3")
                       .arg(i + 1)
                       .arg(chain.at("edges").as_integer())
                       .arg(flag(chain, "closed") ? tr("closed") : tr("open"));
    if (flag(chain, "planar")) part += tr(", planar");
    parts << part;
  }
  if (chains->size() > chains_at_most) parts << tr("%1 more").arg(chains->size() - chains_at_most);
  const auto& mesh = object->cage_mesh;
  if (mesh && !mesh->tags.pins.empty()) parts << tr("%1 pins").arg(mesh->tags.pins.size());
  return parts.join("; ");
}

}  // namespace croquis::app
