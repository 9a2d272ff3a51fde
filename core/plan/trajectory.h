// The robot's motion over time: one block of dof x N joint values (external axes included).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace voluta::plan {

inline constexpr std::size_t kNoWaypoint = std::numeric_limits<std::size_t>::max();

// How a point is reached from the previous one.
enum class MoveKind : std::uint8_t {
  Print,  // Straight in the work frame, extruding
  Linear, // Straight in the work frame, not extruding (approach, lift, straight transfer)
  Joint,  // Linear in joint space, not extruding (transfer; also the first point, from rest)
  Wipe    // As Linear, but along a bead just printed, before the nozzle lifts
};

enum class EventKind : std::uint8_t {
  ToolChange, // `tool` deposits from here on
  Cut,        // the tape is cut
  Pause,      // until the operator continues
  Feed,       // `feedMm` of filament or tape is fed in place
  Wait,       // `seconds` pass
  StartLag,   // the extruder runs for `seconds` until its material comes
  StopLag,    // the extruder is switched off; the material that follows ends the bead
  Purge,      // `volumeMm3` of material flows out in `seconds`
  Release,    // the tool changer releases the tool, which takes `seconds`
  Lock,       // the tool changer locks the tool, which takes `seconds`
  Shot,       // `volumeMm3` of material fills a pocket of the part in `seconds`
  Mark,       // waits until another machine is at the mark with the same number (plan/marks.h)
  Output,     // the machine's digital output `tool` is set to `on`
  Statement   // a line `text` of the user's own, in programs of `format`
};
inline constexpr EventKind kLastEventKind = EventKind::Statement;
// Returns whether the arm is at rest meanwhile.
inline bool stopsArm(EventKind kind) {
  return kind != EventKind::StopLag;
}

// Happens in place, after the arm has arrived at the point before and before it moves to `point`.
struct TrajectoryEvent {
  std::size_t point = 1; // 1 .. pointCount() - 1; of a Mark also pointCount(): at the end
  EventKind kind = EventKind::Pause;
  int tool = 0; // ToolChange: index in the job's tooling; Mark: link (plan/marks.h); Output: number
  double feedMm = 0.0;    // Feed
  double seconds = 0.0;   // Wait, StartLag, Purge, Release, Lock, Shot
  double volumeMm3 = 0.0; // Purge, Shot
  bool on = false;        // Output
  // Pause: shown to the operator; empty: the usual text, or that of the tool change behind it
  std::string text = {};
  std::string format = {}; // Statement: id of the dialect
};

struct Trajectory {
  int dof = 0;
  std::vector<double> joints;          // Dof values per point [rad] (sliding axes: [mm])
  std::vector<double> timeS;           // Per point, from 0, non-decreasing; of the motions alone
  std::vector<MoveKind> move;          // Per point
  std::vector<std::size_t> waypoint;   // Per point: its ToolPlan waypoint, or kNoWaypoint
  std::vector<double> extrudedMm3;     // Per point: total material deposited when it is reached
  std::vector<TrajectoryEvent> events; // Ascending by point; several at a point in their order
  int firstTool = 0;                   // That deposits from the beginning on

  std::size_t pointCount() const { return timeS.size(); }
  // Returns the events before the motion to that point.
  std::span<const TrajectoryEvent> eventsBefore(std::size_t point) const;
  // Returns the tool change for which a pause of the trajectory stops the arm: the next event, in
  // the same place; nullptr if it is no change, or if the pause has a text of its own.
  // Precondition: the event is one of `events`.
  const TrajectoryEvent* changeAfter(const TrajectoryEvent& pause) const;
  // Returns whether the arm stops before the motion to that point for an event.
  bool stopsBefore(std::size_t point) const;
  // Returns the duration of the waits and purges before the motion to that point [s].
  double waitBefore(std::size_t point) const;
  // Returns the volume that flows out in place before the motion to that point [mm3].
  double purgeBefore(std::size_t point) const;
  // Returns whether material fills a pocket before the motion to that point.
  bool shotBefore(std::size_t point) const;
  // Returns the tool that is selected while the arm is at the point, after the events before it.
  int toolAt(std::size_t point) const;
  // Returns whether another tool deposits from a later point than `after` on.
  bool changesTool(std::size_t after = 0) const;
  const double* at(std::size_t point) const {
    return joints.data() + point * static_cast<std::size_t>(dof);
  }
};

} // namespace voluta::plan
