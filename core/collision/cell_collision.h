// Do the bodies of a cell meet each other, or the part printed so far?
#pragma once

#include "collision/growing_part.h"
#include "collision/shape_distance.h"
#include "process/process.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace voluta::collision {

// How far bodies have to keep from each other. mm.
struct Margins {
  double bodiesMm = 2.0; // body to body, but for the head and the plate
  double partMm = 2.0;   // body to printed part, but for the head
  double headMm = 0.0;   // eroded head (process::erodedHead) to plate and printed part
};

// What meets: indices into Cell::bodies(); kPrintedPart for the part itself.
inline constexpr int kPrintedPart = -1;
struct Contact {
  int first = 0, second = kPrintedPart;
};

// Keeps what every query needs of a cell: shapes placed in their bodies' frames, bounding balls,
// the head less the process's contact tolerance. All queries are const and may run in parallel.
class CellCollision {
public:
  // `cell` must outlive this.
  CellCollision(const robot::Cell& cell, const process::Process& process);
  ~CellCollision();
  CellCollision(const CellCollision&) = delete;
  CellCollision& operator=(const CellCollision&) = delete;

  const robot::Cell& cell() const { return cell_; }

  // Poses of the cell's frames, as Cell::framePoses, for the queries below.
  using Frames = std::vector<Eigen::Isometry3d>;

  // The first of cell.checkedPairs() that is closer than its margin. Frusta and prisms against
  // each other go through FCL as polyhedra around them (at most 0.25 % too large); all else is
  // exact.
  std::optional<Contact> bodies(const Frames& base_T_frame, const Margins& margins) const;

  // The first of cell.bodiesAgainstPart() but the head that comes closer than margins.partMm to
  // a cell filled before waypoint `before`.
  std::optional<Contact> bodiesAndPart(const Frames& base_T_frame, const GrowingPart& part,
                                       std::size_t before, const Margins& margins) const;

  // The eroded head, grown by marginMm less half a cell of the part's grid (nearer the grid cannot
  // tell), against the part. The head is round, so this depends on tip and axis alone, not on the
  // joints. `before` and `printing` as in GrowingPart::headTouches.
  bool headTouchesPart(const Eigen::Isometry3d& work_T_tool, const GrowingPart& part,
                       std::size_t before, double marginMm,
                       std::optional<std::size_t> printing = std::nullopt) const;
  // The eroded head against the plate and what carries it.
  bool headTouchesPlatform(const Eigen::Isometry3d& work_T_tool, double marginMm) const;
  // What holds the head, and stands fast in the tool frame, against the plate, what carries it and
  // the part. This too depends on tip and axis alone where the holder is round.
  bool holderTouches(const Eigen::Isometry3d& work_T_tool, const GrowingPart& part,
                     std::size_t before, const Margins& margins) const;

  // All of the above.
  std::optional<Contact> any(const Frames& base_T_frame, const GrowingPart& part,
                             std::size_t before, const Margins& margins) const;

  // Least distance between bodies of a checked pair, and of bodies to the part, the head's to
  // plate and part left out (it is meant to be there); never more than capMm. mm.
  // `nearest`: which pair is looked at first and, where one is below the cap, which is the nearest;
  // poses alike are told sooner so.
  double clearance(const Frames& base_T_frame, double capMm, std::size_t* nearest = nullptr) const;
  double clearanceToPart(const Frames& base_T_frame, const GrowingPart& part, std::size_t before,
                         double capMm) const;

  // Those pairs one by one, of bodies and of a body and the part. distanceOf returns the pair's
  // distance, or a lower bound of it that is no less than capMm.
  std::vector<Contact> clearancePairs() const;
  double distanceOf(const Contact& pair, const Frames& base_T_frame, const GrowingPart& part,
                    std::size_t before, double capMm) const;
  // A ball that holds the body, in its frame.
  Ball ballAbout(int body) const;

  // "forearm", "platform", "printed part", ...
  base::Value nameOf(int body) const;

private:
  struct Solid;
  struct Assembly; // a body's solids in its own frame
  struct PosedSolid;
  class PosedBodies;
  // The pose has to outlive them.
  static void placeSolids(const Assembly& assembly, const Eigen::Isometry3d& pose,
                          std::vector<PosedSolid>& to);
  // The distance, or a lower bound of it that is above `enough`.
  static double distance(const PosedSolid& a, const PosedSolid& b, double enough);
  static double distance(std::span<const PosedSolid> a, std::span<const PosedSolid> b,
                         double enough);
  // Does it come nearer than marginMm to the plate or what carries it?
  bool touchesPlatform(const Assembly& assembly, const Eigen::Isometry3d& work_T_assembly,
                       double marginMm) const;
  template <typename Visit>
  void forBodiesAgainstPart(const Frames& base_T_frame, Visit&& visit) const;
  bool isHeadAndPlatform(int a, int b) const;

  const robot::Cell& cell_;
  std::vector<Assembly> assemblies_; // as cell.bodies()
  std::unique_ptr<Assembly> erodedHead_;
  std::unique_ptr<Revolved> revolvedHead_; // the same
  const Eigen::Isometry3d work_T_platform_ = Eigen::Isometry3d::Identity();
  std::vector<PosedSolid> platformSolids_;     // of plate and what carries it
  std::vector<int> holders_;                   // of cell.bodies()
  std::size_t solidCount_ = 0;                 // of all bodies
  std::vector<std::pair<int, int>> freePairs_; // that are checked, but for head and plate
  double platformTopMm_;                       // in the work frame
};

} // namespace voluta::collision
