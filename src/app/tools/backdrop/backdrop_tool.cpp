// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/backdrop/backdrop_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMetaObject>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>
#include <span>
#include <utility>

#include "app/files/file_reader.h"
#include "app/replay/replays.h"
#include "app/tools/scene_parts.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/panel_docks.h"
#include "app/window/theme.h"
#include "croquis/tools/backdrop/backdrop_steps.h"

namespace croquis::app {
namespace {

render::PictureItemPtr made_of(const PictureFile& picture) {
  const QImage image = decoded(picture, render::max_picture_item_side);
  if (image.isNull()) return nullptr;
  // RGBA8888 has 4 bytes a pixel, so its rows have no padding.
  return render::make_picture_item(std::span(image.constBits(), static_cast<std::size_t>(image.sizeInBytes())),
                                   image.width(), image.height());
}

constexpr double percent = 0.01;

int to_percent(double share) { return static_cast<int>(std::lround(share / percent)); }

constexpr float corner_size = 9;  // logical pixels

/// The picture's border and its corners, which can be dragged.
void add_frame(const Backdrop& backdrop, render::Scene& scene) {
  const BackdropArea area = area_of(backdrop);
  const std::vector<Vec2> corners = corners_of_box(area.low, area.high);
  std::vector<render::Mark> marks;
  for (const Vec2& corner : corners)
    marks.push_back({on_plane(corner), render::MarkShape::Square, corner_size, to_color(colors::accent)});
  const render::LineStyle style{1.5, to_color(colors::accent), {6, 4, 0, 0}};
  add_items(scene, {lines_of({path_of(corners, on_plane, true)}, style)}, {marks_of(marks)});
}

}  // namespace

render::PictureItemPtr PictureItems::item(const std::shared_ptr<const PictureFile>& picture) {
  std::erase_if(items_, [](const auto& entry) { return entry.first.expired(); });
  const auto [place, is_new] = items_.try_emplace(picture);
  if (!is_new) return place->second;
  ++making_;
  thread_.start([this, picture] {
    render::PictureItemPtr item = made_of(*picture);
    QMetaObject::invokeMethod(
        this,
        [this, picture, item] {
          --making_;
          items_[picture] = item;
          emit ready();
        },
        Qt::QueuedConnection);
  });
  return nullptr;
}

BackdropTool::BackdropTool(ToolHost& host) : Tool(host, "Pictures to trace"), editor_(host.studio().session()) {
  connect(&items_, &PictureItems::ready, this, [this] { emit changed(); });
}

void BackdropTool::make_actions(ActionList& actions) {
  QMenu* menu = actions.menu(MenuId::Sketch)->addMenu(tr("Picture behind the drawing"));
  const auto add = [&](const QString& name, const QString& text, const QString& button, std::function<void()> work) {
    QAction* action = actions.add(
        menu, name, text, {}, [this, work = std::move(work)] { host().attempt(work); }, Recorded::ByItself);
    action->setIconText(button);
    return action;
  };
  add("open-picture", tr("Open a picture…"), tr("Replace…"), [this] { ask_picture(); });
  add("show-picture", tr("Show"), tr("Show"), [this] {
    change(tr("Show picture"), [this](Backdrop& b) { b.visible = host().action("show-picture")->isChecked(); });
  })->setCheckable(true);
  add("fit-picture", tr("Fit to the sheet or the strokes"), tr("Fit"), [this] { do_and_record(editor_.fit()); });
  actions
      .add(menu, "move-picture", tr("Move and scale"), {},
           [this] { host().set_mode(mode_ == "move-picture" ? first_mode : QStringLiteral("move-picture")); })
      ->setCheckable(true);
  host().action("move-picture")->setIconText(tr("Move"));
  add("remove-picture", tr("Remove"), tr("Remove"), [this] { do_and_record(editor_.remove()); });
}

void BackdropTool::make_panels(PanelDocks& docks) {
  panel_ = make_panel();
  dock_ = docks.add(tr("Picture"), panel_, "picture");
  docks.tabify("history", dock_);
  docks.set_useful(dock_, false);
  docks_ = &docks;
}

/// The picture by numbers. It follows while there is one.
Panel* BackdropTool::make_panel() {
  auto* panel = new Panel("backdrop-panel");
  QLabel* name = panel->label({});
  name->setObjectName("backdrop-name");
  panel->column()->addWidget(name);
  panel->also([this, name] {
    const PictureFile& picture = *editor_.backdrop()->picture;
    name->setText(tr("%1, %2 × %3")
                      .arg(QFileInfo(QString::fromStdString(picture.file)).fileName())
                      .arg(picture.width)
                      .arg(picture.height));
  });
  add_opacity(*panel);
  const auto place = [this](auto edit) {
    return
        [this, edit](double value) { change(tr("Place picture"), [&](Backdrop& backdrop) { edit(backdrop, value); }); };
  };
  auto* grid = new QGridLayout;
  grid->addWidget(panel->label(tr("Middle x, y")), 0, 0);
  for (const int axis : {0, 1}) {
    grid->addWidget(panel->number(
                        QString("backdrop-") + QChar('x' + axis), {-1e7, 1e7, 2},
                        [this, axis] { return Panel::Number{editor_.backdrop()->centre[axis]}; },
                        place([axis](Backdrop& backdrop, double value) { backdrop.centre[axis] = value; })),
                    0, 1 + axis);
  }
  grid->addWidget(panel->label(tr("Scale")), 1, 0);
  QDoubleSpinBox* scale = panel->number(
      "backdrop-scale", {1e-3, 1e5, 3}, [this] { return Panel::Number{editor_.backdrop()->scale / percent}; },
      place([](Backdrop& backdrop, double value) { backdrop.scale = value * percent; }),
      tr("At 100 % a pixel of the picture is one unit of the drawing"));
  scale->setSuffix(QStringLiteral(" %"));
  grid->addWidget(scale, 1, 1, 1, 2);
  panel->column()->addLayout(grid);
  panel->buttons({"show-picture", "fit-picture", "move-picture", "open-picture", "remove-picture"}, 3,
                 Qt::ToolButtonTextOnly, [this](const QString& action) { return host().action(action); });
  panel->column()->addStretch();
  return panel;
}

/// While the slider is held down it is one change.
void BackdropTool::add_opacity(Panel& panel) {
  QSlider* opacity = panel.slider(
      "backdrop-opacity", 0, 100, [this] { return to_percent(editor_.backdrop()->opacity); },
      [this](int value, bool dragging) {
        const auto now = editor_.backdrop();
        if (!now) return;
        Backdrop edited = *now;
        edited.opacity = value * percent;
        if (value != to_percent(now->opacity)) editor_.change("Opacity of the picture", edited);
        if (!dragging) do_and_record(editor_.finish());
      },
      tr("How strongly the picture is seen behind the drawing"));
  panel.row({panel.label(tr("Opacity")), opacity});
}

void BackdropTool::change(const QString& label, const std::function<void(Backdrop&)>& edit) {
  const auto now = editor_.backdrop();
  if (!now) return;
  Backdrop edited = *now;
  edit(edited);
  host().attempt([&] { do_and_record(editor_.set(label.toStdString(), edited)); });
}

void BackdropTool::do_and_record(Verdict verdict) {
  if (verdict == Verdict::Commit) emit committed(*editor_.done());
}

void BackdropTool::ask_picture() {
  const QString path = QFileDialog::getOpenFileName(&host().viewport(), tr("Open a picture"), QString(),
                                                    tr("Pictures (%1)").arg(picture_patterns()));
  if (!path.isEmpty()) host().open_file(path);
}

void BackdropTool::refresh() {
  const auto backdrop = editor_.backdrop();
  for (const char* name : {"show-picture", "fit-picture", "move-picture", "remove-picture"})
    host().action(name)->setEnabled(backdrop != nullptr);
  host().action("show-picture")->setChecked(backdrop != nullptr && backdrop->visible);
  host().action("move-picture")->setChecked(moves());
  docks_->set_useful(dock_, backdrop != nullptr);
  panel_->setEnabled(backdrop != nullptr);
  if (backdrop) panel_->follow();
}

void BackdropTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  editor_.give_up();
  emit state_changed();
}

