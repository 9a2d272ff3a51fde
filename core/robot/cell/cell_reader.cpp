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
//   homeDeg               list: the robot's joints in the home pose (sliding ones in mm), with the
//                         plate clear of the nozzle; external axes are then at 0
//   travelAccelerationDegPerS2  optional: of the arm's joints in travels with their load (of a
//                         sliding one as asTurn converts it), at most the values of the robot's
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

#include "base/files.h"
#include "base/json_node.h"
#include "robot/cell/json_pose.h"
#include "robot/cell/robot_reader.h"
#include "robot/cell/shape_reader.h"
#include "robot/plate.h"
#include "robot/shape/shape_moves.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace voluta::robot {

namespace {
constexpr double kTravelDegPerS2 = 80.0;
constexpr double kPlateKg = 0.5, kHeadKg = 1.0; // assumed

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

CellRod readRod(const base::JsonNode& node) {
  node.allowOnly({"diameterMm", "lengthMm", "printableRadiusMm"});
  const CellRod rod{node.at("diameterMm").positive(), node.at("lengthMm").positive(),
                    node.at("printableRadiusMm").positive()};
  if (rod.printableRadiusMm <= 0.5 * rod.diameterMm)
    node.at("printableRadiusMm").fail("must be greater than the rod's radius"_text);
  return rod;
}

// A rod is on the work frame's x and turns about it.
void requireTurnsRod(const base::JsonNode& axes, const std::vector<ExternalAxis>& chain,
                     const Eigen::Isometry3d& axis_T_work) {
  constexpr double kSame = 1e-9;
  if (chain.size() != 1 || chain.front().limits.kind != JointKind::Turning)
    axes.fail("must have exactly one axis, which turns the rod"_text);
  if ((axis_T_work.linear().col(0) - Eigen::Vector3d::UnitX()).norm() > kSame ||
      axis_T_work.translation().tail<2>().norm() > kSame)
    axes.fail("must turn the rod about its own axis, the work frame's x"_text);
}

// Returns the rod in the cell: the job's if it has one.
platform::RodShape rodOf(const CellRod& own, const std::optional<platform::RodShape>& wanted,
                         const std::string& cell) {
  constexpr double kSlackMm = 1e-9;
  if (!wanted)
    return platform::straightRod(own.diameterMm, own.lengthMm);
  platform::checkRod(*wanted);
  const double reach =
      std::max(-wanted->profile.front().x(), wanted->profile.back().x()) - kSlackMm;
  const auto refuse = [&](const base::Message& what, const base::Message& remedy) {
    return base::Error(base::ErrorCode::UnusableInput, what,
                       base::message("cell {cell}"_text, cell), remedy);
  };
  if (reach > 0.5 * own.lengthMm)
    throw refuse(
        base::message("the rod extends {reach} mm from its middle; the cell has room for {room} "
                      "mm"_text,
                      base::number(reach), base::number(0.5 * own.lengthMm)),
        "choose a shorter rod"_text);
  for (const Eigen::Vector2d& at : wanted->profile)
    if (at.y() > own.printableRadiusMm)
      throw refuse(
          base::message("the rod's radius is {radius} mm; the cell prints up to {most} mm"_text,
                        base::number(at.y()), base::number(own.printableRadiusMm)),
          "choose a thinner rod"_text);
  return *wanted;
}

// Replaces a prism by the round rod through its vertices. A step of the radius needs no frustum.
Body rodBody(const platform::RodShape& rod, int workFrame) {
  Body body{"platform", BodyRole::Platform, workFrame, {}};
  for (std::size_t i = 1; i < rod.profile.size(); ++i) {
    const Eigen::Vector2d &a = rod.profile[i - 1], &b = rod.profile[i];
    if (b.x() - a.x() > kStepMm)
      body.shapes.push_back(
          Frustum{Eigen::Vector3d(a.x(), 0, 0), Eigen::Vector3d(b.x(), 0, 0), a.y(), b.y()});
  }
  return body;
}

void requireConvex(const std::vector<Eigen::Vector2d>& polygon) {
  base::require(polygon.size() >= 3, "a platform's polygon has three corners or more");
  const std::size_t n = polygon.size();
  double area = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
    const Eigen::Vector2d ab = b - a, bc = c - b;
    base::require(ab.x() * bc.y() - ab.y() * bc.x() >= -1e-9 * (1.0 + ab.norm() * bc.norm()),
                  "a platform's polygon is convex and counter-clockwise");
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  base::require(area > 0.0, "a platform's polygon has an area");
}

// Bodies with the same number never move relative to each other. Frames: base, links, flange, work,
// tool, the moving side of each external axis. `dof`: of the arm.
int rigidGroup(int frame, int dof, bool plateMoves, int axes) {
  if (frame > dof + 3)
    return frame - 3; // after the last link
  if (axes > 0 && frame == dof + 2)
    return dof + axes;
  if (frame == dof + 1 || frame == (plateMoves ? dof + 2 : dof + 3))
    return dof; // on the last link
  if (frame > dof)
    return 0; // fixed to the world
  return frame;
}

// Computes Cell::lastJointTurnsNozzle, with a tolerance because descriptions round right angles.
int turnOfNozzle(const RobotModel& robot, const JointVector& home,
                 const Eigen::Isometry3d& flange_T_tool) {
  constexpr double kTurn = 1.0, kNearMm = 0.05, kNear = 1e-4;
  const int last = robot.dof() - 1;
  if (robot.kinematics->kindOf(last) != JointKind::Turning)
    return 0;
  JointVector turned = home.head(robot.dof());
  const Eigen::Isometry3d from = robot.kinematics->flange(turned) * flange_T_tool;
  turned[last] += kTurn;
  const Eigen::Isometry3d move = from.inverse() * robot.kinematics->flange(turned) * flange_T_tool;
  for (const int sign : {1, -1})
    if (move.translation().norm() < kNearMm &&
        (move.linear() - Eigen::AngleAxisd(sign * kTurn, Eigen::Vector3d::UnitZ()).matrix())
                .norm() < kNear)
      return sign;
  return 0;
}

} // namespace

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
  top.allowOnly({"id", "label", "note", "robot", "nozzle", "platform", "obstacles", "homeDeg",
                 "travelAccelerationDegPerS2", "neverMeet", "externalAxes", "externalUnit",
                 "extruder", "carriedKg"});
  Cell cell;
  cell.id_ = top.at("id").text();
  if (cell.id_ != file.stem().string())
    top.at("id").fail(base::message("is '{id}', but the file is named '{file}'"_text, cell.id_,
                                    file.stem().string()));
  cell.label_ = top.at("label").text();
  if (top.has("note"))
    cell.note_ = top.at("note").text();
  if (top.has("extruder"))
    cell.extruder_ = top.at("extruder").text();
  cell.robot_ = std::move(robot);
  cell.limits_ = cell.robot_.limits;
  std::vector<Body> onAxes;
  for (const base::JsonNode& node : top.at("externalAxes").items()) {
    AxisDescription described =
        readExternalAxis(node, cell.externalAxes_.empty() ? nullptr : &cell.externalAxes_.back());
    const std::size_t before = cell.externalAxes_.size();
    for (Body& body : described.bodies) {
      body.frame = !described.axis.carriesRobot ? cell.axisFrame(before)
                   : before > 0                 ? cell.axisFrame(before - 1)
                                                : 0;
      onAxes.push_back(std::move(body));
    }
    cell.axesUnderRobot_ += described.axis.carriesRobot ? 1 : 0;
    cell.limits_.push_back(described.axis.limits);
    cell.externalAxes_.push_back(std::move(described.axis));
  }
  if (cell.dof() > JointVector::MaxRowsAtCompileTime)
    top.at("externalAxes")
        .fail(base::message("too many: robot and external axes together may have {most} axes"_text,
                            static_cast<int>(JointVector::MaxRowsAtCompileTime)));
  if (!cell.externalAxes_.empty())
    cell.externalUnit_ = cell.externalAxes_.back().name;
  if (top.has("externalUnit"))
    cell.externalUnit_ = top.at("externalUnit").text();
  if (cell.axesUnderRobot_ > 0)
    cell.robotUnit_ = cell.axesMovePlatform() ? cell.externalAxes_[cell.axesUnderRobot_ - 1].name
                                              : cell.externalUnit_;

  const base::JsonNode nozzle = top.at("nozzle"), platform = top.at("platform");
  nozzle.allowOnly({"mount", "pose", "holder"});
  if (platform.has("rod")) {
    platform.allowOnly({"mount", "pose", "rod"});
    cell.rod_ = readRod(platform.at("rod"));
  } else {
    platform.allowOnly({"mount", "pose", "thicknessMm", "stem", "plates"});
  }
  if (solid.rod && !cell.rod_)
    throw base::Error(base::ErrorCode::UnusableInput,
                      base::message("cell {id} has no rod to print on"_text, cell.id_), {},
                      "choose a cell with a rod: --cell lathe"_text);
  cell.nozzleMount_ = readMount(nozzle.at("mount"));
  if (readMount(platform.at("mount")) == cell.nozzleMount_)
    platform.at("mount").fail(
        "must differ from the nozzle's: one of them moves, the other is fixed"_text);
  const bool plateMoves = cell.nozzleMount_ == Mount::World;
  cell.carriedIsAssumed_ = !top.has("carriedKg");
  cell.carriedKg_ = top.has("carriedKg") ? top.at("carriedKg").notNegative()
                    : plateMoves         ? kPlateKg
                                         : kHeadKg;
  if (plateMoves && cell.rod_)
    platform.at("mount").fail("must be world: a rod is held at both ends"_text);
  if (plateMoves && !cell.externalAxes_.empty())
    top.at("externalAxes").fail("must be empty: the plate is on the flange"_text);
  cell.flange_T_moved_ = readPose((plateMoves ? platform : nozzle).at("pose"));
  cell.base_T_fixed_ = readPose((plateMoves ? nozzle : platform).at("pose"));
  if (!cell.externalAxes_.empty()) {
    cell.axis_T_work_ = cell.externalAxes_.back().axis_T_moved * cell.base_T_fixed_;
    cell.base_T_fixed_ = cell.base_T_work(JointVector::Zero(cell.dof()));
  }
  if (cell.rod_)
    requireTurnsRod(top.at("externalAxes"), cell.externalAxes_, cell.axis_T_work_);

  cell.bodies_ = cell.robot_.links;
  cell.bodies_.push_back(headBody(process.head, cell.toolFrame()));
  if (nozzle.has("holder"))
    cell.bodies_.push_back(
        {"holder", BodyRole::Holder, cell.toolFrame(), readShapes(nozzle.at("holder"))});
  if (cell.rod_) {
    cell.bodies_.push_back(rodBody(rodOf(*cell.rod_, solid.rod, cell.id_), cell.workFrame()));
  } else {
    requireConvex(solid.polygon);
    if (platform.has("plates"))
      for (const base::JsonNode& plate : platform.at("plates").items())
        cell.plates_.push_back(plate.text());
    Body plate{"platform", BodyRole::Platform, cell.workFrame(), {}};
    plate.shapes.push_back(
        Prism{std::move(solid.polygon), -platform.at("thicknessMm").positive(), 0.0});
    if (platform.has("stem"))
      for (Shape& shape : readShapes(platform.at("stem")))
        plate.shapes.push_back(std::move(shape));
    if (auto foot = footOf(std::get<Prism>(plate.shapes.front()), plate.shapes))
      plate.shapes.push_back(*std::move(foot));
    cell.bodies_.push_back(std::move(plate));
  }
  const auto isTaken = [&](const std::string& name) {
    return std::any_of(cell.bodies_.begin(), cell.bodies_.end(),
                       [&](const Body& other) { return other.name == name; });
  };
  for (Body& body : onAxes) {
    if (isTaken(body.name))
      top.at("externalAxes")
          .fail(base::message("has a name that is already used: '{name}'"_text, body.name));
    cell.bodies_.push_back(std::move(body));
  }
  for (const base::JsonNode& obstacle : top.at("obstacles").items()) {
    obstacle.allowOnly({"name", "pose", "shapes"});
    const std::string name = obstacle.at("name").text();
    if (isTaken(name))
      obstacle.at("name").fail(base::message("is already used: '{name}'"_text, name));
    Body body{name, BodyRole::Obstacle, cell.worldFrame(), readShapes(obstacle.at("shapes"))};
    if (obstacle.has("pose"))
      for (Shape& shape : body.shapes)
        shape = moved(std::move(shape), readPose(obstacle.at("pose")));
    cell.bodies_.push_back(std::move(body));
  }

  const std::vector<base::JsonNode> home = top.at("homeDeg").items();
  if (static_cast<int>(home.size()) != cell.armDof())
    top.at("homeDeg").fail(
        base::message("must have {wanted} joints, has {found}"_text, cell.armDof(), home.size()));
  cell.home_ = JointVector::Zero(cell.dof());
  for (std::size_t i = 0; i < home.size(); ++i) {
    const double q = ofShownValue(cell.robot_.limits[i].kind, home[i].number());
    if (q < cell.robot_.limits[i].min || q > cell.robot_.limits[i].max)
      home[i].fail("is outside the joint's limits"_text);
    cell.home_[static_cast<Eigen::Index>(i)] = q;
  }

  if (!plateMoves)
    cell.lastJointTurnsNozzle_ = turnOfNozzle(cell.robot_, cell.home_, cell.flange_T_moved_);

  double most = INFINITY;
  for (const JointLimits& limit : cell.robot_.limits)
    most = std::min(most, asTurn(limit.kind, limit.acceleration));
  const char* travel = "travelAccelerationDegPerS2";
  const double travelDeg = top.has(travel) ? top.at(travel).positive() : kTravelDegPerS2;
  if (top.has(travel) && base::degreesToRadians(travelDeg) > most * (1.0 + 1e-9))
    top.at(travel).fail("exceeds the limit of a joint of the robot"_text);
  cell.travelAcceleration_ = std::min(most, base::degreesToRadians(travelDeg));

  std::vector<std::pair<int, int>> never = cell.robot_.neverMeet; // links come first in bodies_
  if (top.has("neverMeet"))
    for (const auto& pair : readBodyPairs(top.at("neverMeet"), cell.bodies_))
      never.push_back(pair);
  const auto groupOf = [&](int body) {
    return rigidGroup(cell.bodies_[static_cast<std::size_t>(body)].frame, cell.armDof(), plateMoves,
                      static_cast<int>(cell.externalAxes_.size()));
  };
  const auto isLink = [&](int body) {
    return cell.bodies_[static_cast<std::size_t>(body)].role == BodyRole::Link;
  };
  const int count = static_cast<int>(cell.bodies_.size());
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b) {
      const int apart = std::abs(groupOf(a) - groupOf(b));
      const bool neighbours = apart == 1 && isLink(a) && isLink(b);
      if (apart == 0 || neighbours ||
          std::find(never.begin(), never.end(), std::pair(a, b)) != never.end())
        continue;
      cell.checkedPairs_.emplace_back(a, b);
    }
  const int partGroup = rigidGroup(cell.workFrame(), cell.armDof(), plateMoves,
                                   static_cast<int>(cell.externalAxes_.size()));
  for (int a = 0; a < count; ++a)
    if (groupOf(a) != partGroup)
      cell.bodiesAgainstPart_.push_back(a);
  return cell;
}

} // namespace voluta::robot
