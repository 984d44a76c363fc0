// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeySequence>
#include <QList>
#include <QMap>
#include <QString>
#include <QStringList>

class QAction;

namespace croquis::app {

using KeysByAction = QMap<QString, QList<QKeySequence>>;

/// Which keys the actions have: they are made with Maya's, a preset changes some of them, people's own change some of
/// these. An action with an empty list has no key.
struct KeyMap {
  QString preset = QStringLiteral("maya");  ///< or "blender", "cad"
  KeysByAction own = {};

  friend bool operator==(const KeyMap&, const KeyMap&) = default;
};

/// Names of the presets with their titles, the first one is that of a new installation.
QList<std::pair<QString, QString>> key_presets();

/// As a file that people give to others: {"preset": "maya", "keys": {"extrude": ["Ctrl+X", "E"]}}.
QByteArray json_of(const KeyMap& map);

/// @param file its name, for the message
/// @throws Error (E_SYNTAX) when it isn't such a file: what in it is wrong
KeyMap key_map_of(const QByteArray& json, const QString& file);

/// In the settings of the program. What can't be read there counts as not kept.
KeyMap kept_keys();
void keep_keys(const KeyMap& map);

/// Gives the actions their keys; those that the map doesn't name keep what they were made with.
void apply_keys(const KeyMap& map, const QList<QAction*>& actions);

/// The other actions that have one of these keys. Only one of them can be done at a time where tools take turns.
QList<QAction*> actions_with_keys(const QList<QKeySequence>& keys, const QAction& except, const QList<QAction*>& among);

}  // namespace croquis::app
