// Where what stands still in a cell should be: the fixed nozzle, or the plate of a nozzle that the
// arm carries. For each place tried, the share of printing poses that some branch and some turn
// about the nozzle reaches with all bodies clear, and the clearance they have. Poses: tip at points
// of a ball standing on the plate, tilted 0, 30, ... 120 deg to 8 sides (an arm that cannot tilt:
// upright only); the plate a disc of 40 mm;
// a ball of three quarters of that radius stands for the part, which links other than the one that
// carries it must not touch.
//   cell_search CELL [RADIUS] [ROW...]   CELL: a cell's id; RADIUS of the poses' ball, mm (65);
//                                        ROW = x,y,z,stem (mm), stem: length of the plate's on the
//                                        flange, else unused; none: a grid. Clear means >= 3 mm.
#include "sampled_distance.h"

#include "base/files.h"
#include "base/parallel.h"
#include "base/units.h"
#include "geometry/directions.h"
#include "process/process.h"
#include "robot/cell.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

using namespace voluta;
using base::kPi;
using nlohmann::json;

namespace {

constexpr double kClearMm = 3.0, kCapMm = 40.0, kSpacingMm = 18.0, kGantryZ = 1100.0,
                 kRestMm = 20.0;
constexpr int kTurns = 16, kTilts = 5;

struct Place {
  double x, y, z, stem;
};

robot::Cell cellAt(json cell, const Place& place, const std::filesystem::path& folder) {
  const bool plateMoves = cell["nozzle"]["mount"] == "world";
  json& stem = cell["platform"]["stem"];
  if (plateMoves) {
    cell["nozzle"]["pose"]["xyzMm"] = {place.x, place.y, place.z};
    for (json& shape : cell["nozzle"]["holder"])
      if (shape.contains("frustum"))
        shape["frustum"]["p1Mm"][2] = -(kGantryZ - place.z);
    cell["platform"]["pose"]["xyzMm"] = {0, 0, place.stem};
    stem[0]["frustum"]["p0Mm"][2] = -place.stem;
    stem[0]["frustum"]["p1Mm"][2] = -place.stem + 8;
    stem[1]["frustum"]["p0Mm"][2] = -place.stem + 8;
  } else {
    // The stem stands on the table, which stays where it is.
    json& foot = stem[0]["frustum"]["p0Mm"][2];
    json& plate = cell["platform"]["pose"]["xyzMm"];
    foot = foot.get<double>() + plate[2].get<double>() - place.z;
    plate = {place.x, place.y, place.z};
  }
  const auto file = folder / (cell["id"].get<std::string>() + ".json");
  std::ofstream(file) << cell.dump();
  std::vector<Eigen::Vector2d> disc;
  for (int i = 0; i < 16; ++i)
    disc.emplace_back(20 * std::cos(kPi * i / 8), 20 * std::sin(kPi * i / 8));
  return robot::Cell::read(file, process::loadProcess("fdm-1.0"), disc);
}

// Least distance over all pairs, not above kCapMm; -inf as soon as it is below kClearMm.
class Clearance {
public:
  Clearance(const robot::Cell& cell, double radius) : cell_(cell) {
    for (const robot::Body& body : cell.bodies())
      samples_.push_back(test::samplesOf(body, kSpacingMm));
    const double part = 0.77 * radius;
    part_.shapes = {robot::Capsule{{0, 0, part + 2}, {0, 0, part + 2}, part}};
    // Head and plate meet first: pairs of them in front spare the rest.
    pairs_ = cell.checkedPairs();
    std::stable_sort(pairs_.begin(), pairs_.end(), [&](const auto& a, const auto& b) {
      return (mounted(a.first) && mounted(a.second)) > (mounted(b.first) && mounted(b.second));
    });
  }

