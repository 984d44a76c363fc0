// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/file_reader.h"

#include <QBuffer>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QMetaObject>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/window/language.h"
#include "app/window/theme.h"
#include "croquis/base/error.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/io/picture_trace.h"
#include "croquis/io/project_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/render/picture_item.h"

namespace croquis::app {
namespace {

/// Drawings in perspective say that they are.
bool is_perspective_drawing(const std::string& bytes) { return bytes.find("urn:croquis:perspective:") != bytes.npos; }

bool has_ending(const QString& path, const char* ending) { return QFileInfo(path).suffix().toLower() == ending; }

/// Other JSON files are cameras. Drawings and networks name their format at the beginning.
bool is_json_drawing(const QString& path) {
  constexpr qint64 looked_at = 4096;  // bytes
  QFile file(path);
  if (!has_ending(path, "json") || !file.open(QIODevice::ReadOnly)) return false;
  const QByteArray beginning = file.read(looked_at);
  return beginning.contains("croquis-perspective/") || beginning.contains("croquis-abs/");
}

ReadFile sheet_of(const QString& path, PerspectiveReadResult read) {
  return {path, std::make_shared<const PerspectiveDrawing>(std::move(read.drawing)), std::move(read.warnings)};
}

/// A drawing, a network of curves or a camera.
ReadFile read_json_file(const QString& path, const std::string& bytes, const std::string& file) {
  if (bytes.find("croquis-perspective/") != bytes.npos) return sheet_of(path, read_perspective_json(bytes, file));
  if (bytes.find("croquis-abs/") != bytes.npos) {
    AttributeNetworkReadResult read = read_attribute_network(bytes, file);
    return {path, std::make_shared<const AttributeNetwork>(std::move(read.network)), std::move(read.warnings)};
  }
  return {path, read_camera_file(bytes, file), {}};
}

ReadFile read_drawing(const QString& path, const std::string& bytes, FileReader::PlainDrawing plain,
                      Progress& progress) {
  const std::string file = local_name(path);
  if (plain == FileReader::PlainDrawing::Perspective || is_perspective_drawing(bytes))
    return sheet_of(path, read_perspective_svg(bytes, file, progress));
  DrawingReadResult read = read_svg_drawing(bytes, file, progress);
  return {path, std::make_shared<const Drawing>(std::move(read.drawing)), std::move(read.warnings)};
}

ReadFile read_picture_file(const QString& path, std::string bytes, const std::string& file, PictureUse use,
                           Progress& progress) {
  if (use == PictureUse::Backdrop)
    return {path, std::make_shared<const PictureFile>(read_picture(std::move(bytes), file)), {}};
  return {path, std::make_shared<const Drawing>(traced_picture(std::move(bytes), file, progress)), {}, {}, true};
}

/// ".croq, .svg, .obj or .off".
std::string readable_endings() {
  std::vector<std::string> endings{".croq", ".svg", ".json", ".fspy"};
  for (const MeshFormat format : mesh_formats()) endings.push_back(extension_of(format));
  for (const QString& ending : picture_endings()) endings.push_back(ending.toStdString());
  return either_of(endings);
}

constexpr QSize report_size(560, 380);

QString when_written(const QString& path) {
  return QLocale().toString(QFileInfo(path).lastModified().toLocalTime(), QLocale::ShortFormat);
}

constexpr int most_megabytes = 2048;  // of a decoded picture; Qt's own bound is less than a large scan takes
constexpr std::string_view jpeg_scan = "\xFF\xDA", jpeg_end = "\xFF\xD9";

/// Qt's reader fills what is missing of a JPEG file with grey, without an error.
bool is_cut_off(const std::string& bytes) {
  if (!bytes.starts_with("\xFF\xD8")) return false;
  const auto scan = bytes.rfind(jpeg_scan);  // the picture's own, not its thumbnail's
  return scan == std::string::npos || bytes.find(jpeg_end, scan) == std::string::npos;
}

[[noreturn]] void refuse_picture(const std::string& file, const std::string& reason) {
  throw Error(make_error(Category::Malformed, "E_PICTURE_FILE",
                         "The picture \"" + file + "\" can't be read: " + reason + "; save it again as PNG or JPEG",
                         {{SubjectKind::File, file, std::nullopt, std::nullopt, {}}}));
}

/// A picture of so many pixels, as large as allowed.
QSize shown_size(const QSize& size, int longest_side) {
  return std::max(size.width(), size.height()) <= longest_side
             ? size
             : size.scaled(longest_side, longest_side, Qt::KeepAspectRatio).expandedTo(QSize(1, 1));
}

/// @param reason what was wrong, where the image is null
QImage read_image(const std::string& bytes, int longest_side, QSize& own_size, QString& reason) {
  QBuffer buffer;
  buffer.setData(QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())));
  buffer.open(QIODevice::ReadOnly);
  QImageReader::setAllocationLimit(most_megabytes);
  QImageReader reader(&buffer);
  reader.setDecideFormatFromContent(true);
  reader.setAutoTransform(true);
  const QSize stored = reader.size();
  if (stored.isValid()) reader.setScaledSize(shown_size(stored, longest_side));
  QImage image = reader.read();
  if (image.isNull()) {
    reason = reader.errorString();
    return image;
  }
  // Files that don't say how large they are are known only now.
  own_size = stored.isValid() ? stored : image.size();
  if (reader.transformation() & QImageIOHandler::TransformationRotate90) own_size.transpose();
  const QSize size = shown_size(image.size(), longest_side);
  if (size != image.size()) image = image.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  return image.convertToFormat(QImage::Format_RGBA8888);
}

}  // namespace

