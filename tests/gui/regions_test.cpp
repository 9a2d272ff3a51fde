// Regions of a part in the window.
#include "gui/regions_fixture.h"

namespace voluta::test {
namespace {

TEST_F(RegionsWindowTest, ABoxIsAddedByClicksAndPlanned) {
  openFlat(open(block()));
  EXPECT_FALSE(panel()->isVisible());
  const QImage before = picture();
  openTool();
  EXPECT_FALSE(find<QWidget>("prepareTabs")->isVisible());
  keepPicture(window(), "regions_none");
  add("box");
  ASSERT_TRUE(bodiesDrawn());
  EXPECT_EQ(regions()[0].shape, "box:0,0,6,8,8,4") << "in the middle, a third of the part";
  EXPECT_EQ(viewport().tool(), viewer::Tool::MoveRegion);
  EXPECT_GT(differingShare(before, picture()), 0.01);
  keepPicture(window(), "regions_box");
  typeNumber(0, "4");
  EXPECT_EQ(regions()[0].shape, "box:4,0,6,8,8,4");
  type(panel()->findChild<QWidget*>("region.infillDensity")->findChild<QDoubleSpinBox*>("editor"),
       "50");
  EXPECT_EQ(regions()[0].parameters.at("infillDensity"), "0.5");
  EXPECT_TRUE(problem().isEmpty()) << problem().toStdString();
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  const auto& figures = document().lastResult()->job.report.item().layers.regions;
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_NEAR(figures[0].volumeMm3, 8 * 8 * 4, 8 * 8 * 4 * 0.1);
  choosePage(Page::Layers);
  picture();
  keepPicture(window(), "regions_layers");
}

TEST_F(RegionsWindowTest, EditsAreUndoneSavedAndReadAgain) {
  openFlat(open(block()));
  openTool();
  add("cylinder");
  add("height");
  add("skin");
  ASSERT_EQ(regions().size(), 3u);
  EXPECT_EQ(regions()[1].shape, "height:4,8");
  EXPECT_EQ(regions()[2].use, "surface");
  EXPECT_EQ(panel()->selected(), 2u);
  ASSERT_TRUE(bodiesDrawn());
  picture();
  keepPicture(window(), "regions_three");
  // The skin's solid infill is its default, and can be the part's.
  select(1);
  chooseUse("cut");
  EXPECT_FALSE(find<QWidget>("regionSettings")->isVisible());
  QTest::mouseClick(find<QToolButton>("regionUp"), Qt::LeftButton);
  EXPECT_EQ(regions()[0].use, "cut");
  EXPECT_EQ(panel()->selected(), 0u);
  document().undoStack()->undo();
  EXPECT_EQ(regions()[0].shape.substr(0, 8), "cylinder");
  EXPECT_EQ(regions()[1].use, "cut");
  document().undoStack()->undo();
  EXPECT_EQ(regions()[1].use, "settings");
  document().undoStack()->redo();
  document().undoStack()->redo();
  EXPECT_EQ(regions()[0].use, "cut");
  // A double click renames.
  const QPoint first = list()->visualItemRect(list()->topLevelItem(1)).center();
  QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, first);
  QTest::mouseDClick(list()->viewport(), Qt::LeftButton, {}, first);
  auto* line = list()->findChild<QLineEdit*>();
  ASSERT_NE(line, nullptr);
  line->selectAll();
  QTest::keyClicks(line, "Bearing");
  QTest::keyClick(line, Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return regions()[1].name == "Bearing"; }, 5000));
  const std::vector<Region> saved = regions();
  const QString file = path("regions.voluta");
  answerFileDialog(file);
  clickMenu("fileMenu", "saveAs");
  ASSERT_TRUE(waitFor([&] { return document().projectFile() == file; }, 20000));
  EXPECT_FALSE(document().dirty());
  window().open(file);
  ASSERT_TRUE(waitFor([&] { return document().undoStack()->count() == 0; }, 20000));
  EXPECT_EQ(regions(), saved);
}

TEST_F(RegionsWindowTest, TheSelectedRegionIsDeleted) {
  openFlat(open(block()));
  openTool();
  for (const char* shape : {"box", "sphere", "cylinder"})
    add(shape);
  EXPECT_TRUE(list()->topLevelItem(1)->text(0).contains("Sphere"));
  select(1);
  QTest::mouseClick(find<QPushButton>("regionRemove"), Qt::LeftButton);
  ASSERT_EQ(regions().size(), 2u);
  EXPECT_EQ(regions()[1].shape.substr(0, 8), "cylinder");
  EXPECT_EQ(panel()->selected(), 1u);
  list()->setFocus();
  QTest::keyClick(list(), Qt::Key_Delete);
  EXPECT_EQ(regions().size(), 1u);
  EXPECT_EQ(document().partCount(), 1u) << "the part stays";
  QTest::keyClick(list(), Qt::Key_Delete);
  EXPECT_TRUE(regions().empty());
  EXPECT_FALSE(find<QComboBox>("regionUse")->isVisible());
  document().undoStack()->undo();
  EXPECT_EQ(regions().size(), 1u);
}

