// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/hotkeys.h"

#include <QAction>
#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>
#include <QVariant>
#include <algorithm>

#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr const char* first_keys = "first-keys";  // property of an action: those that it was made with

QString hotkey_text(const char* text) { return QCoreApplication::translate("Hotkeys", text); }

[[noreturn]] void refuse(const QString& file, const QString& what) {
  const QString sentence =
      hotkey_text("\"%1\" holds no keys: %2. Choose a file that was exported from the list of keys.");
  throw Error(make_error(Category::Malformed, "E_SYNTAX", sentence.arg(file, what).toStdString()));
}

KeysByAction keys_in(const QJsonObject& object, const QString& file) {
  KeysByAction keys;
  for (auto each = object.begin(); each != object.end(); ++each) {
    if (!each.value().isArray()) refuse(file, hotkey_text("\"%1\" has no list of keys").arg(each.key()));
    QList<QKeySequence>& list = keys[each.key()];
    for (const QJsonValue text : each.value().toArray()) {
      const QKeySequence key = QKeySequence::fromString(text.toString(), QKeySequence::PortableText);
      if (key.isEmpty() || key[0].key() == Qt::Key_unknown)
        refuse(file, hotkey_text("\"%1\" of \"%2\" is no key").arg(text.toString(), each.key()));
      list << key;
    }
  }
  return keys;
}

/// What a preset changes.
KeysByAction keys_of_preset(const QString& preset) {
  QFile file(QStringLiteral(":/keys/%1.json").arg(preset));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return keys_in(QJsonDocument::fromJson(file.readAll()).object(), file.fileName());
}

}  // namespace

QList<std::pair<QString, QString>> key_presets() {
  return {{"maya", hotkey_text("Maya")}, {"blender", hotkey_text("Blender")}, {"cad", hotkey_text("CAD")}};
}

QByteArray json_of(const KeyMap& map) {
  QJsonObject keys;
  for (auto each = map.own.begin(); each != map.own.end(); ++each) {
    QJsonArray texts;
    for (const QKeySequence& key : each.value()) texts << key.toString(QKeySequence::PortableText);
    keys[each.key()] = texts;
  }
  return QJsonDocument(QJsonObject{{"preset", map.preset}, {"keys", keys}}).toJson();
}

KeyMap key_map_of(const QByteArray& json, const QString& file) {
  QJsonParseError error;
  const QJsonDocument document = QJsonDocument::fromJson(json, &error);
  if (error.error != QJsonParseError::NoError) refuse(file, error.errorString());
  const QString preset = document["preset"].toString();
  const auto presets = key_presets();
  if (std::ranges::none_of(presets, [&](const auto& known) { return known.first == preset; }))
    refuse(file, hotkey_text("there is no preset \"%1\"").arg(preset));
  return {preset, keys_in(document["keys"].toObject(), file)};
}

KeyMap kept_keys() {
  const QByteArray kept = QSettings().value("keys").toByteArray();
  try {
    return kept.isEmpty() ? KeyMap() : key_map_of(kept, QStringLiteral("keys"));
  } catch (const Error&) {
    return {};
  }
}

void keep_keys(const KeyMap& map) { QSettings().setValue("keys", json_of(map)); }

void apply_keys(const KeyMap& map, const QList<QAction*>& actions) {
  const KeysByAction preset = keys_of_preset(map.preset);
  for (QAction* action : actions) {
    if (!action->property(first_keys).isValid())
      action->setProperty(first_keys, QVariant::fromValue(action->shortcuts()));
    const auto first = action->property(first_keys).value<QList<QKeySequence>>();
    const QString name = action->objectName();
    action->setShortcuts(map.own.value(name, preset.value(name, first)));
  }
}

QList<QAction*> actions_with_keys(const QList<QKeySequence>& keys, const QAction& except,
                                  const QList<QAction*>& among) {
  QList<QAction*> found;
  for (QAction* other : among) {
    const auto others = other->shortcuts();
    const bool shares = std::ranges::any_of(others, [&](const QKeySequence& key) { return keys.contains(key); });
    if (other != &except && shares) found << other;
  }
  return found;
}

}  // namespace croquis::app