std::string local_name(const QString& path) { return QFile::encodeName(path).toStdString(); }

FileThread::~FileThread() {
  cancel();
  thread_.waitForDone();
}

void FileThread::begin(std::function<void(Progress&)> work, Take take, const std::string& too_large) {
  if (open_++ == 0) {
    *cancelled_ = false;
    emit busy_changed(true);
  }
  thread_.start([this, work = std::move(work), take = std::move(take), too_large, cancelled = cancelled_] {
    Progress progress([this](double fraction, const std::string& step) { report_progress(fraction, step); },
                      cancelled.get());
    bool done = false;
    Findings findings;
    try {
      progress.check();
      work(progress);
      done = true;
    } catch (const Error& error) {
      findings = error.findings();
    } catch (const Cancelled&) {
      done = false;
    } catch (const std::bad_alloc&) {
      findings = {make_error(Category::Limit, "E_MEMORY", too_large)};
    }
    const auto end = [this, take, done, findings] {
      --open_;
      take(done, findings);
      if (open_ == 0) emit busy_changed(false);
    };
    QMetaObject::invokeMethod(this, end, Qt::QueuedConnection);
  });
}

void FileThread::report_progress(double fraction, const std::string& step) {
  // One at a time: readers report far more often than a window can show.
  if (progress_posted_.exchange(true)) return;
  QMetaObject::invokeMethod(
      this,
      [this, fraction, text = QString::fromStdString(step)] {
        progress_posted_ = false;
        if (busy()) emit progress_changed(fraction, text);
      },
      Qt::QueuedConnection);
}

bool FileReader::replaces_document(const QString& path) {
  return is_project_name(local_name(path)) || has_ending(path, "svg") || is_json_drawing(path);
}

QString FileReader::dialog_filter() {
  QStringList endings{"*.croq", "*.svg", "*.json", "*.fspy"};
  QStringList kinds{tr("Projects (*.croq)"), tr("Earlier versions of projects (*.croq~*)"),
                    tr("Drawings and networks of curves (*.svg *.json)"), tr("Cameras (*.fspy *.json)")};
  for (const MeshFormat format : mesh_formats()) {
    const QString ending = "*" + QString::fromStdString(extension_of(format));
    endings << ending;
    kinds << QString("%1 (%2)").arg(to_string(format), ending);
  }
  endings << picture_patterns();
  kinds << tr("Pictures (%1)").arg(picture_patterns());
  kinds.prepend(tr("Projects, drawings, meshes and pictures (%1)").arg(endings.join(' ')));
  return kinds.join(";;");
}

