#include "cli/commands.h"
#include "cli/run_interruptibly.h"
#include "pipeline/automatic.h"
#include "pipeline/part_ways.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "project/turn_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace voluta::cli {

namespace {
using Json = nlohmann::ordered_json;

struct Found {
  std::shared_ptr<const modes::LoadStage> placed;
  std::vector<placement::StandingOrientation> ways;
  std::vector<double> seconds; // of each, estimated

  geometry::Placement placementOf(const placement::StandingOrientation& orientation) const {
    return pipeline::standing(orientation, placed->placement);
  }
  // A pose in which the part does not stand is not in the list.
  bool liesBadly() const {
    const auto now = std::ranges::find_if(ways, &placement::StandingOrientation::now);
    return !ways.empty() && (now == ways.end() || placement::liesBadly(*now, ways.front()));
  }
};

Found waysOf(const pipeline::PlanRequest& request, const base::RunContext& ctx) {
  const project::Choices manual = pipeline::resolved(request.choices);
  pipeline::checkChoices(manual);
  const pipeline::Resolved own = pipeline::resolve(manual);
  const auto loaded =
      project::loadPart(request.item().part, own.choices.item().repair, ctx.sub(0.0, 0.1));
  Found found;
  found.placed = pipeline::loadStage(*loaded, own, ctx.sub(0.1, 0.2));
  found.ways = pipeline::partWays(*found.placed, own, ctx.sub(0.2, 1.0));
  for (const placement::StandingOrientation& orientation : found.ways)
    found.seconds.push_back(pipeline::estimatedSeconds(orientation, own));
  return found;
}

Json jsonOf(const Found& found, const std::string& part) {
  Json ways = Json::array();
  for (std::size_t n = 0; n < found.ways.size(); ++n) {
    const placement::StandingOrientation& orientation = found.ways[n];
    const Eigen::Quaterniond rotation = found.placementOf(orientation).rotation;
    const Eigen::Vector3d degrees = project::rotationDegrees(rotation);
    ways.push_back({{"now", orientation.now},
                    {"turn", project::rotationText(rotation)},
                    {"turnDeg", {degrees.x(), degrees.y(), degrees.z()}},
                    {"quaternion", {rotation.w(), rotation.x(), rotation.y(), rotation.z()}},
                    {"contactMm2", orientation.score.contactMm2},
                    {"overhangMm2", orientation.score.riskyMm2},
                    {"heightMm", orientation.score.heightMm},
                    {"voxelMm", orientation.voxelMm},
                    {"voxels", orientation.voxels},
                    {"missedVoxels", orientation.missed},
                    {"estimatedS", found.seconds[n]}});
  }
  return {{"file", part},
          {"scale", found.placed->scale},
          {"liesBadly", found.liesBadly()},
          {"ways", std::move(ways)}};
}

void say(const Found& found) {
  if (found.ways.empty()) {
    fmt::print("no stable pose was found\n");
    return;
  }
  fmt::print("{:<24}{:>13}{:>14}{:>11}{:>22}{:>12}\n", "turn", "contact mm2", "overhang mm2",
             "height mm", "missed of voxels", "about min");
  for (std::size_t n = 0; n < found.ways.size(); ++n) {
    const placement::StandingOrientation& orientation = found.ways[n];
    fmt::print("{:<24}{:>13.0f}{:>14.0f}{:>11.1f}{:>22}{:>12.0f}{}\n",
               project::rotationText(found.placementOf(orientation).rotation),
               orientation.score.contactMm2, orientation.score.riskyMm2, orientation.score.heightMm,
               fmt::format("{} of {}", orientation.missed, orientation.voxels),
               found.seconds[n] / 60.0, orientation.now ? "  as it lies" : "");
  }
  if (found.liesBadly())
    fmt::print("poor orientation; to use the first one: plan PART --turn={}\n",
               project::rotationText(found.placementOf(found.ways.front()).rotation));
}

} // namespace

ExitCode orientCommand(const OrientOptions& options) {
  const auto found = endedWith(runInterruptibly(
      [request = options.request](const base::RunContext& ctx) { return waysOf(request, ctx); },
      options.threads, {}, [] {}));
  if (!found)
    return kCancelled;
  if (options.json)
    fmt::print("{}\n", jsonOf(*found, options.request.item().part)
                           .dump(2, ' ', false, Json::error_handler_t::replace));
  else
    say(*found);
  return kDone;
}

} // namespace voluta::cli
