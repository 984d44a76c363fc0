// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <memory>
#include <vector>

#include "app/gallery.h"

class QVBoxLayout;

namespace croquis::app {

/// What the recovery card offers.
struct RecoveryOffer {
  QString file;     ///< the working copy
  QString project;  ///< path of the project it belongs to, empty for a sketch that was never saved
  QString time;
  QImage thumbnail;
};

/// The first page: a new sketch, samples, what was open lately, and work that a crash left behind.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  void show_recent(const QStringList& projects);
  void show_recoverable(const std::vector<RecoveryOffer>& offers);

  /// Puts the solid's picture onto a sample's tile.
  void set_thumbnail(const QString& sample, const QImage& picture);

 signals:
  void new_sketch_wanted();
  void open_wanted();
  void sample_wanted(const QString& name);
  void project_wanted(const QString& path);
  void recovery_wanted(const croquis::app::RecoveryOffer& offer);
  void discard_wanted(const croquis::app::RecoveryOffer& offer);

 private:
  void add_gallery(const QString& title, SampleKind kind);
  QWidget* make_recovery_card(const RecoveryOffer& offer);

  QVBoxLayout* recovery_;
  QVBoxLayout* recent_;
  QVBoxLayout* gallery_;
};

}  // namespace croquis::app
