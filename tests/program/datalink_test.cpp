// Lines by data link: the files beside them, and a test that the taking program acts on each line
// as the reader reads it.
#include "program_fixture.h"

#include "base/error.h"
#include "program/dialect.h"
#include "program/melfa/melfa_datalink.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>

namespace voluta::program {
namespace {

class Datalink : public test::Programs {
protected:
  // `own`: of the maker's arm.
  plan::Program program(bool own, std::size_t points = 200) {
    trajectory_ = {};
    plan_ = {};
    std::string json = test::kCellJson;
    if (own)
      json.replace(json.find("\"ur5\""), 5, "\"rv2f\"");
    const test::TemporaryFolder folder;
    base::writeFile(folder / "bench.json", json);
    cell_.emplace(robot::Cell::read(folder / "bench.json", process_,
                                    {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
    appendRandom(5, points);
    return writeProgram("melfa-datalink", input());
  }
  plan::ReadProgram read(const plan::Program& p) const {
    return readProgram(p.format, p.files, process::Tooling(process_));
  }
};

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line.ends_with('\r') ? line.substr(0, line.size() - 1) : line);
  return lines;
}

// The target and settings of a motion of the controller.
struct Asked {
  bool joints = false, held = false, byJoints = false; // target; EMvs; Mov
  std::array<double, 6> target = {};                   // mm, degrees
  double speed = 0.0, blend = 0.0;
  bool on = false;
  double flow = 0.0;
};

// As much of MELFA-BASIC V as the taking program has, run on lines. Unlike the reader it does not
// know the purpose of the lines.
class Controller {
public:
  Controller(const std::string& program, std::vector<std::string> lines)
      : lines_(std::move(lines)) {
    for (const std::string& line : linesOf(program)) {
      std::string code = line.substr(line.find(' ') + 1);
      if (!code.empty() && code.front() != '\'')
        steps_.push_back(code);
    }
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (steps_[i].front() == '*')
        labels_[steps_[i]] = i;
  }

  void run() {
    std::vector<std::size_t> calls;
    bool skips = false;
    for (std::size_t at = 0, n = 0; at < steps_.size() && n < 1'000'000; ++at, ++n) {
      std::string code = steps_[at];
      if (code == "EndIf") {
        skips = false;
        continue;
      }
      if (skips || code.front() == '*')
        continue;
      if (code.starts_with("If ")) {
        const std::size_t then = code.find(" Then");
        const bool holds = condition(code.substr(3, then - 3));
        code = code.substr(then + 5);
        if (code.empty())
          skips = !holds;
        if (code.empty() || !holds)
          continue;
        code.erase(0, 1);
      }
      if (code.starts_with("GoTo ")) {
        at = labels_.at(code.substr(5));
      } else if (code.starts_with("GoSub ")) {
        calls.push_back(at);
        at = labels_.at(code.substr(6));
      } else if (code == "Return") {
        at = calls.back();
        calls.pop_back();
      } else if (code == "End") {
        ended = true;
        return;
      } else {
        statement(code);
      }
    }
  }

  std::vector<Asked> motions;
  std::vector<std::pair<double, double>> waits; // seconds, flow
  std::size_t answers = 0;
  bool ended = false, on = false, asksOperator = false, confused = false;

private:
  double number(std::string text) const {
    const bool minus = text.starts_with('-');
    text.erase(0, minus ? 1 : 0);
    double value = 0.0;
    if (text.starts_with("Rad("))
      value = number(text.substr(4, text.size() - 5)) * std::acos(-1.0) / 180.0;
    else if (text.starts_with('M'))
      value = values_.at(text);
    else
      value = std::stod(text);
    return minus ? -value : value;
  }
  bool condition(const std::string& text) const {
    const std::size_t at = text.find_first_of("<>=");
    const std::string name = text.substr(0, at);
    const std::string op = text.substr(at, text.find_first_not_of("<>=", at) - at);
    const double a = name == "M_Open(1)" ? 1.0 : number(name),
                 b = number(text.substr(at + op.size()));
    return op == "=" ? a == b : op == "<" ? a < b : op == ">" ? a > b : a != b;
  }
  static std::vector<std::string> parts(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, ',');)
      all.push_back(part);
    return all;
  }
  static std::array<double, 6> constants(const std::string& text) {
    std::array<double, 6> numbers = {};
    const auto all = parts(text.substr(1, text.find(')') - 1));
    for (std::size_t k = 0; k < 6; ++k)
      numbers[k] = std::stod(all.at(k));
    return numbers;
  }

