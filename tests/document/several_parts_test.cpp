// Several parts in one document: added, copied, removed, edited one by one, saved and planned.
#include "base/files.h"
#include "document/autosave.h"
#include "document/free_place.h"
#include "document/item_choices.h"
#include "document/opening.h"
#include "document/parts.h"
#include "document/planning.h"
#include "document/saving.h"
#include "document/shown_names.h"
#include "helpers/boxes_3mf.h"
#include "helpers/slicer_packages.h"
#include "pipeline/stage_options.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>
#include <random>

namespace voluta::document {
namespace {

using project::Stage;

// Flat layers, since a part of a job of several may not search for its way of building.
void openFlat(Document& document, double side = 8.0) {
  document.openPart(test::boxPart(side), {}, true);
  project::Choices choices = document.choices();
  choices.item().mode = "flat";
  document.setChoices(choices, "flat");
}

double xOf(const Document& document, std::size_t item) {
  return document.jobChoices().item(item).placement.centreMm.x();
}

TEST(SeveralParts, AddedPartIsActiveAndHasTheSameChoices) {
  Document document;
  openFlat(document);
  document.setParameter("brimWidthMm", "3");
  document.setParameter("voxelMm", "1.5");
  QSignalSpy parts(&document, &Document::partsChanged), source(&document, &Document::sourceChanged);
  document.addPart(test::boxPart(6.0, "other.stl"), "/tmp/other.stl", true);
  EXPECT_EQ(document.partCount(), 2u);
  EXPECT_EQ(document.active(), 1u);
  EXPECT_EQ(parts.size(), 1);
  EXPECT_EQ(source.size(), 1);
  EXPECT_EQ(document.source()->name, "other.stl");
  EXPECT_EQ(document.name(), "box") << "the project keeps its name";
  EXPECT_EQ(document.choices().items.size(), 1u);
  EXPECT_EQ(document.choices().item().mode, "flat");
  EXPECT_EQ(document.choices().parameters.at("brimWidthMm"), "3") << "of the job";
  EXPECT_FALSE(document.choices().item().parameters.contains("voxelMm")) << "of the part";
  EXPECT_DOUBLE_EQ(xOf(document, 0), 0.0);
  EXPECT_DOUBLE_EQ(xOf(document, 1), 4.0 + 10.0 + 3.0);
}

TEST(SeveralParts, CopiedPartsArePastedAlsoAfterAllWereRemoved) {
  Document document;
  openFlat(document);
  EXPECT_FALSE(document.hasCopiedParts());
  document.addPart(test::boxPart(6.0, "other.stl"), "/tmp/other.stl", true);
  document.copyParts({0, 1});
  EXPECT_EQ(document.partCount(), 2u) << "no edit";
  document.removeParts({0, 1});
  EXPECT_EQ(document.partCount(), 0u);
  EXPECT_EQ(document.source(), nullptr);
  document.pasteParts();
  ASSERT_EQ(document.partCount(), 2u);
  EXPECT_EQ(document.jobChoices().item(0).mode, "flat");
  document.pasteParts();
  ASSERT_EQ(document.partCount(), 4u);
  EXPECT_NE(xOf(document, 2), xOf(document, 0));
  document.undoStack()->undo();
  document.undoStack()->undo();
  EXPECT_EQ(document.partCount(), 0u);
  document.undoStack()->undo();
  EXPECT_EQ(document.partCount(), 2u);
  EXPECT_EQ(document.source()->name, "other.stl");
}

TEST(SeveralParts, SomeOfSeveralAreRemoved) {
  Document document;
  openFlat(document);
  for (const char* name : {"b.stl", "c.stl", "d.stl"})
    document.addPart(test::boxPart(6.0, name), {}, true);
  document.setActive(2);
  document.removeParts({3, 0});
  ASSERT_EQ(document.partCount(), 2u);
  EXPECT_EQ(document.source()->name, "c.stl") << "the active part stays active";
  document.undoStack()->undo();
  EXPECT_EQ(document.partCount(), 4u);
  EXPECT_EQ(document.active(), 2u);
}

TEST(SeveralParts, TheFirstPartAddedIsOpened) {
  Document document;
  document.addPart(test::boxPart(), "/tmp/box.stl", true);
  EXPECT_EQ(document.partCount(), 1u);
  EXPECT_EQ(document.undoStack()->text(0), "Open box.stl");
}

TEST(SeveralParts, EditsConcernTheActivePartAndTheJob) {
  Document document;
  openFlat(document);
  document.addPart(test::boxPart(6.0, "other.stl"), {}, true);
  document.setScale("2");
  document.setParameter("voxelMm", "1.5");
  document.setParameter("brimWidthMm", "4");
  test::setSeed(document, 7);
  const project::Choices& job = document.jobChoices();
  EXPECT_EQ(job.item(0).scale, "1");
  EXPECT_EQ(job.item(1).scale, "2");
  EXPECT_FALSE(job.item(0).parameters.contains("voxelMm"));
  EXPECT_EQ(job.parameters.at("brimWidthMm"), "4");
  document.setParameter("infillDensity", "0.2");
  const std::size_t other = 1 - document.active();
  EXPECT_FALSE(document.jobChoices().item(other).parameters.contains("infillDensity"))
      << "each part has its own infill";
  document.undoStack()->undo();
  EXPECT_EQ(job.seed, 7);
  document.setActive(0);
  EXPECT_EQ(document.choices().item().scale, "1");
  document.resetParameters();
  EXPECT_FALSE(job.parameters.contains("brimWidthMm"));
  EXPECT_EQ(job.item(1).parameters.at("voxelMm"), "1.5");
}

// A box of 8 x 8 x 4 mm in the corner of its file is printed in the middle of the plate; its halves
// have the coordinates of the plate.
TEST(SeveralParts, RegionsStayInTheirPlacesWhenAPartIsCut) {
  Document document;
  document.openPart(test::boxPart(), "/box.stl", true);
  project::Choices choices = document.choices();
  choices.item().placement.centreMm = {20.0, 10.0};
  choices.item().regions = {{.shape = "sphere:4,4,1,1"},
                            {.shape = "box:4,4,3,2,2,1"},
                            {.shape = "height:2.5,3.5"},
                            {.shape = "sphere:4,4,1,1", .use = "cut"}};
  document.setChoices(choices, "regions");
  const auto half = [](double low, double high) {
    Document::Successor made;
    made.part = test::loadedBox({16.0, 6.0, low}, {24.0, 14.0, high}, "half.stl");
    made.placement.centreMm = {20.0, 10.0};
    return made;
  };
  Document::Successor pin = half(1.0, 3.0);
  pin.hasRegions = false;
  document.replacePart(0, {half(0.0, 2.0), half(2.0, 4.0), pin}, "Cut");
  const auto& lower = document.jobChoices().item(0).regions;
  ASSERT_EQ(lower.size(), 1u) << "the others are above";
  EXPECT_EQ(lower[0].shape, "sphere:20,10,1,1");
  const auto& upper = document.jobChoices().item(1).regions;
  ASSERT_EQ(upper.size(), 2u);
  EXPECT_EQ(upper[0].shape, "box:20,10,3,2,2,1");
  EXPECT_EQ(upper[1].shape.substr(0, 12), "box:20,10,3,") << "put down by 2 mm with the half";
  EXPECT_TRUE(document.jobChoices().item(2).regions.empty());
  document.undoStack()->undo();
  EXPECT_EQ(document.choices().item().regions, choices.item().regions);
}

TEST(SeveralParts, MakingAPartActiveIsNoEdit) {
  Document document;
  openFlat(document);
  document.addPart(test::boxPart(6.0, "other.stl"), {}, true);
  document.saved("/tmp/a.voluta", document.revision(), document.snapshot());
  QSignalSpy edited(&document, &Document::edited), source(&document, &Document::sourceChanged),
      choices(&document, &Document::choicesChanged);
  document.setActive(0);
  EXPECT_EQ(document.source()->name, "box.stl");
  EXPECT_EQ(edited.size(), 0);
  EXPECT_EQ(source.size(), 1);
  EXPECT_EQ(choices.size(), 1);
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(document.undoStack()->count(), 3);
}

TEST(SeveralParts, UndoBringsBackThePartsAndTheActiveOne) {
  Document document;
  openFlat(document);
  document.addPart(test::boxPart(6.0, "other.stl"), {}, true);
  document.duplicatePart();
  EXPECT_EQ(document.partCount(), 3u);
  EXPECT_EQ(document.sources()[2], document.sources()[1]);
  document.setActive(0);
  document.removePart();
  EXPECT_EQ(document.partCount(), 2u);
  EXPECT_EQ(document.source()->name, "other.stl");
  document.undoStack()->undo();
  EXPECT_EQ(document.partCount(), 3u);
  EXPECT_EQ(document.active(), 0u);
  EXPECT_EQ(document.source()->name, "box.stl");
  document.undoStack()->undo();
  document.undoStack()->undo();
  EXPECT_EQ(document.partCount(), 1u);
  document.undoStack()->redo();
  EXPECT_EQ(document.partCount(), 2u);
  EXPECT_EQ(document.active(), 1u);
}

// After any edits, undoing all of them restores every state on the way.
TEST(SeveralParts, RandomEditsAreUndoneOneByOne) {
  std::mt19937 random(7);
  Document document;
  openFlat(document);
  const auto stateOf = [&] {
    std::string text;
    for (std::size_t i = 0; i < document.partCount(); ++i)
      text += document.sources()[i]->name + document.jobChoices().item(i).scale + " " +
              std::to_string(xOf(document, i)) + "\n";
    return text;
  };
  std::vector<std::string> states{stateOf()};
  const int before = document.undoStack()->count();
  for (int step = 0; step < 60; ++step) {
    const int count = document.undoStack()->count();
    const unsigned kind = random() % 5;
    if (kind == 0 && document.partCount() < 5)
      document.addPart(test::boxPart(5.0 + random() % 4, "p.stl"), {}, true);
    else if (kind == 1 && document.partCount() < 5)
      document.duplicatePart();
    else if (kind == 2 && document.partCount() > 1)
      document.removePart();
    else if (kind == 3)
      document.setScale(QString::number(1.0 + 0.01 * step));
    document.setActive(random() % document.partCount());
    ASSERT_EQ(document.jobChoices().items.size(), document.partCount());
    if (document.undoStack()->count() > count)
      states.push_back(stateOf());
  }
  for (std::size_t i = states.size(); i-- > 0;) {
    EXPECT_EQ(stateOf(), states[i]);
    if (document.undoStack()->index() > before)
      document.undoStack()->undo();
  }
  EXPECT_EQ(document.partCount(), 1u);
}

TEST(SeveralParts, ARepairedPartReplacesAllItsCopies) {
  Document document;
  const auto asRead = test::boxPart(), repaired = test::boxPart();
  document.openPart(asRead, {}, false);
  document.duplicatePart();
  EXPECT_FALSE(document.sourceReady());
  document.replaceSource(asRead, repaired);
  EXPECT_TRUE(document.sourceReady());
  EXPECT_EQ(document.sources(), (std::vector{repaired, repaired}));
  project::Choices choices = document.choices();
  choices.item().repair = false;
  document.setChoices(choices, "as read");
  EXPECT_FALSE(document.jobChoices().item(0).repair) << "copies share one mesh";
}

TEST(SeveralParts, EqualNamesAreNumbered) {
  const std::vector parts{test::boxPart(5.0, "kitten.stl"), test::boxPart(6.0, "spot.stl"),
                          test::boxPart(7.0, "kitten.stl"), test::boxPart(8.0, "kitten.obj")};
  EXPECT_EQ(shownNames(parts), (QStringList{"kitten", "spot", "kitten (2)", "kitten (3)"}));
}

TEST(SeveralParts, PlatformIsSharedByAllPartsThatFitItsKind) {
  project::Choices job;
  job.items.resize(3);
  job.item(0).mode = job.item(1).mode = "flat";
  job.item(2).mode = "lathe";
  job.item(2).platform = project::Platform("rod:5x200");
  project::Choices edited = project::onlyItem(job, 1);
  edited.item().platform = project::Platform("disc:60");
  const project::Choices next = withItem(job, 1, edited);
  EXPECT_EQ(next.item(0).platform.text(), "disc:60");
  EXPECT_EQ(next.item(1).platform.text(), "disc:60");
  EXPECT_EQ(next.item(2).platform.text(), "rod:5x200");
}

TEST(SeveralParts, AFreePlaceTouchesNoOther) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-100.0, 100.0), size(1.0, 80.0);
  EXPECT_EQ(nextFreePlace({}, {5.0, 5.0}, 10.0), Eigen::Vector2d::Zero());
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Eigen::AlignedBox2d> others(1 + trial % 6);
    for (Eigen::AlignedBox2d& box : others) {
      const Eigen::Vector2d low(place(random), place(random));
      box = {low, low + Eigen::Vector2d(size(random), size(random))};
    }
    const Eigen::Vector2d own(size(random), size(random));
    const Eigen::Vector2d centre = nextFreePlace(others, own, 10.0);
    const Eigen::AlignedBox2d box(centre - 0.5 * own, centre + 0.5 * own);
    for (const Eigen::AlignedBox2d& other : others)
      EXPECT_GE(box.exteriorDistance(other), 10.0 - 1e-9);
  }
}

