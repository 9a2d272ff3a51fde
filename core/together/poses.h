// Poses of a machine along its motion, in the shared frame.
#pragma once

#include "together/placed_motion.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <vector>

namespace voluta::collision {
struct Ball;
}
namespace voluta::robot {
struct Body;
}

namespace voluta::together {

using Frames = std::vector<Eigen::Isometry3d>;

// Returns the cell's frames (Cell::framePoses) at a point of the trajectory.
Frames framesAt(const PlacedMotion& machine, std::size_t point);

// Calls visit(shared_T_frame) at points [first, last] and between them, so that no point of a body
// moves by more than stepMm from one pose to the next. Between points the joints turn in
// proportion.
void visitPoses(const PlacedMotion& machine, std::size_t first, std::size_t last, double stepMm,
                const std::function<void(const Frames& shared_T_frame)>& visit);

// Returns an upper bound of the way of the points of a ball between two poses of its frame [mm].
double displacementOf(const collision::Ball& ball, const Eigen::Isometry3d& from,
                      const Eigen::Isometry3d& to);

// Returns whether the motion moves the body in the shared frame.
bool isMoved(const robot::Cell& cell, const robot::Body& body);
// Returns whether the motion moves the printed part.
bool isPartMoved(const robot::Cell& cell);

} // namespace voluta::together
