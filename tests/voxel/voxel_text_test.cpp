#include "voxel/voxel_text.h"

#include "base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace voluta::voxel {
namespace {

using ::testing::HasSubstr;

std::size_t countOf(const VoxelObject& o) {
  std::size_t n = 0;
  for (const auto s : o.solid)
    n += s;
  return n;
}

TEST(VoxelText, FlatObjectIsOnItsPlatform) {
  const VoxelObject o = readVoxelText("1100\n0100\n----\n", "l.txt");
  EXPECT_EQ(o.size, Eigen::Vector3i(4, 1, 2));
  EXPECT_EQ(countOf(o), 3u);
  EXPECT_TRUE(o.solidAt(1, 0, 0));
  EXPECT_TRUE(o.solidAt(0, 0, 1));
  EXPECT_FALSE(o.solidAt(0, 0, 0));
  ASSERT_EQ(o.platform.size(), 4u);
  EXPECT_EQ(o.platform[3], (std::array<int, 2>{3, 0}));
}

TEST(VoxelText, PlatformBesideTheLowestRowIsLevelWithItsFoot) {
  const VoxelObject o = readVoxelText("010\n-1-\n", "t.txt");
  EXPECT_EQ(o.size.z(), 2);
  EXPECT_TRUE(o.solidAt(1, 0, 0));
  EXPECT_EQ(o.platform.size(), 2u);
}

TEST(VoxelText, SlicesFollowOneAnotherAlongY) {
  const VoxelObject o = readVoxelText("10\n11\n--\n\n01\n00\n0-\n", "s.txt");
  EXPECT_EQ(o.size, Eigen::Vector3i(2, 2, 2));
  EXPECT_TRUE(o.solidAt(0, 0, 1));
  EXPECT_TRUE(o.solidAt(1, 1, 1));
  EXPECT_FALSE(o.solidAt(1, 1, 0));
  EXPECT_EQ(o.platform, (std::vector<std::array<int, 2>>{{0, 0}, {1, 0}, {1, 1}}));
}

// The pyramid of the thesis's fig. 5.2: layers stacked on a platform of their own.
TEST(VoxelText, LayersStackedOnAPlatformAreHorizontal) {
  const std::string up = "---\n---\n---\n\n111\n111\n110\n\n000\n010\n000\n";
  const std::string down = "000\n010\n000\n\n111\n111\n110\n\n---\n---\n---\n";
  for (const std::string& text : {up, down}) {
    const VoxelObject o = readVoxelText(text, "pyramid.txt");
    EXPECT_EQ(o.size, Eigen::Vector3i(3, 3, 2));
    EXPECT_EQ(countOf(o), 9u);
    EXPECT_FALSE(o.solidAt(2, 0, 0)) << "the last row of a layer is its front";
    EXPECT_TRUE(o.solidAt(2, 2, 0));
    EXPECT_TRUE(o.solidAt(1, 1, 1));
    EXPECT_EQ(o.platform.size(), 9u);
  }
}

TEST(VoxelText, LineEndsMarksAndBlankLinesDoNotMatter) {
  const VoxelObject plain = readVoxelText("10\n11\n--\n\n01\n01\n--", "a.txt");
  const VoxelObject odd = readVoxelText(
      "\xEF\xBB\xBF\r\n\n10 \t\r\n11\r\n--\r\n  \n\r\n01\r\n01\r\n--\r\n\r\n", "a.txt");
  EXPECT_EQ(plain.solid, odd.solid);
  EXPECT_EQ(plain.platform, odd.platform);
}

struct Bad {
  const char *text, *where, *what;
};

TEST(VoxelText, BadObjectsGiveAnErrorOfOneLineWithTheirPlace) {
  const Bad all[] = {
      {"0110\n011\n----\n", "x.txt, line 2, column 4", "3 cells, the first one 4"},
      {"0110\n01100\n----\n", "x.txt, line 2, column 5", "5 cells"},
      {"0110\n01x0\n----\n", "x.txt, line 2, column 3", "'x' is none of 0, 1 and -"},
      {"0110\n01 0\n----\n", "x.txt, line 2, column 3", "a space"},
      {"0110\n01\x01"
       "0\n----\n",
       "x.txt, line 2, column 3", "byte 0x01"},
      {"01\n11\n--\n\n11\n--\n", "x.txt, line 6",
       "slice 2 ends after 2 rows, the first one after 3"},
      {"01\n--\n\n11\n11\n--\n\n11\n--\n", "x.txt, line 6", "slice 2 ends after 3 rows"},
      {"0110\n0110\n", "x.txt, line 2", "there is no platform"},
      {"0110\n----\n0010\n", "x.txt, line 3, column 3", "below the platform"},
      {"0-00\n0110\n----\n", "x.txt, line 2, column 2", "below the platform"},
      {"0110\n0000\n----\n", "x.txt, line 3", "nothing is on the platform"},
      {"0000\n----\n", "x.txt", "no part"},
      {"----\n", "x.txt", "no part"},
      {"", "x.txt", "no cells"},
      {" \n\r\n", "x.txt", "no cells"},
  };
  for (const Bad& bad : all)
    try {
      readVoxelText(bad.text, "x.txt");
      ADD_FAILURE() << bad.text;
    } catch (const base::Error& e) {
      EXPECT_THAT(voluta::base::english(e.context()), HasSubstr(bad.where)) << bad.text;
      EXPECT_THAT(voluta::base::english(e.message()), HasSubstr(bad.what)) << bad.text;
      EXPECT_FALSE(e.remedy().empty());
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
}

TEST(VoxelText, TooLargeAnObjectIsRefusedWithItsLine) {
  const std::string wide(static_cast<std::size_t>(kLargestSide) + 1, '1');
  try {
    readVoxelText(wide + "\n" + std::string(wide.size(), '-'), "wide.txt");
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("line 1"));
    EXPECT_THAT(e.what(), HasSubstr("too large"));
  }
  std::string tall;
  for (int r = 0; r <= kLargestSide; ++r)
    tall += "1\n";
  EXPECT_THROW(readVoxelText(tall + "-\n", "tall.txt"), base::Error);
}

TEST(VoxelText, WrittenObjectsAreReadBack) {
  std::mt19937 random(3);
  for (int round = 0; round < 50; ++round) {
    VoxelObject o;
    o.size = {1 + static_cast<int>(random() % 6), 1 + static_cast<int>(random() % 4),
              1 + static_cast<int>(random() % 5)};
    o.solid.resize(static_cast<std::size_t>(o.size.prod()));
    for (auto& s : o.solid)
      s = random() % 2;
    o.solid[0] = 1;
    for (int j = 0; j < o.size.y(); ++j)
      for (int i = 0; i < o.size.x(); ++i)
        if (random() % 2 || (i == 0 && j == 0))
          o.platform.push_back({i, j});
    const VoxelObject back = readVoxelText(writeVoxelText(o), "back.txt");
    EXPECT_EQ(back.size, o.size);
    EXPECT_EQ(back.solid, o.solid);
    EXPECT_EQ(back.platform, o.platform);
  }
}

TEST(VoxelText, IsDistinguishedFromMeshesByItsFirstLine) {
  EXPECT_FALSE(looksLikeVoxelText("\n 0\n"));
  EXPECT_TRUE(looksLikeVoxelText("\r\n0011-\r\nx"));
  EXPECT_FALSE(looksLikeVoxelText("solid cube\nfacet"));
  EXPECT_FALSE(looksLikeVoxelText("v 0 0 1\n"));
  EXPECT_FALSE(looksLikeVoxelText(""));
}

// For any changed bytes: a consistent object, or one clear line.
TEST(VoxelText, DamagedTextNeverGivesADamagedObject) {
  const std::string sound = "0110\n1111\n----\n\n0100\n0110\n0--0\n\n0000\n0100\n----\n";
  std::mt19937 random(11);
  std::size_t refused = 0, taken = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = sound;
    for (unsigned n = 1 + random() % 4; n > 0; --n) {
      const std::size_t at = random() % text.size();
      constexpr char kBytes[] = "01-\n\r \tx\0\xff";
      switch (random() % 3) {
      case 0:
        text[at] = kBytes[random() % (sizeof kBytes - 1)];
        break;
      case 1:
        text.erase(at, 1 + random() % 3);
        break;
      default:
        text.insert(at, 1, kBytes[random() % (sizeof kBytes - 1)]);
      }
    }
    try {
      const VoxelObject o = readVoxelText(text, "m.txt");
      ++taken;
      ASSERT_EQ(o.solid.size(), static_cast<std::size_t>(o.size.prod()));
      ASSERT_GT(countOf(o), 0u);
      ASSERT_FALSE(o.platform.empty());
      for (const auto& [i, j] : o.platform)
        ASSERT_TRUE(i >= 0 && j >= 0 && i < o.size.x() && j < o.size.y());
      if (std::none_of(o.platform.begin(), o.platform.end(),
                       [&](const auto& column) { return o.solidAt(column[0], column[1], 0); }))
        continue; // beside the part alone
      const VoxelObject back = readVoxelText(writeVoxelText(o), "back.txt");
      ASSERT_EQ(back.solid, o.solid) << text;
      ASSERT_EQ(back.platform, o.platform) << text;
    } catch (const base::Error& e) {
      ++refused;
      ASSERT_NE(e.code(), base::ErrorCode::Internal) << e.what();
      ASSERT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(refused, 5000u);
  EXPECT_GT(taken, 300u);
}

} // namespace
} // namespace voluta::voxel
