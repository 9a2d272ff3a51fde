// An arm that rides on a track, in every language that can state its position.
#include "program_defects.h"
#include "program_fixture.h"
#include "read_programs.h"

#include "base/data_files.h"
#include "base/units.h"
#include "program/dialect.h"

#include <nlohmann/json.hpp>

namespace voluta::program {
namespace {

class Track : public test::ReadPrograms {
protected:
  // The shipped cell; with another robot, or a table that turns beside the track.
  void useTrack(const std::string& robot = {}, bool table = false) {
    constexpr const char* kId = "kr10-r1100-track";
    nlohmann::json cell = nlohmann::json::parse(
        base::readFile(base::dataFile("cells", kId, "unknown cell '{id}'"_text)));
    if (!robot.empty()) {
      cell["robot"] = robot;
      cell["homeDeg"] = {0, 0, 0, 0, 90, 0};
      cell["neverMeet"] = nlohmann::json::array();
    }
    if (table) {
      cell["externalAxes"].push_back({{"name", "table"},
                                      {"kind", "turning"},
                                      {"pose", {{"xyzMm", {700, 50, 100}}}},
                                      {"axis", {0, 0, 1}},
                                      {"minDeg", -720},
                                      {"maxDeg", 720},
                                      {"velocityDegPerS", 90},
                                      {"accelerationDegPerS2", 300},
                                      {"stepDeg", 0},
                                      {"end", "unwinds"}});
      cell["platform"]["pose"] = {{"xyzMm", {0, 10, 50}}};
      cell["externalUnit"] = "TABLE";
    }
    platform::PlatformSolid plate;
    plate.polygon = {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
    cell_.emplace(robot::Cell::readText(cell.dump(), std::string(kId) + ".json", process_, plate));
  }

  // Joints that vary while the track moves by hundreds of mm.
  void appendRandomOnTrack(unsigned seed, std::size_t points) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<double> q = {0.1, -0.8, 1.4, 0.1, 1.2, 0.3, -300.0};
    if (cell_->robot().id == "irb1200")
      q = {0.1, -0.1, 0.3, 0.1, 1.2, 0.3, -300.0};
    if (cell_->dof() == 8)
      q.push_back(0.5);
    std::vector<double> drift(q.size());
    std::size_t waypoint = plan_.waypointCount();
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t phase = i % 40;
      if (phase == 1)
        for (double& d : drift)
          d = 4e-4 * (unit(random) - 0.5);
      for (std::size_t k = 0; k < q.size(); ++k)
        q[k] += (k == 6 ? 100.0 : 1.0) *
                (phase < 3 ? 0.02 * (unit(random) - 0.5) : drift[k] + 1e-4 * (unit(random) - 0.5));
      q[6] += 3.0;
      const double volume = phase < 3 || phase == 39 ? 0.0 : 0.05 + 0.2 * unit(random);
      const auto move = phase < 2                   ? plan::MoveKind::Joint
                        : phase == 2 || phase == 39 ? plan::MoveKind::Linear
                                                    : plan::MoveKind::Print;
      append(move, q, volume / 30.0 + 0.05 + 0.1 * unit(random), volume);
      if (move == plan::MoveKind::Print || phase == 2)
        noteWaypoint(waypoint++, phase == 2, static_cast<int>(i / 400));
    }
    plan_.position.assign(waypoint, Eigen::Vector3d::Zero());
    plan_.direction.assign(waypoint, Eigen::Vector3d::UnitZ());
  }

