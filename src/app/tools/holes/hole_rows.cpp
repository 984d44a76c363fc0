// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_rows.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "app/panels/number_box.h"
#include "croquis/hole_filling/hole_choice.h"

namespace croquis::app {
namespace {

QString tr(const char* text, int count = -1) { return QCoreApplication::translate("Holes", text, nullptr, count); }

using hole_filling::HoleClass;

const char* word_of(HoleClass kind) {
  switch (kind) {
    case HoleClass::Small: return "small";
    case HoleClass::Simple: return "hole";
    case HoleClass::Islands: return "with island";
    case HoleClass::Tunnel: return "tunnel end";
    case HoleClass::Outer: return "open edge";
    case HoleClass::Slit: return "slit";
    case HoleClass::BowTie: return "touches another";
  }
  return "";
}

}  // namespace

std::vector<HoleRow> hole_rows(const Evaluation* result) {
  const FillResult* found = result_of<FillResult>(result);
  return found == nullptr ? std::vector<HoleRow>() : found->holes;
}

std::vector<Index> named_rows(const std::vector<HoleRow>& rows, hole_filling::Selection selection,
                              double max_diameter) {
  std::vector<hole_filling::HoleSize> sizes;
  for (const HoleRow& row : rows) sizes.push_back({row.kind, row.diameter});
  const std::vector<hole_filling::Naming> named = named_holes(sizes, selection, max_diameter);
  std::vector<Index> ids;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (named[i] == hole_filling::Naming::Named) ids.push_back(rows[i].id);
  }
  return ids;
}

std::vector<Index> with_islands(const std::vector<HoleRow>& rows, const std::vector<Index>& holes) {
  std::set<Index> all(holes.begin(), holes.end());
  for (const HoleRow& row : rows) {
    if (row.kind == HoleClass::Islands && std::find(holes.begin(), holes.end(), row.id) != holes.end())
      all.insert(row.companions.begin(), row.companions.end());
  }
  return {all.begin(), all.end()};
}

QString words_for(const HoleRow& hole) { return tr(word_of(hole.kind)); }

QString words_for(HoleState state) {
  switch (state) {
    case HoleState::Filled: return tr("filled");
    case HoleState::Failed: return tr("failed");
    case HoleState::Open: break;
  }
  return tr("open");
}

QString summary_of(const std::vector<HoleRow>& holes) {
  if (holes.empty()) return tr("No holes");
  const auto count = [&](HoleState state, bool border) {
    return std::count_if(holes.begin(), holes.end(), [&](const HoleRow& hole) {
      return hole.state == state && (state != HoleState::Open || hole.is_border() == border);
    });
  };
  QStringList parts;
  const auto add = [&parts](std::ptrdiff_t number, const QString& one, const QString& many) {
    if (number > 0) parts << (number == 1 ? one : many).arg(number);
  };
  add(count(HoleState::Filled, false), tr("%1 filled"), tr("%1 filled"));
  add(count(HoleState::Open, false), tr("%1 open"), tr("%1 open"));
  add(count(HoleState::Open, true), tr("%1 border left open"), tr("%1 borders left open"));
  add(count(HoleState::Failed, false), tr("%1 failed"), tr("%1 failed"));
  return (holes.size() == 1 ? tr("1 hole: ") : tr("%1 holes: ").arg(holes.size())) + parts.join(", ");
}

QString numbers_of(const std::set<Index>& holes) {
  constexpr std::size_t shown_at_most = 6;
  QStringList parts;
  std::size_t shown = 0;
  for (auto hole = holes.begin(); hole != holes.end() && shown < shown_at_most; ++hole, ++shown) {
    parts << QString::number(*hole);
  }
  const QString list = parts.join(", ");
  return holes.size() > shown_at_most ? tr("%1 and %2 more").arg(list).arg(holes.size() - shown_at_most) : list;
}

QString measure(double value) { return number_words(value); }

}  // namespace croquis::app
