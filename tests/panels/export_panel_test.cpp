#include "gallery_data.h"
#include "panels/export_panel.h"
#include "panels/options_form.h"
#include "panels/text_preview.h"
#include "panels/verdict_table.h"
#include "program/dialect.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

using namespace voluta;

namespace {
class ExportPanelTest : public testing::Test {
protected:
  ExportPanelTest() : requested(&panel, &panels::ExportPanel::exportRequested) {
    panel.setFormats(gallery::sampleFormats());
    panel.setFolder("/tmp/programs");
    panel.resize(300, 800);
    panel.show();
    (void)QTest::qWaitForWindowExposed(&panel);
  }
  QPushButton* button() { return panel.findChild<QPushButton*>(QStringLiteral("export")); }
  QString reason() { return panel.findChild<QLabel*>(QStringLiteral("reason"))->text(); }
  // Presses the named button of the box that is about to open, or Cancel.
  void answerWith(const QString& name) {
    QTimer::singleShot(50, &panel, [this, name] {
      auto* box = panel.findChild<QMessageBox*>();
      ASSERT_NE(box, nullptr);
      asked = box->text() + box->informativeText();
      if (auto* chosen = box->findChild<QPushButton*>(name))
        chosen->click();
      else
        box->button(QMessageBox::Cancel)->click();
    });
  }

  panels::ExportPanel panel;
  QSignalSpy requested;
  QString asked;
};
} // namespace

TEST_F(ExportPanelTest, OneClickExportsTheCheckedFormats) {
  panel.setChecked({"urscript"});
  ASSERT_TRUE(button()->isEnabled());
  button()->click();
  ASSERT_EQ(requested.size(), 1);
  EXPECT_EQ(requested[0][0].toString(), "/tmp/programs");
  EXPECT_EQ(requested[0][1].toStringList(), QStringList{"urscript"});
  EXPECT_FALSE(requested[0][2].toBool());
}

TEST_F(ExportPanelTest, DisabledWithAReason) {
  EXPECT_FALSE(button()->isEnabled());
  EXPECT_EQ(reason(), "Choose at least one format.");
  panel.setChecked({"urscript"});
  panel.setBlockedReason("Nothing is planned yet.");
  EXPECT_FALSE(button()->isEnabled());
  EXPECT_EQ(reason(), "Nothing is planned yet.");
  panel.setBlockedReason({});
  panel.setFolder({});
  EXPECT_EQ(reason(), "Choose a folder.");
}

TEST_F(ExportPanelTest, RefusedProgramsOnlyAfterTheUsersWord) {
  panel.setChecked({"urscript", "gcode-extended"});
  answerWith("none");
  button()->click();
  EXPECT_EQ(requested.size(), 0);
  EXPECT_TRUE(asked.contains("refused-kitten.gcode")) << qPrintable(asked);
  answerWith("writeRefused");
  button()->click();
  ASSERT_EQ(requested.size(), 1);
  EXPECT_TRUE(requested[0][2].toBool());
}

TEST_F(ExportPanelTest, ProgramsOfABlockedPlanOnlyAfterTheUsersWord) {
  auto formats = gallery::sampleFormats();
  formats[0].state = panels::VerdictState::Blocked;
  formats[0].whyRefused = "1 piece of a layer begins in the air";
  panel.setFormats(formats);
  panel.setChecked({"urscript"});
  const auto* list = panel.findChild<panels::FormatList*>();
  EXPECT_TRUE(list->topLevelItem(0)->toolTip(2).contains(formats[0].whyRefused));
  answerWith("none");
  button()->click();
  EXPECT_EQ(requested.size(), 0);
  EXPECT_TRUE(asked.contains(formats[0].whyRefused)) << qPrintable(asked);
  answerWith("exportBlocked");
  button()->click();
  ASSERT_EQ(requested.size(), 1);
  EXPECT_FALSE(requested[0][2].toBool());
}

