// Texts name settings as they are typed; the window shows their labels (base/setting_marks.h).
#include "language/setting_labels.h"

#include "base/setting_marks.h"
#include "language/words.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "texts/known_texts.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>
#include <set>

using namespace voluta;

namespace {

// Texts that name keys of the files of processes and materials, which their readers report.
const std::set<std::string_view> kOfFiles{
    "check nozzleDiameterMm and beadWidthMm", "is longer than maxLayerTimeS",
    "is {height} by default, more than the default of beadWidthMm, {width}: beads are no higher "
    "than wide",
    "is {tolerance}, not less than the maximum of layerHeightMm, {height}: the head would pass "
    "through a layer"};

const base::ParameterTable& parameters() {
  static const base::ParameterTable kTable = pipeline::allParameters();
  return kTable;
}

bool isOfWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// Returns the keys and options of settings in a sentence. A key without a capital letter is an
// English word, unless it has a value: "supports=auto".
std::vector<std::string> typedSettings(const std::string& sentence) {
  std::vector<std::string> found;
  for (std::size_t i = 0; i < sentence.size();) {
    const bool isOption = sentence.compare(i, 2, "--") == 0;
    std::size_t end = i + (isOption ? 2 : 0);
    while (end < sentence.size() && isOfWord(sentence[end]))
      ++end;
    const std::string word = sentence.substr(i, end - i);
    const bool isKey = parameters().find(word) != nullptr &&
                       (sentence[end] == '=' || std::ranges::any_of(word, [](char c) {
                          return std::isupper(static_cast<unsigned char>(c)) != 0;
                        }));
    static const std::set<std::string_view> kOptions{"--mode", "--cell", "--platform", "--scale",
                                                     "--units"};
    const bool isPlace = i > 0 && sentence[i - 1] == '{';
    if (!isPlace && (isKey || kOptions.contains(word)))
      found.push_back(word);
    i = std::max(end, i + 1);
  }
  return found;
}

class SettingLabels : public testing::Test {
protected:
  SettingLabels() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
  ~SettingLabels() override { QLocale::setDefault(before_); }

private:
  char name_[5] = "test";
  char* arguments_[2] = {name_, nullptr};
  int count_ = 1;
  QCoreApplication application_{count_, arguments_};
  QLocale before_;
};

std::string inWindow(std::string_view setting) {
  return language::settingText(setting).toStdString();
}

TEST_F(SettingLabels, AreThoseOfTheForms) {
  EXPECT_EQ(inWindow("brimWidthMm"), "“Brim width”");
  EXPECT_EQ(inWindow("orient=none"), "“Turn the part: None”");
  EXPECT_EQ(inWindow("infillDensity=0.1"), "“Infill density: 10 %”");
  EXPECT_EQ(inWindow("givenToolPaths=false"), "“Tool-paths of the file: off”");
  EXPECT_EQ(inWindow("minLayerTimeS={least:.0f}"), "“Minimum layer time: {least:.0f}”");
  EXPECT_EQ(inWindow("--cell lathe"), "“Cell: lathe”");
  EXPECT_EQ(inWindow("--scale fit"), "“Fit to reach”");
  EXPECT_EQ(inWindow("unheardOf=1"), "unheardOf=1");
  EXPECT_EQ(language::words("scale it down (`--scale fit`), or give the units (`--units`)"_text)
                .toStdString(),
            "scale it down (“Fit to reach”), or give the units");
}

// The labels of options are in the sources of their forms.
TEST_F(SettingLabels, OfOptionsAreWrittenInTheForms) {
  const auto source = [](const char* file) {
    QFile in(QStringLiteral(VOLUTA_ROOT) + QLatin1String(file));
    return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
  };
  for (const char* label : {"Mode", "Cell", "Platform"})
    EXPECT_TRUE(source("/widgets/forms/choices_form.cpp").contains(QByteArray("(tr(\"") + label))
        << label;
  for (const char* label : {"Scale", "Fit to reach"})
    EXPECT_TRUE(
        source("/widgets/panels/placement_panel.cpp").contains(QByteArray("(tr(\"") + label))
        << label;
}

TEST_F(SettingLabels, EveryTextNamesSettingsInBackquotes) {
  std::size_t settings = 0;
  for (const base::Text& text : texts::knownTexts())
    for (const std::string_view form : {text.english(), text.one()}) {
      settings += base::settingsIn(form).size();
      const std::string others =
          base::withSettings(form, [](std::string_view) { return std::string("|"); });
      EXPECT_EQ(others.find('`'), std::string::npos) << form;
      if (!kOfFiles.contains(form)) {
        EXPECT_EQ(typedSettings(others), std::vector<std::string>{}) << form;
      }
    }
  EXPECT_GT(settings, 60u);
}

TEST_F(SettingLabels, EveryTextShowsThemAsTypedOrByTheirLabels) {
  for (const base::Text& text : texts::knownTexts())
    for (const std::string& setting : base::settingsIn(text.english())) {
      EXPECT_NE(base::english(text).find(setting), std::string::npos) << text.english();
      EXPECT_EQ(base::english(text).find('`'), std::string::npos) << text.english();
      const std::string shown = language::words(text).toStdString();
      EXPECT_EQ(shown.find('`'), std::string::npos) << shown;
      EXPECT_EQ(typedSettings(shown), std::vector<std::string>{}) << shown;
      std::string label;
      EXPECT_NO_THROW(label = inWindow(setting)) << setting << " has no such value";
      EXPECT_NE(label, setting) << "no form has this setting";
    }
}

TEST_F(SettingLabels, RemediesOfFindingsNameLabelsInTheWindowAndKeysElsewhere) {
  std::size_t withKeys = 0;
  for (const plan::FindingRow& row : plan::findingRows()) {
    const std::string typed = base::english(row.remedy);
    const std::string shown = language::words(row.remedy).toStdString();
    const bool hasKeys = !typedSettings(typed).empty();
    withKeys += hasKeys ? 1 : 0;
    EXPECT_EQ(hasKeys, !base::settingsIn(row.remedy.english()).empty()) << typed;
    EXPECT_EQ(typedSettings(shown), std::vector<std::string>{}) << shown;
    if (!hasKeys) {
      EXPECT_EQ(shown, typed);
    }
  }
  EXPECT_GT(withKeys, 30u);
}

// Project files keep texts as the command line shows them.
TEST(KnownTexts, AreFoundWithoutTheBackquotes) {
  const base::Text text = texts::knownText("give orient=none");
  EXPECT_EQ(text.english(), "give `orient=none`");
}

} // namespace
