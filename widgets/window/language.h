// The languages of the window, switched while it runs.
#pragma once

#include <QString>
#include <vector>

namespace voluta::window {

struct Language {
  QString code; // "en", "it"
  QString name; // in itself: "English", "Italiano"
};

// English first, then every translation compiled in.
std::vector<Language> languagesThere();
QString chosenLanguage();
// Installs its translators (none for English); every widget gets a LanguageChange event. An unknown
// code gives English.
void chooseLanguage(const QString& code);
// The code in the settings, else the system's language where there is a translation, else "en".
QString wantedLanguage();

} // namespace voluta::window
