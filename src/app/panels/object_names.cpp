// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/object_names.h"

#include <QObject>
#include <QRegularExpression>

#include "app/window/language.h"

namespace croquis::app {

QString shown_name(const WorkObject& object) { return shown_name(object.name); }

QString shown_name(const std::string& name) {
  // Names that nobody typed.
  static const QRegularExpression given(QStringLiteral("^(Sketch|Perspective|Surface|Group|stroke)( \\d+)?$"));
  const std::string readable = readable_name(name);
  const QString text = QString::fromStdString(readable);
  return given.match(text).hasMatch() ? localized(readable) : text;
}

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
