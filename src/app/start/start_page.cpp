// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/start/start_page.h"

#include <QAction>
#include <QFileInfo>
#include <QFrame>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/window/action_list.h"

namespace croquis::app {
namespace {

constexpr int most_tile_columns = 6;
constexpr QSize tile_picture(156, 117);
constexpr int tile_spacing = 10;
constexpr int left_width = 230;
constexpr int page_margin = 32;
constexpr int scroll_bar_room = 20;

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * 1.25);
  font.setBold(true);
  label->setFont(font);
  return label;
}

void clear(QLayout* layout) {
  while (QLayoutItem* item = layout->takeAt(0)) {
    delete item->widget();
    delete item;
  }
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setObjectName("start-page");
  setAccessibleName(tr("Start page"));
  setFocusPolicy(Qt::StrongFocus);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  outer->addWidget(scroll);
  auto* page = new QWidget(scroll);
  scroll->setWidget(page);
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(page_margin, 24, page_margin, 24);
  row->setSpacing(page_margin);
  row->addWidget(make_side(page), 0, Qt::AlignTop);
  auto* right = new QVBoxLayout;
  row->addLayout(right, 1);
  add_gallery(tr("Start from a sketch"), SampleKind::Sketch, right);
  add_gallery(tr("Start from a cage with sharp edges"), SampleKind::Cage, right);
  add_gallery(tr("Start from a network of curves"), SampleKind::Network, right);
  add_gallery(tr("Start from a scan with holes"), SampleKind::Scan, right);
  right->addStretch();
  place_tiles();
}

QWidget* StartPage::make_side(QWidget* page) {
  auto* side = new QWidget(page);
  side->setFixedWidth(left_width);
  auto* left = new QVBoxLayout(side);
  left->setContentsMargins(0, 0, 0, 0);
  left->addWidget(heading(tr("Croquis"), side));
  const auto add_button = [&](const QString& text, const QString& name) {
    auto* button = new QPushButton(text, side);
    button->setObjectName(name);
    left->addWidget(button);
    return button;
  };
  back_ = add_button(tr("Back"), "back");
  back_->setMinimumHeight(40);
  back_->hide();
  connect(back_, &QPushButton::clicked, this, &StartPage::back_wanted);
  QPushButton* fresh = add_button(tr("New sketch"), "new-sketch");
  fresh->setMinimumHeight(40);
  fresh->setDefault(true);
  connect(fresh, &QPushButton::clicked, this, &StartPage::new_sketch_wanted);
  starts_ = new QVBoxLayout;
  left->addLayout(starts_);
  connect(add_button(tr("Open…"), "open-file"), &QPushButton::clicked, this, &StartPage::open_wanted);
  tours_ = new QVBoxLayout;
  tours_->setSpacing(0);
  tours_->addWidget(heading(tr("Tours"), side));
  left->addLayout(tours_);
  recovery_ = new QVBoxLayout;
  left->addLayout(recovery_);
  recent_ = new QVBoxLayout;
  left->addLayout(recent_);
  left->addStretch();
  return side;
}

void StartPage::add_gallery(const QString& title, SampleKind kind, QVBoxLayout* column) {
  Gallery gallery{new QGridLayout, {}};
  gallery.grid->setSpacing(tile_spacing);
  for (const Sample& sample : samples()) {
    if (sample.kind != kind) continue;
    auto* tile = new QToolButton(this);
    tile->setObjectName("sketch-" + sample.name);
    tile->setText(sample.title);
    tile->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    tile->setIconSize(tile_picture);
    tile->setFixedSize(tile_picture + QSize(16, 36));
    tile->setAccessibleName(sample.title);
    connect(tile, &QToolButton::clicked, this, [this, name = sample.name] { emit sample_wanted(name); });
    gallery.tiles.push_back(tile);
  }
  if (gallery.tiles.empty()) {
    delete gallery.grid;
    return;
  }
  column->addWidget(heading(title, this));
  column->addLayout(gallery.grid);
  galleries_.push_back(std::move(gallery));
}

