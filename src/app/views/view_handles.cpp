// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_handles.h"

#include <QMouseEvent>
#include <QToolButton>
#include <cmath>

#include "app/views/views.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

using Kind = CameraMotion::Kind;

constexpr int handle_size = 24, icon_size = 14, handle_gap = 4, corner_gap = 10;
constexpr double zoom_per_pixel = 0.01;  // up comes nearer
constexpr const char* handle_style =
    "QToolButton { background: rgba(255, 255, 255, 150); border: 1px solid #b4bac4; border-radius: 12px }"
    " QToolButton:hover { background: white; border-color: #6a7280 } QToolButton:pressed { background: #ffe2a8 }";

class ViewHandle final : public QToolButton {
 public:
  ViewHandle(Views& views, Kind kind) : QToolButton(&views.widget), views_(views), kind_(kind) {}

  QSize sizeHint() const override { return {handle_size, handle_size}; }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void mousePressEvent(QMouseEvent* event) override {
    QToolButton::mousePressEvent(event);
    held_ = views_.under_pointer;
    last_ = event->globalPosition();
  }

  void mouseMoveEvent(QMouseEvent* event) override {
    if (!isDown()) return QToolButton::mouseMoveEvent(event);
    const QPointF by = event->globalPosition() - last_;
    last_ = event->globalPosition();
    const QRectF& view = views_.layout.pane(held_).rect;
    const double factor = kind_ == Kind::Dolly ? std::exp(zoom_per_pixel * (by.x() - by.y())) : 1;
    move_view(views_, {kind_, {by.x(), by.y()}, factor, {view.width() / 2, view.height() / 2}, held_});
  }

 private:
  Views& views_;
  Kind kind_;
  int held_ = 0;  ///< the view that is moved
  QPointF last_;
};

}  // namespace

ViewHandles::ViewHandles(Views& views) : views_(views) {
  const std::array<const char*, 3> names{"rotate-view", "pan-view", "zoom-view"};
  const std::array icons{"rotate", "move", "scale"};
  const std::array<Kind, 3> kinds{Kind::Tumble, Kind::Track, Kind::Dolly};
  for (std::size_t k = 0; k < buttons_.size(); ++k) {
    QToolButton* button = buttons_[k] = new ViewHandle(views, kinds[k]);
    button->setObjectName(names[k]);
    button->setFixedSize(button->sizeHint());
    button->setIconSize({icon_size, icon_size});
    button->setFocusPolicy(Qt::NoFocus);
    button->setStyleSheet(handle_style);
    button->setIcon(paper_icon(icons[k]));
    button->hide();
  }
}

void ViewHandles::place(ChipPlaces& places) {
  const std::array tips{Views::tr("Drag to rotate the view"), Views::tr("Drag to pan the view"),
                        Views::tr("Drag up or down to zoom")};
  const ViewPane& pane = views_.layout.pane(views_.under_pointer);
  const bool is_flat = views_.under_pointer != PerspectiveView && views_.under_pointer != ComparisonView;
  QPointF at = pane.rect.bottomLeft() + QPointF(corner_gap, -corner_gap - handle_size);
  for (std::size_t k = 0; k < buttons_.size(); ++k) {
    buttons_[k]->setToolTip(tips[k]);
    buttons_[k]->setAccessibleName(tips[k]);
    if (!pane.visible() || (k == 0 && is_flat)) {
      buttons_[k]->hide();
      continue;
    }
    places.put(*buttons_[k], at, pane.rect);
    at.rx() += handle_size + handle_gap;
  }
}

}  // namespace croquis::app
