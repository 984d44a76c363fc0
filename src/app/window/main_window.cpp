// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <memory>
#include <utility>

#include "app/files/file_reader.h"
#include "app/replay/replay_player.h"
#include "app/start/gallery.h"
#include "app/start/start_page.h"
#include "app/tours/tour_bar.h"
#include "app/views/viewport.h"
#include "app/window/help_line.h"
#include "app/window/help_pages.h"
#include "app/window/language.h"
#include "app/window/panel_docks.h"
#include "app/window/tool_movies.h"

namespace croquis::app {
namespace {

constexpr int progress_pause_ms = 200;
constexpr std::size_t most_steps = 1000;  // a stroke of the pen has some kilobytes

/// The next action, in words and keys.
void show_help(MainWindow& window) {
  WindowParts& parts = window.parts();
  const QString on_start_page =
      parts.has_shown_views ? QObject::tr("Escape goes back to what was open; or choose a sketch, or press Ctrl+N")
                            : QObject::tr("Choose a sketch, or press Ctrl+N and draw");
  parts.help->show_help(window.shows_views() ? help_of(parts.viewport->views()) : on_start_page);
}

/// Something is being computed, read or written.
bool is_busy(WindowParts& parts) {
  return parts.studio.busy() || parts.files.reader().busy() || parts.files.step_export().busy();
}

/// A tool may take back what it had begun.
void stop_work(WindowParts& parts) {
  parts.files.reader().cancel();
  parts.files.step_export().cancel();
  const bool was_busy = parts.studio.busy();
  parts.studio.cancel();
  if (!was_busy) return;
  for (const auto& tool : parts.tools) tool->command(EditCommand::Cancel);
}

/// What has been added since the last call is explained where the manual is about it.
void note_topic(MainWindow& window, const QString& heading) {
  QList<QObject*> all;
  for (QAction* action : window.actions()) all << action;
  for (QDockWidget* dock : window.parts().docks->all()) all << dock;
  for (QObject* each : all) {
    if (!each->property("topic").isValid()) each->setProperty("topic", heading);
  }
}

/// The line below the views, with the progress of what is busy.
void add_help_line(MainWindow& window) {
  WindowParts& parts = window.parts();
  parts.help = new HelpLine(&window);
  auto* progress = new QProgressBar(&window);
  progress->setObjectName("progress");
  progress->setRange(0, 1000);
  progress->setFixedWidth(220);
  auto* cancel = new QPushButton(QObject::tr("Cancel"), &window);
  cancel->setObjectName("cancel");
  QObject::connect(cancel, &QPushButton::clicked, &window, [&parts] { stop_work(parts); });
  window.statusBar()->addWidget(parts.help, 1);
  window.statusBar()->addPermanentWidget(progress);
  window.statusBar()->addPermanentWidget(cancel);
  progress->hide();
  cancel->hide();
  const auto follow = [&window, since = std::make_shared<QElapsedTimer>(), progress, cancel](auto& work) {
    using Work = std::remove_reference_t<decltype(work)>;
    QObject::connect(&work, &Work::busy_changed, &window, [&window, progress, cancel] {
      const bool busy = is_busy(window.parts());
      if (busy && !progress->isVisible()) progress->setValue(0);
      progress->setVisible(busy);
      cancel->setVisible(busy);
    });
    QObject::connect(&work, &Work::progress_changed, &window, [since, progress](double fraction, const QString& step) {
      if (since->isValid() && !since->hasExpired(progress_pause_ms)) return;
      since->start();
      // By itself the bar draws the whole window at once; so it is drawn with what else has changed.
      progress->setUpdatesEnabled(false);
      progress->setValue(static_cast<int>(fraction * progress->maximum()));
      progress->setFormat(capitalized(localized(step.toStdString())));
      progress->setUpdatesEnabled(true);
    });
  };
  follow(parts.studio);
  follow(parts.files.reader());
  follow(parts.files.step_export());
}

void add_tools(MainWindow& window) {
  WindowParts& parts = window.parts();
  parts.tools = all_tools(window);
  note_topic(window, QStringLiteral("Objects and their steps"));
  std::vector<Tool*> tools;
  for (const auto& tool : parts.tools) {
    tool->make_actions(*parts.actions);
    note_topic(window, tool->help_topic);
    tools.push_back(tool.get());
  }
  for (Tool* tool : tools) {
    tool->make_panels(*parts.docks);
    note_topic(window, tool->help_topic);
    QObject::connect(tool, &Tool::state_changed, &window, &MainWindow::refresh);
  }
  set_tools(parts.viewport->views(), std::move(tools));
}

void follow_views(MainWindow& window) {
  const Views* views = &window.views();
  QObject::connect(views, &Views::committed, &window, &MainWindow::record);
  QObject::connect(views, &Views::help_changed, &window, [&window] { show_help(window); });
  QObject::connect(views, &Views::look_through_changed, &window, [&window] { show_cameras(window); });
  window.viewport().installEventFilter(&window);
}

constexpr QSize first_size(1440, 900);

void enable_groups(MainWindow& window, bool enabled) {
  for (QActionGroup* group : window.findChildren<QActionGroup*>()) group->setEnabled(enabled);
}

void enter_views(MainWindow& window) {
  WindowParts& parts = window.parts();
  parts.thumbnails->stop();
  enable_groups(window, true);
  // The views come last: each change of their size costs a picture.
  window.findChild<QToolBar*>("tools")->show();
  parts.docks->show_all(true);
  parts.pages->setCurrentWidget(parts.viewport);
  // Other bars are shown now: later it would move the views under the pen.
  for (const auto& tool : parts.tools) tool->refresh();
  parts.viewport->setFocus();
  window.refresh();
}

void start_sample(MainWindow& window, const QString& name) {
  if (!may_discard(window) || !window.attempt([&] { window.files().start_sample(name); })) return;
  show_opened(window);
  for (const auto& tool : window.tools()) tool->follow(Change::Opened);
  if (const QString first = first_action_of_sample(name); !first.isEmpty()) window.action(first)->trigger();
}

void recover_work(MainWindow& window, const RecoveryOffer& offer) {
  if (!may_discard(window) || !window.attempt([&] { window.files().recover(offer); })) return;
  show_opened(window);
  report_opening(window, offer.project, window.files().warnings());
}

void discard_work(MainWindow& window, const std::vector<RecoveryOffer>& offers) {
  window.attempt([&] {
    for (const RecoveryOffer& each : offers) discard(each);
  });
  window.parts().start_page->show_recoverable(window.files().recoverable());
}

/// Further buttons below those of the tools, or beside them where a low window has no room for both.
void place_bars(MainWindow& window) {
  const auto* tools = window.findChild<QToolBar*>("tools");
  const int room = window.height() - window.menuBar()->sizeHint().height() - window.statusBar()->sizeHint().height();
  for (QToolBar* bar : window.findChildren<QToolBar*>()) {
    const bool beside = tools->sizeHint().height() + bar->sizeHint().height() > room;
    if (bar == tools || beside == window.toolBarBreak(bar)) continue;
    if (beside) {
      window.insertToolBarBreak(bar);
    } else {
      window.removeToolBarBreak(bar);
    }
  }
}

void give_first_size(QWidget& window) {
  window.resize(first_size);
  fit_to_screen(window);
}

void follow_start_page(MainWindow& window) {
  StartPage* page = window.parts().start_page;
  for (QAction* one : window.actions()) {
    if (one->objectName().startsWith("new-")) page->add_start(*one);
    if (one->objectName().startsWith("help-tour-")) page->add_tour(*one);
  }
  const auto take = [&window, page](auto signal, auto work) { QObject::connect(page, signal, &window, work); };
  take(&StartPage::new_sketch_wanted, [&window] { window.start_with(); });
  take(&StartPage::open_wanted, [&window] { ask_open(window); });
  take(&StartPage::project_wanted, [&window](const QString& path) { begin_open(window, {path}); });
  take(&StartPage::sample_wanted, [&window](const QString& name) { start_sample(window, name); });
  take(&StartPage::recovery_wanted, [&window](const RecoveryOffer& offer) { recover_work(window, offer); });
  take(&StartPage::back_wanted, [&window] { leave_start_page(window); });
  take(&StartPage::discard_all_wanted, [&window] { discard_work(window, window.files().recoverable()); });
  take(&StartPage::discard_wanted, [&window](const RecoveryOffer& offer) { discard_work(window, {offer}); });
  QObject::connect(window.parts().thumbnails, &GalleryThumbnails::finished, page, &StartPage::set_thumbnail);
}

void keep_window_layout(MainWindow& window) {
  WindowParts& parts = window.parts();
  if (!parts.keeps_layout) return;
  parts.docks->note_layout();
  keep_layout({window.saveGeometry(), window.shows_views() ? window.saveState() : parts.views_layout,
               parts.docks->closed(), parts.docks->layouts(), parts.viewport->views().layout.shares()});
}

}  // namespace

MainWindow::MainWindow(const QString& state_folder) : parts_(state_folder) {
  setAcceptDrops(true);
  setAnimated(false);  // each step of it would give the views another size, and draw them
  give_first_size(*this);
  auto* middle = new QWidget(this);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  parts_.pages = new QStackedWidget(middle);
  column->addWidget(parts_.pages, 1);
  setCentralWidget(middle);
  parts_.start_page = new StartPage(parts_.pages);
  parts_.viewport = new Viewport(parts_.studio, parts_.pages);
  parts_.pages->addWidget(parts_.start_page);
  parts_.pages->addWidget(parts_.viewport);
  parts_.thumbnails = new GalleryThumbnails(parts_.studio.registry(), parts_.pictures, this);
  add_help_line(*this);
  parts_.show_panels = add_panels(*this);
  add_actions(*this);
  add_tools(*this);
  add_last_menus(*this);
  add_tool_movies(*this);
  connect(&parts_.studio, &Studio::changed, this, &MainWindow::refresh);
  connect(&parts_.studio, &Studio::result_changed, this, &MainWindow::refresh);
  connect(&parts_.studio, &Studio::loaded, this, [this] {
    // What begins a document belongs to it.
    auto& steps = parts_.steps;
    const auto* last = steps.empty() ? nullptr : steps.back().as<recorded::Action>();
    const bool begins = last != nullptr && last->name.starts_with("new");
    steps.erase(steps.begin(), steps.end() - (begins ? 1 : 0));
  });
  follow_files(*this);
  follow_start_page(*this);
  follow_views(*this);
  show_start_page(*this);
}

MainWindow::~MainWindow() {
  // Both use the studio, on other threads too; children would be destroyed after it.
  delete findChild<TourBar*>();
  delete parts_.thumbnails;
  set_tools(parts_.viewport->views(), {});
  parts_.tools.clear();
  delete parts_.pages;
}

void MainWindow::wait_until_settled() { app::wait_until_settled(*this); }

void MainWindow::refresh() {
  parts_.show_panels();
  enable_actions(*this);
  for (const auto& tool : parts_.tools) tool->refresh();
  parts_.docks->follow_layout();
  parts_.actions->show_menus();
  setWindowModified(parts_.studio.session().modified());
  show_help(*this);
}

bool MainWindow::attempt(const std::function<void()>& work) {
  parts_.help->clear();
  try {
    work();
    return true;
  } catch (const Error& error) {
    show_message(error.findings());
  } catch (const Cancelled&) {
    say(tr("Cancelled."));
  }
  return false;
}

void MainWindow::say(const QString& sentence) { parts_.help->say(sentence); }

void MainWindow::show_message(const Findings& findings) { show_findings(parts_, findings); }

/// A message goes with the next press in a view.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parts_.viewport && event->type() == QEvent::MouseButtonPress) parts_.help->clear();
  return QMainWindow::eventFilter(watched, event);
}

