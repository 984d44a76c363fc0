// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/recording/step.h"

namespace croquis::app {

/// One thing that a tour asks for.
struct TourStep {
  QString caption;                      ///< English
  std::vector<recorded::Step> asked;    ///< strokes, actions …, as recordings have them (docs/replays.md)
  std::vector<recorded::Expect> until;  ///< it is done, too, as soon as there are so many, or more, of each
  std::optional<Vec3> at;               ///< a place of the model that gets a ring in the perspective view
};

/// A guided tour: src/app/tours/*.json, docs/adding-a-tour.md.
struct Tour {
  QString title;   ///< English
  QString action;  ///< of the window, that begins the new document; empty: a sample
  QString sample;  ///< that it begins with
  std::vector<TourStep> steps;
  QString end;  ///< English: what people have made, once all is done
};

/// Their names, in the order of the menu.
QStringList tour_names();

/// English. The steps aren't read, which menus have no use for. @throws Error (E_SYNTAX) as load_tour
QString tour_title(const QString& name);

/// @throws Error (E_SYNTAX, E_REPLAY) naming the file and what is wrong in it
Tour load_tour(const QString& name);

}  // namespace croquis::app
