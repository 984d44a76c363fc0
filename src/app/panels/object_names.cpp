// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/object_names.h"

#include <QObject>

namespace croquis::app {

QString shown_name(const WorkObject& object) { return QString::fromStdString(readable_name(object.name)); }

QString source_words(const Node* source) {
  if (source == nullptr || !source->source) return {};
  const ValueType type = source->source->type();
  if (type == ValueType::Drawing) return QObject::tr("Sketch");
  if (type == ValueType::PerspectiveDrawing) return QObject::tr("Perspective drawing");
  if (type == ValueType::AttributeNetwork) return QObject::tr("Curves");
  if (type == ValueType::Mesh) return QObject::tr("Mesh");
  return QString::fromStdString(readable_name(source->name));
}

std::string document_name(const Studio& studio) {
  const WorkObject* object = studio.active();
  return object == nullptr ? QObject::tr("Sketch").toStdString() : object->name;
}

}  // namespace croquis::app
