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

#include "app/attribute_panel.h"
#include "app/gallery_thumbnails.h"
#include "app/lists.h"
#include "app/start_page.h"
#include "app/viewport.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr QSize first_size(1440, 900);

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
  make_help_line();
  connect_studio();
  show_start_page();
  update_title();
}

MainWindow::~MainWindow() = default;

void MainWindow::connect_studio() {
  connect(&studio_, &Studio::changed, this, &MainWindow::update_panels);
  connect(&studio_, &Studio::result_changed, this, &MainWindow::update_panels);
  connect(&studio_, &Studio::busy_changed, this, [this](bool busy) {
    progress_->setVisible(busy);
    cancel_->setVisible(busy);
    if (busy) progress_->setValue(0);
  });
  connect(&studio_, &Studio::progress_changed, this, [this](double fraction, const QString& step) {
    progress_->setValue(static_cast<int>(fraction * progress_->maximum()));
    progress_->setFormat(step);
  });
  connect(&files_, &ProjectFiles::path_changed, this, &MainWindow::update_title);
  connect(&files_, &ProjectFiles::autosave_failed, this, [this](const QString& text) { message_->setText(text); });
  connect(viewport_, &Viewport::committed, this, &MainWindow::record);
  connect(viewport_, &Viewport::help_changed, this, &MainWindow::update_help);

  connect(start_page_, &StartPage::new_sketch_wanted, this, &MainWindow::start_sketch);
  connect(start_page_, &StartPage::open_wanted, this, &MainWindow::ask_open);
  connect(start_page_, &StartPage::project_wanted, this, &MainWindow::open);
  connect(start_page_, &StartPage::sketch_wanted, this, [this](const QString& name) {
    if (attempt([&] { files_.start_gallery_sketch(name); })) show_views();
  });
  connect(start_page_, &StartPage::recovery_wanted, this, [this](const RecoveryOffer& offer) {
    if (attempt([&] { files_.recover(offer); })) show_views();
  });
  connect(start_page_, &StartPage::discard_wanted, this, [this](const RecoveryOffer& offer) {
    attempt([&] { files_.discard(offer); });
    start_page_->show_recoverable(files_.recoverable());
  });
  connect(thumbnails_, &GalleryThumbnails::finished, start_page_, &StartPage::set_thumbnail);

  connect(attributes_, &AttributePanel::parameter_edited, this,
          [this](NodeId node, const std::string& parameter, const ParameterValue& value, bool dragging) {
            studio_.set_parameter(node, parameter, value, dragging);
            const Node* edited = studio_.session().document().find(node);
            if (!dragging && edited != nullptr) record(recorded::Set{edited->name, parameter, value});
          });
  connect(objects_, &ObjectList::strokes_chosen, this, &MainWindow::select_strokes);
  connect(findings_, &FindingsList::strokes_chosen, this, &MainWindow::select_strokes);
  connect(history_, &HistoryList::step_chosen, this, &MainWindow::go_to_step);
}

void MainWindow::make_help_line() {
  help_ = new QLabel(this);
  help_->setObjectName("help-line");
  message_ = new QLabel(this);
  message_->setObjectName("message");
  message_->setStyleSheet("color: #f0a09a");
  progress_ = new QProgressBar(this);
  progress_->setObjectName("progress");
  progress_->setRange(0, 1000);
  progress_->setFixedWidth(220);
  cancel_ = new QPushButton(tr("Cancel"), this);
  cancel_->setObjectName("cancel");
  connect(cancel_, &QPushButton::clicked, &studio_, &Studio::cancel);
  statusBar()->addWidget(help_);
  statusBar()->addWidget(message_, 1);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
  progress_->hide();
  cancel_->hide();
}

void MainWindow::update_panels() {
  const Session& session = studio_.session();
  attributes_->show_node(studio_.solid_operation(), studio_.solid_description());
  objects_->show_objects(studio_.drawing(), studio_.result().get(), session.selection());
  findings_->show_findings(studio_.findings());
  history_->show_history(session.undo_labels(), session.redo_labels());
  action("undo")->setEnabled(session.can_undo());
  action("redo")->setEnabled(session.can_redo());
  action("delete")->setEnabled(!session.selection().empty());
  action("export-solid")->setEnabled(studio_.solid() != nullptr);
  action("export-picture")->setEnabled(studio_.solid() != nullptr);
  setWindowModified(session.modified());
  update_help();
}

void MainWindow::update_title() {
  const QString name = files_.path().isEmpty() ? tr("Untitled") : QFileInfo(files_.path()).fileName();
  setWindowTitle(name + "[*] — Croquis");
}

void MainWindow::update_help() {
  if (shows_start_page()) {
    help_->setText(tr("Choose a sketch, or press Ctrl+N and draw"));
    return;
  }
  help_->setText(viewport_->help());
}

bool MainWindow::attempt(const std::function<void()>& work) {
  message_->clear();
  try {
    work();
    return true;
  } catch (const Error& error) {
    last_findings_ = error.findings();
    message_->setText(sentences(error.findings()).section('\n', 0, 0));
    message_->setToolTip(sentences(error.findings()));
  } catch (const Cancelled&) {
    message_->setText(tr("Cancelled."));
  }
  return false;
}

void MainWindow::start_sketch() {
  if (!may_discard()) return;
  files_.start_sketch();
  show_views();
}

bool MainWindow::open(const QString& path) {
  if (!may_discard() || !attempt([&] { files_.open(path); })) return false;
  record(recorded::File{"open", QFileInfo(path).absoluteFilePath().toStdString()});
  show_views();
  return true;
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

bool MainWindow::settled() const { return studio_.settled() && !(shows_start_page() && thumbnails_->busy()); }

bool MainWindow::shows_start_page() const { return pages_->currentWidget() == start_page_; }

void MainWindow::show_start_page() {
  start_page_->show_recent(files_.recent());
  start_page_->show_recoverable(files_.recoverable());
  thumbnails_->start();
  pages_->setCurrentWidget(start_page_);
  for (QDockWidget* dock : docks_) dock->hide();
  for (QToolBar* bar : findChildren<QToolBar*>()) bar->hide();
  update_help();
}

void MainWindow::show_views() {
  thumbnails_->stop();
  pages_->setCurrentWidget(viewport_);
  for (QDockWidget* dock : docks_) dock->show();
  if (!docks_sized_) {
    resizeDocks(docks_, {150, 420, 100, 160}, Qt::Vertical);
    resizeDocks(docks_, {290, 290, 290, 290}, Qt::Horizontal);
    docks_sized_ = true;
  }
  for (QToolBar* bar : findChildren<QToolBar*>()) bar->show();
  viewport_->frame_all();
  viewport_->setFocus();
  update_panels();
}

void MainWindow::select_strokes(const std::vector<std::string>& strokes) {
  Selection selection;
  for (const std::string& stroke : strokes) selection.push_back({studio_.drawing_node(), stroke});
  studio_.session().select(std::move(selection));
}

void MainWindow::go_to_step(int steps) {
  Session& session = studio_.session();
  while (static_cast<int>(session.undo_labels().size()) > steps && session.can_undo()) session.undo();
  while (static_cast<int>(session.undo_labels().size()) < steps && session.can_redo()) session.redo();
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
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty()) open(urls.front().toLocalFile());
}

void MainWindow::moveEvent(QMoveEvent* event) {
  QMainWindow::moveEvent(event);
  viewport_->note_window_moved();
}

}  // namespace croquis::app