  void statement(const std::string& code) {
    const double degree = 180.0 / std::acos(-1.0);
    if (code.starts_with("Input #1,")) {
      const auto names = parts(code.substr(9)), numbers = parts(lines_.at(taken_++));
      confused = confused || names.size() != numbers.size();
      for (std::size_t k = 0; k < names.size(); ++k)
        values_[names[k]] = std::stod(numbers.at(k));
    } else if (code.starts_with("P1.")) {
      const std::size_t part = std::string("XYZABC").find(code[3]);
      pose_[part] = number(code.substr(5)) * (part < 3 ? 1.0 : degree);
    } else if (code.starts_with("J1.J")) {
      joints_[static_cast<std::size_t>(code[4] - '1')] = number(code.substr(6)) * degree;
    } else if (code.starts_with("P1=(")) {
      pose_ = constants(code.substr(3));
    } else if (code.starts_with("J1=(")) {
      joints_ = constants(code.substr(3));
    } else if (code.starts_with("Spd ")) {
      mmPerS_ = number(code.substr(4));
    } else if (code.starts_with("JOvrd ")) {
      percent_ = number(code.substr(6));
    } else if (code.starts_with("Cnt 1,")) {
      const auto both = parts(code.substr(6));
      confused = confused || both.size() != 2 || both[0] != both[1];
      blend_ = number(both[0]);
    } else if (code == "Cnt 0") {
      blend_ = 0.0;
      if (!motions.empty())
        motions.back().blend = 0.0;
    } else if (code.starts_with("M_Out(10)=")) {
      // An output changes ahead of the place of an arm in motion.
      const bool now = number(code.substr(10)) > 0.0;
      confused =
          confused || (now != on && blend_ > 0.0 && !motions.empty() && motions.back().blend > 0.0);
      on = now;
    } else if (code.starts_with("M_Outw(16)=")) {
      flow_ = number(code.substr(11));
    } else if (code.starts_with("Dly ")) {
      waits.emplace_back(number(code.substr(4)), on ? flow_ : 0.0);
    } else if (code.starts_with("Mov ") || code.starts_with("Mvs ") ||
               code.starts_with("EMvs 1,")) {
      motion(code);
    } else if (code.starts_with("Print #1")) {
      ++answers;
    } else if (code == "Hlt") {
      asksOperator = motions.empty();
    } else {
      static const std::vector<std::string> kKnown = {
          "Tool ",       "Base P_NBase", "P_WkCord(1)=", "Ovrd 100", "Accel 100,100",
          "P1=JtoP(J1)", "Open ",        "Def Act 1,",   "Act 1=",   "Close #1"};
      confused = confused || std::ranges::none_of(kKnown, [&](const std::string& known) {
                   return code.starts_with(known);
                 });
    }
  }

  void motion(const std::string& code) {
    Asked m;
    m.byJoints = code.starts_with("Mov ");
    m.joints = code == "Mov J1";
    m.held = code.front() == 'E';
    m.target = m.joints ? joints_ : pose_;
    m.speed = m.byJoints ? percent_ : mmPerS_;
    m.blend = m.byJoints ? 0.0 : blend_;
    if (const std::size_t with = code.find(" Wth M_Outw(16)="); with != std::string::npos)
      flow_ = number(code.substr(with + 16));
    m.on = on;
    m.flow = flow_;
    motions.push_back(m);
  }

