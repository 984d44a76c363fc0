// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "app/tools/surface/domain_picture.h"

namespace croquis::app {

/// Draws the domain of a face, and the uniform one beside it for comparison.
class DomainView : public QWidget {
  Q_OBJECT

 public:
  explicit DomainView(QWidget* parent = nullptr);

  /// @param uniform none: the own one alone
  void show_domains(std::optional<DomainPicture> own, std::optional<DomainPicture> uniform);

  const std::optional<DomainPicture>& own() const { return own_; }
  const std::optional<DomainPicture>& uniform() const { return uniform_; }

  QSize sizeHint() const override { return {300, 210}; }
  QSize minimumSizeHint() const override { return {160, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<DomainPicture> own_;
  std::optional<DomainPicture> uniform_;
};

}  // namespace croquis::app
