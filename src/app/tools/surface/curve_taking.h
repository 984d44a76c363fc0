// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "app/studio/studio.h"

namespace croquis::app {

/// Curves taken from the active object by an operation: of its strokes, its edges. They become a network of their own,
/// to be worked on. Computed beside the document, on another thread.
class CurveTaking : public QObject {
  Q_OBJECT

 public:
  explicit CurveTaking(Studio& studio) : studio_(studio) {}

  /// Operations that make networks, in the registry's order.
  std::vector<const OperationDescription*> ways() const;

  /// Whether the active object, or a step of its chain, is something that the operation takes.
  bool can_take(const OperationDescription& operation) const;

  /// Begins; what an earlier call began is given up.
  void take(const std::string& operation);

  bool busy() const { return live_ != nullptr; }

 signals:
  void taken();  ///< the network is in the document
  void failed(const croquis::Findings& findings);

 private:
  std::optional<Link> source_for(const OperationDescription& operation) const;
  void follow();

  Studio& studio_;
  std::string name_;     ///< of the network that comes …
  Placement placement_;  ///< … and where it stands
  std::unique_ptr<LiveNode> live_;
};

}  // namespace croquis::app
