// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <algorithm>
#include <utility>

#include "app/files/file_reader.h"
#include "app/replay/replay_player.h"
#include "app/start/gallery.h"
#include "app/start/start_page.h"
#include "app/tools/tool.h"
#include "app/views/viewport.h"
#include "app/window/help_line.h"
#include "app/window/panel_docks.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

constexpr QSize first_size(1440, 900);
constexpr int progress_pause_ms = 200;

bool is_error(const Finding& finding) { return finding.severity == Severity::Error; }

}  // namespace

MainWindow::MainWindow(const QString& state_folder) : files_(studio_, pictures_, state_folder) {
  setAcceptDrops(true);
  setAnimated(false);  // each step of it would give the views another size, and draw them
  resize(first_size);
  fit_to_screen(*this);
  pages_ = new QStackedWidget(this);
  setCentralWidget(pages_);
  start_page_ = new StartPage(pages_);
  viewport_ = new Viewport(studio_, pages_);
  pages_->addWidget(start_page_);
  pages_->addWidget(viewport_);
  thumbnails_ = new GalleryThumbnails(studio_.registry(), pictures_, this);
  make_help_line();
  make_docks();
  make_actions();
  make_tools();
  make_window_actions();
  make_help_actions();
  gate_document_actions();
  connect_studio();
  connect_files();
  connect_start_page();
  connect_panels();
  connect_viewport();
  first_layout_ = saveState();
  show_start_page();
  update_title();
}

MainWindow::~MainWindow() {
  // Both use the studio, on other threads too; children would be destroyed after it.
  delete thumbnails_;
  viewport_->set_tools({});
  tools_.clear();
  delete pages_;
}

void MainWindow::connect_studio() {
  connect(&studio_, &Studio::changed, this, &MainWindow::update_panels);
  connect(&studio_, &Studio::result_changed, this, &MainWindow::update_panels);
  connect(&studio_, &Studio::busy_changed, this, &MainWindow::show_progress);
  const auto show_step = [this](double fraction, const QString& step) {
    // The bar draws itself at once, and the whole window with it.
    if (since_progress_.isValid() && !since_progress_.hasExpired(progress_pause_ms)) return;
    since_progress_.start();
    progress_->setValue(static_cast<int>(fraction * progress_->maximum()));
    progress_->setFormat(step);
  };
  connect(&studio_, &Studio::progress_changed, this, show_step);
  connect(&files_.reader(), &FileReader::progress_changed, this, show_step);
  connect(&files_.step_export(), &StepExport::progress_changed, this, show_step);
}

void MainWindow::connect_files() {
  connect(&files_, &ProjectFiles::path_changed, this, &MainWindow::update_title);
  connect(&files_.keeper(), &WorkKeeper::failed, this, &MainWindow::say);
  connect(&files_.reader(), &FileReader::busy_changed, this, &MainWindow::show_progress);
  connect(&files_.step_export(), &StepExport::busy_changed, this, &MainWindow::show_progress);
  connect(&files_.step_export(), &StepExport::finished, this, [this](const QString& path) { say_written(path); });
  connect(&files_.step_export(), &StepExport::failed, this, [this](const Findings& findings) {
    if (findings.empty()) return say(tr("Cancelled."));
    last_findings_ = findings;
    show_message(findings);
  });
  connect(&files_, &ProjectFiles::opened, this, [this](const QString& path, const Findings& warnings) {
    record(recorded::File{
        "open", QFileInfo(path).absoluteFilePath().toStdString(), files_.has_replaced(), {}, {}, files_.has_traced()});
    folder_ = QFileInfo(path).absolutePath();
    hold_usable_tool();
    show_views();
    report_opening(path, warnings);
    for (const auto& tool : tools_) tool->follow(Change::Opened);
  });
  connect(&files_, &ProjectFiles::open_failed, this, [this](const QString& path, const Findings& findings) {
    last_findings_ = findings;
    if (findings.empty()) return say(tr("Cancelled."));
    report_opening(path, findings);
  });
  files_.keeper().set_items([this] { return viewport_->objects().surfaces(); });
}

