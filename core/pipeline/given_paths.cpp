#include "pipeline/given_paths.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "layers/layer_stack.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "process/process.h"
#include "process/tooling.h"
#include "project/loaded_part.h"
#include "sliced/sliced_reader.h"
#include "toolpath/path_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <span>
#include <utility>

namespace voluta::pipeline {

using Eigen::Vector3d;

namespace {

// Transform from the mesh's coordinates to the work frame.
struct WorkTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vector3d shift = Vector3d::Zero();
};

WorkTransform workTransformOf(const project::LoadedPart& loaded, const modes::LoadStage& placed) {
  WorkTransform transform;
  transform.rotation = placed.placement.rotation.normalized().toRotationMatrix();
  transform.shift = placed.part->vertices[0] - transform.rotation * loaded.mesh->vertices[0];
  // For a file in the work frame the remaining shift is only rounding error.
  if (transform.rotation.isIdentity(0.0) && transform.shift.cwiseAbs().maxCoeff() < 1e-9)
    transform.shift.setZero();
  return transform;
}

class Taking {
public:
  Taking(const plan::ToolPlan& given, const WorkTransform& transform,
         const process::Tooling& tooling)
      : given_(given), transform_(transform), tooling_(tooling) {}

  plan::ToolPlan take(const base::RunContext& ctx) {
    for (const plan::ToolPath& path : given_.paths) {
      ctx.checkpoint();
      plan::ToolPath mine = path;
      mine.first = plan_.waypointCount();
      takeTool(path, mine);
      for (std::size_t i = path.first; i < path.first + path.count; ++i) {
        if (i > path.first)
          divide(i);
        add(i, i, 0.0);
      }
      mine.count = plan_.waypointCount() - mine.first;
      plan_.paths.push_back(mine);
    }
    plan_.fill = given_.fill;
    slow();
    return std::move(plan_);
  }

  std::size_t filled = 0, slowed = 0; // Numbers of waypoints
  std::optional<Vector3d> fastestAt;  // Where the limit of the flow is exceeded most

private:
  void takeTool(const plan::ToolPath& path, plan::ToolPath& mine) {
    mine.tool = path.tool < static_cast<int>(tooling_.tools().size()) ? path.tool : 0;
    process_ = &tooling_.of(mine).process;
  }

  // Subdivides a long segment that ends at waypoint `i`. Segments up to 1.5 steps stay undivided.
  void divide(std::size_t i) {
    constexpr double kSlack = 1.5;
    const double length = (given_.position[i] - given_.position[i - 1]).norm();
    if (length <= kSlack * process_->stepMm)
      return;
    const auto steps = static_cast<int>(std::ceil(length / process_->stepMm));
    for (int k = 1; k < steps; ++k)
      add(i - 1, i, static_cast<double>(k) / steps);
  }

  void add(std::size_t a, std::size_t b, double t) {
    const auto at = [&](const std::vector<float>& v) {
      return static_cast<float>((1.0 - t) * v[a] + t * v[b]);
    };
    const Vector3d position = given_.position[a] + t * (given_.position[b] - given_.position[a]);
    const Vector3d direction = (1.0 - t) * given_.direction[a] + t * given_.direction[b];
    plan_.position.push_back(transform_.rotation * position + transform_.shift);
    plan_.direction.push_back(
        (transform_.rotation * (direction.norm() > 1e-6 ? direction : given_.direction[b]))
            .normalized());
    float width = at(given_.widthMm), height = at(given_.heightMm);
    float speed = given_.speedMmPerS[b];
    if (!(width > 0.0f) || !(height > 0.0f) || !(speed > 0.0f))
      ++filled;
    height = height > 0.0f ? height : static_cast<float>(process_->layerHeightMm);
    width = width > 0.0f ? width : static_cast<float>(process_->beadWidthMm);
    speed = speed > 0.0f ? speed : static_cast<float>(process_->speedMmPerS);
    // The bead model needs height <= width: use a square of equal area.
    if (height > width)
      height = width = std::sqrt(height * width);
    plan_.widthMm.push_back(width);
    plan_.heightMm.push_back(height);
    plan_.speedMmPerS.push_back(speed);
  }

