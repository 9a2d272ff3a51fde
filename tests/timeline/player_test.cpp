#include "timeline/player.h"

#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

namespace voluta::timeline {
namespace {

TEST(Player, MovesWithTheWallClockTimesItsSpeed) {
  Player player;
  player.setEnd(100.0);
  player.advance(5.0);
  EXPECT_EQ(player.position(), 0.0) << "not playing";
  player.play();
  player.advance(2.0);
  EXPECT_DOUBLE_EQ(player.position(), 2.0);
  player.setSpeed(10.0);
  player.advance(2.0);
  EXPECT_DOUBLE_EQ(player.position(), 22.0);
  player.setUnitsPerSecond(3.0);
  player.advance(1.0);
  EXPECT_DOUBLE_EQ(player.position(), 52.0);
}

TEST(Player, StopsAtTheEndAndStartsOverFromThere) {
  Player player;
  QSignalSpy playing(&player, &Player::playingChanged);
  player.setEnd(10.0);
  player.play();
  player.advance(50.0);
  EXPECT_EQ(player.position(), 10.0);
  EXPECT_FALSE(player.playing());
  player.play();
  EXPECT_EQ(player.position(), 0.0);
  ASSERT_EQ(playing.size(), 3);
  EXPECT_TRUE(playing[0][0].toBool());
  EXPECT_FALSE(playing[1][0].toBool());
}

TEST(Player, EmptyPlayerDoesNotPlay) {
  Player player;
  player.play();
  EXPECT_FALSE(player.playing());
}

TEST(Player, AShorterEndTakesThePositionWithIt) {
  Player player;
  player.setEnd(10.0);
  player.setPosition(8.0);
  player.setEnd(5.0);
  EXPECT_EQ(player.position(), 5.0);
}

// The position follows the wall clock even if the window is busy between two steps.
TEST(Player, StepsAtMostThirtyTimesASecondAndFollowsTheClock) {
  Player player;
  player.setEnd(1e9);
  player.setSpeed(100.0);
  const auto* timer = player.findChild<QTimer*>();
  ASSERT_TRUE(timer);
  EXPECT_GE(timer->interval(), 1000 / 30 - 1);
  QSignalSpy moved(&player, &Player::positionChanged);
  player.play();
  QTest::qSleep(200); // at least
  ASSERT_TRUE(moved.wait(60000));
  EXPECT_EQ(moved.size(), 1) << "one step makes up for all that was missed";
  EXPECT_GE(player.position(), 100.0 * 0.2);
  player.pause();
  const double held = player.position();
  EXPECT_FALSE(moved.wait(100));
  EXPECT_EQ(player.position(), held) << "paused";
}

} // namespace
} // namespace voluta::timeline
