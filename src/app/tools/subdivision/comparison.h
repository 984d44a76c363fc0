// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "app/studio/studio.h"
#include "app/views/live_item.h"

namespace croquis::app {

/// The active object's operation with one parameter changed, kept evaluated beside it: the same cage, another scheme.
/// Nothing of it is in the document.
class Comparison : public QObject {
  Q_OBJECT

 public:
  Comparison(Studio& studio, QThreadPool& threads, QObject* parent);

  bool shown() const { return shown_; }
  void show(bool shown);

  /// @param parameter of the operation, a Choice. @param value one of its choices
  void choose(const std::string& parameter, const std::string& value);

  /// The object in whose place this stands; 0 when there is none to compare with.
  NodeId object() const { return object_; }
  const render::MeshItemPtr& item() const { return item_.item(); }
  QString title() const;  ///< "catmull-clark"
  bool busy() const { return shown_ && ((live_ && live_->busy()) || item_.busy()); }

  /// After the document has changed.
  void follow();

 signals:
  void changed();

 private:
  void take();

  Studio& studio_;
  LiveItem item_;
  bool shown_ = false;
  std::string parameter_ = "scheme";
  std::string value_;  ///< empty: another one than the object's
  NodeId object_ = 0;
  std::string shown_value_;
  QString title_;
  std::unique_ptr<LiveNode> live_;
};

}  // namespace croquis::app
