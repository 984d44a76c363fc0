// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QTimer>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "app/studio_fixture.h"

/// How tests answer what the window asks.
namespace croquis::test {

/// Answers the next dialog of that kind that waits for an answer, as soon as it does. Others are sent away.
template <typename Dialog>
void in_dialog(std::function<void(Dialog&)> answer) {
  constexpr int soon_ms = 100;
  QTimer::singleShot(soon_ms, qApp, [answer = std::move(answer)] {
    QWidget* asked = QApplication::activeModalWidget();
    if (auto* dialog = qobject_cast<Dialog*>(asked)) {
      answer(*dialog);
    } else if (asked != nullptr) {
      asked->close();
    }
  });
}

/// One closed line, in the middle of the sketch.
inline void draw_ring(StudioFixture& hand, double radius = 100) {
  hand.look_at({-200, -200}, {200, 200});
  std::vector<Vec2> ring;
  for (int k = 0; k <= 60; ++k) {
    const double angle = 2 * std::numbers::pi * k / 60;
    ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  hand.draw(ring);
}

inline std::vector<QListWidgetItem*> rows_of(const QListWidget& list) {
  std::vector<QListWidgetItem*> rows;
  for (int row = 0; row < list.count(); ++row) rows.push_back(list.item(row));
  return rows;
}

}  // namespace croquis::test
