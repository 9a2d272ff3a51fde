// The schemes of mode planar on the road, and the user's root.
#include "modes/piece_search.h"

#include "base/error.h"
#include "helpers/shapes.h"
#include "modes/rod_profile.h"
#include "pipeline/stage_options.h"

#include <gtest/gtest.h>

#include <string>

namespace voluta::pipeline {
namespace {

using Eigen::Vector3d;
using namespace voluta::modes;

PieceSearch searched(const std::map<std::string, std::string>& set) {
  base::ParameterValues out(pieceSearchParameters());
  for (const auto& [key, value] : set)
    out.set(key, value);
  return pieceSearch(out);
}

TEST(PieceRoot, IsAPointInWords) {
  EXPECT_FALSE(pieceRoot(""));
  EXPECT_FALSE(pieceRoot("  "));
  EXPECT_EQ(pieceRoot("1,-2.5,3"), Vector3d(1, -2.5, 3));
  EXPECT_EQ(pieceRoot(" 1, -2.5 , 3e1 "), Vector3d(1, -2.5, 30));
  EXPECT_EQ(pieceRoot(pieceRootText({0.125, -40, 7})), Vector3d(0.125, -40, 7));
  for (const char* wrong : {"1", "1,2", "1,2,", "1,2,3,4", "a,2,3", "1;2;3", "1,,3", "nan,0,0",
                            "1e9,0,0", "0,0,-1e300"})
    try {
      pieceRoot(wrong);
      ADD_FAILURE() << wrong;
    } catch (const base::Error& e) {
      EXPECT_EQ(e.code(), base::ErrorCode::Usage);
      EXPECT_NE(std::string(e.what()).find(wrong), std::string::npos);
    }
}

TEST(RodProfile, RefusesPlacesBeyondAKilometre) {
  EXPECT_EQ(rodProfile("-20,2.5 1e6,3").size(), 2u);
  for (const char* wrong : {"-20,2.5 1e9,3", "-1e300,2 20,2", "-20,2.5 20,1e7"})
    EXPECT_THROW(rodProfile(wrong), base::Error) << wrong;
}

TEST(SearchPieces, BothSchemesGiveThePartWhole) {
  const geometry::TriangleMesh block = test::box({-10, -10, 0}, {10, 10, 20});
  for (const char* scheme : {"beam", "greedy"})
    EXPECT_EQ(searchPieces(block, {}, searched({{"planarScheme", scheme}}), base::RunContext())
                  .pieces.size(),
              1u);
}

TEST(SearchPieces, RootInTheAirGivesAnErrorOfOneLine) {
  // Two blocks, one of them in the air.
  geometry::TriangleMesh blocks = test::box({-10, -10, 0}, {10, 10, 20});
  test::append(blocks, test::box({20, -10, 5}, {40, 10, 25}));
  const auto search = [&](const char* root) {
    return searchPieces(blocks, {}, searched({{"planarScheme", "greedy"}, {"pieceRoot", root}}),
                        base::RunContext());
  };
  EXPECT_NO_THROW(search("0,0,0"));
  try {
    search("30,0,25");
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
    const std::string line = e.what();
    EXPECT_NE(line.find("30.0, 0.0, 25.0"), std::string::npos) << line;
    EXPECT_NE(line.find("plate"), std::string::npos);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_FALSE(e.remedy().empty());
  }
}

} // namespace
} // namespace voluta::pipeline