  double of(const robot::JointVector& q) {
    cell_.framePoses(q, frames_);
    double least = kCapMm;
    for (const auto& [a, b] : pairs_) {
      least = std::min(least, between(a, b));
      if (least < kClearMm)
        return -1.0;
    }
    for (int a : cell_.bodiesAgainstPart())
      if (body(a).role == robot::BodyRole::Link) {
        least = std::min(least, test::sampledDistance(samples(a), pose(a), part_,
                                                      frames_[index(cell_.workFrame())], kClearMm));
        if (least < kClearMm)
          return -1.0;
      }
    return least;
  }

private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const robot::Body& body(int i) const { return cell_.bodies()[index(i)]; }
  const std::vector<test::Sample>& samples(int i) const { return samples_[index(i)]; }
  const Eigen::Isometry3d& pose(int i) const { return frames_[index(body(i).frame)]; }
  bool mounted(int i) const { return body(i).role != robot::BodyRole::Link; }

  double between(int a, int b) {
    // Links are balls along a line: few samples, and exact against any solid. Obstacles are never
    // sampled, for they may be large.
    const bool sampleB =
        body(a).role == robot::BodyRole::Obstacle ||
        (body(b).role == robot::BodyRole::Link && body(a).role != robot::BodyRole::Link) ||
        body(b).role == robot::BodyRole::Platform;
    const int s = sampleB && body(b).role != robot::BodyRole::Obstacle &&
                          body(a).role != robot::BodyRole::Link
                      ? b
                      : a;
    const int o = s == a ? b : a;
    return test::sampledDistance(samples(s), pose(s), body(o), pose(o), kClearMm);
  }

  const robot::Cell& cell_;
  std::vector<std::vector<test::Sample>> samples_;
  std::vector<std::pair<int, int>> pairs_;
  robot::Body part_;
  std::vector<Eigen::Isometry3d> frames_;
};

std::vector<Eigen::Vector3d> partPoints(double radius) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 9; ++i) {
    const Eigen::Vector3d d = geometry::onSpiral(i, 1.0 - 2.0 * (i + 0.5) / 9);
    points.emplace_back(radius * (d + Eigen::Vector3d::UnitZ()));
    points.emplace_back(radius * (0.5 * d + Eigen::Vector3d::UnitZ()));
  }
  points.emplace_back(0, 0, 1);
  points.emplace_back(15, 0, 1);
  return points;
}

struct Score {
  std::array<int, kTilts> poses{}, reached{}, clear{};
  std::array<int, 8> clearByBranch{};
  double clearanceSum = 0.0;
  Score& operator+=(const Score& o) {
    for (std::size_t i = 0; i < kTilts; ++i) {
      poses[i] += o.poses[i];
      reached[i] += o.reached[i];
      clear[i] += o.clear[i];
    }
    for (std::size_t i = 0; i < 8; ++i)
      clearByBranch[i] += o.clearByBranch[i];
    clearanceSum += o.clearanceSum;
    return *this;
  }
};

