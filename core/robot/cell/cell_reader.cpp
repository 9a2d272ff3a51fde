// A cell's file (resources/cells/ID.json; the file's name is its id). All keys are required unless
// marked optional; an unknown key is an error. Poses as in robot/cell/json_pose.h, shapes as in
// robot/cell/shape_reader.h.
//   id, label             texts; id as the file's name
//   note                  optional text: how the cell was laid out
//   extruder              optional: id of a row of program::extruders(); default "outputs"
//   robot                 id of a robot, or its whole description as in resources/robots/ID.json
//   nozzle                {mount: "world" | "flange", pose, holder}: pose is base_T_tool or
//                         flange_T_tool (z in the direction of extrusion); holder, optional,
//                         carries the head, shapes in the tool frame. The head itself comes from
//                         the process.
//   platform              {mount: the other one, pose, thicknessMm, stem, plates}: pose is
//                         flange_T_work or base_T_work, or with external axes the work frame in the
//                         moving frame of the last one; the plate is the job's polygon, thicknessMm
//                         thick below z = 0; stem, optional, carries it, shapes in the work frame;
//                         plates, optional: the available ones, smallest first, as platforms are
//                         written ("disc:120", "rect:200x150"). Or {mount: "world", pose, rod}: rod
//                         is {diameterMm, lengthMm, printableRadiusMm}, along x of the work frame,
//                         lengthMm free between its bearings, which are obstacles
//   obstacles             list of {name, pose, shapes}, in the world; may be empty. pose, optional:
//                         the frame of the shapes
//   carriedKg             optional: mass on the flange before printing, kg; default: half a
//                         kilogram for a plate, one for a head
//   toolChange            how the tool is changed, optional: {"by": "hand"} (default), "feeder", or
//                         "changer" with "docks", a list of {"beforeDeg", "inDeg"}: the robot's
//                         joints before the dock of each tool and in it
//                         The tips of all tools are in one place: the nozzle's pose holds for all
//   purgeMm               optional, with a moving nozzle: [x, y, z] of its tip, in the world, where
//                         a tool is changed and the nozzle purged; default: the planner chooses a
//                         low place beside the plate
//   homeDeg               list: the robot's joints in the home pose (sliding ones in mm), with the
//                         plate clear of the nozzle; external axes are then at 0
//   travelAccelerationDegPerS2  optional: of the arm's joints in travels with their load (of a
//                         sliding one as asAngle converts it), at most the values of the robot's
//                         file; default 80, the usual default of controllers (1.4 rad/s2)
//   neverMeet             optional list of {pair: [name, name], why}: bodies that need no check;
//                         the cell's own are named "holder", "head" and "platform"
//   externalAxes          list, the first axis in the world, each next one on the moving side of
//                         the one before it, the platform on the last; empty: none. {name, kind:
//                         "turning" | "sliding", pose: in that frame at 0, axis: [x, y, z], its
//                         direction in that pose, carries, bodies}; if turning: minDeg, maxDeg,
//                         velocityDegPerS, accelerationDegPerS2, stepDeg (0: any position), end
//                         ("unwinds" or "runsOn"); if sliding: minMm, maxMm, velocityMmPerS,
//                         accelerationMmPerS2, stepMm. carries, optional: "platform" or "robot".
//                         Axes that carry the robot come first, starting with the one next to the
//                         robot; their poses are in the base as it is with them at 0, which the
//                         rest of the file takes as the world. bodies, optional: bodies it moves,
//                         {name, shapes} in its moving frame. A rod has one axis, along its x
//   externalUnit          optional: the controller's name of the mechanical unit of these axes;
//                         default: the last one's name. Axes below the robot beside others are a
//                         unit named after the last of them
#include "robot/cell.h"

#include "base/error.h"
#include "base/files.h"
#include "base/json_node.h"
#include "base/units.h"
#include "robot/cell/checked_pairs.h"
#include "robot/cell/json_pose.h"
#include "robot/cell/platform_reader.h"
#include "robot/cell/robot_reader.h"
#include "robot/cell/shape_reader.h"
#include "robot/shape/shape_moves.h"

