// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/start_page.h"

#include <QFileInfo>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace croquis::app {
namespace {

constexpr int columns = 6;
constexpr QSize tile_picture(156, 117);
constexpr int left_width = 230;

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
  auto* outer = new QVBoxLayout(this);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  outer->addWidget(scroll);
  auto* page = new QWidget(scroll);
  scroll->setWidget(page);
  auto* columns_row = new QHBoxLayout(page);
  columns_row->setContentsMargins(32, 24, 32, 24);
  columns_row->setSpacing(32);

  auto* side = new QWidget(page);
  side->setFixedWidth(left_width);
  columns_row->addWidget(side, 0, Qt::AlignTop);
  auto* left = new QVBoxLayout(side);
  left->setContentsMargins(0, 0, 0, 0);
  left->addWidget(heading(tr("Croquis"), page));
  auto* fresh = new QPushButton(tr("New sketch"), page);
  fresh->setObjectName("new-sketch");
  fresh->setMinimumHeight(40);
  fresh->setDefault(true);
  connect(fresh, &QPushButton::clicked, this, &StartPage::new_sketch_wanted);
  left->addWidget(fresh);
  auto* open = new QPushButton(tr("Open…"), page);
  open->setObjectName("open-file");
  connect(open, &QPushButton::clicked, this, &StartPage::open_wanted);
  left->addWidget(open);
  recovery_ = new QVBoxLayout;
  left->addLayout(recovery_);
  recent_ = new QVBoxLayout;
  left->addLayout(recent_);
  left->addStretch();

  auto* right = new QVBoxLayout;
  columns_row->addLayout(right, 1);
  gallery_ = right;
  add_gallery(tr("Start from a sketch"), SampleKind::Sketch);
  add_gallery(tr("Start from a cage with sharp edges"), SampleKind::Cage);
  add_gallery(tr("Start from a scan with holes"), SampleKind::Scan);
  right->addStretch();
}

void StartPage::add_gallery(const QString& title, SampleKind kind) {
  auto* grid = new QGridLayout;
  grid->setSpacing(10);
  int place = 0;
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
    grid->addWidget(tile, place / columns, place % columns, Qt::AlignLeft);
    ++place;
  }
  if (place == 0) return;
  grid->setColumnStretch(columns, 1);
  gallery_->addWidget(heading(title, this));
  gallery_->addLayout(grid);
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
  picture->setPixmap(QPixmap::fromImage(offer.thumbnail.scaled(96, 72, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
  layout->addWidget(picture, 0, 0, 2, 1);
  const QString name = offer.project.isEmpty() ? tr("Untitled sketch") : QFileInfo(offer.project).fileName();
  layout->addWidget(new QLabel(name + "\n" + offer.time, card), 0, 1, 1, 2);
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
