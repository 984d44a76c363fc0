// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <string>

class QWidget;

namespace croquis::app {

// English stands in the sources and in the descriptions of operations; other languages in languages/, which
// scripts/translations keeps complete. A text has one translation, wherever it is shown.

/// Codes of the languages with their own names, English first.
QList<std::pair<QString, QString>> languages();

/// The language that people chose, else that of the system where there is one; else English.
QString kept_language();
void keep_language(const QString& code);

/// Texts are shown in that language from now on.
void use_language(const QString& code);

/// Gives what a window shows already, and windows of its own, texts in the language in use.
void retranslate(QWidget& window);

/// A text of a description in the language in use.
QString shown_text(const std::string& english);

/// A text that a library composed while the program runs (languages/composed.txt), in the language in use. Values in it
/// are shown in it, too, where they are known; a text that isn't stays.
QString localized(const std::string& composed);

/// First letters of ids that the program gives to strokes, and to curves, faces, points and nodes.
inline const QString stroke_ids = QStringLiteral("s"), network_ids = QStringLiteral("cfpn");

/// A text with the numbers alone of such ids: "Draw stroke 3" for "Draw stroke s3". Names and files stay.
QString with_numbers(const std::string& text, const QString& letters);

/// As it begins a row or a sentence.
QString capitalized(QString text);

/// The English of a shown text; the text itself where it is none of the translated ones.
QString english_of(const QString& shown);

}  // namespace croquis::app
