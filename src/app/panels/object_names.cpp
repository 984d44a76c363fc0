// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/object_names.h"

#include <QObject>

namespace croquis::app {

QString shown_name(const WorkObject& object) { return QString::fromStdString(readable_name(object.name)); }

std::string document_name(const Studio& studio) {
  const WorkObject* object = studio.active();
  return object == nullptr ? QObject::tr("Sketch").toStdString() : object->name;
}

}  // namespace croquis::app
