// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/preferences.h"

#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QFile>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTreeWidget>
#include <algorithm>

#include "app/views/viewport.h"
#include "app/window/command_palette.h"
#include "app/window/hotkeys.h"
#include "app/window/language.h"
#include "app/window/main_window.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr QSize dialog_size(680, 600);
constexpr const char* navigation_key = "navigation";

QString preference_text(const char* text) { return QCoreApplication::translate("Preferences", text); }

void navigate_as_kept(MainWindow& window) {
  NavigationOptions options;
  options.preset = kept_navigation().preset;
  window.views().navigation.set_options(options);
}

QComboBox* make_navigation_field(MainWindow& window, QLabel* sentence, QWidget* parent) {
  QList<std::pair<QString, QString>> choices;
  for (const NavigationChoice& choice : navigation_choices()) choices << std::pair{choice.name, choice.title};
  sentence->setText(kept_navigation().sentence);
  const auto take = [&window, sentence](const QString& name) {
    choose_navigation(window, name);
    sentence->setText(kept_navigation().sentence);
  };
  return make_choice_field("navigation", choices, kept_navigation().name, take, parent);
}

QComboBox* make_scale_field(QWidget* parent) {
  QList<std::pair<QString, QString>> choices;
  for (const int percent : scales())
    choices << std::pair{QString::number(percent), QStringLiteral("%1 %").arg(percent)};
  const auto take = [](const QString& percent) { keep_scale(percent.toInt()); };
  return make_choice_field("scale", choices, QString::number(kept_scale()), take, parent);
}

/// The list of all actions with their keys, and a field for those of the selected one.
class KeyEditor : public QWidget {
 public:
  KeyEditor(MainWindow& window, QWidget* parent) : QWidget(parent), window_(window), map_(kept_keys()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    list_->setObjectName("keys");
    list_->setAccessibleName(preference_text("Commands and their keys"));
    column->addWidget(list_, 1);
    auto* row = new QHBoxLayout;
    field_->setObjectName("key");
    field_->setAccessibleName(preference_text("New key"));
    row->addWidget(field_, 1);
    const auto add_button = [&](const QString& text, const char* name, auto work) {
      auto* button = new QPushButton(text, this);
      button->setObjectName(name);
      button->setAutoDefault(false);
      connect(button, &QPushButton::clicked, this, work);
      row->addWidget(button);
    };
    add_button(preference_text("&Set"), "set-key", [this] { set(chosen_keys()); });
    add_button(preference_text("&Remove"), "remove-key", [this] { set({}); });
    add_button(preference_text("As in the &preset"), "reset-key", [this] { reset(); });
    add_button(preference_text("&Export…"), "export-keys", [this] { ask_export(); });
    add_button(preference_text("I&mport…"), "import-keys", [this] { ask_import(); });
    column->addLayout(row);
    clash_->setObjectName("clash");
    clash_->setWordWrap(true);
    column->addWidget(clash_);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] { show_selected(); });
    connect(field_, &QKeySequenceEdit::keySequenceChanged, this, [this] { show_clash(); });
    list_actions();
  }

  const QString& preset() const { return map_.preset; }

  /// What people changed by hand stays changed.
  void set_preset(const QString& preset) {
    map_.preset = preset;
    take();
  }

  void filter(const QString& typed) {
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
      QTreeWidgetItem* item = list_->topLevelItem(i);
      const QString row = item->text(0) + ' ' + item->text(1) + ' ' + item->text(2);
      item->setHidden(!typed.trimmed().isEmpty() && match_of(typed, row) == 0);
    }
  }

 private:
  void list_actions() {
    for (QAction* action : window_.actions()) {
      const QString text = plain_text(*action);
      if (text.isEmpty()) continue;
      auto* item = new QTreeWidgetItem(list_, {text, menu_place(*action), {}});
      item->setData(0, Qt::UserRole, action->objectName());
    }
    show_keys();
    list_->setCurrentItem(list_->topLevelItem(0));
  }

  void show_keys() {
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
      QTreeWidgetItem* item = list_->topLevelItem(i);
      const QAction* action = action_of(item);
      item->setText(2, QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText));
      QFont font = item->font(2);
      font.setBold(map_.own.contains(action->objectName()));
      item->setFont(2, font);
    }
    show_selected();
  }

  QAction* action_of(const QTreeWidgetItem* item) const {
    return window_.action(item->data(0, Qt::UserRole).toString());
  }
  QAction* selected() const { return list_->currentItem() == nullptr ? nullptr : action_of(list_->currentItem()); }

  void show_selected() {
    const QAction* action = selected();
    if (action != nullptr) field_->setKeySequence(action->shortcut());
    show_clash();
  }

  /// Of a sequence that people typed the first key counts.
  QList<QKeySequence> chosen_keys() const {
    const QKeySequence typed = field_->keySequence();
    return typed.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{QKeySequence(typed[0])};
  }

  /// Who else has the key in the field.
  void show_clash() {
    const QAction* action = selected();
    QStringList others;
    if (action != nullptr) {
      for (const QAction* other : actions_with_keys(chosen_keys(), *action, window_.actions()))
        others << QStringLiteral("%1 (%2)").arg(plain_text(*other), menu_place(*other));
    }
    clash_->setText(others.isEmpty() ? QString()
                                     : preference_text("Also the key of %1").arg(others.join(QStringLiteral(", "))));
  }

  void set(const QList<QKeySequence>& keys) {
    const QAction* action = selected();
    if (action == nullptr) return;
    map_.own[action->objectName()] = keys;
    take();
  }

  void reset() {
    const QAction* action = selected();
    if (action == nullptr) return;
    map_.own.remove(action->objectName());
    take();
  }

  void take() {
    keep_keys(map_);
    apply_keys(map_, window_.actions());
    show_keys();
  }

  void ask_export() {
    const QString path = QFileDialog::getSaveFileName(this, preference_text("Export keys"), "keys.json",
                                                      preference_text("Keys (*.json)"));
    if (path.isEmpty()) return;
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(json_of(map_)) < 0)
      clash_->setText(preference_text("\"%1\" can't be written: %2").arg(path, file.errorString()));
  }

  void ask_import() {
    const QString path =
        QFileDialog::getOpenFileName(this, preference_text("Import keys"), {}, preference_text("Keys (*.json)"));
    if (path.isEmpty()) return;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
      return clash_->setText(preference_text("\"%1\" can't be read: %2").arg(path, file.errorString()));
    try {
      map_ = key_map_of(file.readAll(), path);
      take();
    } catch (const Error& error) {
      clash_->setText(QString::fromStdString(error.findings().front().message));
    }
  }

  MainWindow& window_;
  KeyMap map_;
  QTreeWidget* list_ = make_command_list(this);
  QKeySequenceEdit* field_ = new QKeySequenceEdit(this);
  QLabel* clash_ = new QLabel(this);
};

}  // namespace

