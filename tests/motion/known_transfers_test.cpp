#include "motion/transfers/known_transfers.h"

#include <gtest/gtest.h>

namespace voluta::motion {
namespace {

using Purpose = KnownTransfers::Purpose;

RobotState stateWith(double first) {
  RobotState state;
  state.q = robot::JointVector::Zero(6);
  state.q[0] = first;
  return state;
}

TEST(KnownTransfers, AreLookedForOnce) {
  KnownTransfers known;
  int looked = 0;
  const auto found = [&] {
    ++looked;
    Transfer transfer;
    transfer.kind = TransferKind::Tree;
    return std::optional(transfer);
  };
  const RobotState a = stateWith(0.1), b = stateWith(0.2);
  const PrintedBounds ball{Eigen::Vector3d(1, 2, 3), 4.0};
  for (int i = 0; i < 3; ++i) {
    const auto transfer = known.of(Purpose::Between, a, b, 1, 2, ball, found);
    ASSERT_TRUE(transfer);
    EXPECT_EQ(transfer->kind, TransferKind::Tree);
  }
  EXPECT_EQ(looked, 1);
}

TEST(KnownTransfers, ThatAreNotThereAreNotLookedForAgain) {
  KnownTransfers known;
  int looked = 0;
  const auto none = [&] {
    ++looked;
    return std::optional<Transfer>();
  };
  for (int i = 0; i < 3; ++i)
    EXPECT_FALSE(known.of(Purpose::Leave, stateWith(0), stateWith(1), 1, 2, {}, none));
  EXPECT_EQ(looked, 1);
}

TEST(KnownTransfers, DifferByAllThatTheyDependOn) {
  KnownTransfers known;
  int looked = 0;
  const auto look = [&] {
    ++looked;
    return std::optional<Transfer>();
  };
  const RobotState a = stateWith(0.1), b = stateWith(0.2);
  RobotState moved = a;
  moved.tip.x() += 1e-12;
  known.of(Purpose::Between, a, b, 1, 2, {}, look);
  known.of(Purpose::Approach, a, b, 1, 2, {}, look);
  known.of(Purpose::Between, b, a, 1, 2, {}, look);
  known.of(Purpose::Between, moved, b, 1, 2, {}, look);
  known.of(Purpose::Between, a, b, 3, 2, {}, look);
  known.of(Purpose::Between, a, b, 1, 3, {}, look);
  known.of(Purpose::Between, a, b, 1, 2, {Eigen::Vector3d::Zero(), 1.0}, look);
  EXPECT_EQ(looked, 7);
}

} // namespace
} // namespace voluta::motion
