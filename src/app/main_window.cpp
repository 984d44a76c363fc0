// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <algorithm>

#include "app/gallery.h"
#include "app/gallery_thumbnails.h"
#include "app/help_line.h"
#include "app/start_page.h"
#include "app/viewport.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr QSize first_size(1440, 900);

bool is_error(const Finding& finding) { return finding.severity == Severity::Error; }

/// Without the folders: there is one line for the sentence.
Findings with_short_name(Findings findings, const QString& path) {
  for (Finding& finding : findings) {
    const QString message = QString::fromStdString(finding.message);
    finding.message = QString(message).replace(path, QFileInfo(path).fileName()).toStdString();
  }
  return findings;
}

QString sentences(const Findings& findings) {
  QStringList lines;
  for (const Finding& finding : findings) {
    const QString sentence = QString::fromStdString(finding.message);
    lines << (sentence.endsWith('.') ? sentence : sentence + ".");
  }
  return lines.join("\n");
}

}  // namespace

MainWindow::MainWindow(const QString& state_folder) : files_(studio_, pictures_, state_folder) {
  setAcceptDrops(true);
  resize(first_size);
  pages_ = new QStackedWidget(this);
  setCentralWidget(pages_);
  start_page_ = new StartPage(pages_);
  viewport_ = new Viewport(studio_, pages_);
  pages_->addWidget(start_page_);
  pages_->addWidget(viewport_);
  thumbnails_ = new GalleryThumbnails(studio_.registry(), pictures_, this);
  make_docks();
  make_actions();
  make_hole_dock();
  make_help_line();
  connect_studio();
  connect_files();
  connect_start_page();
  connect_panels();
  connect_viewport();
  show_start_page();
  update_title();
}

MainWindow::~MainWindow() {
  // Both work with the studio, beside this thread too; children would go after it.
  thumbnails_->stop();
  delete pages_;
}

void MainWindow::connect_studio() {
  connect(&studio_, &Studio::changed, this, &MainWindow::update_panels);
  connect(&studio_, &Studio::result_changed, this, &MainWindow::update_panels);
  connect(&studio_, &Studio::busy_changed, this, &MainWindow::show_progress);
  const auto show_step = [this](double fraction, const QString& step) {
    progress_->setValue(static_cast<int>(fraction * progress_->maximum()));
    progress_->setFormat(step);
  };
  connect(&studio_, &Studio::progress_changed, this, show_step);
  connect(&files_.reader(), &FileReader::progress_changed, this, show_step);
}

void MainWindow::connect_files() {
  connect(&files_, &ProjectFiles::path_changed, this, &MainWindow::update_title);
  connect(&files_, &ProjectFiles::autosave_failed, this, &MainWindow::tell);
  connect(&files_.reader(), &FileReader::busy_changed, this, &MainWindow::show_progress);
  connect(&files_, &ProjectFiles::opened, this, [this](const QString& path) {
    record(recorded::File{"open", QFileInfo(path).absoluteFilePath().toStdString()});
    folder_ = QFileInfo(path).absolutePath();
    show_views();
    offer_scale();
  });
  connect(&files_, &ProjectFiles::open_failed, this, [this](const QString& path, const Findings& findings) {
    attempt([&] {
      if (findings.empty()) throw Cancelled();
      throw Error(with_short_name(findings, path));
    });
  });
  files_.set_items([this] { return viewport_->objects().surfaces(); });
}

void MainWindow::connect_start_page() {
  connect(start_page_, &StartPage::new_sketch_wanted, this, &MainWindow::start_sketch);
  connect(start_page_, &StartPage::open_wanted, this, &MainWindow::ask_open);
  connect(start_page_, &StartPage::project_wanted, this, [this](const QString& path) { begin_open({path}); });
  connect(start_page_, &StartPage::sample_wanted, this, [this](const QString& name) {
    if (!may_discard() || !attempt([&] { files_.start_sample(name); })) return;
    show_views();
    if (kind_of_sample(name) == SampleKind::Scan) action("holes")->trigger();
  });
  connect(start_page_, &StartPage::recovery_wanted, this, [this](const RecoveryOffer& offer) {
    if (attempt([&] { files_.recover(offer); })) show_views();
  });
  connect(start_page_, &StartPage::discard_wanted, this, [this](const RecoveryOffer& offer) {
    attempt([&] { files_.discard(offer); });
    start_page_->show_recoverable(files_.recoverable());
  });
  connect(thumbnails_, &GalleryThumbnails::finished, start_page_, &StartPage::set_thumbnail);
}