  // Every target as the trajectory has it, in the world where the languages count from there.
  void expectReadBack(const char* format, plan::TargetKind poses) {
    SCOPED_TRACE(format);
    const plan::Program written = writeProgram(format, input());
    plan::ReadProgram back = readProgram(format, written.files, process::Tooling(process_));
    EXPECT_TRUE(back.complete);
    for (const auto& d : back.defects)
      ADD_FAILURE() << d.line << ": " << base::english(d.reason);
    dropPieces(back);
    ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
    std::size_t posed = 0;
    for (std::size_t i = 0; i < back.motions.size(); ++i) {
      expectTarget(back, i);
      const plan::ProgramMotion& m = back.motions[i];
      const robot::JointVector q = jointsAt(i);
      if (m.target == plan::TargetKind::Joints) {
        ASSERT_EQ(static_cast<int>(m.joints.size()), cell_->dof());
      } else if (m.target != plan::TargetKind::ToolPoint) {
        ++posed;
        ASSERT_EQ(m.target, poses);
        ASSERT_EQ(static_cast<int>(m.externals.size()), cell_->dof() - 6);
        EXPECT_NEAR(base::radiansToDegrees(m.externals[0]), q[6], 1e-4) << "texts have mm";
        if (cell_->dof() == 8) {
          EXPECT_NEAR(m.externals[1], q[7], 1e-6);
        }
      }
    }
    EXPECT_EQ(posed == 0, poses == plan::TargetKind::Joints);
  }
};

TEST_F(Track, isReadBackWhereItWas) {
  for (const char* robot : {"", "irb1200"}) {
    trajectory_ = {};
    plan_ = {};
    useTrack(robot);
    appendRandomOnTrack(3, 200);
    expectReadBack("krl", plan::TargetKind::FlangePose);
    expectReadBack("rapid", plan::TargetKind::FlangePose);
    expectReadBack("csv", plan::TargetKind::Joints);
  }
}

TEST_F(Track, isReadBackWithATableThatTurnsBesideIt) {
  for (const char* robot : {"", "irb1200"}) {
    trajectory_ = {};
    plan_ = {};
    useTrack(robot, true);
    appendRandomOnTrack(4, 200);
    expectReadBack("krl", plan::TargetKind::UnitPose);
    expectReadBack("rapid", plan::TargetKind::UnitPose);
    expectReadBack("csv", plan::TargetKind::Joints);
  }
}

// The plate's frame is stated in the world, for any start of the arm.
TEST_F(Track, plateFrameIsInTheWorld) {
  useTrack("irb1200");
  appendRandomOnTrack(3, 60);
  const std::string rapid = writeProgram("rapid", input()).files[0].text;
  EXPECT_NE(rapid.find("ActUnit TRACK;"), std::string::npos);
  EXPECT_NE(rapid.find("PERS wobjdata wPrint:=[FALSE,TRUE,\"\",[[800,0,150],[1,0,0,0]],"),
            std::string::npos)
      << rapid.substr(0, 3000);
  EXPECT_NE(rapid.find("track is eax_a"), std::string::npos);
  useTrack();
  const std::string krl = writeProgram("krl", input()).files[0].text;
  EXPECT_NE(krl.find("$BASE={X 800,Y 0,Z 150,A 0,B 0,C 0}"), std::string::npos);
  EXPECT_NE(krl.find("AXES_UNDER_ROBOT=1"), std::string::npos);
  EXPECT_NE(krl.find("track is E1; $ROBROOT"), std::string::npos);
}

// A table beside it: the track comes first, the unit that is the work object's behind it.
TEST_F(Track, isAUnitOfItsOwnBesideATable) {
  useTrack("irb1200", true);
  appendRandomOnTrack(3, 60);
  const std::string rapid = writeProgram("rapid", input()).files[0].text;
  const std::size_t track = rapid.find("ActUnit track;"), table = rapid.find("ActUnit TABLE;");
  EXPECT_LT(track, table);
  EXPECT_NE(table, std::string::npos);
  EXPECT_NE(rapid.find("[FALSE,FALSE,\"TABLE\","), std::string::npos);
  EXPECT_NE(rapid.find("table is eax_b"), std::string::npos);
}

TEST_F(Track, isRefusedByDialectsWithoutExternalAxes) {
  useTrack();
  appendRandomOnTrack(3, 60);
  for (const Dialect& d : dialects())
    if (!d.supportsExternalAxes) {
      EXPECT_THROW(writeProgram(d.id, input()), base::Error) << d.id;
    }
}

// A program that moves an axis without stating that it carries the arm is refused, as before.
TEST_F(Track, isRefusedWithoutStatingThatTheAxisCarriesTheArm) {
  useTrack();
  appendRandomOnTrack(3, 60);
  const struct {
    const char *format, *line, *reason;
  } cases[] = {{"krl", "AXES_UNDER_ROBOT=1", "moves no work object"},
               {"rapid", "ActUnit TRACK;", "moves no work object"}};
  for (const auto& c : cases) {
    plan::Program program = writeProgram(c.format, input());
    std::string& text = program.files[0].text;
    const std::size_t at = text.find(c.line);
    ASSERT_NE(at, std::string::npos) << c.format;
    text.erase(at, std::string(c.line).size());
    const plan::ReadProgram back = readProgram(c.format, program.files, process::Tooling(process_));
    ASSERT_FALSE(back.defects.empty()) << c.format;
    EXPECT_NE(base::english(back.defects.front().reason).find(c.reason), std::string::npos)
        << base::english(back.defects.front().reason);
  }
  plan::Program program = writeProgram("krl", input());
  std::string& text = program.files[0].text;
  const std::size_t at = text.find(",E1 ");
  text.erase(at, text.find_first_of(",}", at + 1) - at);
  EXPECT_FALSE(readProgram("krl", program.files, process::Tooling(process_)).defects.empty());
}

} // namespace
} // namespace voluta::program