// Amber: marked and asked about, but not called blocked.
TEST_F(ExportPanelTest, SafeProgramsThatDifferSaySo) {
  auto formats = gallery::sampleFormats();
  formats[0].state = panels::VerdictState::NotAsAsked;
  formats[0].whyRefused = "4.6 % of the part is not covered by beads";
  panel.setFormats(formats);
  panel.setChecked({"urscript"});
  const auto* list = panel.findChild<panels::FormatList*>();
  EXPECT_EQ(list->topLevelItem(0)->toolTip(2),
            "Safe to run, not as asked: 4.6 % of the part is not covered by beads");
  answerWith("none");
  button()->click();
  EXPECT_EQ(requested.size(), 0);
  EXPECT_TRUE(asked.contains("Safe to run")) << qPrintable(asked);
  answerWith("exportBlocked");
  button()->click();
  ASSERT_EQ(requested.size(), 1);
  EXPECT_FALSE(requested[0][2].toBool());
}

// What nothing checks is told before anything is written.
TEST_F(ExportPanelTest, ProgramsWithStatementsOfTheUsersOwnSaySo) {
  auto formats = gallery::sampleFormats();
  formats[0].state = panels::VerdictState::Unchecked;
  formats[0].whyRefused = "set_tool_voltage(24)";
  panel.setFormats(formats);
  panel.setChecked({"urscript"});
  const auto* list = panel.findChild<panels::FormatList*>();
  EXPECT_EQ(list->topLevelItem(0)->toolTip(2),
            "Safe to run but for your own statements: set_tool_voltage(24)");
  answerWith("none");
  button()->click();
  EXPECT_EQ(requested.size(), 0);
  EXPECT_TRUE(asked.contains("but for your own statements: set_tool_voltage(24)"))
      << qPrintable(asked);
  answerWith("exportBlocked");
  button()->click();
  EXPECT_EQ(requested.size(), 1);
}

TEST_F(ExportPanelTest, CheckingAndChoosingAreSignalled) {
  QSignalSpy formats(&panel, &panels::ExportPanel::formatsChanged);
  QSignalSpy preview(&panel, &panels::ExportPanel::previewFormatChanged);
  panel.setChecked({"urscript"});
  EXPECT_EQ(formats.size(), 0);
  auto* list = panel.findChild<panels::FormatList*>();
  list->topLevelItem(3)->setCheckState(0, Qt::Checked);
  ASSERT_EQ(formats.size(), 1);
  EXPECT_EQ(formats[0][0].toStringList(), (QStringList{"urscript", "csv"}));
  list->setCurrentItem(list->topLevelItem(1));
  ASSERT_EQ(preview.size(), 1);
  EXPECT_EQ(preview[0][0].toString(), "gcode-extended");
  EXPECT_EQ(panel.findChild<panels::VerdictTable*>()->item(0, 1)->text(), "94.20 %");
}

TEST_F(ExportPanelTest, NewResultsKeepChecksFormatAndPlaceInTheText) {
  auto formats = gallery::sampleFormats();
  panel.setFormats(formats);
  panel.setChecked({"gcode-extended"});
  panel.showLine(0, 1204);
  formats[1].state = panels::VerdictState::Passed;
  panel.setFormats(formats);
  EXPECT_EQ(panel.checkedFormats(), QStringList{"gcode-extended"});
  EXPECT_EQ(panel.previewFormat(), "urscript");
  EXPECT_EQ(panel.findChild<panels::TextPreview*>()->currentLine(), 1204u);
}