bool MainWindow::start_with(Document document) {
  if (!may_discard(*this)) return false;
  parts_.files.start_sketch();
  if (!document.nodes().empty()) parts_.studio.load(std::move(document));
  set_mode(first_mode);
  show_views(*this);
  return true;
}

bool MainWindow::open(const QString& path) {
  if (FileReader::replaces_document(path) && !may_discard(*this)) return false;
  try {
    open_now(parts_.files, path);
  } catch (const Error&) {
    return false;  // reported when reading failed
  } catch (const Cancelled&) {
    return false;
  }
  return true;
}

void MainWindow::record_to(const QString& path) {
  const auto file = std::make_shared<QFile>(path);
  if (!file->open(QIODevice::WriteOnly | QIODevice::Append)) {
    throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
  }
  parts_.recorder.emplace([file](const std::string& line) {
    file->write(line.data(), static_cast<qint64>(line.size()));
    file->flush();  // recordings are needed after a crash
  });
}

void MainWindow::record(const recorded::Step& step) {
  if (parts_.recorder) parts_.recorder->add(step);
  parts_.steps.push_back(step);
  if (parts_.steps.size() > most_steps) parts_.steps.pop_front();
  emit step_recorded(step);
}

bool MainWindow::settled() {
  if (parts_.files.reader().busy() || parts_.files.step_export().busy()) return false;
  return shows_views() ? !parts_.studio.busy() && app::settled(parts_.viewport->pictures())
                       : !parts_.thumbnails->busy();
}

