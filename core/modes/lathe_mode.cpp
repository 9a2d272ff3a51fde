#include "modes/lathe_mode.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "geometry/measures.h"
#include "modes/cell_choice.h"
#include "modes/level_choices.h"
#include "modes/mode_stages.h"
#include "modes/platform_body.h"
#include "modes/rod_profile.h"
#include "plan/finding_kinds.h"
#include "robot/cell.h"
#include "substrate/lathe_layers.h"
#include "substrate/rod_axis.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace voluta::modes {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;

robot::CellRod cellRod(const ModeChoices& in) {
  const robot::Cell cell = cellOnAnyPlatform(in.choices, in.process);
  if (!cell.rod())
    throw base::Error(base::ErrorCode::Usage,
                      base::message("mode {mode} needs a rod, but cell {cell} has none"_text,
                                    in.choices.item().mode, base::dataName(in.choices.cell)),
                      {}, "give `--cell lathe`"_text);
  return *cell.rod();
}

// Extends the profile to the rod's ends, with the rod's own radius there.
std::vector<Vector2d> within(const platform::RodShape& rod, std::vector<Vector2d> profile) {
  const Vector2d first = rod.profile.front(), last = rod.profile.back();
  if (profile.front().x() > first.x()) {
    if (profile.front().y() != first.y())
      profile.insert(profile.begin(), {profile.front().x(), first.y()});
    profile.insert(profile.begin(), first);
  }
  if (profile.back().x() < last.x()) {
    if (profile.back().y() != last.y())
      profile.emplace_back(profile.back().x(), last.y());
    profile.push_back(last);
  }
  return profile;
}

// The chosen rod, and the dimensions of the cell's own rod.
struct RodPlan {
  project::Platform platform;
  int sides;
  std::string profile; // as returned by rodProfileText()
  std::string axis;    // of the part: "auto", "x", "y" or "z"
  double ownDiameterMm, ownLengthMm, printableRadiusMm;
};

RodPlan rodPlan(const ModeChoices& in) {
  const robot::CellRod own = cellRod(in);
  return {in.choices.item().platform,
          static_cast<int>(in.values.integer("rodSides")),
          rodProfileText(in.values.text("rodProfile")),
          in.values.text("rodAxis"),
          own.diameterMm,
          own.lengthMm,
          own.printableRadiusMm};
}

platform::RodShape rodShape(const RodPlan& plan) {
  platform::RodShape rod =
      plan.platform.rod(plan.sides)
          .value_or(platform::straightRod(plan.ownDiameterMm, plan.ownLengthMm, plan.sides));
  const std::vector<Vector2d> profile = rodProfile(plan.profile);
  if (!profile.empty())
    rod.profile = within(rod, profile);
  platform::checkRod(rod);
  return rod;
}

substrate::AxisFit axisOf(const geometry::TriangleMesh& mesh, const std::string& axis) {
  return axis == "auto" ? substrate::fitAxis(mesh)
                        : substrate::axisAlong(mesh, Vector3d::Unit(axis[0] - 'x'));
}

// Returns the motion that puts the platform's body onto the rod; its part moves with it.
Eigen::Isometry3d motionOntoRod(const geometry::TriangleMesh& body, double scale,
                                const std::string& axis) {
  return motionOf(body, scale, substrate::placementOnAxis(body, scale, axisOf(body, axis)));
}

struct PlacePlan {
  project::Platform platform; // a body determines the part's placement
  double bodyScale;
  std::string axis;
};

PlacePlan placePlan(const ModeChoices& in) {
  const bool body = in.choices.item().platform.isBody();
  return {body ? in.choices.item().platform : project::Platform(),
          body ? project::parsedScale(in.choices.item().scale) : 1.0, in.values.text("rodAxis")};
}

geometry::Placement placeOnRod(const PlacePlan& plan, const geometry::TriangleMesh& part,
                               double scale) {
  if (const auto body = platformBody(plan.platform))
    return placementBy(part, scale, motionOntoRod(*body, plan.bodyScale, plan.axis));
  return substrate::placementOnAxis(part, scale, axisOf(part, plan.axis));
}

// Returns the largest scale up to 1 at which the part stays within the cell's printable radius
// around its axis and within the rod's length.
double fittingScale(const RodPlan& plan, const geometry::TriangleMesh& part, double unitMm) {
  constexpr double kWithin = 1.0 - 1e-9; // margin for rounding errors
  const auto profile = rodShape(plan).profile;
  const double half = std::min(-profile.front().x(), profile.back().x());
  const geometry::TriangleMesh placed = geometry::place(
      part, unitMm, substrate::placementOnAxis(part, unitMm, axisOf(part, plan.axis)));
  double scale = 1.0;
  for (const Vector3d& p : placed.vertices)
    scale = std::min({scale, kWithin * plan.printableRadiusMm / p.tail<2>().norm(),
                      kWithin * half / std::abs(p.x())});
  return scale;
}

platform::PlatformSolid platformOf(const RodPlan& plan, const LoadStage& placed) {
  platform::PlatformSolid platform;
  platform.rod = rodShape(plan);
  if (const auto body = platformBody(plan.platform))
    platform.mesh = std::make_shared<geometry::TriangleMesh>(
        moved(*body, placed.scale, motionOntoRod(*body, placed.scale, plan.axis)));
  return platform;
}

substrate::RodSurface surfaceOf(const platform::PlatformSolid& platform) {
  return platform.mesh ? substrate::RodSurface(*platform.rod, platform.mesh)
                       : substrate::RodSurface(*platform.rod);
}

