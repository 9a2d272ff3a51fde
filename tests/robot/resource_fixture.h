// Points the program's data folder at the source tree, independent of the build and its folder.
#pragma once

#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::test {

class WithResources : public ::testing::Test {
protected:
  void SetUp() override { setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1); }
};

} // namespace voluta::test