ReadFile FileReader::read_now(const QString& path, Progress& progress, PlainDrawing plain, PictureUse use) {
  const std::string file = local_name(path);
  if (is_project_name(file)) {
    ProjectFile project = load_project(file, progress);
    return {path, std::move(project.document), std::move(project.warnings), std::move(project.kept)};
  }
  std::string bytes = read_file(file);
  if (const auto format = mesh_format_of(file)) {
    MeshReadResult read = read_mesh(bytes, *format, file, progress);
    return {path, std::make_shared<const PolyMesh>(std::move(read.mesh)), std::move(read.warnings)};
  }
  if (is_picture_name(path)) return read_picture_file(path, std::move(bytes), file, use, progress);
  if (has_ending(path, "svg")) return read_drawing(path, bytes, plain, progress);
  if (has_ending(path, "json")) return read_json_file(path, bytes, file);
  if (has_ending(path, "fspy")) return {path, read_camera_file(bytes, file), {}};
  throw Error(make_error(Category::Malformed, "E_FORMAT",
                         "\"" + file + "\" is no project, drawing, mesh or picture: open " + readable_endings()));
}

void FileReader::read(const QString& path, PlainDrawing plain, PictureUse use) {
  const auto file = std::make_shared<ReadFile>();
  const auto work = [path, plain, use, file](Progress& progress) {
    *file = read_now(path, progress, plain, use);
    progress.check();
  };
  const auto take = [this, path, file](bool done, const Findings& findings) {
    if (done)
      emit finished(*file);
    else
      emit failed(path, findings);
  };
  begin(work, take, tr("\"%1\" doesn't fit into this machine's memory").arg(path).toStdString());
}

QStringList sentences_of(const Findings& findings, const QString& path) {
  QStringList lines;
  for (const Finding& finding : findings) {
    QString sentence = localized(finding.message);
    if (!path.isEmpty()) sentence.replace(path, QFileInfo(path).fileName());
    lines << (sentence.endsWith('.') ? sentence : sentence + ".");
  }
  return lines;
}

OpeningReport::OpeningReport(const QString& path, const Findings& findings, QWidget* parent)
    : QDialog(parent), path_(path) {
  setObjectName("opening-report");
  setWindowTitle(QFileInfo(path).fileName());
  setAttribute(Qt::WA_DeleteOnClose);
  resize(report_size);
  auto* column = new QVBoxLayout(this);
  auto* head = new QLabel(headline(findings), this);
  head->setObjectName("opening-headline");
  head->setWordWrap(true);
  column->addWidget(head);
  auto* list = new QListWidget(this);
  list->setObjectName("opening-findings");
  list->setWordWrap(true);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  const QStringList lines = sentences_of(findings, path);
  for (qsizetype i = 0; i < lines.size(); ++i) {
    auto* row = new QListWidgetItem(lines[i], list);
    const Finding& finding = findings[static_cast<std::size_t>(i)];
    row->setForeground(sentence_color(finding.severity));
    row->setToolTip(QString::fromStdString(finding.code));
  }
  column->addWidget(list, 1);
  column->addWidget(make_versions());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

QString OpeningReport::headline(const Findings& findings) const {
  const QString name = QFileInfo(path_).fileName();
  if (has_errors(findings)) return tr("%1 can't be opened. What was open before is still there.").arg(name);
  return tr("%1 is damaged, and what is named below is lost. The file stays as it is: saving asks for another name.")
      .arg(name);
}

/// Its earlier versions; of one of these, the others.
QWidget* OpeningReport::make_versions() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  const std::string file = local_name(path_);
  int shown = 0;
  for (const auto& version : project_backups(project_of_backup(file).value_or(file))) {
    const QString path = QFile::decodeName(QByteArray::fromStdString(version.string()));
    if (QFileInfo(path) == QFileInfo(path_)) continue;
    if (shown++ == 0) column->addWidget(new QLabel(tr("Earlier versions, as they were saved:"), box));
    auto* button = new QPushButton(tr("Open %1, of %2").arg(QFileInfo(path).fileName(), when_written(path)), box);
    button->setObjectName("version-" + QString::number(shown));
    connect(button, &QPushButton::clicked, this, [this, path] {
      accept();
      emit version_wanted(path);
    });
    column->addWidget(button, 0, Qt::AlignLeft);
  }
  if (shown == 0) column->addWidget(new QLabel(tr("No earlier versions lie beside it."), box));
  return box;
}

