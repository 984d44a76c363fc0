// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/language.h"

#include <QAbstractItemModel>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QHash>
#include <QHeaderView>
#include <QLibraryInfo>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QSettings>
#include <QTableWidget>
#include <QTextEdit>
#include <QTranslator>
#include <QTreeWidget>
#include <QXmlStreamReader>
#include <algorithm>
#include <array>
#include <functional>
#include <memory>

#include "app/window/action_list.h"

namespace croquis::app {
namespace {

constexpr const char* context = "Croquis";
constexpr const char* language_key = "language";

/// The same text is translated alike wherever the sources have it.
class Translations : public QTranslator {
 public:
  using QTranslator::QTranslator;
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* source, const char*, int) const override {
    return QTranslator::translate(context, source);
  }
};

/// A text with places for values, in English or another language.
struct Pattern {
  QRegularExpression shown;
  QString longest;        ///< piece between values: a text without it doesn't fit
  qsizetype letters = 0;  ///< of all pieces
  QList<int> places;      ///< which value each group of it is
  QString source;
};

/// What may be shown, without the marks of letters, and the English of the sources for it.
struct Texts {
  QHash<QString, QString> english;  ///< by itself
  QHash<QString, QString> shown;    ///< by a translation
  QList<Pattern> patterns;
};

/// A sentence may be a part of another one, which has a full stop of its own.
QString without_stop(const QString& sentence) { return sentence.endsWith('.') ? sentence.chopped(1) : sentence; }

void add_pattern(Texts& texts, const QString& sentence, const QString& source) {
  static const QRegularExpression place(QStringLiteral("%(\\d)"));
  static const QRegularExpression word(QStringLiteral("\\w{2}|[\\x{ac00}-\\x{d7a3}]{2}"));
  const QString shown = without_stop(sentence);
  if (!shown.contains(place) || !QString(shown).remove(place).contains(word)) return;  // it would fit anything
  Pattern pattern;
  pattern.source = source;
  for (const auto& found : place.globalMatch(shown)) pattern.places << found.captured(1).toInt();
  const QStringList pieces = shown.split(place);
  QString expression = QRegularExpression::escape(pieces.front());
  for (const QString& piece : pieces.mid(1))  // of two values beside each other the first is one word
    expression += (piece == " " ? "(\\S+)" : "(.+)") + QRegularExpression::escape(piece);
  pattern.longest = *std::ranges::max_element(pieces, {}, &QString::size);
  pattern.letters = pieces.join(QString()).size();
  pattern.shown.setPattern(QRegularExpression::anchoredPattern(expression));
  texts.patterns << pattern;
}

Texts read_texts() {
  Texts texts;
  for (const auto& [code, name] : languages()) {
    QFile file(QStringLiteral(":/languages/croquis_%1.ts").arg(code));
    if (!file.open(QIODevice::ReadOnly)) continue;  // English is in the sources
    QXmlStreamReader reader(&file);
    QString source;
    while (!reader.atEnd()) {
      if (reader.readNext() != QXmlStreamReader::StartElement) continue;
      if (reader.name() == QLatin1String("source")) {
        source = reader.readElementText();
        texts.english[without_marks(source)] = source;
        add_pattern(texts, without_marks(source), source);
      } else if (reader.name() == QLatin1String("translation")) {
        const QString translation = without_marks(reader.readElementText());
        texts.shown[translation] = source;
        add_pattern(texts, translation, source);
      }
    }
  }
  // What says most fits best.
  std::ranges::stable_sort(texts.patterns, std::ranges::greater(), &Pattern::letters);
  return texts;
}

/// Read when they are first asked for: most starts never do.
const Texts& texts() {
  static const Texts read = read_texts();
  return read;
}

QString translated(const QString& english) {
  return QCoreApplication::translate(context, english.toUtf8().constData());
}

QString composed_in_language(const QString& text);

struct Translation {
  QString text;
  qsizetype letters = 0;  ///< that the known text says itself; 0 where none is known
};

/// By itself or by a pattern.
Translation translation_of(const QString& text) {
  const QString sentence = without_stop(text);
  const QString stop = text.endsWith('.') ? QStringLiteral(".") : QString();
  for (const QString& each : {text, sentence, text + '.'}) {
    const auto source = texts().english.constFind(english_of(each));
    if (source == texts().english.constEnd()) continue;
    return {each == text ? translated(*source) : without_stop(translated(*source)) + stop, text.size()};
  }
  for (const Pattern& pattern : texts().patterns) {
    if (!sentence.contains(pattern.longest)) continue;
    const auto found = pattern.shown.match(sentence);
    if (!found.hasMatch()) continue;
    QString after = without_stop(translated(pattern.source));
    for (int i = 0; i < pattern.places.size(); ++i)
      after.replace(QChar(u'%') + QString::number(pattern.places[i]), composed_in_language(found.captured(i + 1)));
    return {after + stop, pattern.letters};
  }
  return {};
}

/// The parts between separators, each in the language in use; null where too few of them are known.
QString parts_in_language(const QString& text, const QString& between, bool all) {
  static const QRegularExpression word(QStringLiteral("[A-Za-z]{3}"));
  QStringList parts = text.split(between);
  qsizetype known = 0, unknown = 0;
  for (QString& part : parts) {
    const Translation after = translation_of(part);
    if (after.letters == 0 && part.contains(word)) ++unknown;
    if (after.letters == 0) continue;
    ++known;
    part = after.text;
  }
  return parts.size() < 2 || known == 0 || (all && unknown > 0) ? QString() : parts.join(between);
}

/// A name with its number, a parameter with its value ("Bulge 0.2"), or else with a choice; null where it is none.
QString titled_in_language(const QString& text, bool with_number) {
  static const QRegularExpression number(QStringLiteral("^-?[\\d.]+(e[-+]?\\d+)?$"));
  const auto& english = texts().english;
  for (qsizetype at = text.indexOf(' '); at > 0; at = text.indexOf(' ', at + 1)) {
    const auto title = english.constFind(text.left(at)), value = english.constFind(text.mid(at + 1));
    if (title == english.constEnd()) continue;
    if (with_number && number.match(text.mid(at + 1)).hasMatch()) return translated(*title) + text.mid(at);
    if (!with_number && value != english.constEnd()) return translated(*title) + ' ' + translated(*value);
  }
  return {};
}

/// "a, b and c" of texts that are known; null where one isn't.
QString list_in_language(const QString& text) {
  static const QRegularExpression between(QStringLiteral(", | and "));
  QStringList parts = text.split(between);
  for (QString& part : parts) {
    const auto source = texts().english.constFind(part);
    if (source == texts().english.constEnd()) return {};
    part = translated(*source);
  }
  return parts.size() < 2 ? QString() : parts.join(QStringLiteral(", "));
}

/// A text with values, or several of them: "Sketch 2", "file, line 3: what is wrong", sentences, a list.
QString composed_in_language(const QString& text) {
  if (const QString titled = titled_in_language(text, true); !titled.isNull()) return titled;
  if (const QString listed = list_in_language(text); !listed.isNull()) return listed;
  Translation best = translation_of(text);
  for (qsizetype at = text.indexOf(": "); at > 0 && best.letters < text.size(); at = text.indexOf(": ", at + 1)) {
    const Translation rest = translation_of(text.mid(at + 2));
    if (rest.letters > 0 && rest.letters >= best.letters)
      best = {composed_in_language(text.left(at)) + ": " + rest.text, rest.letters};
  }
  if (best.letters > 0) return best.text;
  if (const QString titled = titled_in_language(text, false); !titled.isNull()) return titled;
  for (const char* between : {"\n", ". ", ", "}) {
    const QString parts = parts_in_language(text, between, *between == ',');
    if (!parts.isNull()) return parts;
  }
  return text;
}

/// A text that is shown, in the language in use. What follows it ("\tEnter", " (mm)") is a text of its own.
QString in_language(const QString& shown) {
  if (shown.isEmpty()) return shown;
  for (const char* mark : {"\t", " ("}) {
    const auto at = shown.lastIndexOf(QLatin1String(mark));
    if (at <= 0 || texts().english.contains(english_of(shown))) continue;
    if (*mark == '\t') return in_language(shown.left(at)) + '\t' + in_language(shown.mid(at + 1));
    if (shown.endsWith(')'))
      return in_language(shown.left(at)) + " (" + in_language(shown.mid(at + 2).chopped(1)) + ')';
  }
  const QString plain = without_marks(shown);
  const QString after = composed_in_language(plain);
  return after == plain ? shown : after;
}

/// How composed texts are shown. Lists are filled anew after every step, mostly with the same ones.
struct Composed {
  bool translates = false;
  QHash<QString, QString> shown;
};

Composed& composed_texts() {
  static Composed texts;
  return texts;
}

void translate_properties(QObject& object) {
  // What people type isn't the window's.
  const bool typed = qobject_cast<QLineEdit*>(&object) != nullptr || qobject_cast<QTextEdit*>(&object) != nullptr;
  constexpr std::array names{"text",    "iconText",  "title",          "windowTitle",      "placeholderText",
                             "toolTip", "statusTip", "accessibleName", "specialValueText", "accessibleDescription"};
  for (const char* name : names) {
    if (typed && qstrcmp(name, "text") == 0) continue;
    const QVariant value = object.property(name);
    if (value.metaType() != QMetaType::fromType<QString>()) continue;
    // Two English texts may have one translation: which it was is kept beside.
    const QByteArray kept_name = QByteArray("english of ") + name;
    const QStringList kept = object.property(kept_name.constData()).toStringList();
    const QString before = value.toString();
    const QString english = !kept.isEmpty() && kept.front() == before ? kept.back() : before;
    QString after = in_language(english);
    if (qstrcmp(name, "text") != 0 && qstrcmp(name, "title") != 0) after = without_marks(after);
    if (after == before) continue;
    object.setProperty(name, after);
    object.setProperty(kept_name.constData(), QStringList{after, english});
  }
}

void translate_items(QObject& object) {
  if (auto* box = qobject_cast<QComboBox*>(&object)) {
    for (int i = 0; i < box->count(); ++i) box->setItemText(i, in_language(box->itemText(i)));
  }
  if (auto* header = qobject_cast<QHeaderView*>(&object); header != nullptr && header->model() != nullptr) {
    QAbstractItemModel& model = *header->model();
    for (int i = 0; i < header->count(); ++i) {
      const QString title = model.headerData(i, header->orientation()).toString();
      if (const QString after = in_language(title); after != title)
        model.setHeaderData(i, header->orientation(), after);
    }
  }
}

}  // namespace

