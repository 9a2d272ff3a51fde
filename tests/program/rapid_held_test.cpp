// RAPID of cells with a fixed nozzle and a plate on the arm.
#include "program_defects.h"
#include "program_fixture.h"

#include "program/dialect.h"

namespace voluta::program {
namespace {

using RapidHeld = test::Programs;

// A fixed nozzle, on an object that the flange holds: a difference between the frames of program
// and cell moves the nozzle on the part by as much.
TEST_F(RapidHeld, aFixedNozzleIsAStationaryTool) {
  appendRandom(4, 60);
  const plan::Program program = writeProgram("rapid", input());
  const std::string& text = program.files[0].text;
  EXPECT_NE(text.find("PERS tooldata tNozzle:=[FALSE,[[-800,-250,0],[0,"), std::string::npos);
  EXPECT_NE(
      text.find(
          "PERS wobjdata wPlate:=[TRUE,TRUE,\"\",[[0,0,100],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];"),
      std::string::npos)
      << text.substr(0, 2000);
  const plan::ReadProgram back = readProgram("rapid", program.files, process::Tooling(process_));
  EXPECT_TRUE(back.complete && back.defects.empty());
  ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
  ASSERT_TRUE(back.base_T_nozzle && back.base_T_nozzle->isApprox(cell_->base_T_fixed(), 1e-9));
  EXPECT_TRUE(back.flange_T_tcp.isApprox(cell_->flange_T_moved(), 1e-9));
  for (std::size_t i = 0; i < back.motions.size(); ++i) {
    const Eigen::Isometry3d planned =
        cell_->work_T_tool(Eigen::Map<const Eigen::VectorXd>(trajectory_.at(i), 6));
    EXPECT_LE((back.motions[i].frame_T_tcp.translation() - planned.translation()).norm(), 1e-3);
    EXPECT_LE((back.motions[i].frame_T_tcp.linear() - planned.linear()).norm(), 1e-5);
  }
  const auto with = [&](const std::string& from, const std::string& to) {
    std::vector<plan::ProgramFile> files = program.files;
    files[0].text.replace(files[0].text.find(from), from.size(), to);
    return readProgram("rapid", files, process::Tooling(process_));
  };
  EXPECT_NEAR(with("[FALSE,[[-800,", "[FALSE,[[-799,").base_T_nozzle->translation().x(), -799.0,
              1e-9);
  EXPECT_NEAR(with("\"\",[[0,0,100]", "\"\",[[0,0,101]").flange_T_tcp.translation().z(), 101.0,
              1e-9);
  using test::expectDefect;
  const std::size_t first = back.motions.front().line;
  expectDefect(with("tNozzle:=[FALSE", "tNozzle:=[TRUE"), first,
               "either the tool or the work object");
  expectDefect(with("wPlate:=[TRUE", "wPlate:=[FALSE"), first,
               "either the tool or the work object");
}

} // namespace
} // namespace voluta::program
