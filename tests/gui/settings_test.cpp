// The settings of the Prepare page: the first ones on top, research behind a fold, labels, and a
// search by meaning.
#include "base/parameters.h"
#include "forms/choices_form.h"
#include "forms/fold.h"
#include "forms/parameter_form.h"
#include "forms/parameter_row.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "language/setting_words.h"
#include "pipeline/stage_options.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <set>
#include <string>

namespace voluta::test {
namespace {

using project::Stage;

class SettingsTest : public WindowTest {
protected:
  void openFlat() {
    openPart(writePart("plinth.stl", box({0, 0, 0}, {20, 20, 6})));
    chooseFlat();
    ASSERT_TRUE(waitFor([&] {
      return document().upToDate(Stage::Load) && !window().planning().running() &&
             !window().presenter().busy();
    }));
  }
  forms::ParameterForm& form() { return *find<forms::ParameterForm>("parameters"); }
  forms::ParameterRow* row(const char* key) {
    return form().findChild<forms::ParameterRow*>(QLatin1String(key));
  }
  void search(const char* words) {
    auto* line = form().findChild<QLineEdit*>("search");
    QTest::mouseClick(line, Qt::LeftButton);
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Backspace);
    QTest::keyClicks(line, words);
    QTest::qWait(20);
  }
  // Keys of the parameters and names of the choices on show.
  std::set<std::string> shown() {
    std::set<std::string> keys;
    for (const auto* one : form().findChildren<forms::ParameterRow*>())
      if (one->isVisible())
        keys.insert(one->spec().key);
    for (const char* field : {"mode", "platform", "cell", "process", "material", "growth", "seed"})
      if (find<QWidget>(field)->isVisible())
        keys.insert(field);
    return keys;
  }
};

TEST_F(SettingsTest, QualityWallsInfillSupportsAndBrimComeFirst) {
  openFlat();
  keepPicture(window(), "settings_first");
  int last = 0;
  for (const char* key :
       {"layerHeightMm", "walls", "infillDensity", "rimSupports", "brimWidthMm"}) {
    ASSERT_NE(row(key), nullptr) << key;
    EXPECT_TRUE(row(key)->isVisible()) << key;
    const int top = row(key)->mapTo(&window(), QPoint(0, 0)).y();
    EXPECT_GT(top, last) << key;
    EXPECT_TRUE(row(key)->visibleRegion().contains(row(key)->rect().center())) << key;
    last = top;
  }
  EXPECT_TRUE(
      qobject_cast<QAbstractSpinBox*>(row("infillDensity")->editor())->text().endsWith('%'));
  EXPECT_EQ(qobject_cast<QAbstractSpinBox*>(row("brimWidthMm")->editor())->text(), "No brim");
  EXPECT_FALSE(find<QSpinBox>("seed")->isVisible()) << "in the fold";
  EXPECT_FALSE(row("redundancySamples")->isVisible());
  auto* fold = form().findChild<forms::Fold*>("research");
  QTest::mouseClick(fold->findChild<QToolButton*>(), Qt::LeftButton);
  EXPECT_TRUE(find<QSpinBox>("seed")->isVisible());
}

TEST_F(SettingsTest, AZeroIsShownAndTypedAsItsMeaning) {
  openFlat();
  auto* box = qobject_cast<QAbstractSpinBox*>(row("brimWidthMm")->editor());
  QTest::mouseClick(box, Qt::LeftButton);
  box->selectAll();
  QTest::keyClicks(box, "4");
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(document().choices().parameters.at("brimWidthMm"), "4");
  box->selectAll();
  QTest::keyClicks(box, "0");
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_FALSE(document().choices().parameters.contains("brimWidthMm"));
  EXPECT_EQ(box->text(), "No brim");
  document().undoStack()->undo();
  EXPECT_EQ(document().choices().parameters.at("brimWidthMm"), "4");
}

TEST_F(SettingsTest, ASearchFindsByMeaning) {
  openFlat();
  const std::pair<const char*, const char*> kFound[] = {
      {"temperature", "material"}, {"tool", "process"},         {"skirt", "prime"},
      {"overhang", "rimSupports"}, {"perimeter", "walls"},      {"quality", "layerHeightMm"},
      {"fill", "infillDensity"},   {"adhesion", "brimWidthMm"}, {"stringing", "retractMm"},
      {"robot", "cell"},           {"bed", "platform"},         {"random", "seed"},
      {"vase", "spiral"},          {"z hop", "liftMm"}};
  for (const auto& [words, key] : kFound) {
    search(words);
    EXPECT_TRUE(shown().contains(key)) << words;
    EXPECT_LT(shown().size(), 40u) << words;
  }
  search("temperature");
  keepPicture(window(), "settings_temperature");
  EXPECT_FALSE(shown().contains("walls"));
  EXPECT_FALSE(shown().contains("mode"));
  search("");
  EXPECT_TRUE(shown().contains("mode"));
  EXPECT_TRUE(shown().contains("walls"));
  EXPECT_FALSE(shown().contains("seed")) << "the fold is closed again";
}

TEST_F(SettingsTest, ChoicesAreShownByTheirLabels) {
  openFlat();
  for (const char* field : {"cell", "process", "material"}) {
    const auto* combo = find<QComboBox>(field);
    std::set<QString> texts;
    for (int i = 0; i < combo->count(); ++i) {
      EXPECT_NE(combo->itemText(i), combo->itemData(i).toString()) << field;
      EXPECT_TRUE(texts.insert(combo->itemText(i)).second) << combo->itemText(i).toStdString();
    }
  }
  EXPECT_EQ(find<QComboBox>("cell")->currentText(), "UR5, nozzle fixed, plate on the flange");
  EXPECT_EQ(find<QLabel>("statusCell")->text(), "UR5, nozzle fixed, plate on the flange");
}

TEST_F(SettingsTest, EveryFieldHasAToolTip) {
  openFlat();
  form().setShowAll(true);
  QTest::qWait(20);
  int fields = 0;
  for (const QWidget* field : form().findChildren<QWidget*>()) {
    if (!field->isVisible() ||
        !(qobject_cast<const QAbstractSpinBox*>(field) || qobject_cast<const QComboBox*>(field)))
      continue;
    ++fields;
    EXPECT_FALSE(field->toolTip().isEmpty()) << field->objectName().toStdString() << " in "
                                             << field->parentWidget()->objectName().toStdString();
  }
  EXPECT_GT(fields, 30);
}

TEST(SettingWords, AreOfSettingsThatExist) {
  const base::ParameterTable table = pipeline::allParameters();
  const std::set<std::string_view> fields{"mode",     "platform", "cell",   "process",
                                          "material", "tools",    "growth", "seed"};
  for (const std::string_view key : language::keysWithSynonyms())
    EXPECT_TRUE(table.find(key) || fields.contains(key)) << key;
  for (const std::string_view key : language::keysWithZeroText()) {
    const base::ParameterSpec* spec = table.find(key);
    ASSERT_NE(spec, nullptr) << key;
    EXPECT_EQ(spec->minimum, 0.0) << key;
  }
  std::set<std::string> once;
  for (const auto* keys : {&language::firstSettings(), &language::researchSettings()})
    for (const std::string& key : *keys) {
      EXPECT_NE(table.find(key), nullptr) << key;
      EXPECT_TRUE(once.insert(key).second) << key;
    }
}

} // namespace
} // namespace voluta::test
