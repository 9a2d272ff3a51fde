#include "motion/layer_event_text.h"
#include "motion/motion_options.h"

#include "base/error.h"

#include <gtest/gtest.h>

using namespace voluta;
using motion::MotionOptions;
using motion::NozzleRotation;
using motion::SmoothingMethod;

namespace {

MotionOptions optionsWith(std::initializer_list<const char*> assignments) {
  base::ParameterValues values(motion::motionParameters());
  for (const char* assignment : assignments)
    values.setAssignment(assignment);
  return motion::motionOptions(values);
}

} // namespace

TEST(MotionOptions, AreTheDefaultsWhereNothingIsSet) {
  const MotionOptions d, o = optionsWith({});
  EXPECT_EQ(o.printing.bodiesMm, d.printing.bodiesMm);
  EXPECT_EQ(o.printing.partMm, d.printing.partMm);
  EXPECT_EQ(o.printing.headMm, d.printing.headMm);
  EXPECT_EQ(o.travelling.bodiesMm, d.travelling.bodiesMm);
  EXPECT_EQ(o.travelling.partMm, d.travelling.partMm);
  EXPECT_EQ(o.travelling.headMm, d.travelling.headMm);
  EXPECT_EQ(o.liftMm, d.liftMm);
  EXPECT_EQ(o.hopLiftMm, d.hopLiftMm);
  EXPECT_EQ(o.wipeMm, d.wipeMm);
  EXPECT_EQ(o.samples, d.samples);
  EXPECT_EQ(o.rotation, d.rotation);
  EXPECT_EQ(o.smoothing, d.smoothing);
  EXPECT_NEAR(o.leanRad, d.leanRad, 1e-12);
  EXPECT_EQ(o.leans(), 0.0) << "of whole paths only";
}

TEST(MotionOptions, TakeTheValuesOfTheParameters) {
  const MotionOptions o = optionsWith({"bodyClearanceMm=7", "partClearanceMm=3", "liftMm=0.6",
                                       "wipeMm=4", "redundancySamples=36", "tiltToleranceDeg=6"});
  EXPECT_EQ(o.printing.bodiesMm, 7.0);
  EXPECT_EQ(o.travelling.bodiesMm, 7.0);
  EXPECT_EQ(o.printing.partMm, 3.0);
  EXPECT_EQ(o.travelling.partMm, 3.0);
  EXPECT_EQ(o.liftMm, 0.6);
  EXPECT_EQ(o.hopLiftMm, 0.6) << "no higher than other lifts";
  EXPECT_EQ(optionsWith({"liftMm=9"}).hopLiftMm, MotionOptions().hopLiftMm);
  EXPECT_EQ(o.wipeMm, 4.0);
  EXPECT_EQ(o.samples, 36);
  EXPECT_NEAR(o.leanRad, base::degreesToRadians(6.0), 1e-12);
  const auto choices = motion::motionParameters().find("nozzleRotation")->choices;
  ASSERT_EQ(choices.size(), 4u);
  const NozzleRotation turns[] = {NozzleRotation::Free, NozzleRotation::Tangent,
                                  NozzleRotation::WorkAxis, NozzleRotation::Rodrigues};
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_EQ(optionsWith({("nozzleRotation=" + choices[k].id).c_str()}).rotation, turns[k]);
  const auto ways = motion::motionParameters().find("rotationSmoothing")->choices;
  ASSERT_EQ(ways.size(), 2u);
  EXPECT_EQ(optionsWith({("rotationSmoothing=" + ways[0].id).c_str()}).smoothing,
            SmoothingMethod::Evened);
  const MotionOptions whole =
      optionsWith({("rotationSmoothing=" + ways[1].id).c_str(), "tiltToleranceDeg=2"});
  EXPECT_EQ(whole.smoothing, SmoothingMethod::WholePath);
  EXPECT_NEAR(whole.leans(), base::degreesToRadians(2.0), 1e-12);
}

TEST(MotionOptions, ListTheLayersBeforeWhichTheArmPauses) {
  EXPECT_TRUE(optionsWith({}).layerEvents.empty());
  EXPECT_EQ(motion::pauseLayersOf(" 40, 3,3 ,12,"), (std::vector{3, 12, 40}));
  const auto events = optionsWith({"pauseLayers=40,3", "layerEvents=z2 wait 5"}).layerEvents;
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[0].layer, 3);
  EXPECT_EQ(events[1].layer, 40);
  EXPECT_EQ(events[2].heightMm, 2.0);
  EXPECT_EQ(motion::pauseLayersText({3, 12, 40}), "3, 12, 40");
  EXPECT_EQ(motion::pauseLayersText({}), "");
  for (const char* wrong : {"pauseLayers=0", "pauseLayers=-2", "pauseLayers=3;4", "pauseLayers=2.5",
                            "pauseLayers=layer 3", "layerEvents=3 jump"})
    EXPECT_THROW(optionsWith({wrong}), base::Error) << wrong;
}
