#include "base/memory.h"

#include <gtest/gtest.h>
#include <vector>

using namespace voluta;

TEST(Memory, FreedStorageHasNoCapacity) {
  std::vector<double> numbers(1000, 1.0);
  std::vector<int> others(7, 2);
  base::freeStorage(numbers, others);
  EXPECT_EQ(numbers.capacity(), 0u);
  EXPECT_EQ(others.capacity(), 0u);
}