  std::vector<std::string> steps_, lines_;
  std::map<std::string, std::size_t> labels_;
  std::map<std::string, double> values_;
  std::array<double, 6> pose_ = {}, joints_ = {};
  double mmPerS_ = 0.0, percent_ = 100.0, blend_ = 0.0, flow_ = 0.0;
  std::size_t taken_ = 0;
};

// As the sender picks them.
std::vector<std::string> sent(const std::string& text) {
  std::vector<std::string> lines;
  for (std::string line : linesOf(text)) {
    line = line.substr(0, line.find('#'));
    if (!line.empty() && (line.front() == '-' || (line.front() >= '0' && line.front() <= '9')))
      lines.push_back(line);
  }
  return lines;
}

TEST_F(Datalink, TakingProgramMovesAsTheReaderReads) {
  for (const bool own : {false, true}) {
    const plan::Program p = program(own);
    const plan::ReadProgram back = read(p);
    EXPECT_TRUE(back.complete && back.defects.empty());
    const std::vector<std::string> lines = sent(p.files[0].text);
    Controller controller(p.files[1].text, lines);
    controller.run();
    EXPECT_TRUE(controller.ended && controller.asksOperator);
    EXPECT_FALSE(controller.confused || controller.on);
    EXPECT_EQ(controller.answers, lines.size());
    // The start is a target once more than there are lines.
    ASSERT_EQ(controller.motions.size(), back.motions.size() + 1);
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_NEAR(controller.motions[0].target[k], controller.motions[1].target[k], 1e-9);
    EXPECT_EQ(controller.motions[0].joints, own);
    EXPECT_EQ(back.motions[0].target, own ? plan::TargetKind::Joints : plan::TargetKind::WorkPose);
    for (std::size_t i = 0; i < back.motions.size(); ++i) {
      const plan::ProgramMotion& m = back.motions[i];
      const Asked& a = controller.motions[i + 1];
      SCOPED_TRACE(i);
      EXPECT_EQ(a.byJoints, m.jointInterpolated);
      EXPECT_EQ(a.on, m.extruding);
      EXPECT_NEAR(a.blend, m.blendMm, 1e-12);
      if (m.extruding) {
        EXPECT_NEAR(a.flow, m.flowMm3PerS / process_.maxFlowMm3PerS * 10000.0, 1e-6);
      }
      EXPECT_NEAR(a.speed, a.byJoints ? 100.0 * m.jointSpeedRadPerS / base::kPi : m.speedMmPerS,
                  1e-9);
      if (a.joints) {
        ASSERT_EQ(m.target, plan::TargetKind::Joints);
        for (std::size_t k = 0; k < 6; ++k)
          EXPECT_NEAR(a.target[k], base::radiansToDegrees(m.joints[k]), 1e-9);
        continue;
      }
      // R = Rz(C) Ry(B) Rx(A), by elementary turns.
      const auto rotation = [&](std::size_t k, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(a.target[k] * base::kPi / 180.0, axis);
      };
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      pose.linear() =
          (rotation(5, Eigen::Vector3d::UnitZ()) * rotation(4, Eigen::Vector3d::UnitY()) *
           rotation(3, Eigen::Vector3d::UnitX()))
              .toRotationMatrix();
      pose.translation() = Eigen::Vector3d(a.target.data());
      ASSERT_EQ(m.target, plan::TargetKind::WorkPose);
      ASSERT_TRUE(back.base_T_nozzle.has_value());
      EXPECT_TRUE((pose * m.frame_T_tcp).isApprox(*back.base_T_nozzle, 1e-9));
      EXPECT_TRUE(a.byJoints || a.held);
    }
    ASSERT_EQ(controller.waits.size(), back.pauses.size());
    for (std::size_t i = 0; i < back.pauses.size(); ++i) {
      EXPECT_NEAR(controller.waits[i].first, back.pauses[i].durationS, 1e-9);
      EXPECT_NEAR(controller.waits[i].second * 1e-4 * process_.maxFlowMm3PerS *
                      back.pauses[i].durationS,
                  back.pauses[i].volumeMm3, 1e-6);
    }
  }
}

TEST_F(Datalink, NamesTheFilesBesideIt) {
  const plan::Program p = program(true);
  ASSERT_EQ(p.files.size(), 3u);
  EXPECT_EQ(continuationFiles(findDialect("melfa-datalink"), p.files[0].text),
            (std::vector<std::string>{p.files[1].name, p.files[2].name}));
  EXPECT_LE(p.files[1].name.size(), 16u) << "a controller's names hold 12 characters";
  for (const std::string& line : linesOf(p.files[1].text))
    EXPECT_LE(line.size(), 127u);
}

// The program that takes the lines is these lines' own: their tool, their nozzle, their start.
TEST_F(Datalink, RefusesAnotherTakingProgram) {
  const plan::Program whole = program(true), foreign = program(false);
  for (const plan::Program* p : {&whole, &foreign}) {
    plan::Program other = *p;
    other.files[1] = (p == &whole ? foreign : whole).files[1];
    EXPECT_FALSE(read(other).defects.empty());
    const std::vector<std::string> lines = linesOf(p->files[1].text);
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const std::string code = lines[l].substr(lines[l].find(' ') + 1);
      if (code.front() == '\'')
        continue;
      for (int harm = 0; harm < 3; ++harm) {
        std::vector<std::string> changed = lines;
        if (harm == 0)
          changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(l));
        else if (harm == 1)
          changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(l), lines[l]);
        else
          changed[l].insert(changed[l].size() - 1, "7");
        other = *p;
        other.files[1].text.clear();
        for (const std::string& line : changed)
          other.files[1].text += line + "\r\n";
        const plan::ReadProgram back = read(other);
        ASSERT_FALSE(back.defects.empty()) << harm << ": " << lines[l];
        EXPECT_EQ(back.defects[0].file, 1u);
        EXPECT_NEAR(static_cast<double>(back.defects[0].line), static_cast<double>(l + 1), 2.0);
      }
    }
  }
}

