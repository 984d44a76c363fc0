// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <QWidget>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/document/document.h"
#include "croquis/document/kept_work.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/picture_file.h"
#include "croquis/io/camera_file.h"

namespace croquis::app {

/// A path as the file system has it.
std::string local_name(const QString& path);

/// "a", "a or b", "a, b or c".
inline std::string either_of(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  }
  return text;
}

/// What a file held: a project, a drawing, a network of curves, a mesh, a picture or a camera.
struct ReadFile {
  QString path;
  std::variant<Document, std::shared_ptr<const Drawing>, std::shared_ptr<const PerspectiveDrawing>,
               std::shared_ptr<const AttributeNetwork>, std::shared_ptr<const PolyMesh>,
               std::shared_ptr<const PictureFile>, CameraFile>
      content;
  Findings warnings;
  KeptWork kept = {};      ///< of a project
  bool is_traced = false;  ///< a drawing of a picture's lines
};

/// What becomes of a picture: it lies behind what is drawn, or its lines become strokes.
enum class PictureUse { Backdrop, Lines };

/// What takes long with files: on another thread, one after the other in the order asked for.
class FileThread : public QObject {
  Q_OBJECT

 public:
  FileThread() { thread_.setMaxThreadCount(1); }
  ~FileThread() override;

  /// What is being done, and what waits to be, isn't done.
  void cancel() { *cancelled_ = true; }

  bool busy() const { return open_ > 0; }

 signals:
  void progress_changed(double fraction, const QString& step);
  void busy_changed(bool busy);

 protected:
  /// @param findings why it wasn't done; none: it was cancelled
  using Take = std::function<void(bool done, const Findings& findings)>;

  /// @param work on the other thread; it may throw
  /// @param take in the window's thread, once it has ended
  /// @param too_large said where there isn't enough memory
  void begin(std::function<void(Progress&)> work, Take take, const std::string& too_large);

 private:
  void report_progress(double fraction, const std::string& step);

  int open_ = 0;
  std::atomic<bool> progress_posted_ = false;
  std::shared_ptr<std::atomic<bool>> cancelled_ = std::make_shared<std::atomic<bool>>(false);
  QThreadPool thread_;
};

/// Reads projects, drawings, meshes and pictures.
class FileReader : public FileThread {
  Q_OBJECT

 public:
  /// What opens there takes the place of what is open: projects, drawings and networks do, all else is added to it.
  static bool replaces_document(const QString& path);

  /// What a drawing is that doesn't say so: SVG files of other programs can be sketches and drawings in perspective.
  enum class PlainDrawing { Sketch, Perspective };

  /// What a dialog lists: everything that `read` reads, and nothing else.
  static QString dialog_filter();

  void read(const QString& path, PlainDrawing plain = PlainDrawing::Sketch, PictureUse use = PictureUse::Backdrop);

  /// The file's content now, on the caller's thread. @throws Error, Cancelled
  static ReadFile read_now(const QString& path, Progress& progress, PlainDrawing plain = PlainDrawing::Sketch,
                           PictureUse use = PictureUse::Backdrop);

 signals:
  void finished(const croquis::app::ReadFile& file);
  void failed(const QString& path, const croquis::Findings& findings);  ///< none: it was cancelled
};

/// The findings of a file as lines for people: each a sentence with its stop, the file named without its folders.
QStringList sentences_of(const Findings& findings, const QString& path);

/// What was wrong with a project that was opened, every finding of it, and the earlier versions beside it.
class OpeningReport : public QDialog {
  Q_OBJECT

 public:
  OpeningReport(const QString& path, const Findings& findings, QWidget* parent);

 signals:
  void version_wanted(const QString& path);

 private:
  QString headline(const Findings& findings) const;
  QWidget* make_versions();

  QString path_;
};

// Photos and scans: what Qt reads. For any thread.

/// ".png", ".jpg" …: of the formats that can be read on this machine.
const QStringList& picture_endings();
/// "*.png *.jpg …", for dialogs.
QString picture_patterns();
bool is_picture_name(const QString& path);

/// The file's picture, after a look at all of it.
/// @param file for sentences
/// @throws Error (E_PICTURE_FILE, malformed) for a broken, incomplete or empty one
PictureFile read_picture(std::string bytes, const std::string& file);

/// As people see it: turned as the file says, 8 bits a channel (RGBA), its longer side at most so many pixels.
/// @return a null image for bytes that can't be read
QImage decoded(const PictureFile& picture, int longest_side);

/// The lines of a file's picture, upright, as strokes.
/// @throws Error like read_picture and trace_picture
/// @throws Cancelled
Drawing traced_picture(std::string bytes, const std::string& file, Progress& progress);

/// Asks which of two is to be done; nothing: neither.
/// @param first true as the answer; the other one is proposed
std::optional<bool> ask_which(QWidget& parent, const QString& name, const QString& text, const QString& first,
                              const QString& second);

/// Asks what becomes of the pictures among the files; nothing: they aren't wanted. Without pictures it doesn't ask.
std::optional<PictureUse> ask_picture_use(const QStringList& paths, QWidget& parent);

}  // namespace croquis::app
