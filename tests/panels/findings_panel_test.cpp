#include "language/translated.h"
#include "language/words.h"
#include "panels/findings_model.h"
#include "panels/findings_panel.h"
#include "plan/finding_kinds.h"

#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QRegularExpression>
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

// Beside programs that are safe to run, a finding on the printed part alone is amber.
TEST(FindingsModel, FindingsThatConcernThePartAreNoBlockers) {
  using enum plan::FindingKind;
  const plan::Findings findings{
      plan::makeFinding(LeftOut, {{"waypoints", 3}, {"share", base::percent(0.1)}}),
      plan::makeFinding(Mass, {{"share", base::percent(92.0)}}),
      plan::makeFinding(CollisionInMotion, {{"first", "arm"_name}, {"second", "plate"_name}})};
  panels::FindingsModel model;
  model.setFindings(findings, {}, true);
  EXPECT_EQ(model.blocking(), 1u);
  EXPECT_EQ(model.differing(), 1u);
  EXPECT_EQ(model.weight(0), panels::FindingsModel::Blocks);
  EXPECT_EQ(model.weight(1), panels::FindingsModel::Differs);
  EXPECT_EQ(model.weight(2), panels::FindingsModel::Informs);
  EXPECT_TRUE(model.index(1)
                  .data(Qt::AccessibleTextRole)
                  .toString()
                  .startsWith("Not as asked: Deposited volume"));
  model.setBlockedOnly(true);
  EXPECT_EQ(model.rowCount(), 2);
  model.setFindings(findings); // without programs
  EXPECT_EQ(model.blocking(), 2u);
  EXPECT_EQ(model.differing(), 0u);
}

TEST(FindingsPanel, CountsWhatBlocksAndWhatDiffersApart) {
  using enum plan::FindingKind;
  const plan::Finding differs = plan::makeFinding(Mass, {{"share", base::percent(92.0)}});
  panels::FindingsPanel panel;
  const auto* button = panel.findChild<QToolButton*>("blockedOnly");
  panel.setFindings({differs}, {}, true);
  EXPECT_EQ(button->text(), "Not as asked (1)");
  panel.setFindings({differs, finding("replay", "hits", true)}, {}, true);
  EXPECT_EQ(button->text(), "Blocked (1), not as asked (1)");
  panel.setFindings({differs});
  EXPECT_EQ(button->text(), "Blocked (1)");
}

TEST(FindingsModel, DetailNamesStageCountPlaceAndTime) {
  plan::Finding f = finding("motion", "", true);
  f.count = 12;
  f.whenS = 754.2;
  panels::FindingsModel model;
  const QString detail = model.detail(f);
  for (const char* expected : {"Motion", "× 12", "1.0, 2.0, 3.0 mm", "12:34"})
    EXPECT_TRUE(detail.contains(QString::fromUtf8(expected))) << qPrintable(detail);
  model.setParts({"kitten", "spot"});
  f.item = 1;
  EXPECT_TRUE(model.detail(f).startsWith("spot"));
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
  // New findings do not disturb a button that is held down by the mouse.
  QTest::mousePress(button("remedy_prop"), Qt::LeftButton);
  panel.setFindings(some());
  QTest::mouseRelease(button("remedy_prop"), Qt::LeftButton);
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_EQ(plan::englishReason(chosen[0][0].value<plan::Finding>()), "missed");
  EXPECT_EQ(chosen[0][1].toString(), "prop");
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, middleOf(list, 1));
  EXPECT_EQ(button("remedy_turn"), nullptr);
}

// To answer takes its time: every cell there is may be read for it.
TEST(FindingsPanel, RemediesAreQueriedOncePerChange) {
  panels::FindingsPanel panel;
  int asked = 0;
  panel.setRemedies([&](const plan::Finding&) {
    ++asked;
    return std::vector<panels::RemedyButton>{{"turn", "Turn it", ""}};
  });
  panel.setFindings(some());
  EXPECT_EQ(asked, 0) << "nothing is chosen";
  auto* list = panel.findChild<QListView*>("list");
  list->setCurrentIndex(list->model()->index(2, 0));
  EXPECT_EQ(asked, 1);
  panel.setPlanned(true);
  panel.setUnchecked({plan::Stage::Replay});
  EXPECT_EQ(asked, 1) << "nothing of the finding";
  panel.setFindings(some());
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(list->currentIndex().row(), 2);
  panel.setFindings({});
  EXPECT_EQ(asked, 2);
  EXPECT_FALSE(panel.findChild<QWidget*>("actions")->isVisibleTo(&panel));
}