Eigen::Isometry3d toolPose(const Eigen::Vector3d& tip, double tilt, double azimuth, double turn) {
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  t.translation() = tip;
  t.linear() = (Eigen::AngleAxisd(azimuth, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(kPi + tilt, Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()))
                   .toRotationMatrix();
  return t;
}

// Elbow, wrist and shoulder as three bits, by the signs that a UR has; of an arm that cannot tilt
// the elbow.
std::size_t branchOf(const robot::Cell& cell, const robot::JointVector& q,
                     std::vector<Eigen::Isometry3d>& frames) {
  if (!cell.tilts())
    return q[1] > 0 ? 1u : 0u;
  cell.framePoses(q, frames);
  const bool front =
      frames[5].translation().dot(Eigen::Vector3d(std::cos(q[0]), std::sin(q[0]), 0)) > 0;
  return (q[2] > 0 ? 1u : 0u) + (q[4] > 0 ? 2u : 0u) + (front ? 4u : 0u);
}

Score scoreOf(const robot::Cell& cell, double radius, const base::RunContext& ctx) {
  const std::vector<Eigen::Vector3d> points = partPoints(radius);
  return base::parallelSum<Score>(
      ctx, points.size(), 1, Score{}, [&](std::size_t begin, std::size_t end) {
        Score score;
        Clearance clearance(cell, radius);
        std::vector<robot::JointVector> solutions;
        std::vector<Eigen::Isometry3d> frames;
        for (std::size_t p = begin; p < end; ++p)
          for (std::size_t ring = 0; ring < (cell.tilts() ? kTilts : 1u); ++ring) {
            constexpr double kTiltDeg[kTilts] = {0, 30, 60, 90, 120};
            for (int side = 0; side < (ring == 0 ? 1 : 8); ++side) {
              double best = -1.0;
              bool reached = false;
              std::array<bool, 8> byBranch{};
              for (int turn = 0; turn < kTurns; ++turn) {
                cell.inverse(toolPose(points[p], base::degreesToRadians(kTiltDeg[ring]),
                                      side * kPi / 4, 2 * kPi * turn / kTurns),
                             cell.home(), solutions);
                reached = reached || !solutions.empty();
                for (const robot::JointVector& q : solutions) {
                  const double c = clearance.of(q);
                  if (c >= kClearMm)
                    byBranch[branchOf(cell, q, frames)] = true;
                  best = std::max(best, c);
                }
              }
              ++score.poses[ring];
              score.reached[ring] += reached;
              score.clear[ring] += best >= kClearMm;
              score.clearanceSum += std::max(0.0, best);
              for (std::size_t b = 0; b < 8; ++b)
                score.clearByBranch[b] += byBranch[b];
            }
          }
        return score;
      });
}

void printRow(const Place& place, const Score& s) {
  int poses = 0, clear = 0;
  for (std::size_t i = 0; i < kTilts; ++i) {
    poses += s.poses[i];
    clear += s.clear[i];
  }
  std::printf("%5.0f %5.0f %5.0f %5.0f  %6.2f %6.1f  ", place.x, place.y, place.z, place.stem,
              100.0 * clear / poses, s.clearanceSum / poses);
  for (std::size_t i = 0; i < kTilts; ++i)
    std::printf(" %6.1f", s.poses[i] > 0 ? 100.0 * s.clear[i] / s.poses[i] : 0.0);
  const auto best = std::max_element(s.clearByBranch.begin(), s.clearByBranch.end());
  std::printf("  %6.1f (%td)\n", 100.0 * *best / poses, best - s.clearByBranch.begin());
  std::fflush(stdout);
}

// At rest the tip stands 180 mm above the plate, or as high as the arm gets: the clearest branch,
// of those clear by 20 mm the one that turns least from the joints' zero and faces the plate.
void printHome(const robot::Cell& cell, double radius) {
  Clearance clearance(cell, radius);
  std::vector<robot::JointVector> solutions;
  double best = -1.0;
  robot::JointVector home;
  const auto turns = [&](const robot::JointVector& q) {
    return robot::asTurns(q, cell.limits()).norm() + 3.0 * std::abs(q[0]);
  };
  const robot::JointVector zero = robot::JointVector::Zero(cell.dof());
  double height = 180.0;
  const auto solve = [&](double turn) {
    cell.inverse(toolPose({0, 0, height}, 0, 0, turn), zero, solutions);
    return !solutions.empty();
  };
  while (!cell.tilts() && height > 0.0 && !solve(0.0))
    height -= 5.0;
  for (int turn = 0; turn < kTurns; ++turn) {
    solve(2 * kPi * turn / kTurns);
    for (const robot::JointVector& q : solutions)
      if (const double c = std::min(clearance.of(q), kRestMm);
          c > best + 1e-6 || (c > best - 1e-6 && c >= kClearMm && turns(q) < turns(home))) {
        best = c;
        home = q;
      }
  }
  std::printf("clearest rest (%.1f mm), %.0f mm above the plate:", best, height);
  for (Eigen::Index i = 0; i < home.size(); ++i)
    std::printf(" %.1f",
                robot::shownValue(cell.limits()[static_cast<std::size_t>(i)].kind, home[i]));
  std::printf("\n");
}

// Of an arm that cannot tilt: ahead of the middle of joint 1's range, by the height of the lowest
// tip, which the sliding joint says.
std::vector<Place> uprightGrid(const robot::Cell& cell) {
  std::vector<Place> places;
  robot::JointVector q = robot::JointVector::Zero(cell.dof());
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const robot::JointLimits& limit = cell.limits()[static_cast<std::size_t>(i)];
    q[i] = limit.kind == robot::JointKind::Sliding ? limit.min : 0.0;
  }
  q[0] = 0.5 * (cell.limits()[0].min + cell.limits()[0].max);
  const Eigen::Vector3d tip = (cell.base_T_fixed() * cell.work_T_tool(q)).translation();
  for (double share : {0.55, 0.6, 0.65, 0.7, 0.75})
    for (double above : {5.0, 15.0, 25.0, 35.0})
      places.push_back({10.0 * std::round(0.1 * share * tip.x()),
                        10.0 * std::round(0.1 * share * tip.y()), std::round(tip.z() + above), 0});
  return places;
}