TEST_F(RegionsWindowTest, UsesThatMakeNoSenseAreGreyAndProblemsAreNamed) {
  openFlat(open(block()));
  openTool();
  add("box");
  auto* combo = find<QComboBox>("regionUse");
  auto* model = qobject_cast<QStandardItemModel*>(combo->model());
  const int surface = combo->findData("surface");
  EXPECT_FALSE(model->item(surface)->isEnabled());
  EXPECT_FALSE(model->item(surface)->toolTip().isEmpty());
  chooseUse("turn");
  EXPECT_EQ(regions()[0].use, "turn:1,0,1");
  EXPECT_TRUE(problem().isEmpty()) << problem().toStdString();
  type(find<QDoubleSpinBox>("regionUseNumber0"), "0");
  EXPECT_TRUE(problem().contains("direction")) << problem().toStdString();
  keepPicture(window(), "regions_problem");
  document().undoStack()->undo();
  EXPECT_TRUE(problem().isEmpty());
  add("skin");
  EXPECT_TRUE(model->item(surface)->isEnabled());
  add("height");
  typeNumber(0, "9");
  EXPECT_TRUE(waitFor([&] { return problem().contains("empty"); }, 20000));
  EXPECT_EQ(withoutName(window()), QStringList());
}

// A bar is held at one end and pushed at the other: its infill runs along.
TEST_F(RegionsWindowTest, AHoldAndAForceAreGivenByClicksAndPlanned) {
  openFlat(open(box({-30, -8, 0}, {30, 8, 3.2})));
  openTool();
  add("box");
  for (const auto& [at, value] : {std::pair{0, "-28"}, {3, "4"}, {4, "16"}, {5, "4"}})
    typeNumber(at, value);
  chooseUse("hold");
  EXPECT_EQ(regions()[0].use, "hold");
  EXPECT_FALSE(panel()->findChild<QWidget*>("region.infillDensity")->isVisible())
      << "it has no settings";
  add("box");
  for (const auto& [at, value] : {std::pair{0, "28"}, {3, "4"}, {4, "16"}, {5, "4"}})
    typeNumber(at, value);
  chooseUse("load");
  EXPECT_EQ(regions()[1].use, "load:0,0,-10");
  type(find<QDoubleSpinBox>("regionUseNumber1"), "-20");
  type(find<QDoubleSpinBox>("regionUseNumber2"), "0");
  EXPECT_EQ(regions()[1].use, "load:0,-20,0");
  EXPECT_TRUE(problem().isEmpty()) << problem().toStdString();
  document().setParameter("infill", "field");
  ASSERT_TRUE(bodiesDrawn());
  picture();
  keepPicture(window(), "regions_load");
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  const plan::LoadStatistics& load = document().lastResult()->job.report.toolpath.load;
  EXPECT_EQ(load.forceN, 20.0);
  EXPECT_GT(load.infillAlignedFraction, 0.6);
  choosePage(Page::Layers);
  picture();
  keepPicture(window(), "regions_load_layers");
  document().undoStack()->undo(); // the infill
  document().undoStack()->undo();
  EXPECT_EQ(regions()[1].use, "load:0,-20,-10");
}

TEST_F(RegionsWindowTest, ANumberTypedHalfwayIsTakenOnLeaving) {
  openFlat(open(block()));
  openTool();
  add("box");
  add("sphere");
  auto* box = find<QDoubleSpinBox>("regionNumber3");
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "5");
  EXPECT_EQ(regions()[1].shape, "sphere:0,0,6,4") << "no number yet";
  list()->setFocus();
  select(0);
  EXPECT_EQ(regions()[1].shape, "sphere:0,0,6,5");
  EXPECT_EQ(regions()[0].shape, "box:0,0,6,8,8,4") << "the other region has not changed";
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "-"); // and the window closes
}

