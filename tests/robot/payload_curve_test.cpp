// A robot's payload by the distance of the load's centre from the flange.
#include "resource_fixture.h"

#include "base/error.h"
#include "robot/payload_curve.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::robot {
namespace {

class PayloadCurves : public test::WithResources {
protected:
  static std::vector<LoadPoint> read(const std::string& text) {
    return readPayloadCurve(base::JsonNode::parse(text, "curve.json"));
  }
};

TEST_F(PayloadCurves, AreLinearBetweenTheirPoints) {
  const std::vector<LoadPoint> curve{{100, 5}, {200, 3}, {400, 1}};
  EXPECT_DOUBLE_EQ(payloadAt(curve, 0), 5);
  EXPECT_DOUBLE_EQ(payloadAt(curve, 100), 5);
  EXPECT_DOUBLE_EQ(payloadAt(curve, 150), 4);
  EXPECT_DOUBLE_EQ(payloadAt(curve, 300), 2);
  EXPECT_DOUBLE_EQ(payloadAt(curve, 800), 0.5); // the moment of the last point
  EXPECT_DOUBLE_EQ(payloadAt(std::vector<LoadPoint>{{0, 2}}, 300), 2);
}

TEST_F(PayloadCurves, NeverGrowWithTheDistance) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int n = 0; n < 200; ++n) {
    std::vector<LoadPoint> curve{{100 * unit(random), 10}};
    for (int i = 0; i < 5; ++i)
      curve.push_back({curve.back().offsetMm + 1 + 100 * unit(random),
                       curve.back().kg * (0.5 + 0.5 * unit(random))});
    double last = payloadAt(curve, 0);
    for (double offset = 0; offset < 900; offset += 7) {
      EXPECT_LE(payloadAt(curve, offset), last + 1e-12);
      last = payloadAt(curve, offset);
    }
  }
}

TEST_F(PayloadCurves, OfRobotsAreTheirFilesOrTheirRating) {
  const auto curved = payloadAt(loadRobot("rv2f"), 355);
  ASSERT_TRUE(curved);
  EXPECT_TRUE(curved->byCurve);
  EXPECT_DOUBLE_EQ(curved->kg, 1.0);
  const auto rated = payloadAt(loadRobot("ur5"), 355);
  ASSERT_TRUE(rated);
  EXPECT_FALSE(rated->byCurve);
  EXPECT_DOUBLE_EQ(rated->kg, 5.0);
}

TEST_F(PayloadCurves, RefuseInvalidCurves) {
  for (const char* text : {"[]", R"([{"offsetMm": -1, "kg": 2}])", R"([{"offsetMm": 0, "kg": 0}])",
                           R"([{"offsetMm": 9, "kg": 2}, {"offsetMm": 9, "kg": 1}])",
                           R"([{"offsetMm": 0, "kg": 2}, {"offsetMm": 9, "kg": 3}])",
                           R"([{"offsetMm": 0, "kg": 2, "more": 1}])"})
    EXPECT_THROW(read(text), base::Error) << text;
}

} // namespace
} // namespace voluta::robot
