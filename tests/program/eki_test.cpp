// Lines by EthernetKRL: the files beside them, and a test that the taking program acts on each line
// as the reader reads it.
#include "program_fixture.h"

#include "program/dialect.h"
#include "program/krl/krl_eki.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <sstream>

namespace voluta::program {
namespace {

// How many motions a controller knows ahead of the one it makes ($ADVANCE), and that one.
constexpr std::size_t kQueued = 6;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line.ends_with('\r') ? line.substr(0, line.size() - 1) : line);
  return lines;
}

class Eki : public test::Programs {
protected:
  // `own`: of the maker's arm, whose nozzle moves.
  plan::Program program(bool own, std::size_t points = 200) {
    trajectory_ = {};
    plan_ = {};
    SetUp();
    if (own)
      cell_.emplace(robot::loadCell("kr6-r900-moving", process_,
                                    {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
    appendRandom(5, points);
    return writeProgram("krl-eki", input());
  }
  plan::ReadProgram read(const plan::Program& p) const {
    return readProgram(p.format, p.files, process::Tooling(process_));
  }
};

// The target and settings of a motion of the controller.
struct Asked {
  bool joints = false, byJoints = false; // target; PTP
  std::array<double, 6> target = {};     // mm, degrees
  double speed = 0.0, rotation = 0.0, blend = 0.0;
  bool on = false;
  double flow = 0.0;
};

// As much of KRL and EKI as the taking program has, run on records. Unlike the reader it does not
// know the purpose of the lines.
class Controller {
public:
  // The elements of the channel, in the order of the lines' columns.
  Controller(const std::string& program, const std::string& channel, const std::string& lines) {
    for (std::string line : linesOf(program)) {
      line = line.substr(0, line.find(';'));
      while (line.ends_with(' '))
        line.pop_back();
      if (!line.empty())
        code_.push_back(line);
    }
    for (const std::string& line : linesOf(channel))
      if (const std::size_t at = line.find("Tag=\"L/@"); at != std::string::npos)
        names_.push_back(line.substr(at + 5, 4));
    for (std::string line : linesOf(lines)) {
      line = line.substr(0, line.find('#'));
      if (line.empty() || (line.front() != '-' && (line.front() < '0' || line.front() > '9')))
        continue;
      std::istringstream in(line);
      std::size_t k = 0;
      for (std::string number; std::getline(in, number, ','); ++k)
        waiting_[names_.at(k)].push_back(std::stod(number));
      confused = confused || k != names_.size();
      ++records;
    }
  }

  void run() {
    std::vector<std::size_t> loops;
    std::size_t repeat = 0;
    for (std::size_t at = 0, n = 0; at < code_.size() && n < 1'000'000; ++at, ++n) {
      const std::string& line = code_[at];
      const auto begins = [&](const char* word) { return line.starts_with(word); };
      if (line == "LOOP")
        loops.push_back(at);
      else if (line == "ENDLOOP")
        at = loops.back();
      else if (line == "EXIT")
        at = endOf(loops.back(), "LOOP", "ENDLOOP");
      else if (line == "REPEAT")
        repeat = at;
      else if (begins("UNTIL "))
        at = holds(line.substr(6)) ? at : repeat;
      else if (begins("IF "))
        at = holds(line.substr(3, line.rfind(" THEN") - 3)) ? at : otherwise(at);
      else if (line == "ELSE")
        at = endOf(at, "IF ", "ENDIF");
      else if (begins("SWITCH "))
        at = caseOf(at, values_.at(line.substr(7)));
      else if (begins("CASE "))
        at = endOf(at, "SWITCH ", "ENDSWITCH");
      else if (line == "END")
        ended = true;
      else if (line != "ENDIF" && line != "ENDSWITCH")
        statement(line);
    }
    for (std::size_t i = 0; i < triggers_.size(); ++i)
      fire(i);
  }

  std::vector<Asked> motions;
  std::vector<std::pair<double, double>> waits; // seconds, flow
  std::size_t records = 0;
  double reported = 0.0; // the number of lines it acknowledged
  bool ended = false, on = false, asksOperator = false, confused = false, held = false;
  std::map<std::string, std::string> frames;

private:
  std::size_t endOf(std::size_t at, const std::string& begin, const std::string& end) const {
    for (int depth = 1; depth > 0;) {
      ++at;
      depth += code_.at(at).starts_with(begin) ? 1 : code_.at(at) == end ? -1 : 0;
    }
    return at;
  }
  std::size_t otherwise(std::size_t at) const {
    for (int depth = 1;;) {
      ++at;
      if (code_.at(at).starts_with("IF "))
        ++depth;
      else if (code_[at] == "ENDIF" && --depth == 0)
        return at;
      else if (code_[at] == "ELSE" && depth == 1)
        return at;
    }
  }
  std::size_t caseOf(std::size_t at, double value) const {
    while (code_.at(at) != "CASE " + std::to_string(static_cast<int>(value)))
      ++at;
    return at;
  }

  double number(std::string text) {
    const bool minus = text.starts_with('-');
    text.erase(0, minus ? 1 : 0);
    double value = 0.0;
    if (text == "TRUE" || text == "FALSE") {
      value = text == "TRUE" ? 1.0 : 0.0;
    } else if (text.front() >= '0' && text.front() <= '9') {
      value = std::stod(text);
    } else {
      confused = confused || text.front() == '$'; // of the machine: the advance run would stop
      value = values_.at(text == "FLOWS[SLOT]" ? slot() : text);
    }
    return minus ? -value : value;
  }
  std::string slot() const {
    return "FLOWS[" + std::to_string(static_cast<int>(values_.at("SLOT"))) + "]";
  }
  bool holds(const std::string& text) {
    for (const std::string word : {" OR ", " AND "})
      if (const std::size_t at = text.find(word); at != std::string::npos) {
        const bool a = holds(text.substr(0, at)), b = holds(text.substr(at + word.size()));
        return word == " OR " ? a || b : a && b;
      }
    if (text.starts_with('('))
      return holds(text.substr(1, text.size() - 2));
    const std::size_t at = text.find_first_of("<>=");
    const std::string op = text.substr(at, text.find_first_not_of("<>=", at) - at);
    const double a = number(text.substr(0, at)), b = number(text.substr(at + op.size()));
    return op == "==" ? a == b : op == "<" ? a < b : op == ">" ? a > b : a != b;
  }

  void statement(const std::string& line) {
    const auto begins = [&](const char* word) { return line.starts_with(word); };
    if (begins("RET=EKI_"))
      eki(line);
    else if (begins("$OUT[1]="))
      output(number(line.substr(8)) > 0.0, flow_);
    else if (begins("$ANOUT[1]="))
      output(on, number(line.substr(10)));
    else if (begins("TRIGGER WHEN DISTANCE=0 DELAY=0 DO $ANOUT[1]="))
      triggers_.push_back({motions.size(), line.substr(45), false});
    else if (begins("WAIT SEC "))
      waits.emplace_back(number(line.substr(9)), on ? flow_ : 0.0);
    else if (begins("PTP ") || begins("LIN "))
      motion(line);
    else if (begins("BAS (#VEL_PTP,"))
      percent_ = number(line.substr(14, line.size() - 15));
    else if (line == "HALT")
      asksOperator = motions.empty();
    else if (line == "$IPO_MODE=#TCP" || line == "$IPO_MODE=#BASE")
      held = line.ends_with("TCP");
    else if (begins("$BASE=") || begins("$TOOL=") || begins("$LOAD="))
      frames[line.substr(1, 4)] = line.substr(6);
    else if (const std::size_t is = line.find('='); is != std::string::npos && !begins("GLOBAL"))
      assign(line.substr(0, is), line.substr(is + 1));
    else
      confused = confused || (!begins("&") && !begins("DEF ") && !begins("DECL EKI_STATUS RET") &&
                              !begins("GLOBAL INTERRUPT DECL 3") && line != "INTERRUPT ON 3" &&
                              line != "BAS (#INITMOV,0 )" && line != "WAIT FOR $FLAG[1]");
  }
  void assign(std::string name, const std::string& value) {
    double result = 0.0;
    if (value.ends_with("+1"))
      result = number(value.substr(0, value.size() - 2)) + 1.0;
    else if (value.ends_with("/1000"))
      result = number(value.substr(0, value.size() - 5)) / 1000.0;
    else
      result = number(value);
    values_[name == "FLOWS[SLOT]" ? slot() : name] = result;
  }
  void eki(const std::string& line) {
    std::vector<std::string> parts;
    std::istringstream in(line.substr(line.find('(') + 1));
    for (std::string part; std::getline(in, part, ',');)
      parts.push_back(part);
    parts.back().pop_back();
    const std::string element =
        parts.size() > 1 ? parts[1].substr(1, parts[1].size() - 2) : std::string();
    if (line.find("EKI_CheckBuffer") != std::string::npos) {
      values_["RET.BUFF"] = static_cast<double>(waiting_.at(element).size());
      values_["RET.CONNECTED"] = waiting_.at(element).empty() ? 0.0 : 1.0;
    } else if (line.find("EKI_GetReal") != std::string::npos) {
      values_[parts.at(2)] = waiting_.at(element).front();
      waiting_.at(element).pop_front();
    } else if (line.find("EKI_SetInt") != std::string::npos) {
      answer_ = number(parts.at(2));
    } else if (line.find("EKI_Send") != std::string::npos) {
      reported = answer_;
    }
  }
  // An assignment stops the advance run: in a corner that is to be rounded the arm halts.
  void output(bool now, double flow) {
    confused = confused || (!motions.empty() && motions.back().blend > 0.0);
    for (std::size_t i = 0; i < triggers_.size(); ++i)
      fire(i); // the arm has come there
    on = now;
    flow_ = flow;
  }
  void motion(const std::string& line) {
    Asked m;
    m.byJoints = line.starts_with("PTP ");
    const std::string goal = line.substr(4, line.find(" C_DIS") - 4);
    m.joints = goal == "JOINTS" || goal.starts_with("{A1 ");
    for (std::size_t k = 0; k < 6; ++k) {
      const std::string name = m.joints ? "A" + std::to_string(k + 1) : std::string(1, "XYZABC"[k]);
      m.target[k] = goal.front() == '{'
                        ? std::stod(goal.substr(goal.find(name + " ") + name.size()))
                        : values_.at(goal + "." + name);
    }
    m.speed = m.byJoints ? percent_ : values_.at("$VEL.CP") * 1000.0;
    if (!m.byJoints) {
      confused = confused || values_.at("$VEL.ORI1") != values_.at("$VEL.ORI2");
      m.rotation = values_.at("$VEL.ORI1");
    }
    m.blend = line.ends_with(" C_DIS") ? values_.at("$APO.CDIS") : 0.0;
    m.on = on;
    m.flow = flow_;
    motions.push_back(m);
    // As late as it may be.
    for (std::size_t i = 0; i < triggers_.size(); ++i)
      if (triggers_[i].motion + kQueued < motions.size())
        fire(i);
  }
  void fire(std::size_t i) {
    if (std::exchange(triggers_[i].fired, true))
      return;
    flow_ = number(triggers_[i].value);
    for (std::size_t m = triggers_[i].motion; m < motions.size(); ++m)
      motions[m].flow = flow_;
  }

  struct Trigger {
    std::size_t motion;
    std::string value;
    bool fired;
  };
  std::vector<std::string> code_, names_;
  std::map<std::string, std::deque<double>> waiting_;
  std::map<std::string, double> values_;
  std::vector<Trigger> triggers_;
  double percent_ = 0.0, flow_ = 0.0, answer_ = 0.0;
};

TEST_F(Eki, TakingProgramMovesAsTheReaderReads) {
  for (const bool own : {false, true}) {
    const plan::Program p = program(own);
    ASSERT_EQ(p.files.size(), 5u);
    const plan::ReadProgram back = read(p);
    EXPECT_TRUE(back.complete && back.defects.empty());
    Controller controller(p.files[1].text, p.files[3].text, p.files[0].text);
    controller.run();
    EXPECT_TRUE(controller.ended && controller.asksOperator);
    EXPECT_FALSE(controller.confused || controller.on);
    EXPECT_EQ(controller.reported, static_cast<double>(controller.records));
    EXPECT_EQ(controller.held, back.base_T_nozzle.has_value());
    EXPECT_EQ(controller.held, !own);
    // The start is a target once more than there are lines.
    ASSERT_EQ(controller.motions.size(), back.motions.size() + 1);
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_NEAR(controller.motions[0].target[k], controller.motions[1].target[k], 1e-9);
    EXPECT_EQ(controller.motions[0].joints, own);
    for (std::size_t i = 0; i < back.motions.size(); ++i) {
      const plan::ProgramMotion& m = back.motions[i];
      const Asked& a = controller.motions[i + 1];
      SCOPED_TRACE(i);
      EXPECT_EQ(a.byJoints, m.jointInterpolated);
      EXPECT_EQ(a.on, m.extruding);
      EXPECT_NEAR(a.blend, m.blendMm, 1e-12);
      if (m.extruding) {
        EXPECT_NEAR(a.flow, m.flowMm3PerS / process_.maxFlowMm3PerS, 1e-12);
      }
      if (a.byJoints)
        EXPECT_NEAR(a.speed, 100.0 * m.jointSpeedRadPerS / base::kPi, 1e-9);
      else if (m.durationS > 0.0) // the turn rules
        EXPECT_EQ(m.speedMmPerS, 0.0);
      else
        EXPECT_NEAR(a.speed, m.speedMmPerS, 1e-9);
      if (a.joints) {
        ASSERT_EQ(m.target, plan::TargetKind::Joints);
        for (std::size_t k = 0; k < 6; ++k)
          EXPECT_NEAR(a.target[k], base::radiansToDegrees(m.joints[k]), 1e-9);
        continue;
      }
      // R = Rz(A) Ry(B) Rx(C), by elementary turns.
      const auto rotation = [&](std::size_t k, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(a.target[k] * base::kPi / 180.0, axis);
      };
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      pose.linear() =
          (rotation(3, Eigen::Vector3d::UnitZ()) * rotation(4, Eigen::Vector3d::UnitY()) *
           rotation(5, Eigen::Vector3d::UnitX()))
              .toRotationMatrix();
      pose.translation() = Eigen::Vector3d(a.target.data());
      ASSERT_EQ(m.target, own ? plan::TargetKind::FlangePose : plan::TargetKind::WorkPose);
      const Eigen::Isometry3d frame =
          own ? cell_->base_T_work(cell_->home()) : Eigen::Isometry3d::Identity();
      EXPECT_LT((frame * pose).translation().cwiseAbs().maxCoeff(), 1e4);
      EXPECT_TRUE((frame * pose).isApprox(m.frame_T_tcp, 1e-7));
    }
    ASSERT_EQ(controller.waits.size(), back.pauses.size());
    for (std::size_t i = 0; i < back.pauses.size(); ++i) {
      EXPECT_NEAR(controller.waits[i].first, back.pauses[i].durationS, 1e-9);
      EXPECT_NEAR(controller.waits[i].second * process_.maxFlowMm3PerS * back.pauses[i].durationS,
                  back.pauses[i].volumeMm3, 1e-6);
    }
  }
}

// The same as the krl dialect's own program, motion by motion.
TEST_F(Eki, MovesAsTheKrlProgramDoes) {
  for (const bool own : {false, true}) {
    const plan::ReadProgram lines = read(program(own));
    const plan::Program krl = writeProgram("krl", input());
    const plan::ReadProgram back = read(krl);
    ASSERT_EQ(lines.motions.size(), back.motions.size());
    EXPECT_TRUE(lines.flange_T_tcp.isApprox(back.flange_T_tcp, 1e-9));
    ASSERT_EQ(lines.base_T_nozzle.has_value(), back.base_T_nozzle.has_value());
    ASSERT_TRUE(lines.load && back.load);
    EXPECT_NEAR(lines.load->kg, back.load->kg, 1e-9);
    for (std::size_t i = 0; i < back.motions.size(); ++i) {
      const plan::ProgramMotion &a = lines.motions[i], &b = back.motions[i];
      SCOPED_TRACE(i);
      EXPECT_EQ(a.target, b.target);
      EXPECT_TRUE(a.frame_T_tcp.isApprox(b.frame_T_tcp, 1e-9));
      EXPECT_EQ(a.extruding, b.extruding);
      EXPECT_NEAR(a.durationS, b.durationS, 1e-5 * b.durationS);
      EXPECT_NEAR(a.speedMmPerS, b.speedMmPerS, 1e-5 * b.speedMmPerS);
      EXPECT_NEAR(a.flowMm3PerS, b.flowMm3PerS, 1e-3 * b.flowMm3PerS);
      EXPECT_NEAR(a.jointSpeedRadPerS, b.jointSpeedRadPerS, 1e-9);
      EXPECT_LE(b.blendMm, a.blendMm + 1e-9); // in steps there
      EXPECT_EQ(b.blendMm > 0.0, a.blendMm > 0.0);
    }
  }
}

TEST_F(Eki, NamesTheFilesBesideIt) {
  const plan::Program p = program(true);
  std::vector<std::string> names;
  for (std::size_t f = 1; f < p.files.size(); ++f)
    names.push_back(p.files[f].name);
  EXPECT_EQ(continuationFiles(findDialect("krl-eki"), p.files[0].text), names);
  EXPECT_EQ(names[0], "print_part_1_eki.src");
  EXPECT_NE(p.files[1].text.find("\r\nDEF print_part_1_eki ( )\r\n"), std::string::npos);
  EXPECT_NE(p.files[1].text.find("EKI_Init(\"print_part_1_eki\")"), std::string::npos);
  for (const char* place : {"%s", "%d", "%f", "%%"})
    EXPECT_EQ(p.files[1].text.find(place), std::string::npos) << "not filled in";
  EXPECT_LE(names[0].size(), 28u) << "KRL's names hold 24 characters";
}

// Variables that are read into have a value before, and the channel an element for each.
TEST_F(Eki, EachVariableIsDeclared) {
  const plan::Program p = program(true);
  for (const std::string& line : linesOf(p.files[1].text)) {
    const std::size_t at = line.find("EKI_GetReal(");
    if (at == std::string::npos)
      continue;
    std::string variable = line.substr(line.rfind(',') + 1);
    variable = variable.substr(0, variable.find_first_of(".)"));
    EXPECT_NE(p.files[2].text.find(" " + variable + "="), std::string::npos) << variable;
    const std::size_t tag = line.find("L/@");
    EXPECT_NE(p.files[3].text.find("Tag=\"" + line.substr(tag, 4) + "\" Type=\"REAL\""),
              std::string::npos)
        << line;
  }
}

// The files that take the lines are these lines' own: their tool, their nozzle, their start.
TEST_F(Eki, RefusesOtherTakingFiles) {
  const plan::Program whole = program(true), foreign = program(false);
  for (const plan::Program* p : {&whole, &foreign}) {
    plan::Program other = *p;
    other.files[1] = (p == &whole ? foreign : whole).files[1];
    EXPECT_FALSE(read(other).defects.empty());
    for (std::size_t f = 1; f <= 3; ++f) {
      const std::vector<std::string> lines = linesOf(p->files[f].text);
      for (std::size_t l = 0; l < lines.size(); ++l) {
        if (lines[l].starts_with(';'))
          continue;
        for (int harm = 0; harm < 3; ++harm) {
          std::vector<std::string> changed = lines;
          if (harm == 0)
            changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(l));
          else if (harm == 1)
            changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(l), lines[l]);
          else
            changed[l].insert(changed[l].size() - 1, "q");
          other = *p;
          other.files[f].text.clear();
          for (const std::string& line : changed)
            other.files[f].text += line + "\r\n";
          const plan::ReadProgram back = read(other);
          ASSERT_FALSE(back.defects.empty()) << f << " " << harm << ": " << lines[l];
        }
      }
    }
  }
}

TEST_F(Eki, RefusesLinesOfAnotherFrameOrStart) {
  for (const bool own : {false, true}) {
    const plan::Program whole = program(own);
    std::vector<std::pair<std::string, std::string>> edits = {
        {"\ntool,", "\ntool,1"},
        {"\nload,", "\n# load,"},
        {own ? ",10,0,0,-1\n" : ",10,0,0,-2\n", own ? ",9,0,0,-1\n" : ",9,0,0,-2\n"},
        {own ? "\nbase," : "\nnozzle,-", own ? "\nbase,1" : "\nnozzle,-1"},
        {own ? "\nbase," : "\nnozzle,", own ? "\nnozzle," : "\nbase,"}};
    for (const auto& [from, to] : edits) {
      plan::Program other = whole;
      std::string& text = other.files[0].text;
      const std::size_t at = text.find(from);
      ASSERT_NE(at, std::string::npos) << from;
      text.replace(at, from.size(), to);
      EXPECT_FALSE(read(other).defects.empty()) << from;
    }
  }
}

TEST_F(Eki, TakesTheAddressThatAUserSets) {
  plan::Program p = program(true);
  std::string& text = p.files[3].text;
  text.replace(text.find("192.168.0.40"), 12, "10.0.0.7");
  text.replace(text.find("54600"), 5, "54615");
  EXPECT_TRUE(read(p).defects.empty());
  text.replace(text.find("10.0.0.7"), 8, "robot");
  EXPECT_FALSE(read(p).defects.empty());
}

// Reading one did not end: text inserted for a '%' was searched for more of them.
TEST_F(Eki, ANameThatIsNoneIsADefect) {
  for (const std::string name : {"%", "%X", "A%B", "\"", ""}) {
    plan::Program p = program(true);
    std::string& text = p.files[1].text;
    const std::size_t at = text.find("DEF ") + 4;
    text.replace(at, text.find(' ', at) - at, name);
    EXPECT_FALSE(read(p).defects.empty()) << name;
  }
}

TEST_F(Eki, RefusesAnotherSender) {
  plan::Program p = program(true);
  std::string& text = p.files[4].text;
  text.replace(text.find("AHEAD, START_S"), 5, "AFTER");
  const plan::ReadProgram back = read(p);
  ASSERT_FALSE(back.defects.empty());
  EXPECT_EQ(back.defects[0].file, 4u);
}

// Where the TCP turns on the spot the turn determines the time; lines that are not valid.
TEST(EkiRows, AreTenNumbers) {
  const LinkForm& form = krlLinkForm();
  LinkRow row;
  ASSERT_TRUE(parseLinkRow("-10.5, 20,300,12,-3,90, 20 ,200,0.4113,0.05", form, row));
  EXPECT_EQ(row.speed, 20.0);
  EXPECT_EQ(row.rotation, 200.0);
  EXPECT_EQ(row.flow, 0.4113);
  std::string text;
  appendLinkRow(text, row, form);
  EXPECT_EQ(text, "-10.5,20,300,12,-3,90,20,200,0.4113,0.05\n");
  for (const char* bad :
       {"", "0,0,0,0,0,0,20,0,0", "0,0,0,0,0,0,20,200,0,0,0", "0,0,0,0,0,0,20,0,0.4,0",
        "0,0,0,0,0,0,20,-5,0.4,0", "0,0,0,0,0,0,20,200,1.5,0", "0,0,0,0,0,0,10,200,0,-1",
        "0,0,0,0,0,0,-1,200,0,0", "0,0,0,0,0,0,20,nan,0,0", "0,0,0,0,0,0,20,1e9,0,0"})
    EXPECT_FALSE(parseLinkRow(bad, form, row)) << bad;
  const plan::ReadProgram read =
      readProgram("krl-eki",
                  {{"a.eki", std::string(form.header) +
                                 "\ntool,0,0,100,0,0,0\nbase,100,0,0,90,0,0\nload,1,0,0,50,0,0\n"
                                 "0,0,300,0,0,180,10,0,0,-2\n0,0,300,30,0,180,20,15,0,0\n"
                                 "10,0,300,30,0,180,20,15,0,0\n10,0,300,30,0,180,0,0,0,0\n"}},
                  process::Tooling(process::Process{}));
  for (const auto& d : read.defects)
    ADD_FAILURE() << d.line << ": " << voluta::base::english(d.reason);
  ASSERT_EQ(read.motions.size(), 3u);
  EXPECT_TRUE(read.complete);
  EXPECT_NEAR(read.motions[1].durationS, 2.0, 1e-9);
  EXPECT_EQ(read.motions[2].speedMmPerS, 20.0);
  // In a base that is rotated by 90 degrees at x 100.
  EXPECT_TRUE(read.motions[2].frame_T_tcp.translation().isApprox(Eigen::Vector3d(100, 10, 300)));
}

} // namespace
} // namespace voluta::program