  void slow() {
    const auto section = [&](std::size_t i) {
      return process::beadArea(plan_.widthMm[i], plan_.heightMm[i]);
    };
    for (const plan::ToolPath& path : plan_.paths)
      for (std::size_t i = path.first + 1;
           i < path.first + path.count && path.kind != plan::PathKind::Shot; ++i) {
        const double limit = process::flowLimit(tooling_.of(path).process) /
                             std::max({section(i - 1), section(i), 1e-9});
        const double excess = plan_.speedMmPerS[i] / limit;
        if (plan_.speedMmPerS[i] > limit) {
          plan_.speedMmPerS[i] = static_cast<float>(limit);
          ++slowed;
          if (excess > fastest_) {
            fastest_ = excess;
            fastestAt = plan_.position[i];
          }
        }
      }
  }

  const plan::ToolPlan& given_;
  const WorkTransform& transform_;
  const process::Tooling& tooling_;
  const process::Process* process_ = nullptr; // Of the path that is taken
  plan::ToolPlan plan_;
  double fastest_ = 0.0;
};

// Beads whose section the process does not allow.
struct OutsideLimits {
  double lengthMm = 0.0;
  double worst = 1.0;      // Ratio to the limit that is exceeded most; > 1
  std::size_t worstAt = 0; // Waypoint
  int tool = 0;            // That prints it
};

// Returns by which factor a section exceeds the limit that it exceeds most; <= 1: none.
double excessOf(const plan::ToolPlan& plan, std::size_t i, const process::Process& process) {
  const auto width = static_cast<double>(plan.widthMm[i]),
             height = static_cast<double>(plan.heightMm[i]);
  return std::max({width / process.beadWidthMaxMm, process.beadWidthMinMm / width,
                   height / process.layerHeightMaxMm, process.layerHeightMinMm / height});
}

OutsideLimits outsideLimits(const plan::ToolPlan& plan, const process::Tooling& tooling) {
  constexpr double kRounding = 1.01; // Amounts and heights have few decimals in files
  OutsideLimits out;
  for (const plan::ToolPath& path : plan.paths) {
    if (plan::isWaste(path.kind) || path.kind == plan::PathKind::Tape ||
        path.kind == plan::PathKind::Shot)
      continue;
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
      const double excess = excessOf(plan, i, tooling.of(path).process);
      if (excess <= kRounding)
        continue;
      out.lengthMm += (plan.position[i] - plan.position[i - 1]).norm();
      if (excess > out.worst) {
        out.worst = excess;
        out.worstAt = i;
        out.tool = path.tool;
      }
    }
  }
  return out;
}

plan::Finding limitFinding(const OutsideLimits& outside, const plan::ToolPlan& plan,
                           const process::Process& process) {
  return plan::makeFinding(
      plan::FindingKind::GivenOutsideLimits,
      {{"length", base::mm(outside.lengthMm)},
       {"process", process.id},
       {"widthMin", base::number(process.beadWidthMinMm)},
       {"widthMax", base::mm(process.beadWidthMaxMm)},
       {"heightMin", base::number(process.layerHeightMinMm)},
       {"heightMax", base::mm(process.layerHeightMaxMm)},
       {"width", base::mm(static_cast<double>(plan.widthMm[outside.worstAt]))},
       {"height", base::mm(static_cast<double>(plan.heightMm[outside.worstAt]))}},
      plan.position[outside.worstAt]);
}

} // namespace

bool takesGivenPaths(const project::LoadedPart& loaded, const base::ParameterValues& values) {
  return loaded.toolPaths && values.boolean("givenToolPaths");
}

project::Choices choicesForGivenPaths(project::Choices choices) {
  if (!choices.item().automatic)
    return choices;
  const std::vector<project::Choices> ways = automaticChoices(choices);
  const auto flat = std::find_if(ways.begin(), ways.end(), [](const project::Choices& strategy) {
    return strategy.item().mode == "flat";
  });
  project::Choices taken = flat == ways.end() ? ways.front() : *flat;
  taken.item().automatic = false;
  return taken;
}