QComboBox* make_choice_field(const QString& name, const QList<std::pair<QString, QString>>& choices,
                             const QString& kept, const std::function<void(const QString&)>& take, QWidget* parent) {
  auto* field = new QComboBox(parent);
  field->setObjectName(name);
  for (const auto& [value, title] : choices) field->addItem(title, value);
  field->setCurrentIndex(std::max(0, field->findData(kept)));
  QObject::connect(field, &QComboBox::currentIndexChanged, parent,
                   [field, take] { take(field->currentData().toString()); });
  return field;
}

QComboBox* make_language_field(MainWindow& window, QWidget* parent) {
  const auto take = [&window](const QString& code) {
    keep_language(code);
    use_language(code);
    retranslate(window);
    window.refresh();
  };
  return make_choice_field("language", languages(), kept_language(), take, parent);
}

QComboBox* make_theme_field(MainWindow& window, QWidget* parent) {
  const auto take = [&window](const QString& name) {
    keep_theme(name);
    use_theme(name);
    window.refresh();
  };
  return make_choice_field("theme", themes(), kept_theme(), take, parent);
}

std::array<NavigationChoice, 3> navigation_choices() {
  return {{{NavigationPreset::Maya, "maya", preference_text("Maya"),
            preference_text("Alt + left button rotates, Alt + middle pans, Alt + right zooms")},
           {NavigationPreset::Blender, "blender", preference_text("Blender"),
            preference_text("The middle button rotates, with Shift pans, with Ctrl zooms")},
           {NavigationPreset::Cad, "cad", preference_text("CAD"),
            preference_text("The middle button rotates, with Ctrl pans, with Shift zooms")}}};
}

NavigationChoice kept_navigation() {
  const auto choices = navigation_choices();
  const QString kept = QSettings().value(navigation_key).toString();
  const auto found = std::ranges::find_if(choices, [&](const NavigationChoice& choice) { return kept == choice.name; });
  return found == choices.end() ? choices.front() : *found;
}

void choose_navigation(MainWindow& window, const QString& name) {
  QSettings().setValue(navigation_key, name);
  navigate_as_kept(window);
}

bool is_anything_chosen() {
  const QSettings settings;
  const QStringList names{"language", "theme", "scale", "keys", navigation_key};
  return std::ranges::any_of(names, [&](const QString& name) { return settings.contains(name); });
}

void apply_preferences(MainWindow& window) {
  apply_keys(kept_keys(), window.actions());
  navigate_as_kept(window);
}

void show_preferences(MainWindow& window) {
  delete window.findChild<QDialog*>("preferences");
  auto* dialog = new QDialog(&window);
  dialog->setObjectName("preferences");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(preference_text("Preferences"));
  dialog->resize(dialog_size.boundedTo(window.size()));
  auto* editor = new KeyEditor(window, dialog);
  auto* sentence = new QLabel(dialog);
  auto* search = new QLineEdit(dialog);
  search->setObjectName("search");
  search->setPlaceholderText(preference_text("Search commands and keys"));
  search->setAccessibleName(search->placeholderText());
  search->setClearButtonEnabled(true);
  QObject::connect(search, &QLineEdit::textChanged, editor, [editor](const QString& typed) { editor->filter(typed); });
  auto* preset = make_choice_field(
      "key-preset", key_presets(), editor->preset(), [editor](const QString& name) { editor->set_preset(name); },
      dialog);
  auto* form = new QFormLayout(dialog);
  form->addRow(preference_text("&Language"), make_language_field(window, dialog));
  form->addRow(preference_text("&Theme"), make_theme_field(window, dialog));
  form->addRow(preference_text("S&cale"), make_scale_field(dialog));
  form->addRow(QString(), new QLabel(preference_text("A scale takes effect at the next start"), dialog));
  form->addRow(preference_text("&Navigation as in"), make_navigation_field(window, sentence, dialog));
  form->addRow(QString(), sentence);
  form->addRow(preference_text("&Keys as in"), preset);
  form->addRow(search);
  form->addRow(editor);
  dialog->open();
}

}  // namespace croquis::app