// Ticks of removed values would claim a check.
TEST_F(ExportPanelTest, AVerdictFromBeforeAChangeHasNoTicks) {
  auto formats = gallery::sampleFormats();
  for (auto& format : formats)
    if (format.verdict)
      format.state = panels::VerdictState::OutOfDate;
  auto* verdict = panel.findChild<panels::VerdictTable*>();
  const auto said = [&] {
    QStringList all;
    for (int row = 0; row < verdict->rowCount(); ++row)
      if (verdict->item(row, 2)->text() != QStringLiteral("–")) // it has a limit
        all << verdict->item(row, 3)->toolTip();
    all.removeDuplicates();
    return all;
  };
  const QString value = verdict->item(0, 1)->text();
  EXPECT_TRUE(said().contains("Within limit"));
  panel.setFormats(formats);
  EXPECT_EQ(said(), QStringList{"Not checked since the change"});
  EXPECT_EQ(verdict->item(0, 1)->text(), value) << "still there to be read";
}

TEST_F(ExportPanelTest, ClickedLineIsSignalled) {
  QSignalSpy clicked(&panel, &panels::ExportPanel::lineClicked);
  auto* preview = panel.findChild<panels::TextPreview*>();
  QTest::mouseClick(preview->viewport(), Qt::LeftButton, {}, QPoint(80, 3));
  ASSERT_EQ(clicked.size(), 1);
  EXPECT_EQ(clicked[0][0].toInt(), 0);
  EXPECT_EQ(clicked[0][1].toULongLong(), 1u);
}

TEST_F(ExportPanelTest, TypedFolderIsSignalledOnce) {
  QSignalSpy folder(&panel, &panels::ExportPanel::folderChanged);
  auto* line = panel.findChild<QLineEdit*>(QStringLiteral("folder"));
  line->setFocus();
  QTest::keyClicks(line, "/more");
  QTest::keyClick(line, Qt::Key_Return);
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_EQ(folder.size(), 1);
  EXPECT_EQ(folder[0][0].toString(), "/tmp/programs/more");
}

TEST_F(ExportPanelTest, OptionsAndFactsAreOfTheFormatInSight) {
  auto* list = panel.findChild<panels::FormatList*>();
  auto* options = panel.findChild<panels::OptionsForm*>();
  QSignalSpy changed(&panel, &panels::ExportPanel::optionChanged);
  EXPECT_TRUE(options->isVisible());
  auto* form = options->findChild<QWidget*>("urscriptForm")->findChild<QComboBox*>();
  panel.setOptions({{"urscriptForm", "port"}});
  EXPECT_EQ(form->currentIndex(), 1);
  EXPECT_EQ(changed.size(), 0);
  form->setFocus();
  QTest::keyClick(form, Qt::Key_Up);
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(changed[0][0].toString(), "urscriptForm");
  EXPECT_EQ(changed[0][1].toString(), "node");
  const auto text = [&](const char* name) { return panel.findChild<QLabel*>(name)->text(); };
  EXPECT_TRUE(text("programSize").endsWith("in one file"));
  EXPECT_TRUE(text("programTime").contains("planned time of 11 min 40 s"))
      << qPrintable(text("programTime"));
  EXPECT_EQ(text("assumptions").count(QChar(0x2022)), 2);
  list->setCurrentItem(list->topLevelItem(3)); // no options, nothing written
  EXPECT_FALSE(options->isVisible());
  EXPECT_FALSE(panel.findChild<QLabel*>("programSize")->isVisible());
}

// A format's row is all that its form needs.
TEST(OptionsOfFormats, AreAFieldEach) {
  panels::OptionsForm form;
  for (const program::Dialect& dialect : program::dialects()) {
    const std::vector<base::ParameterSpec> options = program::optionsOf(dialect);
    form.setOptions(options);
    EXPECT_EQ(form.isEmpty(), options.empty());
    for (const base::ParameterSpec& option : options)
      EXPECT_NE(form.findChild<QWidget*>(QString::fromStdString(option.key)), nullptr)
          << dialect.id << " " << option.key;
  }
}

