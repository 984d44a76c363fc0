// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QImage>
#include <QString>
#include <QWidget>
#include <memory>
#include <vector>

#include "app/start/gallery.h"

class QAction;
class QGridLayout;
class QPushButton;
class QVBoxLayout;

namespace croquis::app {

/// What the recovery card offers.
struct RecoveryOffer {
  QString file;     ///< the working copy
  QString project;  ///< path of the project it belongs to, empty for a sketch that was never saved
  QDateTime time;   ///< of its last change; invalid when it isn't known
  QImage thumbnail;
};

/// The first page: a new sketch, samples, what was open lately, and work that a crash left behind.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  /// A button for another way to start, below the one for sketches.
  void add_start(QAction& action);

  /// A link that begins a tour.
  void add_tour(QAction& action);

  void show_recent(const QStringList& projects);
  void show_recoverable(const std::vector<RecoveryOffer>& offers);

  /// A button back to what is open, where something is. @param name its file's, may be empty
  void offer_back(const QString& name, bool offered);

  /// Puts the solid's picture onto a sample's tile.
  void set_thumbnail(const QString& sample, const QImage& picture);

 signals:
  void back_wanted();
  void new_sketch_wanted();
  void open_wanted();
  void sample_wanted(const QString& name);
  void project_wanted(const QString& path);
  void recovery_wanted(const croquis::app::RecoveryOffer& offer);
  void discard_wanted(const croquis::app::RecoveryOffer& offer);
  void discard_all_wanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Samples of one kind, in as many columns as there is room for.
  struct Gallery {
    QGridLayout* grid;
    std::vector<QWidget*> tiles;
  };

  QWidget* make_side(QWidget* page);
  void add_gallery(const QString& title, SampleKind kind, QVBoxLayout* column);
  void place_tiles();
  QWidget* make_recovery_card(const RecoveryOffer& offer);

  QPushButton* back_;
  QVBoxLayout* starts_;
  QVBoxLayout* tours_;
  QVBoxLayout* recovery_;
  QVBoxLayout* recent_;
  std::vector<Gallery> galleries_;
  int columns_ = 0;
};

}  // namespace croquis::app
