#include "window/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

namespace voluta::window {

namespace {
const QString kFolder = QStringLiteral(":/translations");

// The application owns the active translators; they are identified by their names.
void removeTranslators() {
  for (QTranslator* translator :
       qApp->findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly)) {
    QCoreApplication::removeTranslator(translator);
    delete translator;
  }
}

bool install(const QString& name, const QString& language, const QString& folder) {
  auto* translator = new QTranslator(qApp);
  if (translator->load(QLocale(language), name, "_", folder))
    return QCoreApplication::installTranslator(translator);
  delete translator;
  return false;
}

// Qt's own texts: those of its dialogs and buttons.
void installTextsOfQt(const QString& language) {
  const QString folder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
  // Qt has one of the two written forms of Norwegian. Words of buttons are mostly the same.
  if (!install("qtbase", language, folder) && language == "nb")
    install("qtbase", "nn", folder);
}
} // namespace

std::vector<Language> languagesThere() {
  std::vector<Language> found{{"en", "English"}};
  for (const QString& file : QDir(kFolder).entryList({"voluta_*.qm"}, QDir::Files, QDir::Name)) {
    const QString code = file.mid(7, file.size() - 10);
    QString name = QLocale(code).nativeLanguageName();
    if (!name.isEmpty())
      name[0] = name[0].toUpper();
    found.push_back({code, name});
  }
  return found;
}

QString chosenLanguage() {
  return qApp->property("volutaLanguage").toString().isEmpty()
             ? QStringLiteral("en")
             : qApp->property("volutaLanguage").toString();
}

void chooseLanguage(const QString& code) {
  removeTranslators();
  QString chosen = "en";
  for (const Language& language : languagesThere())
    if (language.code == code)
      chosen = code;
  qApp->setProperty("volutaLanguage", chosen);
  QLocale::setDefault(QLocale(chosen));
  if (chosen == "en")
    return;
  installTextsOfQt(chosen);
  install("voluta", chosen, kFolder);
}

QString wantedLanguage() {
  const QString kept = QSettings().value("window/language").toString();
  if (!kept.isEmpty())
    return kept;
  const QString system = QLocale::system().name().left(2);
  for (const Language& language : languagesThere())
    if (language.code == system)
      return system;
  return "en";
}

} // namespace voluta::window
