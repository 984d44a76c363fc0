// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/command_palette.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>
#include <utility>

#include "app/panels/attribute_panel.h"
#include "app/panels/object_names.h"
#include "app/start/gallery.h"
#include "app/start/start_page.h"
#include "app/window/help_pages.h"
#include "app/window/language.h"
#include "app/window/main_window.h"
#include "croquis/document/operation.h"

namespace croquis::app {
namespace {

constexpr QSize palette_size(660, 420);
constexpr int top_margin = 60;  // below the window's upper edge

QString palette_text(const char* text) { return QCoreApplication::translate("Palette", text); }

QString plain(const QString& text) {
  return without_marks(text.section('\t', 0, 0)).remove(QStringLiteral("…")).trimmed();
}

void add_menu_commands(std::vector<Command>& commands, const MainWindow& window) {
  for (QAction* action : window.actions()) {
    const QString text = plain_text(*action);
    if (text.isEmpty() || action->isSeparator()) continue;
    commands.push_back({text, menu_place(*action), keys_of(*action), action->isEnabled() && action->isVisible(),
                        [action] { action->trigger(); }});
  }
}

void add_parameter_commands(std::vector<Command>& commands, MainWindow& window) {
  const Studio& studio = window.studio();
  const WorkObject* object = window.shows_views() ? studio.active() : nullptr;
  if (object == nullptr) return;
  for (const NodeId step : object->chain) {
    const Node* node = studio.session().document().find(step);
    const OperationDescription* operation = node == nullptr ? nullptr : studio.description(node->operation);
    if (operation == nullptr) continue;
    for (const ParameterDescription& parameter : operation->parameters) {
      if (parameter.place == ParameterPlace::Nowhere || parameter.name == operation->list_flag) continue;
      commands.push_back({parameter_title(parameter),
                          palette_text("Attributes") + QStringLiteral(" ▸ ") + shown_text(operation->title),
                          {},
                          true,
                          [&window, step, name = parameter.name] { show_parameter(window, step, name); }});
    }
  }
}

void add_files_and_pages(std::vector<Command>& commands, MainWindow& window) {
  for (const QString& path : recent_files()) {
    commands.push_back({QFileInfo(path).fileName(), palette_text("Open recent"), {}, true, [&window, path] {
                          begin_open(window, {path});
                        }});
  }
  for (const Sample& sample : samples()) {
    commands.push_back({sample.title, palette_text("Examples"), {}, true, [&window, name = sample.name] {
                          emit window.parts().start_page->sample_wanted(name);
                        }});
  }
  for (const QString& heading : manual_headings())
    commands.push_back(
        {heading, palette_text("Help"), {}, true, [&window, heading] { show_manual(window, {heading}); }});
}

bool begins_word(const QString& text, qsizetype at) { return at == 0 || !text[at - 1].isLetterOrNumber(); }

/// Whether the rest of the letters stand in the text from a place on, each beside the one before it or where a word
/// begins.
bool has_letters(const QString& text, qsizetype at, const QString& letters) {
  if (letters.isEmpty()) return true;
  for (qsizetype next = at; next < text.size(); ++next) {
    const bool fits = (next == at && at > 0) || begins_word(text, next);
    if (fits && text[next].toLower() == letters[0].toLower() && has_letters(text, next + 1, letters.mid(1)))
      return true;
  }
  return false;
}

int match_of_word(const QString& word, const QString& text) {
  if (text.startsWith(word, Qt::CaseInsensitive)) return 8;
  for (qsizetype at = text.indexOf(word, 0, Qt::CaseInsensitive); at > 0;
       at = text.indexOf(word, at + 1, Qt::CaseInsensitive)) {
    if (begins_word(text, at)) return 6;
  }
  if (text.contains(word, Qt::CaseInsensitive)) return 4;
  return has_letters(text, 0, word) ? 1 : 0;
}

class Palette : public QDialog {
 public:
  Palette(QWidget& parent, std::vector<Command> commands)
      : QDialog(&parent), commands_(std::move(commands)), field_(new QLineEdit(this)), list_(make_command_list(this)) {
    setObjectName("palette");
    setWindowTitle(palette_text("Search commands"));
    setAttribute(Qt::WA_DeleteOnClose);
    field_->setPlaceholderText(palette_text("What do you want to do?"));
    field_->setClearButtonEnabled(true);
    field_->setAccessibleName(windowTitle());
    list_->setAccessibleName(palette_text("Commands found"));
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setHeaderHidden(true);
    auto* column = new QVBoxLayout(this);
    column->addWidget(field_);
    column->addWidget(list_);
    resize(palette_size.boundedTo(parent.size()));
    move(parent.mapToGlobal(QPoint((parent.width() - width()) / 2, top_margin)));
    connect(field_, &QLineEdit::textChanged, this, [this] { list_found(); });
    connect(list_, &QTreeWidget::itemClicked, this, [this] { take(); });
    list_found();
  }

