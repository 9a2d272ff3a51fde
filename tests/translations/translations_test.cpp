#include "scene/colouring.h"
#include "translation_file.h"

#include <QDir>
#include <QDirIterator>
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

// What `pattern` finds in `text`, in sorted order: a translation may place it elsewhere.
QStringList found(const QString& text, const QString& pattern) {
  QStringList all;
  auto matches = QRegularExpression(pattern).globalMatch(text);
  while (matches.hasNext())
    all << matches.next().captured();
  all.sort();
  return all;
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
    {"placeholders", "%(L?[0-9]+|n)"},
    {"tags", "</?[a-z][a-z0-9]*[^>]*>"},
    {"name filters", "\\(\\*[^)]*\\)"},
    {"trailing ellipsis or colon", "[…:]$"},
};

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

// The names in the calls of RunContext::report() in core. The writers of programs report the id
// of their format, which stays as it is in every language.
QStringList stagesReported() {
  static const QRegularExpression kCall(
      QStringLiteral("\\breport\\([^;]*?\"([^\"]+)\"\\s*(\\+[^;]*)?\\);"));
  QStringList names;
  QDirIterator files(root().filePath(QStringLiteral("core")), {QStringLiteral("*.cpp")},
                     QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString path = files.next();
    QFile source(path);
    if (path.contains(QStringLiteral("/core/program/")) || !source.open(QIODevice::ReadOnly))
      continue;
    auto calls = kCall.globalMatch(QString::fromUtf8(source.readAll()));
    while (calls.hasNext())
      names << calls.next().captured(1).trimmed();
  }
  names.removeDuplicates();
  return names;
}

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
        EXPECT_EQ(found(form, kept.pattern).join(' ').toStdString(),
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
  run.start(lupdate, {"-silent", "-no-obsolete", "-locations", "none", "-I", "widgets",
                      "-recursive", "widgets", "app", "-ts", copy});
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

// Core and scene speak English without Qt: lupdate sees their texts only where they are listed.
TEST_P(Translations, HasEveryStageThatCoreReports) {
  const QSet<QString> known = sourcesOf(QStringLiteral("Stages"));
  const QStringList reported = stagesReported();
  ASSERT_FALSE(reported.isEmpty());
  for (const QString& stage : reported)
    EXPECT_TRUE(known.contains(stage)) << "not listed for lupdate: " << stage.toStdString();
}

TEST_P(Translations, HasEveryQuantityToColourBy) {
  const QSet<QString> known = sourcesOf(QStringLiteral("Scene"));
  for (const voluta::scene::ColourByRow& row : voluta::scene::colourByTable()) {
    const std::string label(row.label);
    EXPECT_TRUE(known.contains(QString::fromStdString(label)))
        << "not listed for lupdate: " << label;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Translations, testing::ValuesIn(translationFiles()),
                         [](const testing::TestParamInfo<std::string>& file) {
                           return file.param.substr(0, file.param.find('.'));
                         });

TEST(TranslationFile, NamesLineOfWhatIsNotWellFormed) {
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
