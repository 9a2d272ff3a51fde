// Speeds in lines of their own: each is compared with the plan, of beads, wipes, lifts and ways
// above the part alike.
#include "helpers/all_seeds.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <regex>

namespace voluta::replay {
namespace {

class SpeedWords : public ::testing::Test {
protected:
  void SetUp() override {
    plan::Trajectory& t = scene_.trajectory;
    t = test::walk(scene_.plan, scene_.cell, scene_.process, 3.0, kWipeMm);
    // Before the fourth bead the nozzle is purged aside.
    std::size_t point = 1;
    for (int beads = 0; beads < 4; ++point)
      beads += t.move[point] != plan::MoveKind::Print && t.move[point + 1] == plan::MoveKind::Print;
    point -= 1;
    test::moveSideways(t, scene_.cell, point - 1);
    t.events = {
        {.point = point, .kind = plan::EventKind::Purge, .seconds = 2.0, .volumeMm3 = 20.0}};
  }
  Verification verify(const test::ProgramText& text) const {
    return replayProgram({test::read(text, scene_.process), scene_.plan, scene_.trajectory,
                          scene_.cell, process::Tooling(scene_.process), scene_.part,
                          scene_.platform},
                         ReplayThresholds{}, {});
  }

  static constexpr double kWipeMm = 3.0;
  test::Scene scene_ = test::boxScene(1);
};

TEST_F(SpeedWords, AreComparedWithThePlan) {
  const std::size_t every = test::ofSeeds(5u, 1u);
  for (const auto& [format, word] :
       {std::pair("krl", R"(^\$VEL\.CP=)"), std::pair("spel", "^  SpeedS "),
        std::pair("melfa", "^[0-9]+ Spd ")}) {
    SCOPED_TRACE(format);
    const test::ProgramText whole =
        test::textOf(program::writeProgram(format, {scene_.plan, scene_.trajectory, scene_.cell,
                                                    process::Tooling(scene_.process), "box"}));
    const plan::ReadProgram read = test::read(whole, scene_.process);
    EXPECT_TRUE(verify(whole).passed) << findingsText(verify(whole));
    const std::regex expression(word);
    std::size_t words = 0, wipes = 0;
    for (std::size_t l = read.motions.front().line; l <= whole.lines.size(); ++l) {
      std::smatch begin;
      if (!std::regex_search(whole.lines[l - 1], begin, expression))
        continue;
      const auto motion =
          std::ranges::find_if(read.motions, [&](const auto& m) { return m.line > l; });
      const auto isWipe = [&] {
        const auto m = static_cast<std::size_t>(motion - read.motions.begin());
        return scene_.trajectory.move.at(m) == plan::MoveKind::Wipe;
      };
      const bool isOfWipe = read.motions.size() == scene_.trajectory.pointCount() && isWipe();
      if (words++ % every != 0 && !(isOfWipe && wipes < 2))
        continue;
      wipes += isOfWipe ? 1 : 0;
      const auto number = test::numbersIn(whole.lines[l - 1]).back();
      const double value = std::stod(whole.lines[l - 1].substr(number.first));
      for (const double times : {1.3, 0.7}) {
        test::ProgramText text = whole;
        text.lines[l - 1] = test::withNumber(whole.lines[l - 1], number, times * value);
        SCOPED_TRACE(whole.lines[l - 1] + " -> " + text.lines[l - 1] + (isOfWipe ? ", wipe" : ""));
        const Verification v = verify(text);
        EXPECT_FALSE(v.passed);
        EXPECT_TRUE(std::ranges::any_of(v.places, [&](const TextPlace& place) {
          return place.line >= l && place.line <= motion->line;
        })) << findingsText(v);
      }
      // One motion later the first one would go at the speed before it.
      test::ProgramText late = whole;
      const auto at = late.lines.begin() + static_cast<std::ptrdiff_t>(l) - 1;
      std::rotate(at, at + 1, late.lines.begin() + static_cast<std::ptrdiff_t>(motion->line));
      if (isOfWipe) {
        EXPECT_FALSE(verify(late).passed) << whole.lines[l - 1] << " one motion later";
      }
    }
    EXPECT_GT(words, 10u);
    EXPECT_GT(wipes, 0u);
  }
}

} // namespace
} // namespace voluta::replay
