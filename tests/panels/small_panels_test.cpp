#include "panels/layer_info.h"
#include "panels/mesh_panel.h"
#include "panels/object_tree.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

using namespace voluta;
using panels::SceneItem;

TEST(MeshPanel, ListsFoundRepairedAndRemainingFaults) {
  panels::MeshPanel panel;
  QSignalSpy toggled(&panel, &panels::MeshPanel::repairToggled);
  auto* repair = panel.findChild<QCheckBox*>();
  EXPECT_FALSE(repair->isEnabled());
  panels::MeshSummary mesh;
  mesh.name = "a<b.stl";
  mesh.triangles = 12345;
  mesh.found = {base::message("{text}"_text, "A hole."_name)};
  mesh.repaired = {base::message("{text}"_text, "Closed it."_name)};
  mesh.remains = {base::message("{text}"_text, "A knot."_name)};
  panel.setSummary(mesh);
  const QString text = panel.findChild<QLabel*>(QStringLiteral("text"))->text();
  for (const char* expected : {"a&lt;b.stl", "12,345", "A hole.", "Closed it.", "A knot."})
    EXPECT_TRUE(text.contains(QLatin1String(expected))) << expected;
  panel.setRepair(false);
  EXPECT_EQ(toggled.size(), 0);
  repair->click();
  ASSERT_EQ(toggled.size(), 1);
  EXPECT_TRUE(toggled[0][0].toBool());
}

TEST(ObjectTree, EyesToggleByClickAndByKey) {
  panels::ObjectTree tree;
  tree.resize(300, 220);
  tree.setText(SceneItem::Part, "kitten.stl", "70 mm");
  tree.show();
  (void)QTest::qWaitForWindowExposed(&tree);
  std::vector<std::pair<SceneItem, bool>> reported;
  QObject::connect(&tree, &panels::ObjectTree::visibilityChanged,
                   [&](SceneItem item, bool shown) { reported.emplace_back(item, shown); });
  QTreeWidgetItem* part = tree.topLevelItem(0);
  EXPECT_EQ(part->text(0), "kitten.stl");
  const QRect row = tree.visualItemRect(part);
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {},
                    QPoint(tree.columnViewportPosition(2) + 8, row.center().y()));
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_EQ(reported[0], std::make_pair(SceneItem::Part, false));
  tree.select(SceneItem::Robot);
  QTest::keyClick(&tree, Qt::Key_Space);
  ASSERT_EQ(reported.size(), 2u);
  EXPECT_EQ(reported[1], std::make_pair(SceneItem::Robot, false));
  tree.setShown(SceneItem::Part, true);
  EXPECT_EQ(reported.size(), 2u);
  EXPECT_TRUE(tree.isShown(SceneItem::Part));
}

TEST(ObjectTree, SignalsSelectionsByTheUserOnly) {
  panels::ObjectTree tree;
  std::vector<SceneItem> reported;
  QObject::connect(&tree, &panels::ObjectTree::selected,
                   [&](SceneItem item) { reported.push_back(item); });
  tree.select(SceneItem::Platform);
  EXPECT_TRUE(reported.empty());
  QTest::keyClick(&tree, Qt::Key_Down);
  EXPECT_EQ(reported, (std::vector<SceneItem>{SceneItem::Cell}));
}

TEST(LayerInfo, ShowsMeasuresAndDashesWithoutALayer) {
  panels::LayerInfo info;
  const auto says = [&](const char* text) {
    for (const QLabel* label : info.findChildren<QLabel*>())
      if (label->text() == QString::fromUtf8(text))
        return true;
    return false;
  };
  EXPECT_TRUE(says("–"));
  panels::LayerMeasures layer;
  layer.index = 41;
  layer.layers = 125;
  layer.lengthMm = 15230.0;
  layer.timeS = 61.0;
  info.setMeasures(layer);
  EXPECT_TRUE(says("42 of 125"));
  EXPECT_TRUE(says("15.23 m"));
  EXPECT_TRUE(says("1 min 1 s"));
}