TEST_F(RegionsWindowTest, ARegionIsDraggedAndFollowsItsPart) {
  openFlat(open(block()));
  openTool();
  add("sphere");
  ASSERT_TRUE(bodiesDrawn());
  ASSERT_EQ(viewport().tool(), viewer::Tool::MoveRegion);
  viewport().viewFrom(Eigen::Vector3d(0.3, -1, 0.3).normalized());
  picture();
  const viewer::CameraControl camera(viewport().scene().renderer());
  const auto at = [&](const Eigen::Vector3d& place) {
    const Eigen::Vector3d display = camera.project(place);
    return viewport().fromDisplay({display.x(), display.y()}).toPoint();
  };
  const Eigen::Vector3d middle = window().presenter().partBox().center();
  const Eigen::Vector3d tip =
      middle + 60.0 * viewport().mmPerPoint(middle) * Eigen::Vector3d::UnitX();
  const QPoint from = at(tip), to = at(tip + Eigen::Vector3d(6, 0, 0));
  QTest::mouseMove(&viewport(), from);
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
  QTest::mouseMove(&viewport(), (from + to) / 2);
  QTest::mouseMove(&viewport(), to);
  EXPECT_GT(viewport().view().regionMovedMm.x(), 3.0);
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, to);
  const std::vector<double> moved = regions::parsedShape(regions()[0].shape).numbers;
  EXPECT_NEAR(moved[0], 6.0, 1.0);
  EXPECT_NEAR(moved[2], 6.0, 1e-6);
  EXPECT_EQ(document().undoStack()->undoText(), "Move region");
  // The part is turned: the handles are at the same place of the part.
  document().place({Eigen::Quaterniond(Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitZ())),
                    {20.0, 0.0},
                    0.0},
                   "turn");
  ASSERT_TRUE(settled());
  EXPECT_TRUE(bodiesDrawn());
  EXPECT_EQ(regions::parsedShape(regions()[0].shape).numbers, moved);
  picture();
  keepPicture(window(), "regions_dragged");
  // Escape closes; the outline stays.
  viewport().setFocus();
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_FALSE(panel()->isVisible());
  EXPECT_TRUE(find<QWidget>("prepareTabs")->isVisible());
  EXPECT_TRUE(bodiesDrawn());
  EXPECT_TRUE(viewport().view().regionOutlines);
}

TEST_F(RegionsWindowTest, EachPartHasItsOwnAndToolsExcludeEachOther) {
  openFlat(open(block()));
  openTool();
  add("box");
  document().duplicatePart();
  ASSERT_TRUE(settled());
  EXPECT_EQ(regions().size(), 1u) << "a copy has the regions of its part";
  add("sphere");
  document().setActive(0);
  ASSERT_TRUE(settled());
  EXPECT_EQ(list()->topLevelItemCount(), 1);
  document().setActive(1);
  ASSERT_TRUE(settled());
  EXPECT_EQ(list()->topLevelItemCount(), 2);
  picture();
  keepPicture(window(), "regions_second_part");
  QTest::mouseClick(find<window::ViewTools>("viewTools")->button(find<QAction>("toolCut")),
                    Qt::LeftButton);
  EXPECT_FALSE(panel()->isVisible());
  EXPECT_TRUE(find<QWidget>("cutPanel")->isVisible());
  openTool();
  EXPECT_FALSE(find<QWidget>("cutPanel")->isVisible());
  EXPECT_FALSE(find<QWidget>("prepareTabs")->isVisible());
  choosePage(Page::Layers);
  EXPECT_FALSE(viewport().view().regions);
  choosePage(Page::Prepare);
  EXPECT_FALSE(panel()->isVisible());
  EXPECT_TRUE(find<QWidget>("prepareTabs")->isVisible());
  openTool();
  document().removePart();
  document().removePart();
  EXPECT_FALSE(panel()->isVisible());
}

TEST_F(RegionsWindowTest, TheMenuOfThePartAddsARegion) {
  openFlat(open(block()));
  auto* tree = find<panels::ObjectTree>("tree");
  emit tree->customContextMenuRequested(tree->visualItemRect(tree->topLevelItem(0)).center());
  QMenu* menu = nullptr;
  ASSERT_TRUE(waitFor(
      [&] { return (menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) != nullptr; },
      5000));
  ASSERT_TRUE(menu->actions().contains(find<QAction>("addRegion")));
  menu->close();
  find<QAction>("addRegion")->trigger();
  auto* sphere = find<QAction>("addRegion.sphere");
  QMenu* shapes = nullptr;
  ASSERT_TRUE(waitFor(
      [&] {
        shapes = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        return shapes && shapes->actions().contains(sphere);
      },
      5000));
  keepPicture(*shapes, "regions_shapes");
  QTest::mouseClick(shapes, Qt::LeftButton, {}, shapes->actionGeometry(sphere).center());
  EXPECT_EQ(regions().size(), 1u);
}