#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {
constexpr double kTravelDegPerS2 = 80.0;
constexpr double kPlateKg = 0.5, kHeadKg = 1.0; // Assumed

constexpr double kStepMm = 1e-9; // head sections closer than this are a step, not a frustum

Mount readMount(const base::JsonNode& node) {
  const std::string mount = node.text();
  if (mount == "world")
    return Mount::World;
  if (mount == "flange")
    return Mount::Flange;
  node.fail(base::message("must be world or flange, is '{mount}'"_text, mount));
}

RobotModel readRobotOf(const base::JsonNode& node) {
  if (holdsRobot(node))
    return readRobot(node);
  try {
    return loadRobot(node.text());
  } catch (const base::Error& e) {
    if (e.code() != base::ErrorCode::Usage)
      throw;
    node.fail(e.whole());
  }
}

// In the tool frame the head extends along -z.
Body headBody(const process::HeadShape& head, int toolFrame) {
  Body body{"head", BodyRole::Head, toolFrame, {}};
  for (std::size_t i = 1; i < head.sections.size(); ++i) {
    const process::HeadSection &a = head.sections[i - 1], &b = head.sections[i];
    if (b.zMm - a.zMm > kStepMm)
      body.shapes.push_back(Frustum{Eigen::Vector3d(0, 0, -a.zMm), Eigen::Vector3d(0, 0, -b.zMm),
                                    a.radiusMm, b.radiusMm});
  }
  return body;
}

// Computes Cell::lastJointTurnsNozzle, with a tolerance because descriptions round right angles.
int nozzleRotationSign(const Arm& arm, const Eigen::Isometry3d& flange_T_tool) {
  constexpr double kTestRad = 1.0, kNearMm = 0.05, kNear = 1e-4;
  const Kinematics& kinematics = *arm.robot.kinematics;
  const int last = arm.jointCount() - 1;
  if (kinematics.kindOf(last) != JointKind::Turning)
    return 0;
  JointVector turned = arm.home;
  const Eigen::Isometry3d from = kinematics.flange(turned) * flange_T_tool;
  turned[last] += kTestRad;
  const Eigen::Isometry3d move = from.inverse() * kinematics.flange(turned) * flange_T_tool;
  for (const int sign : {1, -1})
    if (move.translation().norm() < kNearMm &&
        (move.linear() - Eigen::AngleAxisd(sign * kTestRad, Eigen::Vector3d::UnitZ()).matrix())
                .norm() < kNear)
      return sign;
  return 0;
}

} // namespace

// Reads a cell key by key. Later steps depend on earlier ones: frames and the joint vector
// depend on arm and axes, bodies on frames, pairs on all bodies.
class Cell::Reader {
public:
  Reader(const base::JsonNode& top, const process::HeadShape& head) : top_(top), head_(head) {}

  Cell read(const std::string& id, RobotModel robot, platform::PlatformSolid solid) {
    top_.allowOnly({"id", "label", "note", "robot", "nozzle", "platform", "obstacles", "homeDeg",
                    "travelAccelerationDegPerS2", "neverMeet", "externalAxes", "externalUnit",
                    "extruder", "carriedKg", "toolChange", "purgeMm"});
    readTexts(id);
    addArm(std::move(robot));
    readAxes();
    nameUnits();
    const base::JsonNode nozzle = top_.at("nozzle"), platform = top_.at("platform");
    nozzle.allowOnly({"mount", "pose", "holder"});
    readRodOf(platform, solid);
    readMounts(nozzle, platform);
    readCarried();
    readPoses(nozzle, platform);
    addLinks();
    addHead(nozzle);
    addPlatform(platform, std::move(solid));
    addAxisBodies();
    addObstacles();
    readHome();
    readToolChange();
    readPurgePlace();
    if (!plateMoves())
      cell_.lastJointTurnsNozzle_ = nozzleRotationSign(cell_.arms_.front(), cell_.flange_T_moved_);
    readTravelAcceleration();
    findPairs();
    return std::move(cell_);
  }

private:
  bool plateMoves() const { return cell_.nozzleMount_ == Mount::World; }