std::optional<plan::Finding> tooFarOut(const geometry::TriangleMesh& part,
                                       double printableRadiusMm) {
  Vector3d farthest = Vector3d::Zero();
  for (const Vector3d& p : part.vertices)
    if (p.tail<2>().norm() > farthest.tail<2>().norm())
      farthest = p;
  constexpr double kSlackMm = 1e-6;
  if (farthest.tail<2>().norm() <= printableRadiusMm + kSlackMm)
    return std::nullopt;
  return plan::makeFinding(
      plan::FindingKind::BeyondCell,
      {{"reach", base::mm(farthest.tail<2>().norm())}, {"limit", base::mm(printableRadiusMm)}},
      farthest);
}

struct LathePlan {
  RodPlan rod;
  substrate::LevelOptions levels;
  bool followsRod;
  substrate::OverhangRule overhang;

  substrate::LatheOptions options() const {
    substrate::LatheOptions options;
    static_cast<substrate::LevelOptions&>(options) = levels;
    options.followsRod = followsRod;
    return options;
  }
};

LathePlan lathePlan(const ModeChoices& in) {
  return {rodPlan(in), levelOptions(in), in.values.text("rodLayers") == "offset", overhangRule(in)};
}

std::shared_ptr<const DecomposeStage> decompose(const LathePlan& plan, const DecomposeInput& input,
                                                const base::RunContext& ctx) {
  const base::Stopwatch watch;
  ctx.report(0.0, "subtract the rod from the part"_text);
  auto stage = std::make_shared<DecomposeStage>();
  stage->platform = platformOf(plan.rod, input.placed);
  const substrate::RodSurface rod = surfaceOf(stage->platform);
  const auto left =
      std::make_shared<geometry::TriangleMesh>(substrate::partAroundRod(*input.placed.part, rod));
  stage->result = project::ReducedPlatform{left};
  ctx.checkpoint();
  const substrate::LatheOptions options = plan.options();
  const substrate::Overhang overhang = substrate::latheOverhang(*left, rod, options, plan.overhang);
  reportLevels(plan.overhang,
               static_cast<int>(substrate::latheBounds(*left, rod, options).size()) - 1, overhang,
               substrate::GroundKind::Rod, *stage);
  if (auto finding = tooFarOut(*left, plan.rod.printableRadiusMm))
    stage->findings.push_back(std::move(*finding));
  stage->timings.decompose = watch.seconds();
  return stage;
}

std::shared_ptr<const LayersStage> layersOf(const LathePlan& plan, const DecomposeStage& decomposed,
                                            const LayersInput& input, const base::RunContext& ctx) {
  const geometry::TriangleMesh& part = input.part;
  const base::Stopwatch watch;
  substrate::LatheLayers layers =
      substrate::latheLayers(part, surfaceOf(decomposed.platform), plan.options(), ctx);
  return layersStage(std::move(layers), watch.seconds());
}

} // namespace

Mode latheMode() {
  Mode mode{"lathe",
            "Around a rod"_text,
            {lathePlan, decompose},
            {lathePlan, layersOf},
            project::ResultKind::OnGround,
            {"rodAxis", "rodSides", "rodProfile", "rodLayers", "firstLayerMm", "overhangAngle"}};
  mode.platforms = {project::PlatformUse::Rod, project::PlatformUse::Body};
  mode.aroundRod = true;
  // Castelli 2020, 5.3.1: a rod 5 mm in diameter and 200 mm long, and a nozzle that prints 0.25 mm
  // layers on it.
  mode.usual = {"lathe", "fdm-0.35", project::Platform("rod:5x200")};
  mode.place = {placePlan, placeOnRod};
  mode.fittingScale = {rodPlan, fittingScale};
  mode.platform = {rodPlan, platformOf};
  mode.defaults = {{"infill", "woven"}};
  return mode;
}

base::ParameterTable latheParameters() {
  return base::ParameterTable({
      base::choiceParameter(
          "rodAxis", "auto",
          {{"auto", "auto"_text}, {"x", "x"_text}, {"y", "y"_text}, {"z", "z"_text}}, "Rod"_text,
          "part axis"_text,
          "The axis of the part that is aligned with the rod. auto: the axis parallel to "
          "its sides."_text,
          true),
      base::integerParameter("rodSides", 0, 0, 64, "Rod"_text, "rod sides"_text,
                             "0: round rod. 3 or more: prism; its diameter is measured "
                             "across the corners."_text,
                             true),
      base::withFile(
          base::textParameter(
              "rodProfile", "Rod"_text, "rod profile"_text,
              "Pairs of x and radius in mm, such as -20,2.5 0,2.5 0,3.5 20,3.5, or a file "
              "with such pairs. A step needs two pairs at the same x. Beyond the pairs the "
              "rod keeps its own diameter. Empty: straight."_text),
          {"*.txt *.csv *.dat", "", rodProfileText}),
      base::choiceParameter("rodLayers", "radius",
                            {{"radius", "radius"_text}, {"offset", "offset"_text}}, "Rod"_text,
                            "layers around the rod"_text,
                            "Layers at constant radius around the axis, or at constant "
                            "distance from the rod's profile."_text,
                            true),
      base::numberParameter("firstLayerMm", "mm", 0.0, 0.0, 100.0, "Layers"_text,
                            "first layer"_text,
                            "Height of the first layer; in all modes except curved. 0: "
                            "same as the other layers."_text),
  });
}

} // namespace voluta::modes