void MainWindow::connect_start_page() {
  connect(start_page_, &StartPage::new_sketch_wanted, this, &MainWindow::start_sketch);
  for (QAction* one : actions()) {
    if (one->objectName().startsWith("new-")) start_page_->add_start(*one);
  }
  connect(start_page_, &StartPage::open_wanted, this, &MainWindow::ask_open);
  connect(start_page_, &StartPage::project_wanted, this, [this](const QString& path) { begin_open({path}); });
  connect(start_page_, &StartPage::sample_wanted, this, [this](const QString& name) {
    if (!may_discard() || !attempt([&] { files_.start_sample(name); })) return;
    hold_usable_tool();
    show_views();
    for (const auto& tool : tools_) tool->follow(Change::Opened);
    if (const QString first = first_action_of_sample(name); !first.isEmpty()) action(first)->trigger();
  });
  connect(start_page_, &StartPage::recovery_wanted, this, [this](const RecoveryOffer& offer) {
    if (!may_discard() || !attempt([&] { files_.recover(offer); })) return;
    hold_usable_tool();
    show_views();
    report_opening(offer.project, files_.warnings());
  });
  connect(start_page_, &StartPage::back_wanted, this, &MainWindow::leave_start_page);
  connect(start_page_, &StartPage::discard_all_wanted, this, [this] {
    attempt([&] {
      for (const RecoveryOffer& each : files_.recoverable()) discard(each);
    });
    start_page_->show_recoverable(files_.recoverable());
  });
  connect(start_page_, &StartPage::discard_wanted, this, [this](const RecoveryOffer& offer) {
    attempt([&] { discard(offer); });
    start_page_->show_recoverable(files_.recoverable());
  });
  connect(thumbnails_, &GalleryThumbnails::finished, start_page_, &StartPage::set_thumbnail);
}

void MainWindow::connect_viewport() {
  connect(viewport_, &Viewport::committed, this, &MainWindow::record);
  connect(viewport_, &Viewport::help_changed, this, &MainWindow::update_help);
  connect(viewport_, &Viewport::look_through_changed, this, &MainWindow::show_cameras);
  viewport_->installEventFilter(this);
}

void MainWindow::make_tools() {
  tools_ = all_tools(*this);
  std::vector<Tool*> tools;
  for (const auto& tool : tools_) {
    tool->make_actions(*actions_);
    tools.push_back(tool.get());
  }
  for (Tool* tool : tools) {
    tool->make_panels(*panels_);
    connect(tool, &Tool::state_changed, this, &MainWindow::update_panels);
  }
  viewport_->set_tools(std::move(tools));
}

void MainWindow::wait_until_settled() { app::wait_until_settled(*this); }

void MainWindow::set_mode(const QString& mode) { viewport_->set_mode(mode); }

void MainWindow::add_status_widget(QWidget& widget) { statusBar()->insertPermanentWidget(1, &widget); }

bool MainWindow::pick(ComponentKind kind, const std::vector<Index>& elements) {
  return std::ranges::any_of(tools_, [&](const auto& tool) { return tool->show(PickedElements{kind, elements}); });
}

bool MainWindow::picks_elements() const {
  return std::ranges::any_of(tools_, [](const auto& tool) { return tool->state().picks_elements; });
}

QString MainWindow::offer() const {
  for (const auto& tool : tools_) {
    if (const QString offer = tool->offer(); !offer.isEmpty()) return offer;
  }
  return {};
}

void MainWindow::show_progress(bool) {
  const bool busy = studio_.busy() || files_.reader().busy() || files_.step_export().busy();
  if (busy && !progress_->isVisible()) progress_->setValue(0);
  progress_->setVisible(busy);
  cancel_->setVisible(busy);
}

void MainWindow::make_help_line() {
  help_ = new HelpLine(this);
  progress_ = new QProgressBar(this);
  progress_->setObjectName("progress");
  progress_->setRange(0, 1000);
  progress_->setFixedWidth(220);
  cancel_ = new QPushButton(tr("Cancel"), this);
  cancel_->setObjectName("cancel");
  connect(cancel_, &QPushButton::clicked, this, [this] {
    files_.reader().cancel();
    files_.step_export().cancel();
    stop_computing();
  });
  statusBar()->addWidget(help_, 1);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
  progress_->hide();
  cancel_->hide();
}