void BackdropTool::feed(const std::vector<PenStep>& steps) {
  for (const PenStep& step : steps)
    do_and_record(editor_.handle(to_sketch(step, host().viewport().pane(SketchView).sketch_frame())));
}

ToolWords BackdropTool::words() const {
  return {tr("Drag the picture to move it, a corner to scale it · D draws · Q selects")};
}

/// Behind the solid that is seen through the camera of its drawing: what was traced lies over it.
void BackdropTool::add_behind_solid(render::Scene& scene) {
  const auto camera = looked_through(host().views());
  const Node* node = camera ? studio().session().document().find(camera->node) : nullptr;
  if (node == nullptr || !node->backdrop || !node->backdrop->visible) return;
  const BackdropArea area = area_of(*node->backdrop);
  const auto place = [&](double x, double y) { return camera->before_the_eye({x, -y}); };
  const glm::dvec3 corner = place(area.low.x(), area.low.y());
  scene.pictures.push_back({items_.item(node->backdrop->picture), corner, place(area.high.x(), area.low.y()) - corner,
                            place(area.low.x(), area.high.y()) - corner, node->backdrop->opacity});
}

void BackdropTool::add_to(render::Scene& scene, int view) {
  if (view == PerspectiveView) return add_behind_solid(scene);
  const auto backdrop = editor_.backdrop();
  if (view != SketchView || !backdrop) return;
  if (moves()) add_frame(*backdrop, scene);
  if (!backdrop->visible) return;
  const BackdropArea area = area_of(*backdrop);
  const Vec2 size = area.high - area.low;
  scene.pictures.push_back({items_.item(backdrop->picture), on_plane(area.low), glm::dvec3(size.x(), 0, 0),
                            glm::dvec3(0, size.y(), 0), backdrop->opacity});
}

