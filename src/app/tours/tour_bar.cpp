// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tours/tour_bar.h"

#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/replay/replay_player.h"
#include "app/start/start_page.h"
#include "app/tours/tour_guide.h"
#include "app/views/viewport.h"
#include "app/window/language.h"
#include "app/window/main_window.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

constexpr const char* bar_style =
    "QFrame#tour { background: #2b2d31; border-bottom: 2px solid #f28c28 } QLabel#tour-caption { font-size: 14px }";
constexpr const char* frame_style = "border: 2px solid #f28c28; border-radius: 5px; background: transparent";
constexpr int frame_room = 3;

/// Where people find an action: its button in a panel or a bar, else the title of its menu. Empty where nothing of it
/// is shown. In the window's pixels.
QRect place_of_action(MainWindow& window, const QString& name) {
  const auto in_window = [&](QWidget* of, const QRect& rect) {
    return QRect(of->mapTo(&window, rect.topLeft()), rect.size());
  };
  QAction* action = window.action(name);
  if (action == nullptr) return {};
  std::vector<QWidget*> buttons{window.findChild<QPushButton*>(name + "-button")};
  for (QToolButton* button : window.findChildren<QToolButton*>()) {
    if (button->defaultAction() == action) buttons.push_back(button);
  }
  for (QWidget* button : buttons) {
    if (button != nullptr && button->isVisible() && !button->visibleRegion().isEmpty())
      return in_window(button, button->rect());
  }
  while (action != nullptr) {
    QAction* above = nullptr;
    for (QObject* object : action->associatedObjects()) {
      if (object == window.menuBar()) return in_window(window.menuBar(), window.menuBar()->actionGeometry(action));
      if (auto* menu = qobject_cast<QMenu*>(object)) above = menu->menuAction();
    }
    action = above;
  }
  return {};
}

}  // namespace

TourBar::TourBar(MainWindow& window, Tour tour)
    : QFrame(window.centralWidget()),
      window_(window),
      tour_(std::move(tour)),
      replays_(replays_of(window)),
      guide_(new TourGuide(window.views())),
      frame_(new QFrame(&window)) {
  make_widgets();
  connect(&window, &MainWindow::step_recorded, this, [this](const recorded::Step& step) {
    if (step.as<recorded::Action>() == nullptr) note(step);  // not every action is recorded
  });
  for (const QAction* action : window.actions()) {
    connect(action, &QAction::triggered, this,
            [this, name = action->objectName()] { note(recorded::Action{name.toStdString()}); });
  }
  for (const auto signal : {&Studio::changed, &Studio::result_changed})
    connect(&window.studio(), signal, this, &TourBar::look, Qt::QueuedConnection);
  window.viewport().installEventFilter(this);
  begin_step(0);
}

TourBar::~TourBar() {
  delete guide_;
  delete frame_;
}

void TourBar::make_widgets() {
  setObjectName("tour");
  setStyleSheet(bar_style);
  setAccessibleName(shown_text(tour_.title.toStdString()));
  auto* row = new QHBoxLayout(this);
  row->setSpacing(12);
  count_ = new QLabel(this);
  caption_ = new QLabel(this);
  caption_->setObjectName("tour-caption");
  caption_->setWordWrap(true);
  caption_->setMinimumHeight(2 * fontMetrics().height() + frame_room);  // so that the views seldom change their size
  row->addWidget(count_);
  row->addWidget(caption_, 1);
  const auto add = [&](const char* name, const QString& text, const QString& tip) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);  // keys belong to the views
    row->addWidget(button);
    return button;
  };
  show_ = add("tour-show", tr("Show me"), tr("Does this step for you"));
  skip_ = add("tour-skip", tr("Skip"), tr("Goes on without this step"));
  end_ = add("tour-end", tr("End tour"), tr("Ends the tour; what is drawn stays"));
  connect(show_, &QPushButton::clicked, this, &TourBar::show_me);
  connect(skip_, &QPushButton::clicked, this, &TourBar::skip);
  connect(end_, &QPushButton::clicked, this, &QObject::deleteLater);
  frame_->setObjectName("tour-frame");
  frame_->setAttribute(Qt::WA_TransparentForMouseEvents);
  frame_->setStyleSheet(frame_style);
}