  void readTexts(const std::string& id) {
    cell_.id_ = top_.at("id").text();
    if (cell_.id_ != id)
      top_.at("id").fail(
          base::message("is '{id}', but the file is named '{file}'"_text, cell_.id_, id));
    cell_.label_ = top_.at("label").text();
    if (top_.has("note"))
      cell_.note_ = top_.at("note").text();
    if (top_.has("extruder"))
      cell_.extruder_ = top_.at("extruder").text();
  }

  // Its joints follow those of the arms before it; its home pose is read later.
  void addArm(RobotModel robot) {
    Arm arm;
    arm.firstJoint = cell_.dof();
    cell_.limits_.insert(cell_.limits_.end(), robot.limits.begin(), robot.limits.end());
    arm.robot = std::move(robot);
    cell_.arms_.push_back(std::move(arm));
  }

  void readAxes() {
    std::vector<ExternalAxis>& axes = cell_.externalAxes_;
    for (const base::JsonNode& node : top_.at("externalAxes").items()) {
      AxisDescription described = readExternalAxis(node, axes.empty() ? nullptr : &axes.back());
      const std::size_t before = axes.size();
      for (Body& body : described.bodies) {
        body.frame = !described.axis.carriesRobot ? cell_.axisFrame(before)
                     : before > 0                 ? cell_.axisFrame(before - 1)
                                                  : 0;
        axisBodies_.push_back(std::move(body));
      }
      cell_.axesUnderRobot_ += described.axis.carriesRobot ? 1 : 0;
      cell_.limits_.push_back(described.axis.limits);
      axes.push_back(std::move(described.axis));
    }
    if (cell_.dof() > JointVector::MaxRowsAtCompileTime)
      top_.at("externalAxes")
          .fail(
              base::message("too many: robot and external axes together may have {most} axes"_text,
                            static_cast<int>(JointVector::MaxRowsAtCompileTime)));
  }

  void nameUnits() {
    const std::vector<ExternalAxis>& axes = cell_.externalAxes_;
    if (!axes.empty())
      cell_.externalUnit_ = axes.back().name;
    if (top_.has("externalUnit"))
      cell_.externalUnit_ = top_.at("externalUnit").text();
    if (cell_.axesUnderRobot_ > 0)
      cell_.robotUnit_ =
          cell_.axesMovePlatform() ? axes[cell_.axesUnderRobot_ - 1].name : cell_.externalUnit_;
  }

  void readRodOf(const base::JsonNode& platform, const platform::PlatformSolid& solid) {
    if (platform.has("rod")) {
      platform.allowOnly({"mount", "pose", "rod"});
      cell_.rod_ = readRod(platform.at("rod"));
    } else {
      platform.allowOnly({"mount", "pose", "thicknessMm", "stem", "plates"});
    }
    if (solid.rod && !cell_.rod_)
      throw base::Error(base::ErrorCode::UnusableInput,
                        base::message("cell {id} has no rod to print on"_text, cell_.id_), {},
                        "choose a cell with a rod: `--cell lathe`"_text);
  }

  void readMounts(const base::JsonNode& nozzle, const base::JsonNode& platform) {
    cell_.nozzleMount_ = readMount(nozzle.at("mount"));
    if (readMount(platform.at("mount")) == cell_.nozzleMount_)
      platform.at("mount").fail(
          "must differ from the nozzle's: one of them moves, the other is fixed"_text);
  }

  void readCarried() {
    cell_.carriedIsAssumed_ = !top_.has("carriedKg");
    cell_.carriedKg_ = top_.has("carriedKg") ? top_.at("carriedKg").notNegative()
                       : plateMoves()        ? kPlateKg
                                             : kHeadKg;
  }