bool MainWindow::event(QEvent* event) {
  if (event->type() == QEvent::Close) {
    if (!may_discard(*this)) {
      event->ignore();
      return true;
    }
    keep_window_layout(*this);
    parts_.files.keeper().close_cleanly();
  }
  if (event->type() == QEvent::DragEnter || event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    QStringList paths;
    for (const QUrl& url : drop->mimeData()->urls()) paths << url.toLocalFile();
    if (event->type() == QEvent::Drop) {
      begin_open(*this, paths);
    } else if (!paths.isEmpty()) {
      drop->acceptProposedAction();
    }
    return true;
  }
  const bool taken = QMainWindow::event(event);
  if (event->type() == QEvent::Resize) place_bars(*this);
  if (event->type() == QEvent::Move) note_window_moved(parts_.viewport->views());
  // The frame round the window is known once it is there.
  if (event->type() == QEvent::Show) QTimer::singleShot(0, this, [this] { fit_to_screen(*this); });
  return taken;
}

QMenu* MainWindow::createPopupMenu() {
  auto* menu = new QMenu(this);
  for (QAction* shown : actions()) {
    if (shown->objectName().startsWith("panel-")) menu->addAction(shown);
  }
  return menu;
}

// ---- Pages and layout

void show_start_page(MainWindow& window) {
  WindowParts& parts = window.parts();
  if (!window.shows_views() && parts.has_shown_views) return leave_start_page(window);
  if (parts.has_shown_views) parts.views_layout = window.saveState();
  StartPage* page = parts.start_page;
  page->show_recent(recent_files());
  page->show_recoverable(parts.files.recoverable());
  page->offer_back(parts.has_shown_views ? parts.files.file_name() : QString(), parts.has_shown_views);
  parts.thumbnails->start();
  parts.pages->setCurrentWidget(page);
  parts.docks->show_all(false);
  for (QToolBar* bar : window.findChildren<QToolBar*>()) bar->hide();
  enable_groups(window, false);
  page->setFocus();
  show_help(window);
}