std::optional<geometry::Placement> givenPlacement(const project::LoadedPart& loaded) {
  if (!loaded.inWorkFrame)
    return std::nullopt;
  const Eigen::AlignedBox3d box = geometry::bounds(*loaded.mesh);
  geometry::Placement placement;
  placement.centreMm = box.center().head<2>();
  placement.liftMm = box.min().z();
  return placement;
}

std::vector<base::Message> missingToolNotes(const plan::ToolPlan& given,
                                            const process::Tooling& tooling) {
  const std::size_t count = tooling.tools().size();
  std::set<int> missing;
  for (const plan::ToolPath& path : given.paths)
    if (path.tool >= static_cast<int>(count))
      missing.insert(path.tool);
  std::string names;
  for (const int tool : missing)
    names += (names.empty() ? "T" : ", T") + std::to_string(tool);
  if (names.empty())
    return {};
  return {base::Message(
      "the job has {count} tool: its first tool prints the file's beads of {tools}|"
      "the job has {count} tools: its first tool prints the file's beads of {tools}"_plural,
      std::vector<base::Value>{count, names})};
}

namespace {
using KindForGiven = std::pair<plan::FindingKind, plan::FindingKind>;

// Kinds with the same values.
constexpr std::array<KindForGiven, 6> withSameValues() {
  using enum plan::FindingKind;
  return {{{Uncovered, GivenUncovered},
           {Thin, GivenThin},
           {Overfill, GivenOverfill},
           {Mass, GivenMass},
           {Unsupported, GivenUnsupported},
           {LongBridge, GivenLongBridge}}};
}

// Kinds whose counterpart states their reason as a whole.
constexpr std::array<KindForGiven, 26> withSameReason() {
  using enum plan::FindingKind;
  return {{{TinyPart, GivenOddSize},
           {HugePart, GivenOddSize},
           {ThinPart, GivenThinPart},
           {ThinPartInReach, GivenThinPart},
           {LargerThanPlates, GivenTooLarge},
           {TooLarge, GivenUnreachable},
           {MuchOutOfReach, GivenUnreachable},
           {Unreachable, GivenUnreachable},
           {Unconnected, GivenUnreachable},
           {StaysUpright, GivenStaysUpright},
           {HeadInPart, GivenCollision},
           {HeadInPlatform, GivenCollision},
           {Collision, GivenCollision},
           {MeetsOnCloserLook, GivenCollision},
           {CollisionInMotion, GivenCollisionInMotion},
           {NoPathTo, GivenTransfer},
           {NoPathFrom, GivenTransfer},
           {LeftOut, GivenLeftOut},
           {ReplayedCollision, GivenReplayedCollision},
           {OutOfReach, GivenLimit},
           {JointRange, GivenLimit},
           {JointSpeed, GivenLimit},
           {SlideSpeed, GivenLimit},
           {BranchJump, GivenLimit},
           {BlendOverlap, GivenLimit},
           {Flow, GivenLimit}}};
}
constexpr auto kSameValues = withSameValues();
constexpr auto kSameReason = withSameReason();

std::optional<plan::FindingKind> otherKind(std::span<const KindForGiven> kinds,
                                           plan::FindingKind kind) {
  const auto row = std::ranges::find(kinds, kind, &KindForGiven::first);
  return row == kinds.end() ? std::nullopt : std::optional(row->second);
}
} // namespace

plan::FindingKind kindForGiven(plan::FindingKind kind) {
  return otherKind(kSameValues, kind).value_or(otherKind(kSameReason, kind).value_or(kind));
}