TEST_F(ExportPanelTest, ResumeIsOfferedWhereThereIsAPlace) {
  auto* resume = panel.findChild<QPushButton*>("resume");
  QSignalSpy resumed(&panel, &panels::ExportPanel::resumeAsked);
  EXPECT_FALSE(resume->isEnabled());
  panel.setResumePlace("Line 12, bead 3 of 9");
  QTest::mouseClick(resume, Qt::LeftButton);
  EXPECT_EQ(resumed.size(), 1);
  panel.setResumePlace({});
  EXPECT_FALSE(resume->isEnabled());
}

TEST_F(ExportPanelTest, FitsIntoANarrowPanel) {
  EXPECT_LE(panel.minimumSizeHint().width(), 300);
}

TEST(VerdictMeasures, EveryMeasureIsHeldToItsLimit) {
  project::ReplayReport r;
  r.coveredFraction = 0.97;
  r.massRatio = 0.96;
  r.thresholds = {0.97, 0.005, 0.03, 0.03, 0.05, 0, 0};
  const auto measures = panels::verdictMeasures(r);
  r.flowErrorFraction = 0.02;
  r.thresholds.flowError = 0.01;
  r.controllerDurationS = 125.0;
  const auto timed = panels::verdictMeasures(r);
  ASSERT_EQ(timed.size(), 13u);
  EXPECT_FALSE(timed[11].passed) << "flow";
  EXPECT_EQ(timed[12].value, "2 min 5 s");
  EXPECT_TRUE(timed[12].limit.isEmpty()) << "only told";
  EXPECT_TRUE(measures[0].passed);
  EXPECT_TRUE(measures[3].limit.isEmpty()) << "only told";
  EXPECT_FALSE(measures[6].passed);
  EXPECT_EQ(measures[6].value, "4.00 %");
}

// The bridging limit depends on the mode.
TEST(VerdictMeasures, ALongUnsupportedRunIsBesideItsLimit) {
  project::ReplayReport r;
  r.longestUnsupportedMm = 13.4;
  const panels::VerdictMeasure run = panels::verdictMeasures(r, {.bridgeMm = 6.0})[4];
  EXPECT_EQ(run.value, "13.400 mm");
  EXPECT_EQ(run.limit, QString::fromUtf8("≤ 6 mm"));
  EXPECT_FALSE(run.passed);
  EXPECT_FALSE(run.blocks);
}

TEST(VerdictMeasures, RefusedFigureIsNotRoundedToItsLimit) {
  project::ReplayReport r;
  r.massRatio = 1.030004;
  r.coveredFraction = 0.969996;
  r.unsupportedFraction = 0.005004;
  r.maxDeviationMm = 0.05004;
  r.thresholds = {0.97, 0.005, 0.03, 0.03, 0.05, 0, 0};
  const auto measures = panels::verdictMeasures(r, {.deviations = 2});
  const auto valueOf = [&](std::size_t row) { return measures[row].value; };
  EXPECT_EQ(valueOf(0), "96.99 %");
  EXPECT_EQ(valueOf(2), "0.51 %");
  EXPECT_EQ(valueOf(6), "3.01 %");
  EXPECT_EQ(valueOf(9), "0.051 mm");
  EXPECT_EQ(valueOf(10), "2");
  for (const std::size_t row : {0u, 2u, 6u, 9u, 10u})
    EXPECT_FALSE(measures[row].passed) << row;
}

// Of several parts the worst one decides.
TEST(VerdictMeasures, AreThoseOfTheWorstPart) {
  project::ReplayReport r;
  r.coveredFraction = 0.985;
  r.massRatio = 1.0;
  r.items = {{0.99, 0.001, 1.01}, {0.95, 0.02, 0.95}};
  r.thresholds = {0.97, 0.005, 0.03, 0.03, 0.05, 0, 0};
  const auto measures = panels::verdictMeasures(r);
  EXPECT_EQ(measures[0].value, "95.00 %");
  EXPECT_EQ(measures[2].value, "2.00 %");
  EXPECT_EQ(measures[6].value, "5.00 %");
}
