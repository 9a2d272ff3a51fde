#include "panels/compare_table.h"

#include <QFontMetrics>
#include <gtest/gtest.h>

namespace voluta::panels {
namespace {

// Rows of several cells differ by the end of the name only.
TEST(CompareTable, ShowsNamesOfWaysWholeBesideManyFigures) {
  CompareTable table;
  table.setFigures(std::vector<QString>(12, QStringLiteral("A figure")));
  CompareEntry entry;
  entry.strategy = QStringLiteral("Flat layers, kr6-r900-moving");
  entry.figures.assign(12, QStringLiteral("1,234"));
  table.setEntries({entry});
  table.resize(500, 300);
  table.show();
  QFont bold = table.font();
  bold.setBold(true);
  constexpr int kWayColumn = 1, kPicture = 88;
  EXPECT_GT(table.columnWidth(kWayColumn),
            kPicture + QFontMetrics(bold).horizontalAdvance(entry.strategy));
}

} // namespace
} // namespace voluta::panels