/// As many columns as fit, so that nothing lies outside of a narrow window.
void StartPage::place_tiles() {
  const int room = width() - left_width - 3 * page_margin - scroll_bar_room;
  const int columns =
      std::clamp((room + tile_spacing) / (tile_picture.width() + 16 + tile_spacing), 1, most_tile_columns);
  if (columns == columns_) return;
  for (const Gallery& gallery : galleries_) {
    gallery.grid->setColumnStretch(columns_, 0);
    gallery.grid->setColumnStretch(columns, 1);
    for (std::size_t place = 0; place < gallery.tiles.size(); ++place) {
      gallery.grid->removeWidget(gallery.tiles[place]);
      gallery.grid->addWidget(gallery.tiles[place], static_cast<int>(place) / columns,
                              static_cast<int>(place) % columns, Qt::AlignLeft);
    }
  }
  columns_ = columns;
}

void StartPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place_tiles();
}

void StartPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || back_->isHidden()) return QWidget::keyPressEvent(event);
  emit back_wanted();
}

void StartPage::offer_back(const QString& name, bool offered) {
  back_->setText(name.isEmpty() ? tr("Back") : tr("Back to %1").arg(name));
  back_->setToolTip(tr("Goes on with what is open (Escape)"));
  back_->setVisible(offered);
}

void StartPage::add_start(QAction& action) {
  auto* button = new QPushButton(action.text().remove('&'), this);
  button->setObjectName("start-" + action.objectName());
  connect(button, &QPushButton::clicked, &action, &QAction::trigger);
  starts_->addWidget(button);
}

void StartPage::add_tour(QAction& action) {
  auto* link = new QPushButton(without_marks(action.text()), this);
  link->setObjectName("start-" + action.objectName());
  link->setFlat(true);
  connect(link, &QPushButton::clicked, &action, &QAction::trigger);
  tours_->addWidget(link, 0, Qt::AlignLeft);
}

void StartPage::show_recent(const QStringList& projects) {
  clear(recent_);
  if (projects.isEmpty()) return;
  recent_->addWidget(heading(tr("Recent"), this));
  for (const QString& path : projects) {
    auto* button = new QPushButton(QFileInfo(path).fileName(), this);
    button->setToolTip(path);
    button->setFlat(true);
    connect(button, &QPushButton::clicked, this, [this, path] { emit project_wanted(path); });
    recent_->addWidget(button, 0, Qt::AlignLeft);
  }
}

void StartPage::show_recoverable(const std::vector<RecoveryOffer>& offers) {
  clear(recovery_);
  if (offers.empty()) return;
  recovery_->addWidget(heading(tr("Unsaved work"), this));
  if (offers.size() > 1) {
    auto* all = new QPushButton(tr("Discard all %1").arg(offers.size()), this);
    all->setObjectName("discard-all");
    connect(all, &QPushButton::clicked, this, &StartPage::discard_all_wanted);
    recovery_->addWidget(all);
  }
  for (const RecoveryOffer& offer : offers) recovery_->addWidget(make_recovery_card(offer));
}

void StartPage::set_thumbnail(const QString& sample, const QImage& picture) {
  if (auto* tile = findChild<QToolButton*>("sketch-" + sample)) tile->setIcon(QPixmap::fromImage(picture));
}

QWidget* StartPage::make_recovery_card(const RecoveryOffer& offer) {
  auto* card = new QFrame(this);
  card->setFrameShape(QFrame::StyledPanel);
  card->setObjectName("recovery-card");
  auto* layout = new QGridLayout(card);
  auto* picture = new QLabel(card);
  const QImage& seen = offer.thumbnail;  // none of work that was never shown
  if (!seen.isNull()) {
    picture->setPixmap(QPixmap::fromImage(seen.scaled(96, 72, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
  }
  layout->addWidget(picture, 0, 0, 2, 1);
  const QString name = offer.project.isEmpty() ? tr("Untitled sketch") : QFileInfo(offer.project).fileName();
  const QString time = QLocale().toString(offer.time.toLocalTime(), QLocale::ShortFormat);
  auto* text = new QLabel(offer.time.isValid() ? name + "\n" + time : name, card);
  text->setObjectName("recovery-text");
  text->setToolTip(offer.project);
  text->setWordWrap(true);
  layout->addWidget(text, 0, 1, 1, 2);
  auto* recover = new QPushButton(tr("Recover"), card);
  recover->setObjectName("recover");
  connect(recover, &QPushButton::clicked, this, [this, offer] { emit recovery_wanted(offer); });
  layout->addWidget(recover, 1, 1);
  auto* discard = new QPushButton(tr("Discard"), card);
  discard->setObjectName("discard");
  connect(discard, &QPushButton::clicked, this, [this, offer] { emit discard_wanted(offer); });
  layout->addWidget(discard, 1, 2);
  return card;
}

}  // namespace croquis::app
