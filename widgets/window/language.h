// The languages of the window, which can be switched at run time.
#pragma once

#include <QString>
#include <vector>

namespace voluta::window {

struct Language {
  QString code; // "en", "it"
  QString name; // In that language: "English", "Italiano"
};

// Returns English first, then every translation compiled in.
std::vector<Language> languagesThere();
QString chosenLanguage();
// Installs its translators (none for English); every widget gets a LanguageChange event. An unknown
// code gives English.
void chooseLanguage(const QString& code);
// Returns the code from the settings, else the system's language if there is a translation, else
// "en".
QString wantedLanguage();

} // namespace voluta::window
