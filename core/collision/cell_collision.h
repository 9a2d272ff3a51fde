// Collision checks between the bodies of a cell, and with the part printed so far.
#pragma once

#include "base/text.h"
#include "collision/margins.h"
#include "robot/body.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace voluta::process {
struct Process;
}
namespace voluta::robot {
class Cell;
}

namespace voluta::collision {

struct Ball;
class GrowingPart;
class Revolved;

// Colliding pair: indices into Cell::bodies(); kPrintedPart for the part itself.
inline constexpr int kPrintedPart = -1;
struct Contact {
  int first = 0, second = kPrintedPart;
};

// Holds data of a cell that every query needs: shapes placed in their bodies' frames, bounding
// spheres, the head reduced by the process's contact tolerance. All queries are const and may run
// in parallel.
class CellCollision {
public:
  // `cell` must outlive the object.
  CellCollision(const robot::Cell& cell, const process::Process& process);
  ~CellCollision();
  CellCollision(const CellCollision&) = delete;
  CellCollision& operator=(const CellCollision&) = delete;

  const robot::Cell& cell() const { return cell_; }

  // Poses of the cell's frames, as Cell::framePoses, for the queries below.
  using Frames = std::vector<Eigen::Isometry3d>;

  // Returns the first of cell.checkedPairs() that is closer than its margin. Frusta and prisms are
  // tested against each other by FCL as circumscribed polyhedra (at most 0.25 % too large); all
  // other pairs are exact.
  std::optional<Contact> bodies(const Frames& base_T_frame, const Margins& margins) const;

  // Returns the first of cell.bodiesAgainstPart(), except the head, that is closer than
  // margins.partMm to a cell filled before waypoint `before`.
  std::optional<Contact> bodiesAndPart(const Frames& base_T_frame, const GrowingPart& part,
                                       std::size_t before, const Margins& margins) const;

  // Tests the eroded head, grown by marginMm minus half a cell of the part's grid (the grid's
  // resolution), against the part. The head is round, so the result depends on tip and axis only,
  // not on the joints. `before` and `printing` as in GrowingPart::headTouches.
  bool headTouchesPart(const Eigen::Isometry3d& work_T_tool, const GrowingPart& part,
                       std::size_t before, double marginMm,
                       std::optional<std::size_t> printing = std::nullopt) const;
  // Tests the eroded head against the plate and its carrier.
  bool headTouchesPlatform(const Eigen::Isometry3d& work_T_tool, double marginMm) const;
  // Tests the bodies that hold the head and are fixed in the tool frame against the plate, its
  // carrier and the part. If the holder is round, this too depends on tip and axis only.
  bool holderTouches(const Eigen::Isometry3d& work_T_tool, const GrowingPart& part,
                     std::size_t before, const Margins& margins) const;

  // All of the above.
  std::optional<Contact> any(const Frames& base_T_frame, const GrowingPart& part,
                             std::size_t before, const Margins& margins) const;

  // Returns the minimum distance between bodies of a checked pair, and of bodies to the part,
  // without the head's to plate and part (where contact is intended); at most capMm. mm. `nearest`:
  // the pair to test first; set to the nearest pair if one is below the cap. Passing it on speeds
  // up queries at similar poses.
  double clearance(const Frames& base_T_frame, double capMm, std::size_t* nearest = nullptr) const;
  double clearanceToPart(const Frames& base_T_frame, const GrowingPart& part, std::size_t before,
                         double capMm) const;

  // The same pairs individually, of bodies and of a body and the part. distanceOf returns the
  // pair's distance, or a lower bound of it that is at least capMm.
  std::vector<Contact> clearancePairs() const;
  double distanceOf(const Contact& pair, const Frames& base_T_frame, const GrowingPart& part,
                    std::size_t before, double capMm) const;
  // Returns the distance of a body to one of another cell, placed in a common frame, or a lower
  // bound of it above capMm. A head is eroded (process::erodedHead). mm.
  double distanceToOther(int body, const Eigen::Isometry3d& common_T_body,
                         const CellCollision& other, int otherBody,
                         const Eigen::Isometry3d& common_T_other, double capMm) const;
  // Returns the eroded head, in the tool frame.
  std::vector<robot::Shape> erodedHead() const;
  // Returns a sphere that contains the body, in its frame.
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
  // Returns the distance, or a lower bound of it above `enough`.
  static double distance(const PosedSolid& a, const PosedSolid& b, double enough);
  static double distance(std::span<const PosedSolid> a, std::span<const PosedSolid> b,
                         double enough);
  // The same of two bodies that are placed in a common frame.
  static double distanceBetween(const Assembly& first, const Eigen::Isometry3d& common_T_first,
                                const Assembly& second, const Eigen::Isometry3d& common_T_second,
                                double capMm);
  // Returns whether it is closer than marginMm to the plate or its carrier.
  bool touchesPlatform(const Assembly& assembly, const Eigen::Isometry3d& work_T_assembly,
                       double marginMm) const;
  template <typename Visit>
  void forBodiesAgainstPart(const Frames& base_T_frame, Visit&& visit) const;
  bool isHeadAndPlatform(int a, int b) const;

  const robot::Cell& cell_;
  std::vector<Assembly> assemblies_; // in the order of cell.bodies()
  std::unique_ptr<Assembly> erodedHead_;
  std::unique_ptr<Revolved> revolvedHead_; // the same
  const Eigen::Isometry3d work_T_platform_ = Eigen::Isometry3d::Identity();
  std::vector<PosedSolid> platformSolids_;     // of the plate and its carrier
  std::vector<int> holders_;                   // of cell.bodies()
  std::size_t solidCount_ = 0;                 // of all bodies
  std::vector<std::pair<int, int>> freePairs_; // checked pairs without head and plate
  double platformTopMm_;                       // in the work frame
};

} // namespace voluta::collision