ViewUse BackdropTool::use_of(int view) const {
  ViewUse use{.works = view == SketchView && moves(), .cursor = Qt::SizeAllCursor};
  const auto backdrop = editor_.backdrop();
  if (view != SketchView || !backdrop || !backdrop->visible) return use;
  const BackdropArea area = area_of(*backdrop);
  use.bounds.add(on_plane(area.low));
  use.bounds.add(on_plane(area.high));
  return use;
}

void BackdropTool::follow(Change change) {
  if (change != Change::Document) return;
  editor_.set_node(studio().shown_drawing());
  const auto backdrop = editor_.backdrop();
  const auto picture = backdrop ? backdrop->picture : nullptr;
  const bool is_new = picture && picture != shown_.lock();
  shown_ = picture;
  PaneLayout& layout = host().views().layout;
  if (is_new && host().shows_views() && !layout.pane(SketchView).visible()) layout.arrange(Arrangement::SketchAndSolid);
  if (mode_ == "move-picture" && !picture) host().set_mode(first_mode);
}

void BackdropTool::make_replays(Replays& replays) {
  const auto picture = [this] {
    const auto now = editor_.backdrop();
    if (!now) refuse_replay("There is no picture behind the drawing");
    return now;
  };
  replays.on<recorded::BackdropSetting>([this, picture](const recorded::BackdropSetting& step) {
    editor_.set("Place picture", {picture()->picture, step.centre, step.scale, step.opacity, step.visible});
  });
  replays.on<recorded::BackdropRemoval>([this, picture](const auto&) {
    picture();
    editor_.remove();
  });
  replays.counts["backdrops"] = [this](const std::string&) -> std::size_t { return editor_.backdrop() ? 1 : 0; };
  replays.ranges["backdrop-scale"] = [picture](const std::string&) {
    const double scale = picture()->scale;
    return std::pair(scale, scale);
  };
}

}  // namespace croquis::app
