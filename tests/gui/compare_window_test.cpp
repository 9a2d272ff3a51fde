// The Compare page: a comparison run by clicks, rows as they come, weights, and a row adopted.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/compare_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QTest>
#include <optional>

namespace voluta::test {
namespace {

using panels::CompareState;
using window::PageState;

class CompareTest : public WindowTest {
protected:
  void tick(const char* name) {
    QTest::mouseClick(find<QCheckBox>(name), Qt::LeftButton, {}, {8, 8});
  }
  void press(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
  panels::CompareTable& table() { return *find<panels::CompareTable>("compareTable"); }
  document::Comparing& comparing() { return window().comparing(); }
  void openBox() {
    openPart(writePart("box.stl", box({-10, -9, 0}, {10, 9, 8})));
    choosePage(Page::Compare);
  }
  void select(int row) {
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                      table().visualRect(table().model()->index(row, 1)).center());
    ASSERT_EQ(table().selectedRow(), row);
  }
  void quick() { // as far as the decomposition
    auto* until = find<QComboBox>("until");
    until->setFocus();
    QTest::keyClick(until, Qt::Key_Down);
    ASSERT_EQ(until->currentIndex(), 1);
  }
  PageState state() { return find<window::FlowBar>("flowBar")->state(Page::Compare); }
};

TEST_F(CompareTest, RowsAppearAndOneIsAdoptedAsOneEdit) {
  openBox();
  EXPECT_TRUE(find<QWidget>("comparePage")->isVisible());
  EXPECT_EQ(state(), PageState::Nothing);
  tick("compareGrowth_greedy");
  EXPECT_EQ(find<QLabel>("count")->text(), QString("Plans: 4"));
  press("runCompare");
  ASSERT_EQ(table().entries().size(), 4u);
  EXPECT_EQ(state(), PageState::Running);
  EXPECT_FALSE(find<QPushButton>("runCompare")->isEnabled());
  ASSERT_TRUE(waitFor([&] { return table().entries()[0].place > 0; }, 120000));
  EXPECT_TRUE(comparing().running()) << "rows appear one after the other";
  EXPECT_FALSE(table().entries()[0].picture.isNull());
  choosePage(Page::Prepare); // the window stays usable
  choosePage(Page::Compare);
  ASSERT_TRUE(waitFor([&] { return !comparing().running(); }, 240000));
  int best = 0;
  for (const panels::CompareEntry& entry : table().entries()) {
    EXPECT_EQ(entry.state, CompareState::Clear) << entry.tip.toStdString();
    EXPECT_FALSE(entry.picture.isNull());
    EXPECT_GT(entry.place, 0);
    best += entry.best ? 1 : 0;
  }
  EXPECT_EQ(best, 1);
  ASSERT_TRUE(waitFor([&] { return state() == PageState::Done; }));
  EXPECT_TRUE(table().entries()[0].inUse);
  EXPECT_TRUE(find<QLabel>("compareVerdict")->text().startsWith("Best: "));

  EXPECT_FALSE(find<QPushButton>("adopt")->isEnabled());
  select(3);
  EXPECT_EQ(table().entries()[3].strategy, QString("Flat layers"));
  const int edits = document().undoStack()->index();
  press("adopt");
  EXPECT_EQ(document().choices().item().mode, "flat");
  EXPECT_EQ(document().undoStack()->index(), edits + 1);
  EXPECT_TRUE(table().entries()[3].inUse);
  EXPECT_EQ(state(), PageState::Done) << "the rows are what they were";
  ASSERT_TRUE(waitFor([&] { return !window().planning().running(); }));
  clickToolBar("plan");
  ASSERT_TRUE(planned(project::Stage::Replay));
  EXPECT_EQ(document().lastResult()->job.choices.item().mode, "flat");
  QTest::keySequence(&window(), QKeySequence::Undo);
  EXPECT_EQ(document().choices().item().mode, "curved");
}

TEST_F(CompareTest, WeightsRankAtOnce) {
  openBox();
  quick();
  press("runCompare");
  ASSERT_TRUE(waitFor([&] { return !comparing().running(); }, 120000));
  ASSERT_EQ(table().entries().size(), 3u);
  EXPECT_EQ(table().entries()[0].score, 0.5) << "one piece, the weight of pieces";
  auto* pieces = find<QDoubleSpinBox>("weight_pieces");
  pieces->setFocus();
  pieces->selectAll();
  QTest::keyClicks(pieces, "3");
  QTest::keyClick(pieces, Qt::Key_Return);
  EXPECT_EQ(table().entries()[0].score, 3.0);
  press("resetWeights");
  EXPECT_EQ(table().entries()[0].score, 0.5);

  document().setParameter("overhangAngle", "30");
  EXPECT_EQ(state(), PageState::OutOfDate);
  document().undoStack()->undo();
  EXPECT_NE(state(), PageState::OutOfDate);
}

TEST_F(CompareTest, AHalfTypedWeightIsTakenWhileTheWindowIsWhole) {
  openBox();
  auto* pieces = find<QDoubleSpinBox>("weight_pieces");
  const QPointer<document::Comparing> taker(&comparing());
  std::optional<bool> wasThere;
  QObject::connect(pieces, &QDoubleSpinBox::valueChanged, pieces,
                   [&] { wasThere = !taker.isNull(); });
  pieces->setFocus();
  pieces->selectAll();
  QTest::keyClicks(pieces, "7");
  EXPECT_FALSE(wasThere) << "not committed yet";
  openWindow(); // in place of the first one
  ASSERT_TRUE(wasThere);
  EXPECT_TRUE(*wasThere);
}

TEST_F(CompareTest, VerdictNamesTheBlockingFindingOfTheSelectedRow) {
  openPart(writePart("thin.stl", box({-10, -0.2, 0}, {10, 0.2, 8}))); // no bead fits into it
  choosePage(Page::Compare);
  for (const char* mode : {"compareMode_curved", "compareMode_planar"})
    tick(mode);
  press("runCompare");
  ASSERT_TRUE(waitFor([&] { return !comparing().running(); }, 120000));
  ASSERT_EQ(table().entries().size(), 1u);
  ASSERT_NE(table().entries()[0].state, CompareState::Clear);
  auto* verdict = find<QLabel>("compareVerdict");
  EXPECT_FALSE(verdict->text().contains("Flat layers: ")) << verdict->text().toStdString();
  select(0);
  EXPECT_TRUE(verdict->text().contains("Flat layers: ")) << verdict->text().toStdString();
}

// Not a test of time: how long edits keep the window's thread while rows are there, for the record.
TEST_F(CompareTest, StretchesWhileRowsAreThere) {
  openBox();
  quick();
  for (const char* growth : {"compareGrowth_greedy", "compareGrowth_incremental"})
    tick(growth);
  press("runCompare");
  ASSERT_TRUE(waitFor([&] { return !comparing().running(); }, 120000));
  ASSERT_EQ(table().entries().size(), 5u);
  select(2);
  application().resetWatch();
  document().setParameter("overhangAngle", "30");
  for (const char* button : {"undo", "redo", "undo"}) {
    clickToolBar(button);
    ASSERT_TRUE(waitFor([&] { return !window().planning().running(); }));
  }
  EXPECT_EQ(table().selectedRow(), 2) << "edits leave the selection alone";
  choosePage(Page::Prepare);
  choosePage(Page::Compare);
  recordLongestStretch();
}

TEST_F(CompareTest, CancelKeepsFinishedRows) {
  openBox();
  tick("compareGrowth_greedy");
  press("runCompare");
  ASSERT_TRUE(waitFor([&] { return table().entries()[0].state != CompareState::Waiting; }, 60000));
  ASSERT_TRUE(waitFor([&] { return table().entries()[0].place > 0; }, 120000));
  press("cancelCompare");
  EXPECT_FALSE(comparing().running());
  EXPECT_EQ(table().entries()[0].state, CompareState::Clear);
  EXPECT_EQ(table().entries()[3].state, CompareState::Waiting);
  EXPECT_EQ(table().entries()[3].verdict, QString("Not planned"));
  EXPECT_TRUE(find<QPushButton>("runCompare")->isEnabled());
}

TEST_F(CompareTest, NothingIsTickedNothingIsRun) {
  choosePage(Page::Compare);
  EXPECT_FALSE(find<QPushButton>("runCompare")->isEnabled()) << "no part";
  openBox();
  for (const char* mode : {"compareMode_curved", "compareMode_planar", "compareMode_flat"})
    tick(mode);
  EXPECT_FALSE(find<QPushButton>("runCompare")->isEnabled());
  tick("compareMode_flat");
  EXPECT_TRUE(find<QPushButton>("runCompare")->isEnabled());
  EXPECT_EQ(find<QLabel>("count")->text(), QString("Plans: 1"));
}

} // namespace
} // namespace voluta::test