// The mode of the nozzle only defines the meaning of speeds; the program that takes the lines
// states it too.
TEST_F(Datalink, RefusesLinesOfAnotherNozzleOrStart) {
  const plan::Program whole = program(true);
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"\nnozzle,-800,", "\nnozzle,-801,"},
        {"\nnozzle,", "\n# nozzle,"},
        {"\ntool,0,0,100,", "\ntool,0,0,101,"},
        {",8,0,-1\n", ",9,0,-1\n"}}) {
    plan::Program other = whole;
    std::string& text = other.files[0].text;
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    EXPECT_FALSE(read(other).defects.empty()) << from;
  }
}

TEST_F(Datalink, TakesThePortThatAUserSets) {
  plan::Program p = program(true);
  std::string& text = p.files[1].text;
  text.replace(text.find("COM3:"), 5, "COM5:");
  EXPECT_TRUE(read(p).defects.empty());
  text.replace(text.find("COM5:"), 5, "COMX:");
  EXPECT_FALSE(read(p).defects.empty());
}

TEST_F(Datalink, RefusesAnotherSender) {
  plan::Program p = program(true);
  std::string& text = p.files[2].text;
  text.replace(text.find("AHEAD, START_S"), 5, "AFTER");
  const plan::ReadProgram back = read(p);
  ASSERT_FALSE(back.defects.empty());
  EXPECT_EQ(back.defects[0].file, 2u);
}

// Golden lines, and such as are none.
TEST(LinkRows, AreNineNumbers) {
  LinkRow row;
  ASSERT_TRUE(parseLinkRow("-10.5, 20,300,12,-3,90, 20 ,4113,0.05", melfaLinkForm(), row));
  EXPECT_EQ(row.target, (std::array<double, 6>{-10.5, 20, 300, 12, -3, 90}));
  EXPECT_EQ(row.speed, 20.0);
  EXPECT_EQ(row.flow, 4113.0);
  EXPECT_EQ(row.blend, 0.05);
  std::string text;
  appendLinkRow(text, row, melfaLinkForm());
  EXPECT_EQ(text, "-10.5,20,300,12,-3,90,20,4113,0.05\n");
  for (const char* bad :
       {"", "1,2,3", "0,0,0,0,0,0,20,0", "0,0,0,0,0,0,20,0,0,0", "0,0,0,0,0,x,20,0,0",
        "0,0,0,0,0,0,20,0.5,0", "0,0,0,0,0,0,20,-1,0", "0,0,0,0,0,0,20,10001,0",
        "0,0,0,0,0,0,20,0,-0.5", "0,0,0,0,0,0,20,0,-3", "0,0,0,0,0,0,101,0,-1",
        "0,0,0,0,0,0,nan,0,0", "0,0,0,0,0,0,1e9,0,0", "0,0,0,0,0,0,20,0,99999"})
    EXPECT_FALSE(parseLinkRow(bad, melfaLinkForm(), row)) << bad;
}

// A pause between blends, and an output that changes there, would run ahead of the arm.
TEST(LinkRows, SwitchOnlyWhereTheArmRests) {
  const auto defectsOf = [](const std::string& lines) {
    process::Process process;
    return readProgram("melfa-datalink",
                       {{"a.lines",
                         std::string(melfaLinkForm().header) + "\ntool,0,0,100,0,0,0\n" + lines}},
                       process::Tooling(process))
        .defects;
  };
  const std::string start = "400,0,300,180,0,180,8,0,-2\n", a = "400,1,300,180,0,180,20,",
                    end = "400,3,300,180,0,180,0,0,0\n";
  const auto on = [&](const char* y, const char* rest) {
    return std::string("400,") + y + ",300,180,0,180,20," + rest + "\n";
  };
  EXPECT_TRUE(
      defectsOf(start + on("1", "0,0") + on("2", "4000,0.1") + on("3", "4000,0") + end).empty());
  const struct {
    std::string lines;
    std::size_t line;
  } cases[] = {{start + on("1", "0,0.1") + on("2", "4000,0.1") + on("3", "4000,0") + end, 5},
               {start + on("1", "0,0") + on("2", "4000,0.1") + on("3", "0,0") + end, 6},
               {start + on("1", "0,0") + on("2", "4000,0.1") + "400,2,300,180,0,180,-1,4000,0\n" +
                    on("3", "4000,0") + end,
                6},
               {start + on("1", "0,0") + on("3", "4000,0.1") + end, 6},
               {start + "400,3,300,180,0,180,8,4000,-2\n" + end, 4},
               {start + "0,0,90,0,90,0,8,0,-1\n" + on("3", "0,0") + end, 4}};
  for (const auto& c : cases) {
    const auto defects = defectsOf(c.lines);
    ASSERT_FALSE(defects.empty()) << c.lines;
    EXPECT_EQ(defects[0].line, c.line) << c.lines;
  }
}

} // namespace
} // namespace voluta::program