void MainWindow::connect_viewport() {
  connect(viewport_, &Viewport::committed, this, &MainWindow::record);
  connect(viewport_, &Viewport::help_changed, this, &MainWindow::update_help);
  connect(&viewport_->mesh(), &MeshInteraction::mode_changed, this, &MainWindow::update_panels);
  connect(&viewport_->mesh(), &MeshInteraction::told, this, &MainWindow::tell);
  viewport_->installEventFilter(this);
}

void MainWindow::show_progress(bool) {
  const bool busy = studio_.busy() || files_.reader().busy();
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
    viewport_->holes().cancel();
  });
  status_ = new QLabel(this);
  status_->setObjectName("status");
  status_->setStyleSheet("color: #b9c0cb");
  statusBar()->addWidget(help_, 1);
  statusBar()->addPermanentWidget(status_);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
  progress_->hide();
  cancel_->hide();
}

void MainWindow::update_title() {
  const QString name = files_.path().isEmpty() ? tr("Untitled") : QFileInfo(files_.path()).fileName();
  setWindowTitle(name + "[*] — Croquis");
}

void MainWindow::update_help() {
  if (shows_start_page()) {
    help_->show_help(tr("Choose a sketch, or press Ctrl+N and draw"));
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
    tell(tr("Cancelled."));
  }
  return false;
}

void MainWindow::show_message(const Findings& findings) {
  const bool error = std::ranges::any_of(findings, &is_error);
  const QString all = sentences(findings);
  help_->tell(all.section('\n', 0, 0), error ? HelpLine::Tone::Error : HelpLine::Tone::Warning, all);
}

/// What was told is old once the hand goes on.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == viewport_ && event->type() == QEvent::MouseButtonPress) help_->clear();
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::start_sketch() {
  if (!may_discard()) return;
  files_.start_sketch();
  show_views();
}

bool MainWindow::open(const QString& path) {
  if (FileReader::replaces_document(path) && !may_discard()) return false;
  return attempt([&] { files_.open(path); });
}

void MainWindow::begin_open(const QStringList& paths) {
  for (const QString& path : paths) {
    if (FileReader::replaces_document(path) && !may_discard()) return;
    files_.begin_open(path);
  }
}

void MainWindow::record_to(const QString& path) {
  recording_ = std::make_unique<QFile>(path);
  if (!recording_->open(QIODevice::WriteOnly | QIODevice::Append)) {
    throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
  }
  recorder_ = std::make_unique<recorded::Recorder>([this](const std::string& line) {
    recording_->write(line.data(), static_cast<qint64>(line.size()));
    recording_->flush();  // a crash is what recordings are wanted for
  });
}

void MainWindow::record(const recorded::Step& step) {
  if (recorder_) recorder_->add(step);
}

void MainWindow::export_picture(const QString& path) { viewport_->export_picture(pictures_, path); }

bool MainWindow::settled() const {
  if (files_.reader().busy()) return false;
  return shows_start_page() ? !thumbnails_->busy() : studio_.settled() && viewport_->settled();
}

bool MainWindow::shows_start_page() const { return pages_->currentWidget() == start_page_; }

void MainWindow::show_start_page() {
  start_page_->show_recent(files_.recent());
  start_page_->show_recoverable(files_.recoverable());
  thumbnails_->start();
  pages_->setCurrentWidget(start_page_);
  for (QDockWidget* dock : docks_) dock->hide();
  edges_dock_->hide();
  sets_dock_->hide();
  holes_dock_->hide();
  for (QToolBar* bar : findChildren<QToolBar*>()) bar->hide();
  update_help();
}

void MainWindow::show_views() {
  thumbnails_->stop();
  pages_->setCurrentWidget(viewport_);
  for (QDockWidget* dock : docks_) dock->show();
  if (!docks_sized_) {
    resizeDocks(docks_, {130, 400, 90, 140}, Qt::Vertical);
    resizeDocks(docks_, {310, 310, 310, 310}, Qt::Horizontal);
    docks_sized_ = true;
  }
  for (QToolBar* bar : findChildren<QToolBar*>()) bar->show();
  viewport_->frame_all();
  viewport_->setFocus();
  update_panels();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_discard()) {
    event->ignore();
    return;
  }
  files_.close_cleanly();
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

void MainWindow::moveEvent(QMoveEvent* event) {
  QMainWindow::moveEvent(event);
  viewport_->note_window_moved();
}

}  // namespace croquis::app