  void readPoses(const base::JsonNode& nozzle, const base::JsonNode& platform) {
    if (plateMoves() && cell_.rod_)
      platform.at("mount").fail("must be world: a rod is held at both ends"_text);
    if (plateMoves() && !cell_.externalAxes_.empty())
      top_.at("externalAxes").fail("must be empty: the plate is on the flange"_text);
    cell_.flange_T_moved_ = readPose((plateMoves() ? platform : nozzle).at("pose"));
    cell_.base_T_fixed_ = readPose((plateMoves() ? nozzle : platform).at("pose"));
    if (!cell_.externalAxes_.empty()) {
      cell_.axis_T_work_ = cell_.externalAxes_.back().axis_T_moved * cell_.base_T_fixed_;
      cell_.base_T_fixed_ = cell_.base_T_work(JointVector::Zero(cell_.dof()));
    }
    if (cell_.rod_)
      requireTurnsRod(top_.at("externalAxes"), cell_.externalAxes_, cell_.axis_T_work_);
  }

  // They come first: pairs in a robot's file are indices of its links.
  void addLinks() { cell_.bodies_ = cell_.robot().links; }

  void addHead(const base::JsonNode& nozzle) {
    cell_.bodies_.push_back(headBody(head_, cell_.toolFrame()));
    if (nozzle.has("holder"))
      cell_.bodies_.push_back(
          {"holder", BodyRole::Holder, cell_.toolFrame(), readShapes(nozzle.at("holder"))});
  }

  void addPlatform(const base::JsonNode& platform, platform::PlatformSolid solid) {
    if (cell_.rod_) {
      cell_.bodies_.push_back(rodBody(*cell_.rod_, solid.rod, cell_.id_, cell_.workFrame()));
      return;
    }
    if (platform.has("plates"))
      for (const base::JsonNode& plate : platform.at("plates").items())
        cell_.plates_.push_back(plate.text());
    cell_.bodies_.push_back(plateBody(platform, std::move(solid.polygon), cell_.workFrame()));
  }

  bool isTaken(const std::string& name) const {
    return std::any_of(cell_.bodies_.begin(), cell_.bodies_.end(),
                       [&](const Body& other) { return other.name == name; });
  }

  void addAxisBodies() {
    for (Body& body : axisBodies_) {
      if (isTaken(body.name))
        top_.at("externalAxes")
            .fail(base::message("has a name that is already used: '{name}'"_text, body.name));
      cell_.bodies_.push_back(std::move(body));
    }
  }

  void addObstacles() {
    for (const base::JsonNode& obstacle : top_.at("obstacles").items()) {
      obstacle.allowOnly({"name", "pose", "shapes"});
      const std::string name = obstacle.at("name").text();
      if (isTaken(name))
        obstacle.at("name").fail(base::message("is already used: '{name}'"_text, name));
      Body body{name, BodyRole::Obstacle, cell_.worldFrame(), readShapes(obstacle.at("shapes"))};
      if (obstacle.has("pose"))
        for (Shape& shape : body.shapes)
          shape = moved(std::move(shape), readPose(obstacle.at("pose")));
      cell_.bodies_.push_back(std::move(body));
    }
  }

