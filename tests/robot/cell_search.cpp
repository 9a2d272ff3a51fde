// The best place of the fixed body of a cell: of the fixed nozzle, or of the plate if the arm
// carries the nozzle. For each place tried, the share of printing poses that some branch and some
// turn about the nozzle reaches with all bodies clear (cells/cell_score.h); for places that are
// named also where the arm rests there.
//   cell_search CELL [RADIUS] [ROW...]   CELL: a cell's id; RADIUS of the poses' ball, mm (65);
//                                        ROW = x,y,z,stem (mm), stem: length of the plate's on the
//                                        flange, else unused; none: a grid.
#include "base/files.h"
#include "base/units.h"
#include "cells/arm_facts.h"
#include "cells/cell_score.h"
#include "cells/rest_pose.h"
#include "process/process.h"
#include "robot/cell.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

using namespace voluta;
using nlohmann::json;

namespace {

constexpr double kGantryZ = 1100.0;

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
    // The stem starts at the table, which stays in place.
    json& foot = stem[0]["frustum"]["p0Mm"][2];
    json& plate = cell["platform"]["pose"]["xyzMm"];
    foot = foot.get<double>() + plate[2].get<double>() - place.z;
    plate = {place.x, place.y, place.z};
  }
  const auto file = folder / (cell["id"].get<std::string>() + ".json");
  std::ofstream(file) << cell.dump();
  return robot::Cell::read(file, process::loadProcess("fdm-1.0"), cells::smallPlate());
}

void printRow(const Place& place, const cells::CellScore& score) {
  std::printf("%5.0f %5.0f %5.0f %5.0f  %6.2f  ", place.x, place.y, place.z, place.stem,
              100.0 * score.share());
  for (std::size_t tilt = 0; tilt < score.poses.size(); ++tilt)
    std::printf(" %6.1f", 100.0 * score.share(tilt));
  std::printf("\n");
  std::fflush(stdout);
}

void printHome(const robot::Cell& cell, const process::Process& process) {
  const auto rest = cells::restPose(cell, process, cells::armFacts(cell.robot()).reachMm);
  if (!rest)
    return void(std::printf("no rest\n"));
  std::printf("rest (%.1f mm clear, %.3f from singular), %.0f mm above the plate:", rest->clearMm,
              rest->fromSingular, rest->heightMm);
  for (Eigen::Index i = 0; i < cell.armDof(); ++i)
    std::printf(" %.1f",
                robot::shownValue(cell.limits()[static_cast<std::size_t>(i)].kind, rest->q[i]));
  std::printf("\n");
}

// Of an arm that cannot tilt: ahead of the middle of joint 1's range, by the height of the lowest
// tip, which follows from the sliding joint.
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

// A plate ahead of the arm between 0.4 and 0.7 of its reach, at heights up to 0.45 of it; a fixed
// nozzle and stems as in the first cell.
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
  const process::Process process = process::loadProcess("fdm-1.0");
  cells::PosePattern pattern;
  pattern.radiusMm = radius;
  std::printf("    x     y     z  stem  clear%%  at tilt  0     30     60     90    120\n");
  for (const Place& place : places) {
    const robot::Cell cell = cellAt(shipped, place, folder);
    printRow(place, cells::scoreOf(cell, process, pattern, ctx));
    if (asked)
      printHome(cell, process);
  }
  std::filesystem::remove_all(folder);
  return 0;
}