void leave_start_page(MainWindow& window) {
  if (!window.shows_views() && window.parts().has_shown_views) enter_views(window);
}

void show_views(MainWindow& window) {
  WindowParts& parts = window.parts();
  if (!std::exchange(parts.has_shown_views, true) && !parts.views_layout.isEmpty())
    window.restoreState(parts.views_layout);
  enter_views(window);
  if (!std::exchange(parts.panels_sized, true)) parts.docks->give_first_sizes();
  frame_all(parts.viewport->views());
  window.refresh();
}

void show_opened(MainWindow& window) {
  if (window.views().mode != select_mode && !has_cage(window.studio())) window.set_mode(first_mode);
  show_views(window);
}

void remember_layout(MainWindow& window) {
  WindowParts& parts = window.parts();
  parts.keeps_layout = true;
  const auto kept = kept_layout();
  if (!kept) return;
  window.restoreGeometry(kept->geometry);
  fit_to_screen(window);
  parts.docks->set_closed(kept->closed_panels);
  parts.docks->set_layouts(kept->layouts);
  parts.viewport->views().layout.set_shares(kept->pane_shares);
  if (kept->panels.isEmpty()) return;
  parts.views_layout = kept->panels;
  parts.panels_sized = true;
  parts.docks->set_room_given(true);
}

void reset_layout(MainWindow& window, const QByteArray& first) {
  WindowParts& parts = window.parts();
  forget_layout();
  parts.docks->set_closed({});
  window.restoreState(first);
  parts.docks->set_layouts({});
  parts.views_layout.clear();
  parts.panels_sized = false;
  parts.docks->set_room_given(false);
  parts.viewport->views().layout.set_shares(QPointF(0.5, 0.5));
  give_first_size(window);
  if (!window.shows_views()) return parts.docks->show_all(false);
  enter_views(window);
  parts.panels_sized = true;
  parts.docks->give_first_sizes();
}

}  // namespace croquis::app