TEST_F(RegionsWindowTest, ABodyComesFromAFile) {
  openFlat(open(block()));
  openTool();
  const QString file = writePart("body.stl", box({-3, -3, 2}, {3, 3, 20}));
  answerFileDialog(file);
  find<QAction>("addRegion.mesh")->trigger();
  ASSERT_TRUE(waitFor([&] { return regions().size() == 1; }, 20000));
  EXPECT_EQ(regions()[0].shape, "mesh:body.stl");
  ASSERT_TRUE(regions()[0].mesh);
  EXPECT_TRUE(bodiesDrawn());
  EXPECT_EQ(viewport().tool(), viewer::Tool::Regions) << "without handles";
  chooseUse("cut");
  ASSERT_TRUE(settled());
  EXPECT_LT(geometry::volume(*document().result(Stage::Load)->job.item().part),
            24 * 24 * 12 - 6 * 6 * 9);
  EXPECT_TRUE(problem().isEmpty()) << problem().toStdString();
  picture();
  keepPicture(window(), "regions_cut");
}

TEST_F(RegionsWindowTest, UndoInABoxIsThatOfTheWindowUnlessANumberIsTyped) {
  openFlat(open(block()));
  openTool();
  add("sphere");
  auto* box = find<QDoubleSpinBox>("regionNumber3");
  typeNumber(3, "5,5");
  EXPECT_EQ(regions()[0].shape, "sphere:0,0,6,5.5");
  EXPECT_EQ(QApplication::focusWidget(), box);
  QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(regions()[0].shape, "sphere:0,0,6,4");
  EXPECT_DOUBLE_EQ(box->value(), 4.0);
  box->selectAll();
  QTest::keyClicks(box, "7");
  QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(regions()[0].shape, "sphere:0,0,6,4") << "only the text";
  EXPECT_EQ(regions().size(), 1u);
}

// A project that is saved before anything is painted shows its part.
TEST_F(RegionsWindowTest, ARegionWithoutPaintIsSavedAndPlanned) {
  openFlat(open(block()));
  openTool();
  add("painted");
  const QString file = path("unpainted.voluta");
  answerFileDialog(file);
  clickMenu("fileMenu", "saveAs");
  ASSERT_TRUE(waitFor([&] { return document().projectFile() == file; }, 20000));
  window().open(file);
  ASSERT_TRUE(waitFor([&] { return document().undoStack()->count() == 0; }, 20000));
  ASSERT_TRUE(settled());
  EXPECT_EQ(regions().size(), 1u);
  EXPECT_TRUE(document().result(Stage::Load));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Layers));
}

TEST_F(RegionsWindowTest, GroupsOfRegionsAreNamedInTheLegend) {
  openFlat(open(block()));
  openTool();
  add("skin");
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Layers));
  choosePage(Page::Layers);
  picture();
  const auto names = [&](scene::ColourBy colourBy) {
    auto* combo = find<QComboBox>("colourBy");
    combo->setCurrentIndex(combo->findData(static_cast<int>(colourBy)));
    emit combo->activated(combo->currentIndex());
    EXPECT_TRUE(waitFor([&] { return viewport().view().colourBy == colourBy; }, 20000));
    picture();
    QStringList shown;
    for (const scene::LegendEntry& entry : find<window::LegendView>("legend")->legend().entries)
      shown << QString::fromStdString(base::english(entry.text()));
    return shown;
  };
  EXPECT_EQ(names(scene::ColourBy::Group), QStringList({"1", "Skin below the upper surface"}));
  keepPicture(window(), "regions_groups");
  QTest::mouseClick(find<QToolButton>("subject2"), Qt::LeftButton); // layers
  EXPECT_EQ(names(scene::ColourBy::Region), QStringList({"Part", "Skin below the upper surface"}));
}

TEST_F(RegionsWindowTest, FitsASmallScreenInEveryLanguageAndLook) {
  openFlat(open(block()));
  window().resize(1280, 800);
  openTool();
  add("box");
  add("skin");
  chooseUse("flat");
  select(0);
  ASSERT_TRUE(bodiesDrawn());
  find<QAction>("language_it")->trigger();
  QApplication::processEvents();
  picture();
  keepPicture(window(), "regions_italian");
  find<QAction>("language_en")->trigger();
  QApplication::processEvents();
  EXPECT_EQ(list()->topLevelItem(0)->text(0), "Box");
  EXPECT_EQ(panel()->selected(), 0u);
  EXPECT_LE(window().width(), 1280);
  EXPECT_GE(find<QPushButton>("regionRemove")->width(),
            find<QPushButton>("regionRemove")->sizeHint().width());
  for (const char* look : {"dark", "highContrast", "light"}) {
    find<QAction>(look)->trigger();
    QTest::qWait(50);
    picture();
    keepPicture(window(), (std::string("regions_small_") + look).c_str());
  }
}

} // namespace
} // namespace voluta::test
