#include "base/zeroed_array.h"

#include <cstdint>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>
#include <utility>

using voluta::base::ZeroedArray;

namespace {

long residentBytes() {
  std::ifstream statm("/proc/self/statm");
  long all = 0, resident = 0;
  statm >> all >> resident;
  return resident * ::sysconf(_SC_PAGESIZE);
}

TEST(ZeroedArray, IsZeroInitiallyAndKeepsWrittenValues) {
  ZeroedArray<std::uint32_t> a(1000), b(1000);
  EXPECT_EQ(a.size(), 1000u);
  for (const std::uint32_t x : a)
    EXPECT_EQ(x, 0u);
  EXPECT_TRUE(a == b);
  a[999] = 7;
  EXPECT_FALSE(a == b);
  const ZeroedArray<std::uint32_t> c = std::move(a);
  EXPECT_EQ(c[999], 7u);
  EXPECT_TRUE(ZeroedArray<float>().empty());
  const ZeroedArray<float> none(0);
  EXPECT_TRUE(none.begin() == none.end());
}

TEST(ZeroedArray, PrepareKeepsElementValues) {
  ZeroedArray<float> a(100'000);
  a[7] = 2.5f;
  for (const std::size_t i : {std::size_t{0}, std::size_t{7}, std::size_t{99'999}})
    a.prepare(i);
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_EQ(a[i], i == 7 ? 2.5f : 0.0f);
}

TEST(ZeroedArray, UnwrittenPagesTakeNoMemory) {
  const long before = residentBytes();
  ZeroedArray<float> large(100'000'000);
  for (std::size_t i = 0; i < 1'000'000; ++i)
    large[i] = 1.0f;
  EXPECT_EQ(large[99'999'999], 0.0f);
  EXPECT_LT(residentBytes() - before, 40'000'000);
}

} // namespace
