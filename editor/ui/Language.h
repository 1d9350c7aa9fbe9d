// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <QStringList>

namespace glenoid {

/// The languages that the program speaks, by ISO code; the first is that of the sources.
QStringList languages();
/// A language in its own words: "English", "Español".
QString languageName(const QString& code);
/// The one of the system if the program speaks it, else English.
QString systemLanguage();
/// Switches at once: every widget gets a LanguageChange event. Unknown codes mean English.
void setLanguage(const QString& code);
QString currentLanguage();

}  // namespace glenoid