TEST(FindingsPanel, ClickEnterAndButtonActivateTheFinding) {
  panels::FindingsPanel panel;
  panel.resize(300, 500);
  panel.setPlanned(true);
  panel.setFindings(some());
  panel.show();
  (void)QTest::qWaitForWindowExposed(&panel);
  std::vector<std::string> reported;
  QObject::connect(&panel, &panels::FindingsPanel::activated, [&](const plan::Finding& f) {
    reported.push_back(voluta::plan::englishReason(f));
  });
  auto* list = panel.findChild<QListView*>();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, middleOf(list, 1));
  EXPECT_EQ(reported, (std::vector<std::string>{"hits"}));
  QTest::keyClick(list, Qt::Key_Down);
  EXPECT_EQ(reported.size(), 1u);
  QTest::keyClick(list, Qt::Key_Return);
  panel.findChild<QPushButton*>(QStringLiteral("show"))->click();
  EXPECT_EQ(reported, (std::vector<std::string>{"hits", "hole", "hole"}));
  EXPECT_TRUE(panel.findChild<QWidget*>(QStringLiteral("details"))->isVisible());
}

TEST(FindingsPanel, EmptyListExplainsWhyItIsEmpty) {
  panels::FindingsPanel panel;
  panel.show();
  const auto says = [&](const char* text) {
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (label->isVisible() && label->text() == QLatin1String(text))
        return true;
    return false;
  };
  EXPECT_TRUE(says("No findings yet."));
  panel.setPlanned(true);
  EXPECT_TRUE(says("No problems found."));
  panel.setFindings({finding("load", "hole", false)});
  EXPECT_FALSE(says("No problems found."));
  EXPECT_TRUE(says("Findings (1)"));
  panel.setBlockedOnly(true);
  EXPECT_TRUE(says("No blocking findings."));
}

TEST(FindingsPanel, UncheckedStagesAreNamed) {
  panels::FindingsPanel panel;
  panel.show();
  const auto* nothing = panel.findChild<QLabel*>("nothing");
  const auto* notChecked = panel.findChild<QLabel*>("notChecked");
  panel.setPlanned(true);
  panel.setUnchecked({plan::Stage::Motion, plan::Stage::Replay});
  panel.setFindings({});
  EXPECT_EQ(nothing->text(), "No problems found so far.\nNot checked: Motion, Replay.");
  EXPECT_FALSE(notChecked->isVisible()) << "once is enough";
  panel.setFindings(some());
  EXPECT_TRUE(notChecked->isVisible());
  EXPECT_EQ(notChecked->text(), "Not checked: Motion, Replay.");
  panel.setUnchecked({});
  EXPECT_FALSE(notChecked->isVisible());
}

TEST(FindingsModel, OutOfDateFindingsAreLastAndNotCounted) {
  panels::FindingsModel model;
  model.setFindings({finding("layers", "thin", false)}, some());
  EXPECT_EQ(model.rowCount(), 5);
  EXPECT_EQ(model.total(), 1u);
  EXPECT_EQ(model.blocking(), 0u);
  EXPECT_FALSE(model.isOutOfDate(0));
  const QModelIndex first = model.index(1);
  EXPECT_TRUE(first.data(panels::FindingsModel::OutOfDateRole).toBool());
  EXPECT_EQ(first.data().toString(), "Missed") << "among themselves as ever";
  EXPECT_TRUE(
      first.data(panels::FindingsModel::DetailRole).toString().startsWith("before the change"));
}

plan::Finding uncovered(const char* format, double percent) {
  plan::Finding f = plan::makeFinding(
      plan::FindingKind::Uncovered, {{"share", base::percent(percent)}}, Eigen::Vector3d(0, 0, 2));
  f.program.format = format;
  return f;
}

plan::Finding refused(const char* format) {
  return plan::makeFinding(
      plan::FindingKind::ProgramRefused,
      {{"format", std::string(format)}, {"failed", std::vector<base::Message>{}}});
}

