// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <array>
#include <functional>

#include "croquis/tools/pointer/navigation.h"

class QComboBox;
class QWidget;

namespace croquis::app {

class MainWindow;

/// Gives a new window the keys and the way to navigate that people chose.
void apply_preferences(MainWindow& window);

/// The window where they are chosen. Changes work at once, and are kept.
void show_preferences(MainWindow& window);

/// People chose something at any time: language, theme, scale, keys or navigation.
bool is_anything_chosen();

/// Where nobody has chosen anything yet, and this wasn't shown before: asks for language, theme, keys and navigation,
/// and has a strip to try the pen on. What is chosen works at once and is kept.
void offer_first_choices(MainWindow& window);

// ---- What the first start asks, too

/// A field where one of several values is chosen.
/// @param choices values with their titles
/// @param take gets the value whenever people choose another one
QComboBox* make_choice_field(const QString& name, const QList<std::pair<QString, QString>>& choices,
                             const QString& kept, const std::function<void(const QString&)>& take, QWidget* parent);
QComboBox* make_language_field(MainWindow& window, QWidget* parent);
QComboBox* make_theme_field(MainWindow& window, QWidget* parent);

/// How the mouse moves the view.
struct NavigationChoice {
  NavigationPreset preset;
  const char* name;  ///< in the settings
  QString title;
  QString sentence;
};

std::array<NavigationChoice, 3> navigation_choices();
NavigationChoice kept_navigation();
void choose_navigation(MainWindow& window, const QString& name);

}  // namespace croquis::app
