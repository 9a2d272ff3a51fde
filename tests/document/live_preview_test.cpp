#include "curved/decomposition.h"
#include "document/live_preview.h"

#include "document/parts.h"
#include "document/planning.h"

#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

namespace voluta::document {
namespace {

using project::Stage;

class LivePreviewTest : public testing::Test {
protected:
  void planBox(Stage until = Stage::Layers) {
    document_.openPart(test::boxPart(), {}, true);
    plan(until);
  }
  void plan(Stage until) {
    QSignalSpy finished(&planning_, &Planning::finished);
    planning_.plan(until);
    ASSERT_TRUE(finished.wait(120000));
  }
  void setPlatform(const char* platform) {
    project::Choices choices = document_.choices();
    choices.item().platform = project::Platform(platform);
    document_.setChoices(choices, QStringLiteral("platform"));
  }
  bool waitFor(const std::function<bool()>& condition, int ms = 30000) {
    return QTest::qWaitFor(condition, ms);
  }

  Document document_;
  Planning planning_{document_};
  LivePreview live_{document_, planning_};
};

TEST_F(LivePreviewTest, EditOfGrowthUpdatesVoxelsAndOutdatesLaterStages) {
  planBox();
  EXPECT_FALSE(document_.voxelsAhead());
  const auto before = document_.result(Stage::Decompose)->job.item().decomposition();
  std::vector<bool> withField; // of the previews that came in
  QObject::connect(&document_, &Document::previewChanged, &document_, [&] {
    if (document_.preview())
      withField.push_back(!document_.preview()->decomposition->field.empty());
  });
  QSignalSpy finished(&live_, &LivePreview::finished);
  setPlatform("disc:30");
  EXPECT_EQ(document_.state(Stage::Decompose), StageState::OutOfDate);
  ASSERT_TRUE(finished.wait(30000));
  ASSERT_GE(withField.size(), 2U);
  EXPECT_FALSE(withField.front()) << "ranks come first";
  EXPECT_TRUE(withField.back());
  EXPECT_FALSE(document_.preview()) << "the result has taken its place";
  EXPECT_NE(document_.result(Stage::Decompose)->job.item().decomposition(), before);
  EXPECT_EQ(document_.state(Stage::Decompose), StageState::Done);
  EXPECT_EQ(document_.state(Stage::Layers), StageState::OutOfDate);
  EXPECT_TRUE(document_.voxelsAhead());
  EXPECT_TRUE(document_.voxelsInPlace());
  EXPECT_EQ(document_.presentResult(), document_.result(Stage::Decompose));
  EXPECT_NE(document_.lastResult(), document_.presentResult());
}

TEST_F(LivePreviewTest, PlanReusesThePreview) {
  planBox();
  QSignalSpy finished(&live_, &LivePreview::finished);
  setPlatform("disc:30");
  ASSERT_TRUE(finished.wait(30000));
  const auto previewed = document_.result(Stage::Decompose)->job.item().decomposition();
  plan(Stage::Layers);
  EXPECT_EQ(document_.result(Stage::Decompose)->job.item().decomposition(), previewed);
  EXPECT_FALSE(document_.voxelsAhead());
}

TEST_F(LivePreviewTest, EditsThatChangeNoVoxelStartNothing) {
  planBox();
  QSignalSpy started(&live_, &LivePreview::started);
  document_.setParameter("walls", "3");
  document_.setParameter("beadWidthMm", "1.3");
  EXPECT_FALSE(waitFor([&] { return started.size() > 0; }, 600));
}

TEST_F(LivePreviewTest, LayersThatAreOnlyOutOfDateAreNotOvertaken) {
  planBox(Stage::Toolpath);
  document_.setParameter("beadWidthMm", "1.3"); // a parameter of the layers and later stages
  EXPECT_TRUE(document_.upToDate(Stage::Decompose));
  EXPECT_EQ(document_.state(Stage::Layers), StageState::OutOfDate);
  EXPECT_FALSE(document_.voxelsAhead());
  EXPECT_FALSE(document_.ahead(Stage::Layers));
  plan(Stage::Layers);
  EXPECT_TRUE(document_.ahead(Stage::Layers)) << "the paths are still those of other layers";
  plan(Stage::Toolpath);
  EXPECT_FALSE(document_.ahead(Stage::Layers));
}

TEST_F(LivePreviewTest, NothingRunsBeforeAPlanOrWhereItIsTurnedOff) {
  QSignalSpy started(&live_, &LivePreview::started);
  document_.openPart(test::boxPart(), {}, true);
  setPlatform("disc:30");
  EXPECT_FALSE(waitFor([&] { return started.size() > 0; }, 600));
  plan(Stage::Layers);
  live_.setEnabled(false);
  setPlatform("disc:40");
  EXPECT_FALSE(waitFor([&] { return started.size() > 0; }, 600));
  live_.setEnabled(true);
  EXPECT_TRUE(waitFor([&] { return started.size() > 0; }, 2000));
}

TEST_F(LivePreviewTest, TheLastOfSeveralEditsIsShown) {
  planBox();
  QSignalSpy started(&live_, &LivePreview::started), finished(&live_, &LivePreview::finished);
  for (const char* platform : {"disc:30", "disc:31", "disc:32", "disc:33"})
    setPlatform(platform);
  ASSERT_TRUE(finished.wait(30000));
  EXPECT_EQ(started.size(), 1) << "one run for edits in a row";
  EXPECT_EQ(document_.result(Stage::Decompose)->job.choices.item().platform.text(), "disc:33");
  setPlatform("disc:34");
  live_.refresh();
  ASSERT_TRUE(live_.running());
  setPlatform("disc:35"); // while it runs
  ASSERT_TRUE(waitFor([&] { return !live_.running() && document_.upToDate(Stage::Decompose); }));
  EXPECT_EQ(document_.result(Stage::Decompose)->job.choices.item().platform.text(), "disc:35");
}

TEST_F(LivePreviewTest, UndoBringsThePlanBackWithoutARun) {
  planBox();
  QSignalSpy started(&live_, &LivePreview::started);
  setPlatform("disc:30");
  document_.undoStack()->undo();
  EXPECT_FALSE(waitFor([&] { return started.size() > 0; }, 600));
  EXPECT_EQ(document_.state(Stage::Layers), StageState::Done);
  EXPECT_FALSE(document_.voxelsAhead());
}

TEST_F(LivePreviewTest, APlanTakesOver) {
  planBox();
  QSignalSpy finished(&live_, &LivePreview::finished);
  setPlatform("disc:30");
  live_.refresh();
  ASSERT_TRUE(live_.running());
  plan(Stage::Layers);
  EXPECT_FALSE(live_.running());
  EXPECT_EQ(finished.size(), 0);
  EXPECT_FALSE(document_.preview());
  EXPECT_EQ(document_.state(Stage::Layers), StageState::Done);
}

TEST_F(LivePreviewTest, CancelRestoresTheLastResult) {
  planBox();
  const auto before = document_.result(Stage::Decompose);
  setPlatform("disc:30");
  document_.showPreview({before->job.item().decomposition(), 0.8, document_.key(Stage::Load),
                         document_.source()->hash});
  live_.refresh();
  ASSERT_TRUE(live_.running());
  live_.cancel();
  EXPECT_FALSE(live_.running());
  EXPECT_FALSE(document_.preview());
  EXPECT_EQ(document_.result(Stage::Decompose), before);
}

TEST_F(LivePreviewTest, DecomposeErrorIsShownUntilTheNextEdit) {
  planBox();
  QSignalSpy failed(&live_, &LivePreview::failed);
  geometry::Placement lifted = document_.choices().item().placement;
  lifted.liftMm = 5.0;
  document_.place(lifted, QStringLiteral("lift"));
  ASSERT_TRUE(failed.wait(30000));
  ASSERT_NE(document_.failure(), nullptr);
  EXPECT_EQ(document_.failure()->stage, Stage::Decompose);
  EXPECT_FALSE(document_.voxelsInPlace());
  document_.undoStack()->undo();
  EXPECT_EQ(document_.failure(), nullptr);
  EXPECT_EQ(document_.state(Stage::Layers), StageState::Done);
}

TEST_F(LivePreviewTest, APlanShowsItsRanksBeforeItsResult) {
  document_.openPart(test::boxPart(), {}, true);
  std::vector<std::string> order;
  QObject::connect(&document_, &Document::previewChanged, &document_,
                   [&] { order.push_back(document_.preview() ? "preview" : "dropped"); });
  QObject::connect(&document_, &Document::resultChanged, &document_,
                   [&](Stage stage) { order.push_back(std::string(project::stageName(stage))); });
  plan(Stage::Decompose);
  ASSERT_GE(order.size(), 3U);
  EXPECT_EQ(order.front(), "load");
  EXPECT_EQ(order[1], "preview");
  EXPECT_EQ(order.back(), "decompose");
  EXPECT_EQ(std::count(order.begin(), order.end(), "dropped"), 0);
}

} // namespace
} // namespace voluta::document