void TourBar::begin_step(std::size_t step) {
  at_ = step;
  const bool over = at_ == tour_.steps.size();
  done_.assign(over ? 0 : tour_.steps[at_].asked.size(), false);
  count_->setText(over ? QString() : tr("Step %1 of %2").arg(at_ + 1).arg(tour_.steps.size()));
  caption_->setText(shown_text((over ? tour_.end : tour_.steps[at_].caption).toStdString()));
  for (QPushButton* button : {show_, skip_}) button->setVisible(!over);
  QMetaObject::invokeMethod(this, &TourBar::place_marks, Qt::QueuedConnection);  // once the views have their place
}

std::vector<recorded::Step> TourBar::left() const {
  std::vector<recorded::Step> steps;
  for (std::size_t i = 0; i < done_.size(); ++i) {
    if (!done_[i]) steps.push_back(tour_.steps[at_].asked[i]);
  }
  return steps;
}

/// Of the things that are asked for, the one that fits best is done.
void TourBar::note(const recorded::Step& done) {
  double least = 1;
  std::size_t best = done_.size();
  for (std::size_t i = 0; i < done_.size(); ++i) {
    const double miss = done_[i] ? 1 : misfit(done, tour_.steps[at_].asked[i]);
    if (miss >= least) continue;
    least = miss;
    best = i;
  }
  if (best == done_.size()) return;
  done_[best] = true;
  // After whatever happens now: actions are noted while they run.
  QMetaObject::invokeMethod(this, &TourBar::look, Qt::QueuedConnection);
}

bool TourBar::is_done() const {
  if (left().empty()) return true;
  const auto& until = tour_.steps[at_].until;
  const auto is_there = [&](const recorded::Expect& expected) {
    try {
      return static_cast<std::int64_t>(replays_.counts.at(expected.what)(expected.node)) >= expected.count;
    } catch (const Error&) {
      return false;  // there is nothing to count yet
    }
  };
  return !until.empty() && !window_.studio().busy() && std::ranges::all_of(until, is_there);
}

void TourBar::look() {
  if (shows_ || at_ == tour_.steps.size() || any_down(window_.views())) return;
  if (is_done()) return begin_step(at_ + 1);
  place_marks();
}

void TourBar::show_me() {
  if (shows_ || at_ == tour_.steps.size()) return;
  shows_ = true;
  leave_start_page(window_);
  const bool played = window_.attempt([this] {
    for (const recorded::Step& step : left()) {
      window_.wait_until_settled();
      play_step(replays_, step);
    }
    window_.wait_until_settled();
  });
  shows_ = false;
  if (played) begin_step(at_ + 1);
}

void TourBar::skip() {
  if (!shows_ && at_ < tour_.steps.size()) begin_step(at_ + 1);
}

void TourBar::place_marks() {
  guide_->follow();
  std::vector<StepPath> paths;
  QRect place;
  for (const recorded::Step& step : left()) {
    if (const StepPath path = path_of(step); !path.places.empty()) paths.push_back(path);
    const auto* action = step.as<recorded::Action>();
    if (action != nullptr && place.isEmpty()) place = place_of_action(window_, QString::fromStdString(action->name));
  }
  if (at_ < tour_.steps.size() && tour_.steps[at_].at) paths.push_back({PerspectiveView, {*tour_.steps[at_].at}});
  guide_->show_paths(std::move(paths));
  guide_->raise();
  frame_->setGeometry(place.adjusted(-frame_room, -frame_room, frame_room, frame_room));
  frame_->setVisible(!place.isEmpty());
  frame_->raise();
}

bool TourBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Move)
    QMetaObject::invokeMethod(this, &TourBar::place_marks, Qt::QueuedConnection);
  return QFrame::eventFilter(watched, event);
}

void start_tour(MainWindow& window, const QString& name) {
  window.attempt([&] {
    const Tour tour = load_tour(name);
    bool begun = false;
    QObject watch;
    QObject::connect(&window.studio(), &Studio::loaded, &watch, [&begun] { begun = true; });
    if (tour.sample.isEmpty()) {
      window.action(tour.action)->trigger();
    } else {
      emit window.parts().start_page->sample_wanted(tour.sample);
    }
    if (!begun) return;
    delete window.findChild<TourBar*>("tour");
    auto* bar = new TourBar(window, tour);
    qobject_cast<QBoxLayout*>(window.centralWidget()->layout())->insertWidget(0, bar);
  });
}

void add_tour_actions(MainWindow& window, QMenu* menu) {
  for (const QString& name : tour_names()) {
    window.parts().actions->add(
        menu, "help-tour-" + name, shown_text(tour_title(name).toStdString()), {},
        [&window, name] { start_tour(window, name); }, Recorded::ByItself);
  }
}

}  // namespace croquis::app
