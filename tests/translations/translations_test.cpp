#include "texts/known_texts.h"
#include "translation_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <gtest/gtest.h>

using namespace voluta::translations;

namespace {
QDir root() {
  return QDir(QStringLiteral(VOLUTA_ROOT));
}

// The matches of `pattern` in `text`, in sorted order: a translation may place them elsewhere.
QStringList found(const QString& text, const QString& pattern) {
  QStringList all;
  auto matches = QRegularExpression(pattern).globalMatch(text);
  while (matches.hasNext())
    all << matches.next().captured();
  all.sort();
  return all;
}

// Chinese has wide colons.
QString withUsualColons(QString text) {
  return text.replace(QChar(0xFF1A), ':');
}

qsizetype mnemonics(QString text) {
  text.remove(QStringLiteral("&&"));
  return text.count(
      QRegularExpression(QStringLiteral("&\\w"), QRegularExpression::UseUnicodePropertiesOption));
}

// The parts of a text that no language changes.
struct Kept {
  const char* what;
  const char* pattern;
};
constexpr Kept kKept[] = {
    {"placeholders", "%(L?[0-9]+|n)"},       {"settings", "`[^`]+`"},
    {"tags", "</?[a-z][a-z0-9]*[^>]*>"},     {"name filters", "\\(\\*[^)]*\\)"},
    {"trailing ellipsis or colon", "[…:]$"},
};

constexpr const char* kPlacePattern = "\\{([A-Za-z][A-Za-z0-9]*)(:[.0-9]*[gf])?#?\\}";

// Of places, each once.
QStringList namesOf(const QString& text) {
  static const QRegularExpression kPlace(QLatin1String{kPlacePattern});
  QStringList names;
  auto matches = kPlace.globalMatch(text);
  while (matches.hasNext())
    names << matches.next().captured(1);
  names.removeDuplicates();
  return names;
}

class Translations : public testing::TestWithParam<std::string> {
protected:
  QString name() const { return QString::fromStdString(GetParam()); }
  QSet<QString> sourcesOf(const QString& context) const {
    QSet<QString> sources;
    for (const Message& message : readTranslationFile(file()))
      if (message.context == context)
        sources.insert(message.source);
    return sources;
  }
  QString file() const { return root().filePath(QStringLiteral("translations/") + name()); }
};

std::vector<std::string> translationFiles() {
  std::vector<std::string> names;
  for (const QString& name : QDir(root().filePath(QStringLiteral("translations")))
                                 .entryList({QStringLiteral("*.ts")}, QDir::Files, QDir::Name))
    names.push_back(name.toStdString());
  return names;
}
} // namespace

TEST_P(Translations, EveryMessageIsFinished) {
  const std::vector<Message> messages = readTranslationFile(file());
  ASSERT_FALSE(messages.empty());
  for (const Message& message : messages) {
    EXPECT_TRUE(message.finished) << message.key().toStdString();
    EXPECT_FALSE(message.forms.isEmpty()) << message.key().toStdString();
    for (const QString& form : message.forms)
      EXPECT_FALSE(form.trimmed().isEmpty()) << message.key().toStdString();
  }
}

TEST_P(Translations, KeepsPlaceholdersAndMarkup) {
  for (const Message& message : readTranslationFile(file()))
    for (const QString& form : message.forms)
      for (const Kept& kept : kKept)
        EXPECT_EQ(found(withUsualColons(form), kept.pattern).join(' ').toStdString(),
                  found(message.source, kept.pattern).join(' ').toStdString())
            << kept.what << " of " << message.key().toStdString();
}

TEST_P(Translations, KeepsMnemonics) {
  for (const Message& message : readTranslationFile(file()))
    for (const QString& form : message.forms)
      EXPECT_EQ(mnemonics(form), mnemonics(message.source)) << message.key().toStdString();
}

// The same call as the target update_translations, on a copy.
TEST_P(Translations, HasEveryTextOfTheWindow) {
  const QString lupdate = QStringLiteral(VOLUTA_LUPDATE);
  if (lupdate.isEmpty() || !QFileInfo(lupdate).isExecutable())
    GTEST_SKIP() << "lupdate is not installed (Debian: qt6-l10n-tools)";
  const QTemporaryDir folder;
  const QString copy = folder.filePath(name());
  ASSERT_TRUE(QFile::copy(file(), copy));
  QProcess run;
  run.setWorkingDirectory(root().path());
  run.start(lupdate,
            {"-silent", "-no-obsolete", "-locations", "none", "-I", "widgets", "-recursive",
             "widgets", "app", QStringLiteral(VOLUTA_TEXT_NOTES), "-ts", copy});
  ASSERT_TRUE(run.waitForFinished(120000));
  ASSERT_EQ(run.exitCode(), 0) << run.readAllStandardError().toStdString();

  QSet<QString> inWindow;
  for (const Message& message : readTranslationFile(copy)) {
    EXPECT_TRUE(message.finished) << "not translated: " << message.key().toStdString();
    inWindow.insert(message.key());
  }
  for (const Message& message : readTranslationFile(file()))
    EXPECT_TRUE(inWindow.contains(message.key()))
        << "no longer in the window: " << message.key().toStdString();
}

// Core's texts are data: the list for translators is made from its sources.
TEST_P(Translations, HasEveryTextOfCore) {
  const QSet<QString> known = sourcesOf(QStringLiteral("Core"));
  static const QRegularExpression kPlace(QLatin1String{kPlacePattern}), kLetter("[A-Za-z]");
  ASSERT_GT(voluta::texts::knownTexts().size(), 500u);
  for (const voluta::base::Text& text : voluta::texts::knownTexts()) {
    const QString source = QString::fromStdString(std::string(text.english()));
    const bool hasWords = QString(source).remove(kPlace).contains(kLetter);
    EXPECT_TRUE(!hasWords || known.contains(source)) << "not translated: " << source.toStdString();
  }
}

// Each value of a sentence has its place in every language; the form for one may do without its
// number ("a piece ...").
TEST_P(Translations, KeepsPlacesOfValues) {
  for (const Message& message : readTranslationFile(file())) {
    const QStringList places = namesOf(message.source);
    for (qsizetype i = 0; i < message.forms.size(); ++i) {
      const QStringList own = namesOf(message.forms[i]);
      for (const QString& name : own)
        EXPECT_TRUE(places.contains(name))
            << name.toStdString() << " in " << message.key().toStdString();
      const bool last = i + 1 == message.forms.size();
      EXPECT_TRUE(!last || own.size() == places.size()) << message.key().toStdString();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Translations, testing::ValuesIn(translationFiles()),
                         [](const testing::TestParamInfo<std::string>& file) {
                           return file.param.substr(0, file.param.find('.'));
                         });

TEST(TranslationFile, NamesTheLineThatIsNotWellFormed) {
  const QTemporaryDir folder;
  QFile broken(folder.filePath(QStringLiteral("broken.ts")));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("<TS>\n<context>\n<message>\n</context></TS>");
  broken.close();
  try {
    readTranslationFile(broken.fileName());
    FAIL() << "read without complaint";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("broken.ts:4:"), std::string::npos) << error.what();
  }
}
