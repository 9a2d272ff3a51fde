// Opening, planning and closing documents again and again leaves no memory behind.
#include "gui/window_fixture.h"
#include "helpers/all_seeds.h"
#include "helpers/shapes.h"
#include "pipeline/plan_result.h"
#include "pipeline/stage_cache.h"

#include <QTest>
#include <fstream>
#include <memory>
#include <unistd.h>

namespace voluta::test {
namespace {

using project::Stage;

double residentMb() {
  std::ifstream file("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

class MemoryTest : public WindowTest {
protected:
  void planOnAllPages(const QString& part) {
    openPart(part);
    chooseFlat();
    window().planning().plan(Stage::Replay);
    ASSERT_TRUE(planned(Stage::Replay));
    for (const char* page : {Page::Prepare, Page::Layers, Page::Simulate, Page::Export})
      choosePage(page);
  }
  void closeDocument() {
    answerBox("", QMessageBox::DestructiveRole);
    find<QAction>("new")->trigger();
    ASSERT_TRUE(waitFor([&] { return document().source() == nullptr; }, 10000));
  }
};

TEST_F(MemoryTest, AClosedDocumentLeavesNoResults) {
  planOnAllPages(writePart("plinth.stl", box({0, 0, 0}, {24, 18, 6})));
  const std::weak_ptr<const pipeline::PlanResult> result = document().lastResult();
  const std::weak_ptr<pipeline::StageCache> cache = window().planning().cache();
  closeDocument();
  EXPECT_TRUE(waitFor([&] { return result.expired() && cache.expired(); }, 20000))
      << result.use_count() << " and " << cache.use_count();
}

TEST_F(MemoryTest, SeveralDocumentsTakeNoMoreThanOne) {
  constexpr double kMb = 50.0;
  constexpr int kMs = 3000; // by then the memory is returned
  double first = 0.0;
  for (int i = 0; i < ofSeeds(3, 20); ++i) {
    planOnAllPages(writePart("plinth.stl", box({0, 0, 0}, {40, 30, 10.0 + i})));
    closeDocument();
    QTest::qWait(kMs);
    if (i == 0)
      first = residentMb();
    RecordProperty(("megabytes" + std::to_string(i)).c_str(), std::to_string(residentMb()));
  }
  EXPECT_LE(residentMb(), first + kMb);
}

} // namespace
} // namespace voluta::test