// A plate ahead of the arm between 0.4 and 0.7 of what it stretches to, at heights up to 0.45 of
// it; a fixed nozzle and stems as the first cell was laid out.
std::vector<Place> grid(const robot::Cell& cell) {
  std::vector<Place> places;
  if (cell.nozzleMount() == robot::Mount::World) {
    for (double stem : {60, 100, 140})
      for (double x : {350, 450, 550})
        for (double z : {350, 450, 550})
          places.push_back({x, 0, z, stem});
    return places;
  }
  if (!cell.tilts())
    return uprightGrid(cell);
  std::vector<Eigen::Isometry3d> links;
  cell.robot().kinematics->linkPoses(robot::JointVector::Zero(cell.dof()), links);
  double stretch = 0.0;
  for (std::size_t i = 2; i < links.size(); ++i)
    stretch += (links[i].translation() - links[i - 1].translation()).norm();
  const auto share = [&](double of) { return 10.0 * std::round(0.1 * of * stretch); };
  for (double x : {0.4, 0.5, 0.6, 0.7})
    for (double z : {0.0, 0.15, 0.3, 0.45})
      places.push_back({share(x), 0, share(z), 0});
  return places;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2)
    return std::fprintf(stderr, "which cell?\n"), 2;
  const json shipped = json::parse(
      base::readFile(base::resourceFolder() / "cells" / (std::string(argv[1]) + ".json")));
  const double radius = argc > 2 ? std::atof(argv[2]) : 65.0;
  const auto folder = std::filesystem::temp_directory_path() / "voluta_cell_search";
  std::filesystem::create_directories(folder);
  std::vector<Place> places;
  for (int i = 3; i < argc; ++i) {
    Place p{};
    if (std::sscanf(argv[i], "%lf,%lf,%lf,%lf", &p.x, &p.y, &p.z, &p.stem) != 4)
      return std::fprintf(stderr, "not x,y,z,stem: %s\n", argv[i]), 2;
    places.push_back(p);
  }
  const bool asked = !places.empty();
  if (!asked)
    places = grid(cellAt(shipped, {400, 0, 200, 100}, folder));
  const base::RunContext ctx(base::CancelToken(),
                             static_cast<int>(std::max(1u, std::thread::hardware_concurrency())));
  std::printf("    x     y     z  stem  clear%%   mm    at tilt  0     30     60     90    120   "
              "best single branch\n");
  for (const Place& place : places) {
    const robot::Cell cell = cellAt(shipped, place, folder);
    printRow(place, scoreOf(cell, radius, ctx));
    if (asked)
      printHome(cell, radius);
  }
  std::filesystem::remove_all(folder);
  return 0;
}
