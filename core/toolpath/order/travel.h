// Short travel: the order of stops within their turns, and the point at which each begins.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace voluta::toolpath {

// A bead, as travel moves see it.
struct Stop {
  // Closed: the points at which it may begin; it ends where it begins. Open: its two ends; it
  // begins at one of them and ends at the other.
  std::vector<Eigen::Vector3d> ends;
  bool closed = false;
};
struct Visit {
  std::size_t stop = 0;
  std::size_t begin = 0; // index in Stop::ends
  bool operator==(const Visit&) const = default;
};
// Indices of the stops that may change places with each other.
using StopGroup = std::vector<std::size_t>;

// Returns the length of the moves from stop to stop [mm]; with that from `from`, if given.
double travelMm(std::span<const Stop> stops, std::span<const Visit> visits,
                const std::optional<Eigen::Vector3d>& from = {});

// Returns the visits that always go on with the nearest stop of the turn, and begin it at its point
// nearest to the end of the last. The first is the nearest to `from`. All of a turn is visited
// before the next turn.
std::vector<Visit> visitNearestFirst(std::span<const Stop> stops, std::span<const StopGroup> groups,
                                     const Eigen::Vector3d& from);

// Begins each stop where the travel of all is least. The order stays; travel never grows. The
// orientation of open stops is exact as long as closed ones begin near the ends of open ones.
void chooseBegins(std::span<const Stop> stops, std::span<Visit> visits,
                  const std::optional<Eigen::Vector3d>& from = {});

// Shortens the travel within every turn by 2-opt and Or-opt moves, with a limited number of passes.
// Precondition: as returned by visitNearestFirst() for the same turns.
void reorderWithinGroups(std::span<const Stop> stops, std::span<const StopGroup> groups,
                         std::span<Visit> visits, const std::optional<Eigen::Vector3d>& from = {});

// Returns visits in the order of the turns whose travel is at most that of visitNearestFirst(), by
// all of the above.
std::vector<Visit> visitShortly(std::span<const Stop> stops, std::span<const StopGroup> groups,
                                const Eigen::Vector3d& from);

} // namespace voluta::toolpath
