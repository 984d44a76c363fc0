// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/subdivision/chain_table.h"

#include <QHeaderView>
#include <algorithm>
#include <numbers>

#include "app/panels/number_box.h"
#include "croquis/operators/subdivide_result.h"

namespace croquis::app {
namespace {

const std::vector<SharpChain>& chains_of(const WorkObject* object) {
  static const std::vector<SharpChain> none;
  const SubdivideResult* found = object == nullptr ? nullptr : result_of<SubdivideResult>(object->result.get());
  return found == nullptr ? none : found->chains;
}

QString chain_angle(double angle) { return number_words(angle * (180 / std::numbers::pi), 6) + "°"; }

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

void ChainTable::show_chains(const WorkObject* object) {
  const std::vector<SharpChain>& chains = chains_of(object);
  setRowCount(static_cast<int>(chains.size()));
  cage_edges_.clear();
  for (int row = 0; row < rowCount(); ++row) {
    const SharpChain& chain = chains[static_cast<std::size_t>(row)];
    cage_edges_.push_back(chain.cage_edges);
    const QStringList cells{QString::number(row + 1), QString::number(chain.edges), chain.closed ? tr("yes") : tr("no"),
                            chain_angle(chain.least_angle), chain_angle(chain.greatest_angle)};
    for (int column = 0; column < cells.size(); ++column) {
      if (item(row, column) == nullptr) setItem(row, column, new QTableWidgetItem);
      item(row, column)->setText(cells[column]);
    }
  }
}

std::vector<std::array<Index, 2>> ChainTable::cage_edges(int chain) const {
  return cage_edges_.at(static_cast<std::size_t>(chain));
}

QString ChainTable::summary(const WorkObject* object) {
  const std::vector<SharpChain>& chains = chains_of(object);
  if (chains.empty()) return {};
  QStringList parts{chains.size() == 1 ? tr("1 crease") : tr("%1 creases").arg(chains.size())};
  const auto& mesh = object->cage_mesh;
  if (mesh && !mesh->tags.pins.empty())
    parts << (mesh->tags.pins.size() == 1 ? tr("1 pin") : tr("%1 pins").arg(mesh->tags.pins.size()));
  return parts.join(", ");
}

}  // namespace croquis::app