 protected:
  void keyPressEvent(QKeyEvent* event) override {
    const int row = list_->indexOfTopLevelItem(list_->currentItem());
    const auto choose = [this](int at) {
      list_->setCurrentItem(list_->topLevelItem(std::clamp(at, 0, list_->topLevelItemCount() - 1)));
    };
    switch (event->key()) {
      case Qt::Key_Down: return choose(row + 1);
      case Qt::Key_Up: return choose(row - 1);
      case Qt::Key_Return:
      case Qt::Key_Enter: return take();
      default: QDialog::keyPressEvent(event);
    }
  }

 private:
  void list_found() {
    list_->clear();
    for (const std::size_t i : found_commands(commands_, field_->text())) {
      const Command& command = commands_[i];
      auto* item = new QTreeWidgetItem(list_, {command.text, command.place, command.keys});
      item->setData(0, Qt::UserRole, static_cast<qulonglong>(i));
      for (int column = 0; column < 3; ++column) {
        if (!command.enabled || column == 1) item->setForeground(column, palette().placeholderText());
      }
      if (!command.enabled) item->setToolTip(0, palette_text("Not possible with what is selected now"));
    }
    list_->setCurrentItem(list_->topLevelItem(0));
  }

  /// What can't be done now stays in the list, so that people see that it exists.
  void take() {
    const QTreeWidgetItem* item = list_->currentItem();
    if (item == nullptr) return;
    const Command command = commands_[item->data(0, Qt::UserRole).toULongLong()];
    if (!command.enabled) return;
    close();
    QMetaObject::invokeMethod(parent(), command.run, Qt::QueuedConnection);  // once the keyboard is back there
  }

  std::vector<Command> commands_;
  QLineEdit* field_;
  QTreeWidget* list_;
};

}  // namespace

QTreeWidget* make_command_list(QWidget* parent) {
  auto* list = new QTreeWidget(parent);
  list->setHeaderLabels({palette_text("Command"), palette_text("Menu"), palette_text("Keys")});
  list->setRootIsDecorated(false);
  list->header()->setStretchLastSection(false);
  list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  return list;
}

QString plain_text(const QAction& action) { return plain(action.text()); }

QString menu_place(const QAction& action) {
  for (const QObject* object : action.associatedObjects()) {
    const auto* menu = qobject_cast<const QMenu*>(object);
    if (menu == nullptr || menu->title().isEmpty()) continue;
    const QString above = menu_place(*menu->menuAction());
    return (above.isEmpty() ? QString() : above + QStringLiteral(" ▸ ")) + plain(menu->title());
  }
  return {};
}

std::vector<Command> all_commands(MainWindow& window) {
  std::vector<Command> commands;
  add_menu_commands(commands, window);
  add_parameter_commands(commands, window);
  add_files_and_pages(commands, window);
  for (Command& command : commands) command.english = english_of(command.text);
  return commands;
}

int match_of(const QString& typed, const QString& text) {
  int sum = 0;
  for (const QString& word : typed.split(' ', Qt::SkipEmptyParts)) {
    const int match = match_of_word(word, text);
    if (match == 0) return 0;
    sum += match;
  }
  return sum;
}

std::vector<std::size_t> found_commands(const std::vector<Command>& commands, const QString& typed) {
  std::vector<std::size_t> found(commands.size());
  std::iota(found.begin(), found.end(), std::size_t{0});
  if (typed.trimmed().isEmpty()) return found;
  std::vector<int> matches;
  for (const Command& command : commands) {
    const int by_text = std::max(match_of(typed, command.text), match_of(typed, command.english));
    // The place counts, too, but less: "file open" finds "Open" of the menu File.
    const int best = std::max(2 * by_text, match_of(typed, command.text + ' ' + command.place));
    matches.push_back(best == 0 ? 0 : 2 * best + (command.enabled ? 1 : 0));
  }
  std::erase_if(found, [&](std::size_t i) { return matches[i] == 0; });
  std::ranges::stable_sort(found, [&](std::size_t a, std::size_t b) {
    if (matches[a] != matches[b]) return matches[a] > matches[b];
    return commands[a].text.size() < commands[b].text.size();
  });
  return found;
}

void show_palette(QWidget& parent, std::vector<Command> commands) {
  delete parent.findChild<QDialog*>("palette");
  (new Palette(parent, std::move(commands)))->open();
}

}  // namespace croquis::app
