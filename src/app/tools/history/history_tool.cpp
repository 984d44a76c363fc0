// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/history/history_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QStyleOptionSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <tuple>

#include "app/files/mesh_export.h"
#include "app/views/offscreen_pictures.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/panel_docks.h"
#include "croquis/geometry/joined_meshes.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/workspace/computed.h"

namespace croquis::app {
namespace {

constexpr QSize step_picture(96, 72), version_icon(64, 48);
constexpr std::size_t most_pictures = 200;
constexpr int idle_ms = 400;  // nothing has happened for that long

QString text_of(const Version& version) { return QString::fromStdString(version.name); }

/// A name that is taken gets a number.
QString free_version_name(const std::vector<Version>& versions, const QString& wanted, int except = -1) {
  QStringList taken;
  for (const Version& version : versions) taken << text_of(version);
  if (except >= 0) taken.removeAt(except);
  QString name = wanted.trimmed();
  for (int number = 2; taken.contains(name); ++number) name = QString("%1 %2").arg(wanted.trimmed()).arg(number);
  return name;
}

QListWidget* make_version_list() {
  auto* list = new QListWidget;
  list->setObjectName("versions");
  list->setAccessibleName(HistoryTool::tr("Versions"));
  list->setIconSize(version_icon);
  list->setMinimumHeight(version_icon.height() + 8);
  list->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list->setToolTip(HistoryTool::tr("A version: click shows it, the right button what can be done"));
  list->hide();
  return list;
}

}  // namespace

StepSlider::StepSlider(std::function<QImage(int)> picture) : QSlider(Qt::Horizontal), picture_of_(std::move(picture)) {
  setObjectName("history-slider");
  setAccessibleName(tr("Steps of the history"));
  setToolTip(tr("Drag to go through the steps of the history"));
}

QRect StepSlider::handle() const {
  QStyleOptionSlider option;
  initStyleOption(&option);
  return style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
}

bool StepSlider::event(QEvent* event) {
  const bool taken = QSlider::event(event);
  if (event->type() == QEvent::Enter) show_picture();
  if (picture_ != nullptr && (event->type() == QEvent::Leave || event->type() == QEvent::Hide)) picture_->hide();
  return taken;
}

/// The handle comes to where the pointer is, and can be dragged from there.
void StepSlider::mousePressEvent(QMouseEvent* event) {
  const QPoint at = event->position().toPoint();
  if (event->button() == Qt::LeftButton && !handle().contains(at)) {
    const int wide = handle().width();
    setValue(QStyle::sliderValueFromPosition(minimum(), maximum(), at.x() - wide / 2, width() - wide));
  }
  QSlider::mousePressEvent(event);
  show_picture();
}

void StepSlider::sliderChange(SliderChange change) {
  QSlider::sliderChange(change);
  if (change == SliderValueChange && (underMouse() || isSliderDown())) show_picture();
}

void StepSlider::show_picture() {
  constexpr int above = 4;
  const QImage image = picture_of_(value());
  if (picture_ == nullptr) picture_ = new QLabel(window());
  picture_->setObjectName("history-picture");
  picture_->setFrameShape(QFrame::Box);
  picture_->setPixmap(QPixmap::fromImage(image));
  picture_->adjustSize();
  const QPoint at = mapTo(window(), QPoint(handle().center().x() - picture_->width() / 2, -above));
  picture_->move(std::min(at.x(), window()->width() - picture_->width()), at.y() - picture_->height());
  picture_->raise();
  picture_->setVisible(!image.isNull());
}

HistoryTool::HistoryTool(ToolHost& host) : Tool(host), comparison_(host) {
  pause_.setSingleShot(true);
  pause_.setInterval(idle_ms);
  connect(&pause_, &QTimer::timeout, this, &HistoryTool::take_picture);
  connect(&studio(), &Studio::loaded, this, [this] {
    pictures_.clear();
    comparison_.stop();
  });
  connect(&comparison_, &DocumentComparison::changed, this, [this] { emit changed(); });
}

void HistoryTool::make_actions(ActionList& actions) {
  QMenu* menu = actions.menu(MenuId::Edit);
  QAction* after = host().action("delete");
  QAction* save = actions.add(
      menu, "save-version", tr("Save version…"), {}, [this] { ask_name(); }, Recorded::ByItself);
  QAction* compare =
      actions.add(menu, "compare-version", tr("Compare with the chosen version"), {}, [this] { toggle_comparing(); });
  compare->setCheckable(true);
  menu->insertActions(after, {save, compare});
  menu->insertSeparator(after);
}

void HistoryTool::make_panels(PanelDocks& panels) {
  slider_ = new StepSlider([this](int step) {
    const auto history = studio().session().history();
    const auto place = static_cast<std::size_t>(step);
    return place < history.size() ? picture(history[place].state) : QImage();
  });
  steps_ = new HistoryList;
  versions_ = make_version_list();
  QDockWidget* dock = panels.add_column(tr("History"), slider_, "history");
  panels.tabify("findings", dock);
  panels.keep_in_front(dock);
  for (QListWidget* list : {static_cast<QListWidget*>(steps_), versions_}) {
    panels.add_to_column("history", list);
    list->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list, &QWidget::customContextMenuRequested, this, [this, list](const QPoint& at) { show_menu(*list, at); });
  }
  connect(slider_, &QSlider::valueChanged, this, [this](int step) { go_to(step, slider_->isSliderDown()); });
  connect(slider_, &QSlider::sliderReleased, this, [this] { go_to(slider_->value(), false); });
  connect(steps_, &HistoryList::step_chosen, this, [this](int step) { go_to(step, false); });
  const auto take = [this](auto signal, auto work, Qt::ConnectionType when) {
    connect(
        versions_, signal, this, [this, work](QListWidgetItem* row) { work(versions_->row(row), row); }, when);
  };
  take(
      &QListWidget::itemClicked, [this](int row, QListWidgetItem*) { show_version(row); }, Qt::DirectConnection);
  // All rows are shown again.
  take(
      &QListWidget::itemChanged, [this](int row, QListWidgetItem* item) { rename_version(row, item->text()); },
      Qt::QueuedConnection);
}

