// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "croquis/document/registry.h"
#include "croquis/document/value.h"

namespace croquis::app {

/// What a sample becomes.
enum class SampleKind {
  Sketch,   ///< a drawing that becomes solid
  Cage,     ///< a mesh with sharp edges that becomes smooth
  Network,  ///< curves that become smooth patches
  Scan      ///< a mesh with holes that are to be filled
};

/// A sketch or mesh that ships inside the program.
struct Sample {
  QString name;   ///< "linked_rings": how command lines and replays call it
  QString title;  ///< "Linked rings"
  SampleKind kind = SampleKind::Sketch;
};

/// Sketches, then cages, then networks, then scans, each in the order of their names.
std::vector<Sample> samples();

/// A drawing, a mesh or a network of curves. @throws Error (E_FILE_OPEN) when there is none of that name
Value load_sample(const QString& name);

SampleKind kind_of_sample(const QString& name);

/// The operation that the sample of a cage is shown with.
std::string first_step_of_sample(const QString& name);

/// The action of the window that people begin with; empty for none.
QString first_action_of_sample(const QString& name);

/// What becomes of it, coarse: for a small picture. A scan is shown as it is. @throws Error, Cancelled
std::shared_ptr<const PolyMesh> sample_surface(const QString& name, const Registry& registry, Progress& progress);

class OffscreenPictures;

/// Makes the samples solid or smooth, one after the other on another thread, and pictures of them. The window's thread
/// only shows these.
class GalleryThumbnails : public QObject {
  Q_OBJECT

 public:
  GalleryThumbnails(const Registry& registry, OffscreenPictures& pictures, QObject* parent);
  ~GalleryThumbnails() override;

  /// Goes on with those that have no picture yet.
  void start();

  /// Some samples have no picture yet, and it is being made.
  bool busy() const { return busy_; }

  /// Stops soon: files that are opened go first.
  void stop();

 signals:
  void finished(const QString& sample, const QImage& picture);

 private:
  void make_pictures(std::size_t first);
  QImage picture_of(const QString& sample);

  const Registry& registry_;
  OffscreenPictures& pictures_;
  std::size_t done_ = 0;
  bool busy_ = false;
  std::atomic<bool> stopped_{false};
  std::thread worker_;
};

}  // namespace croquis::app
