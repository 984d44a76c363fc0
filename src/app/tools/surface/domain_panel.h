// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/panel.h"
#include "app/tools/background_job.h"
#include "app/tools/surface/network.h"
#include "app/tools/surface/network_scene.h"
#include "croquis/attribute_surface/domain_comparison.h"
#include "croquis/attribute_surface/surface_measures.h"
#include "croquis/render/mesh_item.h"

namespace croquis::app {

/// The same network on uniform domains, beside the document: its surfaces as a ghost, and in numbers what the domains
/// make of points. Computed on another thread; the newest wins, and meanwhile what there is stays.
class UniformGhost : public QObject {
  Q_OBJECT

 public:
  bool on() const { return on_; }
  void set_on(bool on);

  /// After a result has come.
  void follow(const ShownSurface& shown);

  /// What was compared; null before the first time and while it is off.
  struct Compared {
    ShownSurface shown;  ///< with which
    DomainComparison comparison;
    SurfaceMeasures measures;  ///< of the uniform one
    render::MeshItemPtr item;  ///< in the world; null where there is no surface
  };
  const Compared* compared() const { return compared_.get(); }
  bool busy() const { return job_.runs(); }

 signals:
  void changed();

 private:
  void begin();
  void take(const std::shared_ptr<const Compared>& made);

  bool on_ = false;
  ShownSurface wanted_;
  std::shared_ptr<const Compared> compared_;
  BackgroundJob job_;
};

/// The domain of a face with what lies in it.
struct DomainPicture {
  struct Side {
    QString name;         ///< of its curve
    bool smooth = false;  ///< the patch beside it goes on there
  };
  struct Point {
    QString name;
    Vec2 place = Vec2::Zero();
    double radius = 0;  ///< parts of the perimeter
    bool selected = false;
  };
  DomainPolygon polygon;
  std::vector<Side> sides;  ///< one for each side of the polygon
  std::vector<Point> points;
  std::vector<std::vector<Vec2>> curves;  ///< footprints of inner curves
  std::optional<Vec2> pointer;            ///< the place under the pointer, or being dragged
};

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

/// The plane polygon that a patch is a map of, with what lies in it, and the numbers of the comparison with a uniform
/// one. It follows the document, results, the selection and the pointer's place.
Panel* make_domain_panel(DrawnNetwork& drawn, const UniformGhost& ghost);

}  // namespace croquis::app
