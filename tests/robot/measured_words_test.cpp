// Words about measured points.
#include "robot/measured/measured_words.h"

#include "base/units.h"

#include <gmock/gmock.h>

namespace voluta::robot {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

TEST(MeasuredWords, WhereAFrameIs) {
  Eigen::Isometry3d frame(Eigen::Translation3d(512.25, -20, 3));
  frame.rotate(Eigen::AngleAxisd(base::degreesToRadians(30), Vector3d::UnitZ()));
  const std::string reported = base::english(placeOf(frame));
  EXPECT_THAT(reported, HasSubstr("512.250, -20.000, 3.000 mm"));
  EXPECT_THAT(reported, HasSubstr("0.000, 0.000, 30.000"));
}

TEST(MeasuredWords, HowWellTheRowsAgree) {
  const MeasuredFrame three =
      frameFromPoints({{{0, 0, 0}, {1, 2, 3}}, {{10, 0, 0}, {11, 2, 3}}, {{0, 10, 0}, {1, 12, 3}}});
  EXPECT_THAT(base::english(agreementOf(three.residual, 3)), HasSubstr("3 rows"));
  EXPECT_THAT(base::english(agreementOf(Residual{}, 3)), HasSubstr("cannot be estimated"));
  Residual known{0.123, 0.456, 0.2, 0.0789, base::degreesToRadians(0.05)};
  const std::string reported = base::english(agreementOf(known, 8));
  for (const char* part : {"8 rows", "0.123 mm", "0.456 mm", "0.079 mm", "0.050"})
    EXPECT_THAT(reported, HasSubstr(part));
  known.angleRad = 0.0; // of a tip
  EXPECT_EQ(base::english(agreementOf(known, 8)).find("0.050"), std::string::npos);
}

} // namespace
} // namespace voluta::robot
