// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tours/tour.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "croquis/base/error.h"
#include "croquis/tools/all_steps.h"
#include "croquis/tools/recording/recording.h"

namespace croquis::app {
namespace {

const QString tours_folder = QStringLiteral(":/tours/");

[[noreturn]] void refuse_tour(const QString& file, const QString& what) {
  throw Error(make_error(Category::Malformed, "E_SYNTAX", QString("\"%1\": %2").arg(file, what).toStdString()));
}

/// Objects of a list, read as the lines of a recording.
std::vector<recorded::Step> recorded_steps(const QJsonValue& list, const QString& file) {
  QByteArray lines;
  for (const QJsonValue each : list.toArray())
    lines += QJsonDocument(each.toObject()).toJson(QJsonDocument::Compact) + '\n';
  std::vector<recorded::Step> steps;
  for (const recorded::Line& line : recorded::parse(lines.toStdString(), file.toStdString(), recorded::all_steps()))
    steps.push_back(line.step);
  return steps;
}

TourStep tour_step(const QJsonObject& object, const QString& file) {
  TourStep step{object["caption"].toString(), recorded_steps(object["asked"], file), {}, {}};
  if (step.caption.isEmpty() || step.asked.empty())
    refuse_tour(file, "every step has a caption and asks for something");
  for (const recorded::Step& each : recorded_steps(object["until"], file)) {
    const auto* expected = each.as<recorded::Expect>();
    if (expected == nullptr || expected->value) refuse_tour(file, "\"until\" takes lines of \"expect\" with counts");
    step.until.push_back(*expected);
  }
  const QJsonArray at = object["at"].toArray();
  if (object.contains("at") && at.size() != 3) refuse_tour(file, "\"at\" is three numbers");
  if (!at.isEmpty()) step.at = Vec3(at[0].toDouble(), at[1].toDouble(), at[2].toDouble());
  return step;
}

QJsonDocument read_tour(const QString& name) {
  QFile file(tours_folder + name + ".json");
  if (!file.open(QIODevice::ReadOnly)) refuse_tour(file.fileName(), "there is no such tour");
  QJsonParseError error;
  const QJsonDocument json = QJsonDocument::fromJson(file.readAll(), &error);
  if (error.error != QJsonParseError::NoError) refuse_tour(file.fileName(), error.errorString());
  return json;
}

}  // namespace

QStringList tour_names() {
  QStringList names = QDir(tours_folder).entryList({"*.json"}, QDir::Files, QDir::Name);
  for (QString& name : names) name.chop(static_cast<int>(strlen(".json")));
  return names;
}

QString tour_title(const QString& name) { return read_tour(name)["title"].toString(); }

Tour load_tour(const QString& name) {
  const QString file = tours_folder + name + ".json";
  const QJsonDocument json = read_tour(name);
  Tour tour{json["title"].toString(), json["action"].toString(), json["sample"].toString(), {}, json["end"].toString()};
  if (tour.title.isEmpty() || tour.end.isEmpty() || tour.action.isEmpty() == tour.sample.isEmpty())
    refuse_tour(file, "a tour has a title, an end, and an action or a sample that it begins with");
  for (const QJsonValue each : json["steps"].toArray()) tour.steps.push_back(tour_step(each.toObject(), file));
  if (tour.steps.empty()) refuse_tour(file, "a tour has steps");
  return tour;
}

}  // namespace croquis::app