void HistoryTool::refresh() {
  const Session& session = studio().session();
  const auto done = session.undo_labels(), undone = session.redo_labels();
  steps_->show_history(done, undone);
  {
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, static_cast<int>(done.size() + undone.size()));
    // While it is dragged it may be ahead of the document.
    if (!slider_->isSliderDown()) slider_->setValue(static_cast<int>(done.size()));
  }
  slider_->setEnabled(slider_->maximum() > 0);
  if (std::exchange(versions_state_, session.versions.state()) != versions_state_) show_versions();
  // Other arrangements of the views end it.
  if (host().views().layout.arrangement() != Arrangement::Compare) comparison_.stop();
  QAction* compare = host().action("compare-version");
  compare->setChecked(comparison_.shown());
  compare->setEnabled(comparison_.shown() || versions_->count() > 0 || session.can_undo());
  host().action("save-version")->setEnabled(!session.document().nodes().empty());
}

void HistoryTool::follow(Change) {
  pause_.start();
  comparison_.follow();
}

// ---- Steps

/// While the slider is dragged, only what is computed already is shown.
void HistoryTool::go_to(int step, bool dragging) {
  Session& session = studio().session();
  const auto history = session.history();
  const auto wanted = static_cast<std::size_t>(step);
  const std::size_t before = session.undo_labels().size();
  if (wanted >= history.size() || wanted == before) return;
  if (dragging && !is_computed(studio(), history[wanted].document)) return;
  app::abandon(host().views());
  session.go_to(wanted);
  const std::size_t after = session.undo_labels().size();
  for (std::size_t i = std::min(before, after); i < std::max(before, after); ++i)
    host().record(recorded::Action{after < before ? "undo" : "redo"});
}

QImage HistoryTool::picture(std::uint64_t state) const {
  const auto found = pictures_.find(state);
  return found == pictures_.end() ? QImage() : found->second;
}

/// When nothing else happens; on other threads, so that nobody waits for it.
void HistoryTool::take_picture() {
  const Views& views = host().views();
  const std::uint64_t state = studio().session().state();
  const bool works = studio().busy() || views.objects.busy() || any_down(views) || picturing_.runs();
  if (works || !host().shows_views() || pictures_.contains(state)) return;
  auto items = views.objects.surfaces();
  if (items.empty()) return;
  picturing_.start([&pictures = host().pictures(), items = std::move(items)](
                       Progress&) { return pictures.draw_small(items, render::NamedView::Perspective, step_picture); },
                   [this, state, document = studio().session().document()](const std::optional<QImage>& image) {
                     keep_picture(state, document, image.value_or(QImage()));
                   });
}

