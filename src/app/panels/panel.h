// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/number_box.h"

class QAction;
class QBoxLayout;
class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QSlider;

namespace croquis::app {

/// A panel of fields. Each field is made with a function that reads what it shows and one that takes what people set
/// there, so that a panel is one list of rows: it keeps no widgets, and all of them follow by one call.
class Panel : public QWidget {
 public:
  /// @param name of the object, by which tests find it
  explicit Panel(const QString& name);

  /// What a field of numbers shows. Without a value it keeps the one that it has.
  struct Number {
    std::optional<double> value;
    bool enabled = true;
  };

  // Fields, which aren't laid out yet.
  QDoubleSpinBox* number(const QString& name, const NumberRange& range, std::function<Number()> read,
                         std::function<void(double)> take, const QString& tip = {});
  /// @param read the place in the list of words; without one the field is disabled and keeps its word
  QComboBox* choice(const QString& name, const QStringList& words, std::function<std::optional<int>()> read,
                    std::function<void(int)> take, const QString& tip = {});
  /// The same by values, which are the items' data.
  struct Choice {
    QString words, value;
  };
  QComboBox* choice_of_values(const QString& name, const std::vector<Choice>& choices,
                              std::function<std::string()> read, std::function<void(const std::string&)> take,
                              const QString& tip = {});
  QCheckBox* flag(const QString& name, const QString& words, std::function<bool()> read, std::function<void(bool)> take,
                  const QString& tip = {});
  /// @param take a value, and whether the slider is still held down: then it leads
  QSlider* slider(const QString& name, int low, int high, std::function<int()> read,
                  std::function<void(int value, bool dragging)> take, const QString& tip = {});
  QPushButton* button(const QString& name, const QString& words, const QString& tip, std::function<void()> work);
  QLabel* text(const QString& name, std::function<QString()> read);  ///< hidden while it is empty
  QLabel* label(const QString& words);

  /// Calls this whenever the panel follows; what it sets isn't taken for what people set.
  void also(std::function<void()> follow) { follow_.push_back(std::move(follow)); }

  // Layout, from above.
  struct Cell {
    Cell(QWidget* shown, int share = 0) : widget(shown), stretch(share) {}  // NOLINT(google-explicit-constructor)
    QWidget* widget;
    int stretch;
  };
  QBoxLayout* column() const { return column_; }
  QHBoxLayout* row(std::initializer_list<Cell> cells);
  /// Buttons of the window's actions in a grid, named "button-" and the action.
  void buttons(std::initializer_list<const char*> names, int columns, Qt::ToolButtonStyle style,
               const std::function<QAction*(const QString&)>& action);

  /// Shows everything as it is now.
  void follow();
  bool following() const { return following_; }

 private:
  QBoxLayout* column_;
  std::vector<std::function<void()>> follow_;
  bool following_ = false;
};

/// A panel that a small window scrolls.
QScrollArea* scrolled(QWidget* panel);

}  // namespace croquis::app