/// A tool may take back what it had begun.
void MainWindow::stop_computing() {
  const bool was_busy = studio_.busy();
  studio_.cancel();
  if (!was_busy) return;
  for (const auto& tool : tools_) tool->command(EditCommand::Cancel);
}

void MainWindow::update_title() {
  const QString name = files_.file_name();
  setWindowTitle((name.isEmpty() ? tr("Untitled") : name) + "[*] — Croquis");
}

void MainWindow::update_help() {
  if (shows_start_page()) {
    help_->show_help(has_shown_views_ ? tr("Escape goes back to what was open; or choose a sketch, or press Ctrl+N")
                                      : tr("Choose a sketch, or press Ctrl+N and draw"));
    return;
  }
  help_->show_help(viewport_->help());
}

bool MainWindow::attempt(const std::function<void()>& work) {
  help_->clear();
  try {
    work();
    return true;
  } catch (const Error& error) {
    last_findings_ = error.findings();
    show_message(error.findings());
  } catch (const Cancelled&) {
    say(tr("Cancelled."));
  }
  return false;
}

void MainWindow::show_message(const Findings& findings, const QString& path) {
  const bool error = std::ranges::any_of(findings, &is_error);
  const QStringList all = sentences_of(findings, path);
  const QString more = all.size() > 1 ? tr(" And %1 more: see the panel Findings.").arg(all.size() - 1) : QString();
  help_->say(all.value(0) + more, error ? HelpLine::Tone::Error : HelpLine::Tone::Warning, all.join('\n'));
}

/// All findings about a file are shown; what a damaged project lost, and where earlier versions are, in full.
void MainWindow::report_opening(const QString& path, const Findings& findings) {
  help_->clear();
  if (findings.empty()) return;
  show_message(findings, path);
  show_findings();
  if (!unattended_ && files_.is_damaged(path)) show_opening_report(path, findings);
}

void MainWindow::show_opening_report(const QString& path, const Findings& findings) {
  if (report_) report_->close();
  report_ = new OpeningReport(path, findings, this);
  connect(report_, &OpeningReport::version_wanted, this, [this](const QString& version) { begin_open({version}); });
  report_->open();
}

/// A message goes with the next press in a view.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == viewport_ && event->type() == QEvent::MouseButtonPress) help_->clear();
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::start_sketch() {
  if (!may_discard()) return;
  files_.start_sketch();
  set_mode(first_mode);
  show_views();
}

bool MainWindow::start_with(Document document) {
  if (!may_discard()) return false;
  files_.start_sketch();
  studio_.load(std::move(document));
  set_mode(first_mode);
  show_views();
  return true;
}

bool MainWindow::open(const QString& path) {
  if (FileReader::replaces_document(path) && !may_discard()) return false;
  try {
    open_now(files_, path);
  } catch (const Error&) {
    return false;  // reported when reading failed
  } catch (const Cancelled&) {
    return false;
  }
  return true;
}

void MainWindow::record_to(const QString& path) {
  recording_ = std::make_unique<QFile>(path);
  if (!recording_->open(QIODevice::WriteOnly | QIODevice::Append)) {
    throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
  }
  recorder_ = std::make_unique<recorded::Recorder>([this](const std::string& line) {
    recording_->write(line.data(), static_cast<qint64>(line.size()));
    recording_->flush();  // recordings are needed after a crash
  });
}

void MainWindow::record(const recorded::Step& step) {
  if (recorder_) recorder_->add(step);
}

void MainWindow::export_picture(const QString& path) { viewport_->export_picture(pictures_, path); }

bool MainWindow::settled() const {
  if (files_.reader().busy() || files_.step_export().busy()) return false;
  return shows_start_page() ? !thumbnails_->busy() : !studio_.busy() && viewport_->settled();
}

bool MainWindow::shows_start_page() const { return pages_->currentWidget() == start_page_; }

