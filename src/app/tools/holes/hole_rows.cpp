// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_rows.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <map>

#include "app/tools/holes/filling.h"

namespace croquis::app {
namespace {

QString tr(const char* text, int count = -1) { return QCoreApplication::translate("Holes", text, nullptr, count); }

std::optional<double> number(const Report& report, const char* name) {
  const Report* found = report.find(name);
  if (found == nullptr || found->is_null()) return std::nullopt;
  return found->as_number();
}

std::string text(const Report& report, const char* name) {
  const Report* found = report.find(name);
  return found == nullptr || found->is_null() ? std::string() : found->as_string();
}

Vec3 place(const Report& report, const char* name, const Vec3& otherwise) {
  const Report* found = report.find(name);
  if (found == nullptr || found->is_null() || found->as_array().size() != 3) return otherwise;
  const Report::Array& values = found->as_array();
  return {values[0].as_number(), values[1].as_number(), values[2].as_number()};
}

HoleState state_of(const std::string& action) {
  if (action == "fill") return HoleState::Filled;
  return action == "failed" ? HoleState::Failed : HoleState::Open;
}

HoleRow row_of(const Report& report) {
  HoleRow row;
  row.id = static_cast<Index>(report.at("id").as_integer());
  row.kind = text(report, "class");
  row.edges = static_cast<std::size_t>(report.at("boundary_edges").as_integer());
  row.diameter = number(report, "diameter").value_or(0);
  row.area = number(report, "area").value_or(0);
  row.perimeter = number(report, "perimeter").value_or(0);
  row.state = state_of(text(report, "action"));
  row.method = text(report, "method");
  row.reason = text(report, "reason");
  row.normal_jump = number(report, "max_normal_jump");
  row.confidence = number(report, "confidence");
  if (const auto patch = number(report, "patch")) row.patch = static_cast<Index>(*patch);
  row.at = place(report, "at", row.at);
  row.normal = place(report, "normal", row.normal);
  if (const Report* companions = report.find("companions"); companions != nullptr && !companions->is_null()) {
    for (const Report& other : companions->as_array()) row.companions.push_back(static_cast<Index>(other.as_integer()));
  }
  return row;
}

}  // namespace

std::vector<HoleRow> hole_rows(const StudioObject* object) {
  const Report* details = object == nullptr ? nullptr : report_of(object->result.get(), "details");
  const Report* holes = details == nullptr ? nullptr : details->find("holes");
  std::vector<HoleRow> rows;
  if (holes == nullptr || holes->is_null()) return rows;
  for (const Report& hole : holes->as_array()) rows.push_back(row_of(hole));
  return rows;
}

std::vector<Index> with_islands(const std::vector<HoleRow>& rows, const std::vector<Index>& holes) {
  std::set<Index> all(holes.begin(), holes.end());
  for (const HoleRow& row : rows) {
    if (row.kind == "islands" && std::find(holes.begin(), holes.end(), row.id) != holes.end())
      all.insert(row.companions.begin(), row.companions.end());
  }
  return {all.begin(), all.end()};
}

QString words_for(const HoleRow& hole) {
  static const std::map<std::string, const char*> words{
      {"small", "small"},         {"simple", "hole"}, {"islands", "with island"},    {"tunnel", "tunnel end"},
      {"OUTER", "border, keep?"}, {"slit", "slit"},   {"bow-tie", "touches another"}};
  const auto found = words.find(hole.kind);
  return found == words.end() ? QString::fromStdString(hole.kind) : tr(found->second);
}

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

QString measure(double value) { return QLocale().toString(value, 'g', 4); }

}  // namespace croquis::app
