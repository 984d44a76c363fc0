// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/stalls.h"

#include <QAbstractEventDispatcher>
#include <QCoreApplication>
#include <QJsonObject>
#include <QMetaEnum>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace croquis::app {
namespace {

constexpr std::size_t most_stalls = 10;
constexpr double noted_ms = 20;  // what is shorter is no stall

bool is_painting(QEvent::Type type) {
  return type == QEvent::UpdateRequest || type == QEvent::Paint || type == QEvent::Expose;
}

QString name_of(const StallPart& part) {
  // Results of computations reach the studio as calls that were posted to it.
  if (part.type == QEvent::MetaCall && std::strcmp(part.receiver, "croquis::app::Studio") == 0)
    return QStringLiteral("evaluation result");
  return QString::fromLatin1(part.receiver) + ' ' + QMetaEnum::fromType<QEvent::Type>().valueToKey(part.type);
}

double rounded(double ms) { return std::round(10 * ms) / 10; }

}  // namespace

StallWatch::StallWatch() : action_(QStringLiteral("start")) {
  clock_.start();
  // Depending on the system's event loop each of the signals comes once in a turn, or only one of them.
  const auto* loop = QAbstractEventDispatcher::instance();
  connect(loop, &QAbstractEventDispatcher::awake, this, [this] { end_turn(false); });
  connect(loop, &QAbstractEventDispatcher::aboutToBlock, this, [this] { end_turn(true); });
  qApp->installEventFilter(this);
}

bool StallWatch::eventFilter(QObject* watched, QEvent* event) {
  begin_part({watched->metaObject()->className(), event->type()});
  return false;
}

void StallWatch::begin_part(const StallPart& part) {
  const double now = 1e-6 * static_cast<double>(clock_.nsecsElapsed());
  if (turn_began_ < 0) turn_began_ = part_began_ = now;
  const double ms = now - part_began_;
  if (is_painting(part_.type)) turn_.drawing_ms += ms;
  if (ms > turn_.longest_ms) {
    turn_.longest_ms = ms;
    longest_part_ = part_;
  }
  part_ = part;
  part_began_ = now;
}

void StallWatch::end_turn(bool waits) {
  begin_part({});
  turn_.ms = part_began_ - turn_began_;
  if (turn_.ms >= noted_ms && (longest_.size() < most_stalls || turn_.ms > longest_.back().ms)) {
    turn_.what = longest_part_.receiver == nullptr ? action_ : name_of(longest_part_);
    turn_.after = action_;
    longest_.insert(std::ranges::upper_bound(longest_, turn_.ms, std::greater<>(), &Stall::ms), turn_);
    if (longest_.size() > most_stalls) longest_.pop_back();
  }
  turn_ = {};
  longest_part_ = {};
  turn_began_ = waits ? -1 : part_began_;
}

QJsonArray to_json(const std::vector<Stall>& stalls) {
  QJsonArray all;
  for (const Stall& stall : stalls) {
    all.append(QJsonObject{{"ms", rounded(stall.ms)},
                           {"drawing_ms", rounded(stall.drawing_ms)},
                           {"longest_ms", rounded(stall.longest_ms)},
                           {"what", stall.what},
                           {"after", stall.after}});
  }
  return all;
}

}  // namespace croquis::app
