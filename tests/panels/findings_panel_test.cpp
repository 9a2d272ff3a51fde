#include "panels/findings_model.h"
#include "panels/findings_panel.h"
#include "plan/finding_kinds.h"

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
  plan::Finding f =
      plan::verbatimFinding(*plan::stageNamed(stage), "sample", reason, "Do something.");
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

TEST(FindingsModel, BlockingFirstThenByStage) {
  panels::FindingsModel model;
  model.setFindings(some());
  ASSERT_EQ(model.rowCount(), 4);
  EXPECT_EQ(plan::englishReason(model.finding(0)), "missed");
  EXPECT_EQ(plan::englishReason(model.finding(1)), "hits");
  EXPECT_EQ(plan::englishReason(model.finding(2)), "hole");
  EXPECT_EQ(plan::englishReason(model.finding(3)), "thin");
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
    return plan::englishReason(f) == "missed"
               ? std::vector<panels::RemedyButton>{{"turn", "Turn it", "about"},
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
  EXPECT_EQ(plan::englishReason(chosen[0][0].value<plan::Finding>()), "missed");
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
                   [&](const plan::Finding& f) { told.push_back(voluta::plan::englishReason(f)); });
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
