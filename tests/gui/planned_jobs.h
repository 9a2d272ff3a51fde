// A small job of each mode, planned in the window as far as its programs.
#pragma once

#include "gui/window_fixture.h"

#include <string>

namespace voluta::test {

class PlannedJobTest : public WindowTest, public testing::WithParamInterface<std::string> {
protected:
  void SetUp() override;
  void TearDown() override;

  void planJob(const std::string& mode);
  // Whether the window's planning is finished or cancelled, and drawn.
  bool settled();
};

inline auto everyMode() {
  return testing::Values("curved", "planar", "flat", "lathe", "substrate");
}
inline std::string modeOf(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

} // namespace voluta::test