// On a plate with room behind the others only; a larger plate is taken where the first has no room.
TEST(SeveralParts, AFreePlaceIsOnThePlateWhereThereIsRoom) {
  const auto square = [](double half) {
    return std::vector<Eigen::Vector2d>{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  };
  const std::vector<Eigen::AlignedBox2d> wide{{Eigen::Vector2d(-80, -20), Eigen::Vector2d(80, 20)}};
  const Eigen::Vector2d own(30, 30);
  EXPECT_EQ(nextFreePlace(wide, own, 10.0), Eigen::Vector2d(105, 0));
  EXPECT_EQ(nextFreePlace(wide, own, 10.0, {square(100), square(200)}), Eigen::Vector2d(0, 45));
  const std::vector<Eigen::AlignedBox2d> both{wide.front(),
                                              {Eigen::Vector2d(-15, 30), Eigen::Vector2d(15, 60)}};
  EXPECT_EQ(nextFreePlace(both, own, 10.0, {square(100)}), Eigen::Vector2d(0, -45));
  EXPECT_EQ(nextFreePlace(wide, {90, 90}, 10.0, {square(100), square(200)}),
            Eigen::Vector2d(135, 0));
  EXPECT_EQ(nextFreePlace(wide, own, 10.0, {square(30)}), Eigen::Vector2d(105, 0)) << "no room";
}

// The cell's plates are 200, 300 and 400 wide.
TEST(SeveralParts, AddedPartIsPlacedOnTheCellsPlate) {
  Document document;
  openFlat(document, 180.0);
  project::Choices choices = document.choices();
  choices.cell = "ur5-moving";
  choices.item().platform = project::Platform("cell");
  document.setChoices(choices, "cell");
  for (int i = 0; i < 3; ++i) {
    document.addPart(test::boxPart(60.0, "other.stl"), {}, true);
    const Eigen::Vector2d centre = document.choices().item().placement.centreMm;
    EXPECT_LE(centre.cwiseAbs().maxCoeff() + 30.0, 200.0) << i;
  }
}

class SeveralPartsPlan : public testing::Test {
protected:
  void SetUp() override {
    openFlat(document_);
    document_.addPart(test::boxPart(6.0, "other.stl"), {}, true);
  }
  void plan(Stage until) {
    QSignalSpy finished(&planning_, &Planning::finished);
    planning_.plan(until);
    ASSERT_TRUE(finished.wait(120000));
  }

  Document document_;
  Planning planning_{document_};
};

// Parts that were added, copied and moved need no new plan once they are removed.
TEST_F(SeveralPartsPlan, UndoOfSeveralEditsShowsThePlanAgain) {
  plan(Stage::Toolpath);
  const auto planned = document_.result(Stage::Toolpath);
  document_.addPart(test::boxPart(5.0, "third.stl"), {}, true);
  plan(Stage::Load);
  document_.duplicatePart();
  plan(Stage::Load);
  document_.arrangeParts();
  EXPECT_FALSE(document_.upToDate(Stage::Toolpath));
  for (int i = 0; i < 3; ++i)
    document_.undoStack()->undo();
  EXPECT_EQ(document_.result(Stage::Toolpath), planned);
  EXPECT_EQ(document_.state(Stage::Toolpath), StageState::Done);
  for (int i = 0; i < 3; ++i)
    document_.undoStack()->redo();
  for (int i = 0; i < 3; ++i)
    document_.undoStack()->undo();
  EXPECT_EQ(document_.result(Stage::Toolpath), planned);
}

TEST_F(SeveralPartsPlan, AllPartsArePlannedAndEachHasItsResult) {
  plan(Stage::Toolpath);
  EXPECT_EQ(document_.state(Stage::Toolpath), StageState::Done);
  const auto all = document_.result(Stage::Toolpath);
  ASSERT_EQ(all->job.items.size(), 2u);
  const auto one = document_.itemResult(Stage::Toolpath);
  ASSERT_EQ(one->job.items.size(), 1u);
  EXPECT_EQ(one->job.item().layers, all->job.item(1).layers);
  EXPECT_EQ(one, document_.itemResult(Stage::Toolpath)) << "made once";
  document_.setActive(0);
  EXPECT_EQ(document_.itemResult(Stage::Toolpath)->job.item().layers, all->job.item(0).layers);
  EXPECT_EQ(document_.state(Stage::Toolpath), StageState::Done);
  const geometry::Placement moved{Eigen::Quaterniond::Identity(), {0.0, 30.0}, 0.0};
  document_.place(moved, "move");
  EXPECT_EQ(document_.state(Stage::Load), StageState::OutOfDate);
  document_.setPrintOrder(layers::PrintOrder::ByLayer);
  document_.undoStack()->undo();
  document_.undoStack()->undo();
  EXPECT_EQ(document_.state(Stage::Toolpath), StageState::Done);
}

TEST_F(SeveralPartsPlan, UndoRestoresRemovedPartsWithTheirPlan) {
  plan(Stage::Toolpath);
  const auto all = document_.result(Stage::Toolpath);
  document_.removePart();
  EXPECT_FALSE(document_.result(Stage::Toolpath));
  document_.undoStack()->undo();
  EXPECT_EQ(document_.result(Stage::Toolpath), all);
  EXPECT_EQ(document_.state(Stage::Toolpath), StageState::Done);
}

TEST_F(SeveralPartsPlan, ProjectOfSeveralPartsIsReadBackWithItsResults) {
  document_.setPrintOrder(layers::PrintOrder::ByLayer);
  plan(Stage::Toolpath);
  QTemporaryDir folder;
  Saving saving(document_);
  QSignalSpy saved(&saving, &Saving::saved);
  saving.saveAs(folder.filePath("two"));
  ASSERT_TRUE(saved.wait(10000));
  EXPECT_FALSE(document_.dirty());

  Document again;
  Planning planning(again);
  Opening opening(again, planning);
  QSignalSpy opened(&opening, &Opening::opened);
  opening.open(folder.filePath("two.voluta"));
  ASSERT_TRUE(opened.wait(10000));
  EXPECT_EQ(again.partCount(), 2u);
  EXPECT_EQ(again.active(), 0u);
  EXPECT_EQ(again.name(), "two");
  EXPECT_EQ(shownNames(again.sources()), (QStringList{"box", "other"}));
  EXPECT_EQ(again.jobChoices().printOrder, layers::PrintOrder::ByLayer);
  EXPECT_DOUBLE_EQ(xOf(again, 1), xOf(document_, 1));
  EXPECT_FALSE(again.dirty());
  EXPECT_EQ(again.state(Stage::Toolpath), StageState::Done);
}

TEST_F(SeveralPartsPlan, AReadPartIsAddedRepaired) {
  Opening opening(document_, planning_);
  QSignalSpy repaired(&opening, &Opening::repaired);
  opening.addPart("sample:vase");
  ASSERT_TRUE(repaired.wait(20000));
  EXPECT_EQ(document_.partCount(), 3u);
  EXPECT_EQ(document_.active(), 2u);
  EXPECT_EQ(document_.sourcePath(), "sample:vase");
  EXPECT_TRUE(document_.sourceReady());
  opening.addPart("/nowhere/none.stl");
  QSignalSpy failed(&opening, &Opening::failed);
  ASSERT_TRUE(failed.wait(20000));
  EXPECT_EQ(document_.partCount(), 3u) << "an unreadable file changes nothing";
}

// A 3MF of two boxes, `gap` apart.
QString twoBoxes(const QTemporaryDir& folder, double gap) {
  const std::string model =
      test::model3mf(test::object3mf(1, "plinth", test::boxMesh({20, 10, 4})) +
                         test::object3mf(2, "post", test::boxMesh({6, 6, 12})),
                     test::use3mf("item", 1, test::moved(100, 100)) +
                         test::use3mf("item", 2, test::moved(120 + gap, 102)));
  const QString file = folder.filePath("two.3mf");
  base::writeFile(file.toStdString(), test::package3mf(model));
  return file;
}

class PartsOfAFile : public ::testing::Test {
protected:
  // Returns whether the file was opened or added and repaired.
  bool read(double gap, bool added = false) {
    const QString file = twoBoxes(folder_, gap);
    QSignalSpy repaired(&opening_, &Opening::repaired);
    added ? opening_.addPart(file) : opening_.open(file);
    return repaired.wait(20000) && document_.sourceReady();
  }
  QTemporaryDir folder_;
  Document document_;
  Planning planning_{document_};
  Opening opening_{document_, planning_};
};

TEST_F(PartsOfAFile, AreOpenedInTheirPlaces) {
  ASSERT_TRUE(read(14.0));
  EXPECT_EQ(shownNames(document_.sources()), (QStringList{"plinth", "post"}));
  EXPECT_EQ(document_.active(), 0u);
  // The whole is 40 mm long.
  EXPECT_NEAR(xOf(document_, 0), -10.0, 1e-9);
  EXPECT_NEAR(xOf(document_, 1), 17.0, 1e-9);
  EXPECT_EQ(document_.undoStack()->count(), 1);
  document_.undoStack()->undo();
  EXPECT_EQ(document_.partCount(), 0u);
}

TEST_F(PartsOfAFile, AreAddedTogetherBesideTheOthers) {
  openFlat(document_);
  ASSERT_TRUE(read(14.0, true));
  EXPECT_EQ(document_.partCount(), 3u);
  EXPECT_EQ(document_.active(), 2u);
  EXPECT_NEAR(xOf(document_, 2) - xOf(document_, 1), 27.0, 1e-9);
  EXPECT_GE(xOf(document_, 1) - 10.0, 4.0 + 10.0 - 1e-9) << "clear of the first part";
  EXPECT_EQ(document_.jobChoices().item(2).mode, "flat");
}

// Opened and added, each part has the regions of the file; opened again, it keeps its own.
TEST_F(PartsOfAFile, HaveTheRegionsOfTheFile) {
  const test::SlicerSettings settings{{"perimeters", "4"}, {"extruder", "2"}};
  const std::vector<test::SlicerPart> parts{
      {{{"body", {0, 0, 0}, {20, 20, 8}},
        {"dense", {5, 5, 0}, {15, 15, 4}, test::SlicerKind::Modifier, settings}}},
      {{{"body", {0, 0, 0}, {20, 20, 8}}}}};
  const auto written = [&](const QString& name, std::size_t count) {
    const QString file = folder_.filePath(name);
    base::writeFile(
        file.toStdString(),
        test::prusaPackage({parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(count)}));
    return file;
  };
  const auto isRead = [&](const QString& file, bool added) {
    QSignalSpy repaired(&opening_, &Opening::repaired);
    added ? opening_.addPart(file) : opening_.open(file);
    return repaired.wait(20000) && document_.sourceReady();
  };
  const QString one = written("one.3mf", 1), two = written("two.3mf", 2);
  const auto regionsOf = [&](std::size_t item) {
    return document_.jobChoices().item(item).regions;
  };
  ASSERT_TRUE(isRead(one, false));
  ASSERT_EQ(regionsOf(0).size(), 1u);
  EXPECT_EQ(regionsOf(0)[0].parameters, (std::map<std::string, std::string>{{"walls", "4"}}));
  EXPECT_EQ(document_.source()->regions.size(), 1u) << "also after its repair";
  project::Choices edited = document_.choices();
  edited.item().regions[0].parameters["walls"] = "5";
  document_.setChoices(edited, "walls");
  ASSERT_TRUE(isRead(one, false));
  EXPECT_EQ(regionsOf(0)[0].parameters.at("walls"), "5");
  ASSERT_TRUE(isRead(two, true));
  ASSERT_EQ(document_.partCount(), 3u);
  EXPECT_EQ(regionsOf(1).size(), 1u);
  EXPECT_TRUE(regionsOf(2).empty());
  ASSERT_TRUE(isRead(two, false));
  EXPECT_EQ(regionsOf(0)[0].parameters.at("walls"), "4");
  EXPECT_TRUE(regionsOf(1).empty());
}

TEST_F(PartsOfAFile, ThatTouchMayBecomeOne) {
  QString asked;
  bool asOne = true;
  opening_.setAsOneQuestion([&](const QString& path, const QString& first, const QString& second) {
    asked = first + "+" + second + (path.endsWith("two.3mf") ? " of two.3mf" : "");
    return asOne;
  });
  ASSERT_TRUE(read(14.0));
  EXPECT_TRUE(asked.isEmpty()) << "they are apart";
  ASSERT_TRUE(read(0.0));
  EXPECT_EQ(asked, "plinth+post of two.3mf");
  EXPECT_EQ(document_.partCount(), 1u);
  EXPECT_EQ(document_.source()->name, "two.3mf");
  asOne = false;
  ASSERT_TRUE(read(0.0));
  EXPECT_EQ(document_.partCount(), 2u);
}

TEST_F(SeveralPartsPlan, TheRecoveryCopyHasAllParts) {
  QTemporaryDir folder;
  AutosaveOptions options;
  options.folder = folder.path();
  options.pauseMs = 60;
  Autosave autosave(document_, options);
  QSignalSpy written(&autosave, &Autosave::written);
  document_.duplicatePart();
  ASSERT_TRUE(written.wait(5000));
  const project::Job copy =
      project::readJob(autosave.file().toStdString(), pipeline::allParameters());
  ASSERT_EQ(copy.items.size(), 3u);
  EXPECT_EQ(copy.item(2).loaded->hash, copy.item(1).loaded->hash);
}

} // namespace
} // namespace voluta::document
