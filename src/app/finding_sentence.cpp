// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/finding_sentence.h"

#include <QRegularExpression>

namespace croquis::app {

QString sentence_in_view(const Finding& finding) {
  // Two numbers or three, and further places that "and" joins to the first.
  static const QRegularExpression places(R"( at (\(-?\d[^(),]*(, -?\d[^(),]*){1,2}\))( and (?1))*)");
  return QString::fromStdString(finding.message).remove(places);
}

}  // namespace croquis::app
