#include "collision/bead_solid.h"

#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Vector3d;

// Beads of all widths and heights, turned by anything from nothing to a right angle and more.
TEST(BeadSolid, ItsBoxHoldsIt) {
  std::mt19937 engine(17);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  const auto anywhere = [&](double reach) -> Vector3d {
    return {number(-reach, reach), number(-reach, reach), number(-reach, reach)};
  };
  std::size_t inside = 0, tight = 0, beads = 0;
  for (int n = 0; n < 400; ++n) {
    const double angle = n % 4 == 0 ? 0.0 : n % 4 == 1 ? 0.1 : n % 4 == 2 ? 0.8 : 3.0;
    plan::ToolPlan plan;
    Vector3d direction = anywhere(1.0).normalized();
    for (int i = 0; i < 2; ++i) {
      plan.position.push_back(anywhere(1.0));
      plan.direction.push_back(direction);
      plan.widthMm.push_back(static_cast<float>(number(0.6, 2.0)));
      plan.heightMm.push_back(static_cast<float>(number(0.3, 1.0)));
      direction = (direction + anywhere(angle)).normalized();
    }
    const collision::BeadSolid bead(plan, 0);
    const Vector3d low = bead.low(), high = bead.high();
    Eigen::AlignedBox3d reached;
    for (int k = 0; k < 4000; ++k) {
      const Vector3d p = anywhere(3.0);
      if (!bead.contains(p))
        continue;
      ++inside;
      reached.extend(p);
      EXPECT_TRUE((p.array() >= low.array() - 1e-9).all() &&
                  (p.array() <= high.array() + 1e-9).all());
    }
    if (reached.isEmpty())
      continue;
    ++beads;
    tight += (reached.sizes().array() > 0.5 * (high - low).array()).all();
  }
  EXPECT_GT(inside, 5000u);
  EXPECT_GT(tight, beads / 2);
}