plan::Findings withRemediesForGiven(plan::Findings findings, const std::vector<bool>& isGiven) {
  const bool areAllGiven = std::ranges::all_of(isGiven, std::identity());
  for (plan::Finding& finding : findings) {
    if (finding.item < 0 ? !areAllGiven : !isGiven.at(static_cast<std::size_t>(finding.item)))
      continue;
    if (otherKind(kSameReason, finding.kind)) {
      finding.values = {{"reason", plan::factOf(finding)}};
      finding.more = false; // the reason says so
    }
    finding.kind = kindForGiven(finding.kind);
  }
  return findings;
}

plan::Findings amountFindings(const project::LoadedPart& loaded) {
  constexpr double kSameShare = 0.01;
  plan::Findings findings;
  for (const base::Message& note : loaded.readNotes) {
    if (note.text.english() != sliced::kAmountNote.english())
      continue;
    const auto amount = [&](std::size_t i) {
      const auto* quantity = std::get_if<base::Quantity>(&note.values.at(i).data());
      return quantity ? quantity->number : 0.0;
    };
    if (std::abs(amount(1) - amount(0)) > kSameShare * amount(0))
      findings.push_back(
          plan::makeFinding(plan::FindingKind::GivenAmountDiffers, {{"stated", note.values.at(0)},
                                                                    {"read", note.values.at(1)},
                                                                    {"line", note.values.at(2)}}));
  }
  return findings;
}

void requireOwnSize(const project::Choices& choices) {
  if (project::parsedScale(choices.item().scale) != 1.0 || choices.item().units != "mm")
    throw base::Error(base::ErrorCode::Usage, "the tool-paths of a file cannot be scaled"_text, {},
                      "leave scale and units as they are, or give `givenToolPaths=false`"_text);
}

std::shared_ptr<const modes::DecomposeStage>
onlyGround(const modes::DecomposeStage& made, std::shared_ptr<const geometry::TriangleMesh> body) {
  auto stage = std::make_shared<modes::DecomposeStage>();
  stage->platform = made.platform;
  if (body)
    stage->platform.mesh = std::move(body);
  stage->result = made.result;
  stage->timings = made.timings;
  return stage;
}

std::shared_ptr<const modes::LayersStage> layersOfGiven(const plan::ToolPlan& given) {
  auto stage = std::make_shared<modes::LayersStage>();
  std::set<int> layers;
  for (const plan::ToolPath& path : given.paths)
    layers.insert(path.layer);
  stage->layers = std::make_shared<layers::LayerStack>();
  stage->report.count = static_cast<int>(layers.size());
  return stage;
}

std::shared_ptr<const ToolpathStage> givenToolpathStage(const project::LoadedPart& loaded,
                                                        const modes::LoadStage& placed,
                                                        const process::Tooling& tooling,
                                                        const base::RunContext& ctx) {
  const base::Stopwatch watch;
  const process::Process& process = tooling.first().process;
  auto stage = std::make_shared<ToolpathStage>();
  const WorkTransform transform = workTransformOf(loaded, placed);
  Taking taking(*loaded.toolPaths, transform, tooling);
  stage->toolPlan = std::make_shared<plan::ToolPlan>(taking.take(ctx));
  toolpath::setPathFigures(*stage->toolPlan, 1, tooling, stage->report);
  stage->report.maxRotationDeg = toolpath::maxRotationDeg(*stage->toolPlan);
  if (taking.filled > 0)
    stage->findings.push_back(plan::makeFinding(
        plan::FindingKind::GivenWithoutSection,
        {{"points", taking.filled}, {"process", process.id}}, std::nullopt, taking.filled));
  if (taking.slowed > 0)
    stage->findings.push_back(plan::makeFinding(
        plan::FindingKind::GivenTooFast,
        {{"points", taking.slowed},
         {"limit", base::Quantity{process::flowLimit(process), base::Unit::Mm3PerS}}},
        taking.fastestAt, taking.slowed));
  const OutsideLimits outside = outsideLimits(*stage->toolPlan, tooling);
  if (outside.lengthMm > 0.0)
    stage->findings.push_back(
        limitFinding(outside, *stage->toolPlan, tooling.at(outside.tool).process));
  stage->timings.toolpath = watch.seconds();
  return stage;
}

} // namespace voluta::pipeline
