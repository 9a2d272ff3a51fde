// Transfers between runs that avoid collisions, also with the part printed so far.
#pragma once

#include "motion/bead_run.h"
#include "motion/motion_scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::collision {
struct Margins;
}

namespace voluta::motion {

struct TransferPoint {
  RobotState at;
  plan::MoveKind move = plan::MoveKind::Linear; // move from the preceding point
  // For straight moves: displacement of each joint if it moved at its peak speed throughout. Empty:
  // constant speed.
  robot::JointVector peakDisplacement = {};
};

// Kind of the transfer found, simplest first.
enum class TransferKind : std::uint8_t { Straight, Arc, Joint, Tree };
// A part of a tool change, or an event of a layer, before the motion to a point of a transfer.
struct ToolStep {
  enum class Kind {
    Release, // the mounted tool
    Take,    // the tool of the next run
    Purge,   // its nozzle
    Prime,   // the nozzle of the tool, at the beginning or after a pause
    Event    // of a layer (motion/layer_events.h)
  };
  std::size_t point = 0;
  Kind kind = Kind::Take;
  std::size_t event = 0; // Event: its index in EventPlaces
};

struct Transfer {
  std::vector<TransferPoint> points; // without `from`; the last one is `to`
  TransferKind kind = TransferKind::Straight;
  std::vector<ToolStep> toolSteps = {}; // ascending by point
};

// How far a transfer lifts the nozzle.
enum class Lift {
  Hop,   // options.hopLiftMm, then as Usual
  Usual, // options.liftMm and its multiples
  High   // kHighLiftMm if possible, else as Usual
};
// Height of the nozzle at points where a program may be split into files.
inline constexpr double kHighLiftMm = 10.0;

// A ball that contains the material printed before a waypoint, for paths around it.
struct PrintedBounds {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

class TransferPlanner {
public:
  // `effort`: factor for options.treeIterations in searches.
  explicit TransferPlanner(const MotionScene& scene, int effort = 1)
      : scene_(scene), effort_(effort) {}

  // Plans a transfer with everything printed before waypoint `before` in place. Tries in turn: lift
  // along the nozzle, straight move, lower (heights as given by `lift`); out of the surrounding
  // ball and around it on an arc; the same lifts with a joint move in between; RRT-Connect between
  // the lifted stations. Lifting along the nozzle frees a head that is not in collision, since the
  // head is convex along its axis. If a rod turns or other external axes move, lifts with a joint
  // move in between come first: the part moves while the arm hardly does. Checks are at most 2 mm
  // and 1 degree apart (linear moves), half a degree per joint with 3 mm more clearance or a fifth
  // of a degree (joint moves; external axes by the motion of the part). Returns nullopt if no
  // transfer was found.
  std::optional<Transfer> plan(const RobotState& from, const RobotState& to, Lift lift,
                               std::size_t before, const PrintedBounds& surround,
                               std::uint64_t seed, const base::RunContext& ctx) const;

  // Moves along the run's own bead with the extruder off, for at most `lengthMm`: forward where the
  // bead is closed and the tool has the same orientation there, else backward, as far as that is
  // free of collisions with everything printed before waypoint `before`; checked like a straight
  // move.
  std::vector<TransferPoint> wipe(const Run& run, double lengthMm, std::size_t before) const;

  // Same from or to a state away from the part (home): joint moves only.
  std::optional<Transfer> approach(const RobotState& home, const RobotState& start,
                                   std::size_t before, const PrintedBounds& surround,
                                   std::uint64_t seed, const base::RunContext& ctx) const;
  std::optional<Transfer> leave(const RobotState& end, const RobotState& home, std::size_t before,
                                const PrintedBounds& surround, std::uint64_t seed,
                                const base::RunContext& ctx) const;

  // Between two states away from the part: joint moves only. `before` and the seed as in plan().
  std::optional<Transfer> between(const RobotState& from, const RobotState& to, std::size_t before,
                                  std::uint64_t seed, const base::RunContext& ctx) const;
  // The same along a straight line in joint space, there and back for docks of tools.
  std::optional<Transfer> straight(const RobotState& from, const RobotState& to,
                                   std::size_t before) const;

private:
  using Points = std::vector<TransferPoint>;
  bool free(const robot::JointVector& q, std::size_t before,
            const collision::Margins& margins) const;
  // Moves straight in the work frame from `from`; appends to points.
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
  void appendJointPath(const std::vector<robot::JointVector>& path, const RobotState& to,
                       Points& points) const;
  // Lifts along the nozzle to increasing heights; returns the stations reached, each with the
  // points on the way.
  std::vector<Points> lifts(const RobotState& from, const std::vector<double>& heights,
                            std::size_t before) const;

  const MotionScene& scene_;
  int effort_;
};

} // namespace voluta::motion