/// Also in versions of that document that were saved before.
void HistoryTool::keep_picture(std::uint64_t state, const Document& document, const QImage& image) {
  pictures_[state] = image;
  if (pictures_.size() > most_pictures) pictures_.erase(pictures_.begin());
  pause_.start();  // there may be another document by now
  Versions& kept = studio().session().versions;
  std::vector<Version> versions = kept.list();
  bool is_new = false;
  for (Version& version : versions) {
    if (!version.picture_png.empty() || !same_nodes(version.document, document) || image.isNull()) continue;
    version.picture_png = png_bytes(image);
    is_new = true;
  }
  if (is_new) kept.set(std::move(versions), true);
}

// ---- Versions

void HistoryTool::show_versions() {
  const QSignalBlocker quiet(versions_);
  const int chosen = versions_->currentRow();
  versions_->clear();
  for (const Version& version : studio().session().versions.list()) {
    QPixmap picture(version_icon);
    picture.fill(Qt::transparent);
    if (!version.picture_png.empty())
      picture.loadFromData(version.picture_png.data(), static_cast<uint>(version.picture_png.size()));
    auto* row = new QListWidgetItem(picture, text_of(version), versions_);
    row->setFlags(row->flags() | Qt::ItemIsEditable);
  }
  versions_->setCurrentRow(std::min(chosen, versions_->count() - 1));
  versions_->setVisible(versions_->count() > 0);
}

/// Of a step or a version.
void HistoryTool::show_menu(const QListWidget& list, const QPoint& at) {
  const int row = list.indexAt(at).row();
  if (row < 0) return;
  auto* menu = new QMenu(versions_);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const bool version = &list == versions_;
  if (version) menu->addAction(tr("Show"), this, [this, row] { show_version(row); });
  menu->addAction(tr("Compare"), this, [this, row, version] { compare(version ? row : -1, row); });
  if (version) menu->addAction(tr("Rename"), this, [this, row] { versions_->editItem(versions_->item(row)); });
  if (version) menu->addAction(tr("Delete"), this, [this, row] { delete_version(row); });
  menu->popup(list.viewport()->mapToGlobal(at));
}

void HistoryTool::ask_name() {
  const std::vector<Version>& versions = studio().session().versions.list();
  auto* dialog = new QInputDialog(host().views().widget.window());
  dialog->setObjectName("version-name");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Save version"));
  dialog->setLabelText(tr("Name of the model as it is now:"));
  dialog->setTextValue(free_version_name(versions, tr("Version %1").arg(versions.size() + 1)));
  connect(dialog, &QInputDialog::textValueSelected, this, &HistoryTool::save_version);
  dialog->open();
}

void HistoryTool::save_version(const QString& name) {
  Session& session = studio().session();
  if (name.trimmed().isEmpty()) return host().say(tr("A version needs a name."));
  std::vector<Version> versions = session.versions.list();
  const QImage image = picture(session.state());
  versions.push_back({free_version_name(versions, name).toStdString(), session.document()});
  if (!image.isNull()) versions.back().picture_png = png_bytes(image);
  session.versions.set(std::move(versions));
  take_picture();
  host().say(tr("The version \"%1\" is saved. The panel History shows it again, and the project keeps it.")
                 .arg(text_of(session.versions.list().back())));
}

void HistoryTool::show_version(int version) {
  app::abandon(host().views());
  const Version shown = studio().session().versions.list()[static_cast<std::size_t>(version)];
  studio().session().edit(tr("Version %1").arg(text_of(shown)).toStdString(), shown.document);
}

void HistoryTool::rename_version(int version, const QString& name) {
  std::vector<Version> versions = studio().session().versions.list();
  if (version < 0 || static_cast<std::size_t>(version) >= versions.size()) return;
  std::string& own = versions[static_cast<std::size_t>(version)].name;
  if (!name.trimmed().isEmpty()) own = free_version_name(versions, name, version).toStdString();
  studio().session().versions.set(std::move(versions));
}

