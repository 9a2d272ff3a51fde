// Ways between runs that keep clear of everything, the part printed so far included.
#pragma once

#include "motion/motion_scene.h"
#include "motion/run.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::motion {

struct TransferPoint {
  RobotState at;
  plan::MoveKind move = plan::MoveKind::Linear; // how it is reached from the point before
  // Straight: how far each joint would go there if it went as fast all the way as where it goes
  // fastest. Empty: evenly.
  robot::JointVector most = {};
};

// Which kind of way was found, simplest first.
enum class TransferKind : std::uint8_t { Straight, Arc, Joint, Tree };
struct Transfer {
  std::vector<TransferPoint> points; // after `from`, the last one is `to`
  TransferKind kind = TransferKind::Straight;
};

// How far a transfer lifts the nozzle.
enum class Lift {
  Hop,   // options.hopLiftMm, then as Usual
  Usual, // options.liftMm and its multiples
  High   // kHighLiftMm where that can be, else as Usual
};
// As high as the nozzle should stand where a program may be cut into files.
inline constexpr double kHighLiftMm = 10.0;

// A ball that holds what is printed before a waypoint, for ways around it.
struct PrintedBounds {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

class TransferPlanner {
public:
  // `effort`: how many times options.treeIterations a search may take.
  explicit TransferPlanner(const MotionScene& scene, int effort = 1)
      : scene_(scene), effort_(effort) {}

  // From state to state with everything printed before waypoint `before` in place. Tried in
  // turn: lift along the nozzle, straight, down (lifts as `lift` says); out of the
  // surrounding ball and round it on an arc; the same lifts with a joint move between; RRT-Connect
  // between the lifted stations. Lifting along the nozzle frees a head that is free, since it is
  // convex along its axis. Where a rod turns or other external axes move, lifts with a joint move
  // between come first: the arm hardly moves, the part does. Checked at steps of at most 2 mm and 1
  // degree (linear), half a degree a joint with 3 mm more clearance or a fifth of a degree (joint
  // moves; external axes' by what the part moves). None: no way was found.
  std::optional<Transfer> plan(const RobotState& from, const RobotState& to, Lift lift,
                               std::size_t before, const PrintedBounds& surround,
                               std::uint64_t seed, const base::RunContext& ctx) const;

  // Along the run's own bead with the extruder off, for `lengthMm` at most: on where it closes and
  // the tool stands as it did there, else back. As far as that is free with everything printed
  // before waypoint `before` in place; checked as a straight way is.
  std::vector<TransferPoint> wipe(const Run& run, double lengthMm, std::size_t before) const;

  // The same from or to a state that is not at the part (home): joint moves only.
  std::optional<Transfer> approach(const RobotState& home, const RobotState& start,
                                   std::size_t before, const PrintedBounds& surround,
                                   std::uint64_t seed, const base::RunContext& ctx) const;
  std::optional<Transfer> leave(const RobotState& end, const RobotState& home, std::size_t before,
                                const PrintedBounds& surround, std::uint64_t seed,
                                const base::RunContext& ctx) const;

private:
  using Points = std::vector<TransferPoint>;
  bool free(const robot::JointVector& q, std::size_t before,
            const collision::Margins& margins) const;
  // Straight in the work frame from `from`; appends to points.
  bool linear(const RobotState& from, const Eigen::Vector3d& tip, const Eigen::Quaterniond& tool,
              std::size_t before, const collision::Margins& margins, Points& points) const;
  bool jointSegmentFree(const robot::JointVector& a, const robot::JointVector& b,
                        std::size_t before, const collision::Margins& margins,
                        double checkRad) const;
  bool arc(const RobotState& from, const RobotState& to, const PrintedBounds& surround,
           std::size_t before, Points& points) const;
  // Joint move or tree between two lifted stations.
  std::optional<TransferKind> swing(const RobotState& from, const RobotState& to,
                                    std::size_t before, std::uint64_t seed,
                                    const base::RunContext& ctx, Points& points) const;
  void appendJointWay(const std::vector<robot::JointVector>& way, const RobotState& to,
                      Points& points) const;
  // Lifts along the nozzle, further and further; stations reached, each with the points there.
  std::vector<Points> lifts(const RobotState& from, const std::vector<double>& heights,
                            std::size_t before) const;

  const MotionScene& scene_;
  int effort_;
};

} // namespace voluta::motion