  // The joints of the first arm, within their limits.
  JointVector readJoints(const base::JsonNode& list) const {
    const Arm& arm = cell_.arms_.front();
    const std::vector<base::JsonNode> values = list.items();
    if (static_cast<int>(values.size()) != arm.jointCount())
      list.fail(base::message("must have {wanted} joints, has {found}"_text, arm.jointCount(),
                              values.size()));
    JointVector joints = JointVector::Zero(arm.jointCount());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const JointLimits& limit = arm.robot.limits[i];
      const double q = ofShownValue(limit.kind, values[i].number());
      if (q < limit.min || q > limit.max)
        values[i].fail("is outside the joint's limits"_text);
      joints[static_cast<Eigen::Index>(i)] = q;
    }
    return joints;
  }

  void readHome() { cell_.arms_.front().home = readJoints(top_.at("homeDeg")); }

  void readToolChange() {
    if (!top_.has("toolChange"))
      return;
    const base::JsonNode change = top_.at("toolChange");
    change.allowOnly({"by", "docks"});
    const std::string by = change.at("by").text();
    using By = ToolChange::By;
    ToolChange& out = cell_.toolChange_;
    if (by == "hand" || by == "feeder")
      out.by = by == "hand" ? By::Hand : By::Feeder;
    else if (by == "changer")
      out.by = By::Changer;
    else
      change.at("by").fail("must be hand, feeder or changer"_text);
    if (out.by != By::Changer) {
      if (change.has("docks"))
        change.at("docks").fail("are those of a changer"_text);
      return;
    }
    if (plateMoves())
      change.at("by").fail("cannot be changer: the nozzle does not move"_text);
    for (const base::JsonNode& dock : change.at("docks").items()) {
      dock.allowOnly({"beforeDeg", "inDeg"});
      out.docks.push_back({readJoints(dock.at("beforeDeg")), readJoints(dock.at("inDeg"))});
    }
  }

  void readPurgePlace() {
    if (!top_.has("purgeMm"))
      return;
    if (plateMoves())
      top_.at("purgeMm").fail("the nozzle does not move"_text);
    cell_.purgePlaceMm_ = readVector3(top_.at("purgeMm"));
  }

  void readTravelAcceleration() {
    double maximum = INFINITY;
    for (const JointLimits& limit : cell_.robot().limits)
      maximum = std::min(maximum, asAngle(limit.kind, limit.acceleration));
    const char* travel = "travelAccelerationDegPerS2";
    const double travelDeg = top_.has(travel) ? top_.at(travel).positive() : kTravelDegPerS2;
    if (top_.has(travel) && base::degreesToRadians(travelDeg) > maximum * (1.0 + 1e-9))
      top_.at(travel).fail("exceeds the limit of a joint of the robot"_text);
    cell_.travelAcceleration_ = std::min(maximum, base::degreesToRadians(travelDeg));
  }

  void findPairs() {
    std::vector<std::pair<int, int>> never = cell_.robot().neverMeet;
    if (top_.has("neverMeet"))
      for (const auto& pair : readBodyPairs(top_.at("neverMeet"), cell_.bodies_))
        never.push_back(pair);
    const RigidGroups groups{cell_.armDof(), static_cast<int>(cell_.externalAxes_.size()),
                             plateMoves()};
    cell_.checkedPairs_ = robot::checkedPairs(cell_.bodies_, groups, never);
    cell_.bodiesAgainstPart_ = bodiesMovingAgainst(cell_.workFrame(), cell_.bodies_, groups);
  }

  const base::JsonNode& top_;
  const process::HeadShape& head_;
  Cell cell_;
  std::vector<Body> axisBodies_;
};

Cell Cell::read(const std::filesystem::path& file, const process::Process& process,
                platform::PlatformSolid solid) {
  return readText(base::readFile(file), file, process, std::move(solid));
}

Cell Cell::readText(const std::string& text, const std::filesystem::path& file,
                    const process::Process& process, platform::PlatformSolid solid) {
  const base::JsonNode top = base::JsonNode::parse(text, file.string());
  return read(top, file, readRobotOf(top.at("robot")), process, std::move(solid));
}

Cell Cell::read(std::string_view text, const std::filesystem::path& name, RobotModel robot,
                const process::Process& process, platform::PlatformSolid solid) {
  return read(base::JsonNode::parse(text, name.string()), name, std::move(robot), process,
              std::move(solid));
}

Cell Cell::read(const base::JsonNode& top, const std::filesystem::path& file, RobotModel robot,
                const process::Process& process, platform::PlatformSolid solid) {
  return Reader(top, process.head).read(file.stem().string(), std::move(robot), std::move(solid));
}

} // namespace voluta::robot