void MainWindow::show_start_page() {
  if (shows_start_page() && has_shown_views_) return leave_start_page();
  if (has_shown_views_) views_layout_ = saveState();
  start_page_->show_recent(recent_files());
  start_page_->show_recoverable(files_.recoverable());
  start_page_->offer_back(has_shown_views_ ? files_.file_name() : QString(), has_shown_views_);
  thumbnails_->start();
  pages_->setCurrentWidget(start_page_);
  panels_->show_all(false);
  for (QToolBar* bar : findChildren<QToolBar*>()) bar->hide();
  for (QActionGroup* group : findChildren<QActionGroup*>()) group->setEnabled(false);
  start_page_->setFocus();
  update_help();
}

/// What was open is as it was, the views included.
void MainWindow::leave_start_page() {
  if (shows_start_page() && has_shown_views_) enter_views();
}

void MainWindow::enter_views() {
  thumbnails_->stop();
  pages_->setCurrentWidget(viewport_);
  for (QActionGroup* group : findChildren<QActionGroup*>()) group->setEnabled(true);
  findChild<QToolBar*>("tools")->show();
  for (const auto& tool : tools_) tool->refresh();  // shows other bars now: later it would move the views under the pen
  panels_->show_all(true);
  viewport_->setFocus();
  update_panels();
}

void MainWindow::show_views() {
  if (!std::exchange(has_shown_views_, true) && !views_layout_.isEmpty()) restoreState(views_layout_);
  enter_views();
  if (!std::exchange(docks_sized_, true)) size_panels();
  viewport_->frame_all();
  update_panels();
}

void MainWindow::size_panels() {
  resizeDocks(docks_, {210, 360, 80, 110}, Qt::Vertical);
  resizeDocks(docks_, {310, 310, 310, 310}, Qt::Horizontal);
}

void MainWindow::remember_layout() {
  remembers_layout_ = true;
  const auto kept = kept_layout();
  if (!kept) return;
  restoreGeometry(kept->geometry);
  fit_to_screen(*this);
  panels_->set_closed(kept->closed_panels);
  viewport_->set_pane_shares(kept->pane_shares);
  if (kept->panels.isEmpty()) return;
  views_layout_ = kept->panels;
  docks_sized_ = true;
  panels_->set_room_given(true);
}

void MainWindow::keep_window_layout() {
  if (!remembers_layout_) return;
  keep_layout(
      {saveGeometry(), shows_start_page() ? views_layout_ : saveState(), panels_->closed(), viewport_->pane_shares()});
}

void MainWindow::reset_layout() {
  forget_layout();
  panels_->set_closed({});
  restoreState(first_layout_);
  views_layout_.clear();
  docks_sized_ = false;
  panels_->set_room_given(false);
  viewport_->set_pane_shares(QPointF(0.5, 0.5));
  resize(first_size);
  fit_to_screen(*this);
  if (shows_start_page()) return panels_->show_all(false);
  enter_views();
  docks_sized_ = true;
  size_panels();
}

/// The current tool is always one that works on what is open.
void MainWindow::hold_usable_tool() {
  if (viewport_->mode() != select_mode && !has_cage(studio_)) set_mode(first_mode);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_discard()) {
    event->ignore();
    return;
  }
  keep_window_layout();
  files_.keeper().close_cleanly();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls()) paths << url.toLocalFile();
  begin_open(paths);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  // The frame round the window is known once it is there.
  QTimer::singleShot(0, this, [this] { fit_to_screen(*this); });
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  place_bars();
}

/// Further buttons below those of the tools, or beside them where a low window has no room for both.
void MainWindow::place_bars() {
  const auto* tools = findChild<QToolBar*>("tools");
  const int room = height() - menuBar()->sizeHint().height() - statusBar()->sizeHint().height();
  for (QToolBar* bar : findChildren<QToolBar*>()) {
    const bool beside = tools->sizeHint().height() + bar->sizeHint().height() > room;
    if (bar == tools || beside == toolBarBreak(bar)) continue;
    if (beside) {
      insertToolBarBreak(bar);
    } else {
      removeToolBarBreak(bar);
    }
  }
}

void MainWindow::moveEvent(QMoveEvent* event) {
  QMainWindow::moveEvent(event);
  viewport_->note_window_moved();
}

}  // namespace croquis::app
