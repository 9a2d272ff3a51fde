// Robot programs, by the readers of all dialects.
#include "fuzz_target.h"

#include "program/dialect.h"
#include "program/extruder.h"
#include "program/gcode/gcode_milling.h"

#include <algorithm>
#include <cmath>

using namespace voluta;

namespace {

const std::string kRows = "kind,seconds,j1_rad,j2_rad,j3_rad,j4_rad,j5_rad,j6_rad,extruder,flow\n"
                          "1,0,0.1,0,0,0,0,0,0,0\n2,0.5,0.2,0,0,0,0,0,1,0.4\n"
                          "0,0,0.2,0,0,0,0,0,0,0\n";

constexpr const char* kLines = "x_mm,y_mm,z_mm,a_deg,b_deg,c_deg,mm_per_s,flow,blend_mm\n"
                               "tool,0,0,100,0,0,0\nnozzle,-800,-250,0,180,0,0\n"
                               "0,0,90,0,90,0,8,0,-1\n-10.5,20,300,12,-3,90,20,4113,0.05\n"
                               "-10.5,21,300,12,-3,90,0,0,0\n";

constexpr const char* kEkiLines =
    "X_mm,Y_mm,Z_mm,A_deg,B_deg,C_deg,mm_per_s,deg_per_s,flow,blend_mm\n"
    "tool,0,0,100,0,0,0\nnozzle,-800,-250,0,180,0,0\nload,1,0,0,50,0,0\n"
    "0,0,90,0,90,0,8,0,0,-1\n-10.5,20,300,12,-3,90,20,200,0.4113,0.05\n"
    "-10.5,21,300,12,-3,90,0,0,0,0\n";

// `external`: with an external axis behind the arm's.
plan::Trajectory sampleTrajectory(bool external) {
  plan::Trajectory t;
  t.dof = external ? 7 : 6;
  constexpr int kPoints = 8;
  for (int i = 0; i < kPoints; ++i) {
    const bool prints = i > 2 && i + 1 < kPoints;
    const double rotation = 0.002 * i;
    t.joints.insert(t.joints.end(), {0.1 + rotation, -1.9, 1.7, -1.2, -1.4, 0.3});
    if (external)
      t.joints.push_back(100.0 * rotation);
    t.timeS.push_back(0.5 * i);
    t.extrudedMm3.push_back(prints ? t.extrudedMm3.back() + 0.8
                                   : (i == 0 ? 0.0 : t.extrudedMm3.back()));
    t.move.push_back(prints   ? plan::MoveKind::Print
                     : i == 2 ? plan::MoveKind::Linear
                              : plan::MoveKind::Joint);
    t.waypoint.push_back(prints ? static_cast<std::size_t>(i - 3) : plan::kNoWaypoint);
  }
  return t;
}

} // namespace

std::vector<std::string> fuzz::seeds() {
  ::setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cells[] = {
      robot::loadCell("ur5-fixed", process, {{-9, -9}, {9, -9}, {0, 9}}),
      robot::loadCell("lathe", process, {}),
      robot::loadCell("rv2f-moving", process, {{-9, -9}, {9, -9}, {0, 9}})};
  plan::ToolPlan toolPlan;
  toolPlan.position.assign(4, Eigen::Vector3d::Zero());
  toolPlan.direction.assign(4, Eigen::Vector3d::UnitZ());
  toolPlan.paths.push_back({.first = 0, .count = 4, .layer = 1});
  std::vector<std::string> texts;
  for (const robot::Cell& cell : cells) {
    const plan::Trajectory trajectory = sampleTrajectory(!cell.externalAxes().empty());
    for (const program::Dialect& dialect : program::dialects()) {
      if ((!dialect.supportsExternalAxes && !cell.externalAxes().empty()) ||
          (dialect.needsJoints && program::isForeign(dialect, cell)))
        continue;
      plan::Trajectory said = trajectory;
      if (!dialect.tiltsNozzle) // it leans; by joints it may
        std::fill(said.move.begin(), said.move.end(), plan::MoveKind::Joint);
      std::vector<std::string_view> extruders = dialect.extruders;
      if (extruders.empty())
        extruders = {program::kOutputsExtruder};
      for (const std::string_view extruder : extruders) {
        program::ProgramInput input{toolPlan, said, cell, process::Tooling(process), "part"};
        input.options.own[std::string(program::kExtruderOption)] = std::string(extruder);
        for (const plan::ProgramFile& file : program::writeProgram(dialect.id, input).files)
          texts.push_back(file.text);
      }
    }
  }
  texts.emplace_back("G21 G90 G94\nG53 G0 Z0\nG0 A0\nS8500 M3\nG54 F300\nG0 X1 Y-2.5 Z3\nG1 Z-1\n"
                     "G53 G0 Z0\nG0 A180\nG55\nG1 X1 Y1 Z1\nM5\nM30\n");
  return texts;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  const process::Process process;
  program::detectDialect("input", text);
  // The columns beside the rows of a stream.
  for (const char* id : {"urscript-stream", "melfa-stream"})
    program::readProgram(id, {{"rows", kRows}, {"beside", text}}, process::Tooling(process));
  program::readProgram("melfa-datalink", {{"lines", kLines}, {"beside", text}},
                       process::Tooling(process));
  program::readProgram("krl-eki", {{"lines", kEkiLines}, {"beside", text}},
                       process::Tooling(process));
  for (const plan::ProgramMotion& motion : program::readMillingGcode(text).motions)
    fuzz::expect(motion.position.allFinite() && motion.speedMmPerS >= 0.0, "the cutter has a tip");
  for (const program::Dialect& dialect : program::dialects()) {
    const plan::ReadProgram read =
        program::readProgram(dialect.id, {{"input", text}}, process::Tooling(process));
    fuzz::expect(read.defects.size() <= program::kMaxDefects, "defects are not listed without end");
    for (const plan::ProgramMotion& motion : read.motions)
      fuzz::expect(motion.position.allFinite() && motion.frame_T_tcp.matrix().allFinite() &&
                       std::all_of(motion.externals.begin(), motion.externals.end(),
                                   [](double angle) { return std::abs(angle) < 1e6; }),
                   "motions lead to places");
  }
  return 0;
}
