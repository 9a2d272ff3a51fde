#include "plan/trajectory_jerk.h"

#include <cmath>

namespace voluta::plan {

namespace {

// Velocity, or acceleration, of a joint at a time.
struct Rate {
  double value, atS;
};

Rate between(const Rate& from, const Rate& to) {
  const double seconds = to.atS - from.atS;
  return {seconds > 0.0 ? (to.value - from.value) / seconds : 0.0, 0.5 * (from.atS + to.atS)};
}

// Sets the jerks of a joint at the points first .. last, at rest at both.
void setJerk(const Trajectory& t, int joint, std::size_t first, std::size_t last,
             std::vector<float>& jerks) {
  Rate velocity{0.0, t.timeS[first]}, acceleration{0.0, t.timeS[first]};
  for (std::size_t i = first + 1; i <= last + 1; ++i) {
    Rate next{0.0, t.timeS[last]};
    if (i <= last) {
      if (!(t.timeS[i] > t.timeS[i - 1]))
        continue;
      next = between({t.at(i - 1)[joint], t.timeS[i - 1]}, {t.at(i)[joint], t.timeS[i]});
    }
    const Rate gained = between(velocity, next), jerk = between(acceleration, gained);
    // At a point of the piece, the greater one where two meet.
    if (float& at = jerks[i - 1]; std::abs(jerk.value) > std::abs(at))
      at = static_cast<float>(jerk.value);
    velocity = next;
    acceleration = gained;
  }
}

} // namespace

std::vector<std::vector<float>> jerkAlong(const Trajectory& t) {
  const std::size_t count = t.pointCount();
  std::vector<std::vector<float>> jerks(static_cast<std::size_t>(t.dof),
                                        std::vector<float>(count, 0.0f));
  for (std::size_t first = 0; first + 1 < count;) {
    std::size_t last = first + 1;
    while (last + 1 < count && t.move[last + 1] == t.move[first + 1] && !t.stopsBefore(last + 1))
      ++last;
    for (int joint = 0; joint < t.dof; ++joint)
      setJerk(t, joint, first, last, jerks[static_cast<std::size_t>(joint)]);
    first = last;
  }
  return jerks;
}

} // namespace voluta::plan
