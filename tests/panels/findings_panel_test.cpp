#include "helpers/shapes.h"
#include "panels/finding_texts.h"
#include "panels/findings_model.h"
#include "panels/findings_panel.h"
#include "planar/flat.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

using namespace voluta;

namespace {
plan::Finding finding(const char* stage, const char* reason, bool blocking) {
  plan::Finding f;
  f.stage = stage;
  f.reason = reason;
  f.remedy = "Do something.";
  f.blocking = blocking;
  f.where = Eigen::Vector3d(1.0, 2.0, 3.0);
  return f;
}

plan::Findings some() {
  return {finding("layers", "thin", false), finding("replay", "hits", true),
          finding("decompose", "missed", true), finding("load", "hole", false)};
}

QPoint middleOf(QListView* list, int row) {
  return list->visualRect(list->model()->index(row, 0)).center();
}
} // namespace

// Puts "~" before what it translates, and swaps the first two numbers.
class SomeLanguage : public QTranslator {
public:
  QString translate(const char* context, const char* text, const char*, int) const override {
    if (QLatin1String(context) != QLatin1String("Findings"))
      return {};
    QString out = QStringLiteral("~") + QString::fromUtf8(text);
    return out.replace("%1", "%3").replace("%2", "%1").replace("%3", "%2");
  }
  bool isEmpty() const override { return false; }
};

TEST(FindingTexts, AreasAndVolumesHaveTheirSign) {
  EXPECT_EQ(panels::findingText("4.5 mm2 of 10 mm2 hold 3 mm3, 2 mm23 and 7 mm"),
            QString::fromUtf8("4.5 mm² of 10 mm² hold 3 mm³, 2 mm23 and 7 mm"));
}

TEST(FindingTexts, SentencesAreTranslatedAroundTheirNumbers) {
  const std::string english = "7.03 mm2 lean over by more than 45 degrees";
  EXPECT_EQ(panels::findingText(english),
            QString::fromUtf8("7.03 mm² lean over by more than 45 degrees"));
  SomeLanguage language;
  const QLocale before;
  QCoreApplication::installTranslator(&language);
  QLocale::setDefault(QLocale(QLocale::Italian));
  EXPECT_EQ(panels::findingText(english),
            QString::fromUtf8("~45 mm² lean over by more than 7,03 degrees"));
  EXPECT_EQ(panels::findingText("nobody knows 1.5 of this"), "nobody knows 1.5 of this");
  QCoreApplication::removeTranslator(&language);
  QLocale::setDefault(before);
}

// What core tells today is known: a sentence that is changed there is changed here too.
TEST(FindingTexts, KnowWhatFlatModeTells) {
  geometry::TriangleMesh plate = test::box({-10, -10, 10}, {10, 10, 12});
  SomeLanguage language;
  const plan::Findings told = planar::flatDecomposition(plate, {}).findings;
  ASSERT_FALSE(told.empty());
  QCoreApplication::installTranslator(&language);
  for (const plan::Finding& f : told)
    for (const std::string& text : {f.reason, f.remedy})
      EXPECT_TRUE(panels::findingText(text).startsWith('~')) << text;
  QCoreApplication::removeTranslator(&language);
}

TEST(FindingsModel, BlockingFirstThenByStage) {
  panels::FindingsModel model;
  model.setFindings(some());
  ASSERT_EQ(model.rowCount(), 4);
  EXPECT_EQ(model.finding(0).reason, "missed");
  EXPECT_EQ(model.finding(1).reason, "hits");
  EXPECT_EQ(model.finding(2).reason, "hole");
  EXPECT_EQ(model.finding(3).reason, "thin");
  EXPECT_EQ(model.blocking(), 2u);
  model.setBlockedOnly(true);
  EXPECT_EQ(model.rowCount(), 2);
}

TEST(FindingsModel, DetailNamesStageCountPlaceAndTime) {
  plan::Finding f = finding("motion", "", true);
  f.count = 12;
  f.whenS = 754.2;
  const QString detail = panels::FindingsModel::detail(f);
  for (const char* expected : {"Motion", "× 12", "1.0, 2.0, 3.0 mm", "12:34"})
    EXPECT_TRUE(detail.contains(QString::fromUtf8(expected))) << qPrintable(detail);
}

