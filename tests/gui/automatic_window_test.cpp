// Mode Automatic in the window: chosen in the list, planned, shown, saved and opened again.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "pipeline/automatic.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QRegularExpression>
#include <QTest>
#include <QToolButton>

namespace voluta::test {
namespace {

using project::Stage;

class AutomaticTest : public WindowTest {
protected:
  void chooseMode(const char* id) {
    auto* combo = find<QComboBox>("mode");
    combo->setFocus();
    combo->setCurrentIndex(combo->findData(QString::fromLatin1(id)));
  }
  QString mode() { return find<QComboBox>("mode")->currentData().toString(); }
  QString notice() { return find<QLabel>("notice")->text(); }
  template <typename T> T* editorOf(const char* parameter) {
    auto* row = find<QWidget>("parameters")->findChild<QWidget*>(QString::fromLatin1(parameter));
    return row ? row->findChild<T*>("editor") : nullptr;
  }
  QString supports() { return editorOf<QComboBox>("supports")->currentData().toString(); }
  double layerHeight() { return editorOf<QDoubleSpinBox>("layerHeightMm")->value(); }
  // Report, notice and form agree, and none of it counts as changed by the user.
  void expectFormShowsWhatWasUsed() {
    const project::ChosenReport& chosen = document().lastResult()->job.report.item().chosen;
    EXPECT_EQ(supports().toStdString(), chosen.supports);
    EXPECT_DOUBLE_EQ(layerHeight(), chosen.layerHeightMm);
    EXPECT_EQ(document().choices().item().mode, chosen.mode);
    EXPECT_EQ(document().choices().item().platform.text(), chosen.platform);
    EXPECT_TRUE(notice().contains(QString::fromStdString(base::english(chosen.name))))
        << qPrintable(notice());
    EXPECT_TRUE(document().choices().item().parameters.empty());
    EXPECT_FALSE(find<QToolButton>("resetAll")->isEnabled());
  }
};

TEST_F(AutomaticTest, ChosenWayIsShown) {
  openPart(writePart("part.stl", box({0, 0, 0}, {14, 14, 8})));
  chooseMode("auto");
  EXPECT_TRUE(document().choices().item().automatic);
  EXPECT_FALSE(notice().contains("Chosen")) << "nothing is planned";
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_EQ(mode(), "auto");
  EXPECT_EQ(document().choices().item().mode, "flat");
  EXPECT_EQ(document().state(Stage::Layers), document::StageState::Done);
  EXPECT_TRUE(notice().startsWith("Chosen: flat layers (")) << qPrintable(notice());
  expectFormShowsWhatWasUsed();
}

TEST_F(AutomaticTest, PlanByHandIsOutOfDateAndANewPlanTriesTheWays) {
  openPart(writePart("part.stl", box({0, 0, 0}, {14, 14, 8})));
  chooseMode("curved");
  auto choices = document().choices();
  choices.item().platform = project::Platform("fit:10");
  window().document().setChoices(choices, "platform");
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_EQ(document().state(Stage::Layers), document::StageState::Done);
  chooseMode("auto");
  EXPECT_NE(document().state(Stage::Layers), document::StageState::Done);
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_TRUE(notice().startsWith("Chosen: flat layers (")) << qPrintable(notice());
  expectFormShowsWhatWasUsed();
  EXPECT_EQ(document().state(Stage::Layers), document::StageState::Done);
}

// Low flat layers with supports, the way whose values are furthest from the defaults.
TEST_F(AutomaticTest, TheFormShowsTheValuesOfTheWayAndTheUsersOwnOverThem) {
  openPart(writePart("part.stl", box({0, 0, 0}, {14, 14, 8})));
  chooseMode("auto");
  auto choices = document().choices();
  choices.item().mode = "flat";
  choices.item().platform = project::Platform("cell");
  choices.item().automaticStrategy = "flat-low";
  window().document().setChoices(choices, "way");
  EXPECT_EQ(supports(), "auto");
  EXPECT_DOUBLE_EQ(layerHeight(), 0.5);
  EXPECT_FALSE(find<QToolButton>("resetAll")->isEnabled());
  window().document().setParameter("layerHeightMm", "0.6");
  EXPECT_DOUBLE_EQ(layerHeight(), 0.6);
  EXPECT_TRUE(find<QToolButton>("resetAll")->isEnabled());
  EXPECT_EQ(document().choices().item().parameters.at("layerHeightMm"), "0.6");
  window().document().resetParameter("layerHeightMm");
  EXPECT_DOUBLE_EQ(layerHeight(), 0.5);
}

TEST_F(AutomaticTest, WaysThatAreRejectedAreListedWithTheirReason) {
  geometry::TriangleMesh part = box({-5, -5, 0}, {5, 5, 16});
  append(part, box({20, -8, 8}, {36, 8, 12})); // over nothing
  openPart(writePart("air.stl", part));
  chooseMode("auto");
  QStringList said;
  QObject::connect(&window().planning(), &document::Planning::progressed,
                   [&](const jobs::Progress& progress) {
                     said << QString::fromStdString(base::english(progress.stage));
                   });
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_TRUE(said.join('\n').contains(QRegularExpression("Trying .+ \\([1-6] of 6\\): ")));
  const auto& tried = document().lastResult()->job.report.item().tried;
  ASSERT_GT(tried.size(), 1U);
  EXPECT_EQ(notice().count("Rejected: "), static_cast<qsizetype>(tried.size()) - 1)
      << qPrintable(notice());
  expectFormShowsWhatWasUsed();
  keepPicture(window(), "automatic-rejected");
}

TEST_F(AutomaticTest, ModeChosenByHandTurnsAutomaticOff) {
  openPart(writePart("part.stl", box({0, 0, 0}, {14, 14, 8})));
  chooseMode("auto");
  chooseMode("flat");
  EXPECT_FALSE(document().choices().item().automatic);
  EXPECT_EQ(document().choices().item().mode, "flat");
  window().document().undoStack()->undo();
  EXPECT_TRUE(document().choices().item().automatic);
  EXPECT_EQ(mode(), "auto");
}

TEST_F(AutomaticTest, NewProjectStartsWithTheGivenChoices) {
  project::Choices start;
  start.item().automatic = true;
  window().document().startWith(start);
  EXPECT_EQ(mode(), "auto");
  openPart(writePart("part.stl", box({0, 0, 0}, {14, 14, 8})));
  EXPECT_EQ(mode(), "auto");
}

} // namespace
} // namespace voluta::test