QList<std::pair<QString, QString>> languages() { return {{"en", "English"}, {"ko", QStringLiteral("한국어")}}; }

QString kept_language() {
  const QString chosen = QSettings().value(language_key).toString();
  const QString wanted = chosen.isEmpty() ? QLocale().name().section('_', 0, 0) : chosen;
  for (const auto& [code, name] : languages()) {
    if (code == wanted) return code;
  }
  return languages().front().first;
}

void keep_language(const QString& code) { QSettings().setValue(language_key, code); }

void use_language(const QString& code) {
  static std::array<std::unique_ptr<QTranslator>, 2> installed;
  installed = {};  // one that is destroyed isn't installed any more
  composed_texts() = {};
  auto own = std::make_unique<Translations>();
  if (!own->load(QStringLiteral(":/languages/croquis_%1.qm").arg(code))) return;
  auto qt = std::make_unique<QTranslator>();  // of buttons such as Cancel
  if (qt->load(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(qt.get());
  QCoreApplication::installTranslator(own.get());
  composed_texts().translates = true;
  installed = {std::move(qt), std::move(own)};
}

void retranslate(QWidget& window) {
  translate_properties(window);
  for (QObject* object : window.findChildren<QObject*>()) {
    translate_properties(*object);
    translate_items(*object);
  }
}

QString shown_text(const std::string& english) { return QCoreApplication::translate(context, english.c_str()); }

QString with_numbers(const std::string& text, const QString& letters) {
  static QHash<QString, QRegularExpression> ids;  // by their letters
  QRegularExpression& id = ids[letters];
  if (id.pattern().isEmpty()) id.setPattern("(?<![\\w./\"'-])[" + letters + "](?=\\d+(?![\\w\"'-]|\\.\\w))");
  return QString::fromStdString(text).remove(id);
}

QString capitalized(QString text) {
  if (!text.isEmpty()) text.front() = text.front().toUpper();
  return text;
}

QString localized(const std::string& composed) {
  const QString text = with_numbers(composed, composed.find("troke") == std::string::npos ? network_ids : stroke_ids);
  if (!composed_texts().translates) return text;
  constexpr qsizetype most_kept = 2000;
  QHash<QString, QString>& shown = composed_texts().shown;
  if (shown.size() > most_kept) shown.clear();
  auto known = shown.constFind(text);
  if (known == shown.constEnd()) known = shown.insert(text, composed_in_language(text));
  return *known;
}

QString english_of(const QString& shown) {
  const QString plain = without_marks(shown);
  return texts().english.contains(plain) ? plain : without_marks(texts().shown.value(plain, plain));
}

}  // namespace croquis::app