TEST(ListedFindings, EqualFindingsOfSeveralProgramsShareOneRow) {
  const auto rows = panels::listed({uncovered("urscript", 5.01), refused("urscript"),
                                    uncovered("csv", 5.04), refused("csv"), refused("rapid")});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].formats, (std::vector<std::string>{"urscript", "csv"}));
  EXPECT_EQ(rows[1].finding.kind, plan::FindingKind::ProgramRefused) << "nothing else says why";

  panels::FindingsModel model;
  model.setFindings({uncovered("urscript", 5.01), uncovered("csv", 5.04)});
  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_EQ(model.total(), 1u);
  EXPECT_TRUE(model.reason(0).startsWith("5.01")) << qPrintable(model.reason(0));
  EXPECT_EQ(model.index(0).data(panels::FindingsModel::FormatsRole).toStringList(),
            (QStringList{"urscript", "csv"}));
}

// One fact at several places is one card, which leads from place to place.
TEST(FindingsPanel, OneFactAtSeveralPlacesIsOneCard) {
  plan::Findings findings;
  for (const double x : {1.0, 20.0, 40.0}) {
    findings.push_back(uncovered("urscript", 5.0 + x));
    findings.back().where = Eigen::Vector3d(x, 0.0, 2.0);
  }
  findings.push_back(finding("load", "hole", false));
  panels::FindingsPanel panel;
  panel.resize(320, 500);
  panel.show();
  panel.setFindings(findings);
  auto* list = panel.findChild<QListView*>("list");
  ASSERT_EQ(list->model()->rowCount(), 2);
  const QString detail =
      list->model()->index(0, 0).data(panels::FindingsModel::DetailRole).toString();
  EXPECT_TRUE(detail.contains("3 place")) << qPrintable(detail);
  QSignalSpy activated(&panel, &panels::FindingsPanel::activated);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, middleOf(list, 0));
  auto* next = panel.findChild<QPushButton*>("show");
  EXPECT_EQ(next->text(), "Show next");
  for (int i = 0; i < 3; ++i)
    QTest::mouseClick(next, Qt::LeftButton);
  ASSERT_EQ(activated.size(), 4);
  const auto xAt = [&](int i) { return activated[i][0].value<plan::Finding>().where->x(); };
  EXPECT_EQ(xAt(0), 1.0);
  EXPECT_EQ(xAt(1), 20.0);
  EXPECT_EQ(xAt(2), 40.0);
  EXPECT_EQ(xAt(3), 1.0) << "and around again";
}

// No text of the window speaks in keys, and each begins as a sentence does.
TEST(FindingsModel, TextsAreSentencesWithoutKeys) {
  for (const plan::FindingRow& row : plan::findingRows())
    for (const base::Text text : {row.reason, row.remedy, row.whyNoRemedy}) {
      if (text.empty())
        continue;
      const QString shown = language::capitalized(language::words(text));
      EXPECT_EQ(shown[0], shown[0].toUpper()) << qPrintable(shown);
      EXPECT_FALSE(shown.contains('`')) << qPrintable(shown);
      EXPECT_FALSE(shown.contains(QRegularExpression("\\b[a-z]+[A-Za-z]*=[a-z]")))
          << qPrintable(shown);
      EXPECT_FALSE(shown.contains(QRegularExpression("(^|[ (])--[a-z]"))) << qPrintable(shown);
    }
  plan::Finding one = finding("load", "open edges at `openSurfaces=wall`", true);
  panels::FindingsModel model;
  model.setFindings({one});
  EXPECT_TRUE(model.reason(0).startsWith("Open edges")) << qPrintable(model.reason(0));
}

TEST(ListedFindings, OtherPlacesAndOtherThingsAreOtherFacts) {
  plan::Finding elsewhere = uncovered("csv", 5.0);
  elsewhere.where = Eigen::Vector3d(9, 0, 2);
  EXPECT_EQ(panels::listed({uncovered("urscript", 5.0), elsewhere}).size(), 2u);
  EXPECT_EQ(panels::listed({uncovered("csv", 5.0), uncovered("csv", 4.0)}).size(), 2u)
      << "twice in one program";
}

// In a dock 280 high: the room on a small screen.
TEST(FindingsPanel, LeavesRowsToReadAboveLongWords) {
  panels::FindingsPanel panel;
  plan::Findings findings;
  const std::string words = std::string(600, 'a') + ' ' + std::string(600, 'b');
  for (int i = 0; i < 36; ++i) {
    findings.push_back(finding("replay", words.c_str(), true));
  }
  panel.setFindings(findings);
  panel.resize(230, 280);
  panel.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  auto* list = panel.findChild<QListView*>();
  list->setCurrentIndex(list->model()->index(0, 0));
  QTest::qWait(20);
  EXPECT_LE(panel.minimumSizeHint().height(), 280);
  EXPECT_GE(list->viewport()->height(), 4 * list->visualRect(list->model()->index(0, 0)).height());
}

