// A part on a flat plate in the view, for tools that are used by clicks on it.
#pragma once

#include "gui/window_fixture.h"

namespace voluta::test {

class PartViewTest : public WindowTest {
protected:
  void openFlat(const QString& file) {
    openPart(file);
    chooseFlat("rect:200x200");
    ASSERT_TRUE(settled());
    viewport().framePart();
    picture();
  }
  bool settled() {
    return waitFor([&] {
      return document().sourceReady() && !window().planning().running() &&
             document().upToDate(project::Stage::Load) && !window().presenter().busy();
    });
  }
  viewer::Viewport& viewport() { return window().viewport(); }
};

} // namespace voluta::test