const QStringList& picture_endings() {
  static const QStringList endings = [] {
    QStringList readable;
    const QList<QByteArray> formats = QImageReader::supportedImageFormats();
    for (const char* format : {"png", "jpg", "jpeg", "webp", "tif", "tiff", "bmp", "gif"}) {
      if (formats.contains(format)) readable << QString(".") + format;
    }
    return readable;
  }();
  return endings;
}

QString picture_patterns() { return "*" + picture_endings().join(" *"); }

bool is_picture_name(const QString& path) {
  return picture_endings().contains("." + QFileInfo(path).suffix(), Qt::CaseInsensitive);
}

PictureFile read_picture(std::string bytes, const std::string& file) {
  if (bytes.empty()) refuse_picture(file, "it is empty");
  if (is_cut_off(bytes)) refuse_picture(file, "its end is missing");
  QSize size;
  QString reason;
  const QImage image = read_image(bytes, render::max_picture_item_side, size, reason);
  if (image.isNull()) refuse_picture(file, reason.isEmpty() ? "it is damaged" : reason.toLower().toStdString());
  PictureFile picture;
  picture.bytes = std::move(bytes);
  picture.width = size.width();
  picture.height = size.height();
  picture.file = file;
  return picture;
}

QImage decoded(const PictureFile& picture, int longest_side) {
  QSize size;
  QString reason;
  return read_image(picture.bytes, longest_side, size, reason);
}

Drawing traced_picture(std::string bytes, const std::string& file, Progress& progress) {
  // As on the command line.
  if (bytes.starts_with("\x89PNG")) return read_picture_drawing(bytes, file, progress);
  const QImage image = decoded(read_picture(std::move(bytes), file), TraceOptions().longest_side);
  Picture picture{image.width(), image.height(), {}};
  for (int y = 0; y < image.height(); ++y) {
    const uchar* row = image.constScanLine(y);
    picture.rgba.insert(picture.rgba.end(), row, row + 4 * static_cast<std::ptrdiff_t>(image.width()));
  }
  return trace_picture(picture, file, progress);
}

std::optional<bool> ask_which(QWidget& parent, const QString& name, const QString& text, const QString& first,
                              const QString& second) {
  QMessageBox question(QMessageBox::Question, QMessageBox::tr("Croquis"), text, QMessageBox::Cancel, &parent);
  question.setObjectName(name);
  const QPushButton* one = question.addButton(first, QMessageBox::AcceptRole);
  QPushButton* other = question.addButton(second, QMessageBox::AcceptRole);
  question.setDefaultButton(other);
  question.exec();
  if (question.clickedButton() == one) return true;
  return question.clickedButton() == other ? std::optional(false) : std::nullopt;
}

std::optional<PictureUse> ask_picture_use(const QStringList& paths, QWidget& parent) {
  const auto count = std::ranges::count_if(paths, is_picture_name);
  if (count == 0) return PictureUse::Backdrop;
  const QString what = count == 1 ? QFileInfo(*std::ranges::find_if(paths, is_picture_name)).fileName()
                                  : QMessageBox::tr("%1 pictures").arg(count);
  const auto traces =
      ask_which(parent, "picture-question",
                QMessageBox::tr("Trace the lines of %1 as strokes, or put it behind the drawing?").arg(what),
                QMessageBox::tr("Trace lines"), QMessageBox::tr("Backdrop"));
  if (!traces) return std::nullopt;
  return *traces ? PictureUse::Lines : PictureUse::Backdrop;
}

}  // namespace croquis::app
