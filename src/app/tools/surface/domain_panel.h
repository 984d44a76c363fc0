// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <string>

#include "app/tools/surface/domain_view.h"
#include "app/tools/surface/network_interaction.h"

class QAction;
class QLabel;

namespace croquis::app {

/// The plane polygon that a patch is a map of, with what lies in it, and the numbers of the comparison with a uniform
/// one.
class DomainPanel : public QWidget {
  Q_OBJECT

 public:
  /// @param compare the action that shows the uniform domain, too
  DomainPanel(NetworkInteraction& network, const UniformGhost& ghost, QAction* compare);

  /// After the document, a result, the selection or the pointer's place has changed.
  void follow();

  /// The face whose domain is shown: the selected one, that of the selected point, the one under the pointer, else the
  /// one shown last; empty for none.
  const std::string& face() const { return face_; }
  const DomainView& view() const { return *view_; }

 private:
  std::string wanted_face() const;
  QString numbers_text() const;
  QString points_text() const;

  NetworkInteraction& network_;
  const UniformGhost& ghost_;
  std::string face_;
  DomainView* view_;
  QLabel* title_;
  QLabel* numbers_;
};

}  // namespace croquis::app