TEST(FindingsPanel, RemediesAreButtonsOfTheChosenFinding) {
  panels::FindingsPanel panel;
  panel.setRemedies([](const plan::Finding& f) {
    return f.reason == "missed" ? std::vector<panels::RemedyButton>{{"turn", "Turn it", "about"},
                                                                    {"prop", "Prop it", ""}}
                                : std::vector<panels::RemedyButton>{};
  });
  panel.resize(300, 500);
  panel.show();
  panel.setFindings(some());
  auto* list = panel.findChild<QListView*>("list");
  const auto button = [&](const char* name) { return panel.findChild<QPushButton*>(name); };
  EXPECT_EQ(button("remedy_turn"), nullptr) << "nothing is chosen";
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, middleOf(list, 0));
  ASSERT_NE(button("remedy_turn"), nullptr);
  EXPECT_EQ(button("remedy_turn")->text(), "Turn it");
  EXPECT_EQ(button("remedy_turn")->toolTip(), "about");
  QSignalSpy chosen(&panel, &panels::FindingsPanel::remedyChosen);
  // Findings that come in anew leave what is held down by the mouse.
  QTest::mousePress(button("remedy_prop"), Qt::LeftButton);
  panel.setFindings(some());
  QTest::mouseRelease(button("remedy_prop"), Qt::LeftButton);
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(chosen[0][0].value<plan::Finding>().reason, "missed");
  EXPECT_EQ(chosen[0][1].toString(), "prop");
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, middleOf(list, 1));
  EXPECT_EQ(button("remedy_turn"), nullptr);
}

TEST(FindingsPanel, ClickEnterAndButtonTellWhichFinding) {
  panels::FindingsPanel panel;
  panel.resize(300, 500);
  panel.setPlanned(true);
  panel.setFindings(some());
  panel.show();
  (void)QTest::qWaitForWindowExposed(&panel);
  std::vector<std::string> told;
  QObject::connect(&panel, &panels::FindingsPanel::activated,
                   [&](const plan::Finding& f) { told.push_back(f.reason); });
  auto* list = panel.findChild<QListView*>();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, middleOf(list, 1));
  EXPECT_EQ(told, (std::vector<std::string>{"hits"}));
  QTest::keyClick(list, Qt::Key_Down);
  EXPECT_EQ(told.size(), 1u);
  QTest::keyClick(list, Qt::Key_Return);
  panel.findChild<QPushButton*>(QStringLiteral("show"))->click();
  EXPECT_EQ(told, (std::vector<std::string>{"hits", "hole", "hole"}));
  EXPECT_TRUE(panel.findChild<QWidget*>(QStringLiteral("details"))->isVisible());
}

TEST(FindingsPanel, AnEmptyListSaysWhatItMeans) {
  panels::FindingsPanel panel;
  panel.show();
  const auto says = [&](const char* text) {
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->isVisible() && label->text() == QLatin1String(text))
        return true;
    return false;
  };
  EXPECT_TRUE(says("Nothing found so far."));
  panel.setPlanned(true);
  EXPECT_TRUE(says("No problems found."));
  panel.setFindings({finding("load", "hole", false)});
  EXPECT_FALSE(says("No problems found."));
  EXPECT_TRUE(says("Findings (1)"));
  panel.setBlockedOnly(true);
  EXPECT_TRUE(says("Nothing is blocked."));
}

TEST(FindingsPanel, TenThousandFindingsMakeNoWidgets) {
  panels::FindingsPanel panel;
  panel.resize(300, 500);
  panel.show();
  (void)QTest::qWaitForWindowExposed(&panel);
  const qsizetype before = panel.findChildren<QWidget*>().size();
  plan::Findings many;
  for (int i = 0; i < 10000; ++i)
    many.push_back(finding("motion", ("waypoint " + std::to_string(i)).c_str(), i % 3 == 0));
  QElapsedTimer watch;
  watch.start();
  panel.setFindings(many);
  QApplication::processEvents();
  panel.findChild<QListView*>()->scrollToBottom();
  panel.grab();
  RecordProperty("milliseconds", static_cast<int>(watch.elapsed()));
  std::printf("10,000 findings shown in %lld ms\n", static_cast<long long>(watch.elapsed()));
  EXPECT_EQ(panel.findChildren<QWidget*>().size(), before);
}
