// Fixture of tests of the regions tool.
#pragma once

#include "geometry/measures.h"
#include "gui/part_view_fixture.h"
#include "helpers/shapes.h"
#include "panels/object_tree.h"
#include "panels/regions_panel.h"
#include "plan/tool_plan.h"
#include "regions/region_kinds.h"
#include "timeline/layer_range_slider.h"
#include "viewer/camera_control.h"
#include "window/legend_view.h"
#include "window/view_tools.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStandardItemModel>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>

namespace voluta::test {

using project::Region;
using project::Stage;

class RegionsWindowTest : public PartViewTest {
protected:
  panels::RegionsPanel* panel() { return find<panels::RegionsPanel>("regionsPanel"); }
  QTreeWidget* list() { return find<QTreeWidget>("regionList"); }
  QString problem() { return find<QLabel>("regionProblem")->text(); }
  const std::vector<Region>& regions() { return document().choices().item().regions; }
  void openTool() {
    QTest::mouseClick(find<window::ViewTools>("viewTools")->button(find<QAction>("toolRegions")),
                      Qt::LeftButton);
    EXPECT_TRUE(panel()->isVisible());
  }
  void add(const char* shape) {
    const std::size_t before = regions().size();
    panel()->openAddMenu();
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_NE(menu, nullptr);
    auto* action = find<QAction>((std::string("addRegion.") + shape).c_str());
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
    ASSERT_EQ(regions().size(), before + 1);
  }
  void type(QDoubleSpinBox* box, const char* value) {
    ASSERT_NE(box, nullptr);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, value);
    QTest::keyClick(box, Qt::Key_Return);
  }
  void typeNumber(int at, const char* value) {
    type(find<QDoubleSpinBox>(qPrintable(QString("regionNumber%1").arg(at))), value);
  }
  void chooseUse(const char* id) {
    auto* combo = find<QComboBox>("regionUse");
    combo->setCurrentIndex(combo->findData(QString(id)));
    emit combo->activated(combo->currentIndex());
  }
  void select(int row) {
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, {},
                      list()->visualItemRect(list()->topLevelItem(row)).center());
  }
  bool bodiesDrawn() {
    return waitFor([&] { return viewport().view().regions; }, 20000);
  }
  QString open(const geometry::TriangleMesh& mesh) { return writePart("block.stl", mesh); }
};

inline geometry::TriangleMesh block() {
  return box({-12, -12, 0}, {12, 12, 12});
}

} // namespace voluta::test