TEST(FindingsPanel, WordsAndButtonsAreInSightWhereThereIsRoom) {
  panels::FindingsPanel panel;
  panel.setRemedies([](const plan::Finding&) {
    return std::vector<panels::RemedyButton>{{"turn", "Turn it", ""}, {"prop", "Prop it", ""}};
  });
  std::string words;
  for (int i = 0; i < 60; ++i)
    words += "some words ";
  panel.setFindings({finding("replay", words.c_str(), true), finding("load", "hole", false)});
  panel.resize(260, 700);
  panel.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  auto* list = panel.findChild<QListView*>();
  const auto inSight = [&](const char* name) {
    const auto* button = panel.findChild<QPushButton*>(name);
    return QTest::qWaitFor([&] { return button->visibleRegion().contains(button->rect()); }, 1000);
  };
  const auto chosen = [&](int row) { list->setCurrentIndex(list->model()->index(row, 0)); };
  for (const int row : {0, 1, 0}) {
    chosen(row);
    for (const char* name : {"remedy_turn", "remedy_prop", "show"})
      EXPECT_TRUE(inSight(name)) << name << ", row " << row;
  }
  chosen(1);
  const auto* details = panel.findChild<QWidget*>("details");
  EXPECT_TRUE(QTest::qWaitFor([&] { return details->height() < panel.height() / 4; }, 1000))
      << "a short one leaves the list its room";
}

// The room on a screen of 1280 by 800 at 150 %, in the words of a language with longer ones.
TEST(FindingsPanel, ButtonsAreInSightOnASmallScreen) {
  panels::FindingsPanel panel;
  panel.setRemedies([](const plan::Finding&) {
    return std::vector<panels::RemedyButton>{
        {"turn", QStringLiteral("Appoggia il pezzo nel modo migliore"), ""},
        {"prop", QStringLiteral("Aggiungi supporti"), ""},
        {"way", QStringLiteral("Lascia scegliere a Voluta"), ""}};
  });
  std::string words;
  for (int i = 0; i < 60; ++i)
    words += "some words ";
  plan::Findings findings;
  for (int i = 0; i < 12; ++i)
    findings.push_back(finding("replay", (std::to_string(i) + words).c_str(), true));
  panel.setFindings(findings);
  panel.setPlanned(true);
  panel.setUnchecked({plan::Stage::Motion, plan::Stage::Replay});
  panel.resize(260, 250);
  panel.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  auto* list = panel.findChild<QListView*>("list");
  list->setCurrentIndex(list->model()->index(1, 0));
  QTest::qWait(20);
  EXPECT_LE(panel.minimumSizeHint().height(), 250);
  EXPECT_GE(list->viewport()->height(), list->visualRect(list->model()->index(0, 0)).height());
  for (const char* name : {"remedy_turn", "remedy_prop", "remedy_way", "show"}) {
    const auto* button = panel.findChild<QPushButton*>(name);
    ASSERT_NE(button, nullptr) << name;
    EXPECT_TRUE(button->visibleRegion().contains(button->rect())) << name;
    EXPECT_GE(button->width(), button->sizeHint().width()) << name << " is cut off";
  }
}

TEST(FindingsPanel, FindingWithoutAButtonExplainsWhy) {
  panels::FindingsPanel panel;
  panel.resize(260, 500);
  panel.show();
  const plan::FindingRow* row = nullptr;
  for (const plan::FindingRow& one : plan::findingRows())
    if (!one.whyNoRemedy.empty() && base::placeNames(one.reason.english()).empty())
      row = &one;
  ASSERT_NE(row, nullptr);
  panel.setFindings({plan::makeFinding(row->kind)});
  auto* list = panel.findChild<QListView*>("list");
  list->setCurrentIndex(list->model()->index(0, 0));
  EXPECT_TRUE(panel.findChild<QLabel*>("whyNoRemedy")->isVisible());
  panel.setRemedies([](const plan::Finding&) {
    return std::vector<panels::RemedyButton>{{"turn", "Turn it", ""}};
  });
  EXPECT_FALSE(panel.findChild<QLabel*>("whyNoRemedy")->isVisible());
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
  panel.setFindings(many);
  QApplication::processEvents();
  panel.findChild<QListView*>()->scrollToBottom();
  panel.grab();
  EXPECT_EQ(panel.findChild<QListView*>()->model()->rowCount(), 10000);
  EXPECT_EQ(panel.findChildren<QWidget*>().size(), before);
}