void HistoryTool::delete_version(int version) {
  std::vector<Version> versions = studio().session().versions.list();
  const QString question =
      tr("Delete the version \"%1\"? This can't be undone.").arg(text_of(versions[static_cast<std::size_t>(version)]));
  QWidget* window = host().views().widget.window();
  if (QMessageBox::question(window, tr("Delete version"), question) != QMessageBox::Yes) return;
  versions.erase(versions.begin() + version);
  studio().session().versions.set(std::move(versions));
}

// ---- Two states beside each other

/// Without a version it is the step before.
void HistoryTool::toggle_comparing() {
  if (comparison_.shown()) return comparison_.stop();
  const int chosen = versions_->currentRow();
  compare(chosen < 0 ? versions_->count() - 1 : chosen, slider_->value() - 1);
}

/// @param version -1: the step
void HistoryTool::compare(int version, int step) {
  const Session& session = studio().session();
  if (version < 0 && step < 0) return;
  if (version >= 0) {
    const Version& chosen = session.versions.list()[static_cast<std::size_t>(version)];
    comparison_.start(text_of(chosen), chosen.document);
  } else {
    const auto history = session.history();
    comparison_.start(steps_->item(step)->text(), history[static_cast<std::size_t>(step)].document);
  }
  host().refresh();
}

ViewUse HistoryTool::use_of(int view) const { return {.title = comparison_.title(view)}; }

void HistoryTool::adjust(ObjectScenes::Wanted& wanted, int view) const {
  if (comparison_.shown() && view == ComparisonView) wanted.instead = comparison_.item();
}

void DocumentComparison::start(const QString& name, const Document& document) {
  Views& views = host_.views();
  // One of them has the second view.
  if (QAction* schemes = host_.action("compare"); schemes->isChecked()) schemes->trigger();
  if (!shown()) layout_before_ = {views.layout.arrangement(), views.layout.alone()};
  name_ = name;
  document_ = document;
  made_ = false;
  other_ = present_ = {};
  views.layout.arrange(Arrangement::Compare);
  show_scene(views);
  follow();
}

void DocumentComparison::stop() {
  if (!shown()) return;
  name_.reset();
  job_.cancel();
  PaneLayout& layout = host_.views().layout;
  if (layout.arrangement() == Arrangement::Compare) layout.arrange(layout_before_.first, layout_before_.second);
  host_.action("compare-version")->setChecked(false);
  emit changed();
}

void DocumentComparison::follow() {
  const Document& now = host_.studio().session().document();
  if (!shown() || host_.studio().busy() || (made_ && same_nodes(now_, now))) return;
  now_ = now;
  made_ = true;
  job_.start(
      [this, document = document_, now, &known = host_.studio()](Progress& progress) {
        const Side other = side_of(document, known, own_, progress);
        return std::pair(other, side_of(now, known, own_, progress));
      },
      [this](const std::optional<std::pair<Side, Side>>& sides) {
        std::tie(other_, present_) = sides.value_or(std::pair<Side, Side>());
        emit changed();
      });
}

/// What a document shows, as one mesh.
DocumentComparison::Side DocumentComparison::side_of(const Document& document, const Workspace& known, Evaluator& own,
                                                     Progress& progress) {
  std::vector<NamedMesh> meshes;
  for (const WorkObject& object : objects_of(document, known.registry())) {
    if (!object.visible) continue;
    auto mesh = final_mesh(known, document, object.node);
    if (!mesh) {
      const auto evaluation = own.evaluate(document, object.node, Quality::Final, progress);
      mesh = mesh_of(*evaluation, *known.description(document.find(object.node)->operation));
    }
    if (mesh) meshes.push_back({object.name, mesh, object.placement.map()});
  }
  if (meshes.empty()) return {};
  const PolyMesh whole = joined(meshes);
  render::MeshItemOptions looks;
  looks.use_normal_channel = whole.channel("normal", Domain::Corner) != nullptr;
  return {render::make_mesh_item(whole, looks), inspect(whole, false, progress)};
}

QString DocumentComparison::title(int view) const {
  if (!shown() || (view != PerspectiveView && view != ComparisonView)) return {};
  const bool other = view == ComparisonView;
  const QString name = other ? *name_ : tr("Now");
  if (busy() || !made_) return name;
  const auto& figures = other ? other_.figures : present_.figures;
  const QString unit = QString::fromStdString(host_.studio().unit());
  return tr("%1: %2").arg(name, figures ? summary_of(*figures, unit) : tr("no faces"));
}

}  // namespace croquis::app
