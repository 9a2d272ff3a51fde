#include "modes/substrate_mode.h"

#include "base/error.h"
#include "base/far_places.h"
#include "base/files.h"
#include "base/number_list.h"
#include "base/stopwatch.h"
#include "geometry/convex_polygon.h"
#include "geometry/measures.h"
#include "modes/level_choices.h"
#include "modes/mode_stages.h"
#include "modes/platform_body.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/file_content.h"
#include "project/loaded_part.h"
#include "project/part_formats.h"
#include "project/platform_kinds.h"
#include "substrate/substrate_layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace voluta::modes {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;

// share of a layer's height; points up to that height count as on z = 0
constexpr double kContactShare = 0.5;

substrate::LevelShape shapeOf(const ModeChoices& in) {
  const std::string shape = in.values.text("layerShape");
  return shape == "sphere"     ? substrate::LevelShape::Sphere
         : shape == "cylinder" ? substrate::LevelShape::Cylinder
         : shape == "flatten"  ? substrate::LevelShape::Flatten
                               : substrate::LevelShape::Offset;
}

constexpr std::string_view kMeshPrefix = "mesh:";

// geometry::place puts the platform's body at its default placement; the part and an end surface
// move with it.
Eigen::Isometry3d motionToMiddle(const geometry::TriangleMesh& body, double scale) {
  return motionOf(body, scale, geometry::Placement{});
}

struct GroundPlan {
  project::Platform platform;
  double standsMm; // points up to this height count as on z = 0
};

GroundPlan groundPlan(const ModeChoices& in) {
  return {in.choices.item().platform, kContactShare * in.process.layerHeightMm};
}

// The parameter as typed. Its key contains the content of a named file instead of the name.
struct EndChoice {
  std::string text;
};

std::string keyOf(const EndChoice& end) {
  return end.text.starts_with(kMeshPrefix)
             ? keyOf(project::FileContent{end.text.substr(kMeshPrefix.size())})
             : end.text;
}

struct SurfacePlan {
  GroundPlan ground;
  double scale; // of the meshes in files; 0: to fit
  substrate::LevelOptions levels;
  substrate::LevelShape shape;
  std::string centre; // "x,y,z" [mm] or empty
  EndChoice end;
  substrate::OverhangRule overhang;
};

substrate::EndSurface endSurface(const SurfacePlan& plan) {
  const std::string& text = plan.end.text;
  substrate::EndSurface end;
  const auto fail = [&] {
    throw base::Error(base::ErrorCode::Usage,
                      base::message("`endSurface` '{text}' is not an end surface"_text, text), {},
                      "write flat, flat:Z, radius:R or mesh:FILE, in mm"_text);
  };
  const std::size_t colon = text.find(':');
  const std::string word = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  double number = 0.0;
  if (word == "flat" && colon != std::string::npos) {
    if (!base::readNumbers(rest, ',', {&number}))
      fail();
    base::refuseFar({&number, 1}, text, "endSurface"_name);
    end.heightMm = number;
  } else if (word == "radius") {
    if (!base::readNumbers(rest, ',', {&number}) || !(number > 0.0))
      fail();
    base::refuseFar({&number, 1}, text, "endSurface"_name);
    end.radiusMm = number;
  } else if (text.starts_with(kMeshPrefix) && !rest.empty()) {
    const auto file = project::loadPart(rest, true, {});
    const double scale = plan.scale;
    const auto body = platformBody(plan.ground.platform);
    if (!body)
      throw base::Error(base::ErrorCode::Usage,
                        "`endSurface` mesh:FILE requires a platform that is a body"_text, {},
                        base::message("give `--platform {platforms}`, or `endSurface` flat:Z"_text,
                                      project::platformForms({project::PlatformUse::Body})));
    end.mesh = std::make_shared<geometry::MeshQuery>(
        moved(*file->mesh, scale, motionToMiddle(*body, scale)));
  } else if (!text.empty() && text != "flat") {
    fail();
  }
  return end;
}

substrate::SubstrateOptions substrateOptions(const SurfacePlan& plan) {
  substrate::SubstrateOptions options;
  static_cast<substrate::LevelOptions&>(options) = plan.levels;
  options.shape = plan.shape;
  if (const std::string& text = plan.centre; !text.empty()) {
    Vector3d& c = options.centre.emplace();
    if (!base::readNumbers(text, ',', {&c.x(), &c.y(), &c.z()}))
      throw base::Error(
          base::ErrorCode::Usage,
          base::message("`layerCentre` '{text}' is not a point"_text, text.substr(0, 40)), {},
          "write x,y,z in mm"_text);
    base::refuseFar({c.data(), 3}, text, "layerCentre"_name);
  }
  options.end = endSurface(plan);
  return options;
}

struct PlacePlan {
  project::Platform platform; // a body determines the part's placement
  double bodyScale;
};

PlacePlan placePlan(const ModeChoices& in) {
  if (!in.choices.item().platform.isBody())
    return {{}, 1.0};
  return {in.choices.item().platform, project::parsedScale(in.choices.item().scale)};
}

geometry::Placement placeOnSurface(const PlacePlan& plan, const geometry::TriangleMesh& part,
                                   double scale) {
  const auto body = platformBody(plan.platform);
  return body ? placementBy(part, scale, motionToMiddle(*body, plan.bodyScale))
              : geometry::Placement{};
}

// Returns points that enclose the mesh's parts up to heightMm: vertices, and edges cut at that
// height.
std::vector<Vector2d> standing(const geometry::TriangleMesh& mesh, double heightMm) {
  std::vector<Vector2d> on;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vector3d &p = mesh.corner(t, k), &q = mesh.corner(t, (k + 1) % 3);
      if (p.z() <= heightMm)
        on.emplace_back(p.head<2>());
      if ((p.z() <= heightMm) != (q.z() <= heightMm)) {
        const double f = (heightMm - p.z()) / (q.z() - p.z());
        on.emplace_back((1.0 - f) * p.head<2>() + f * q.head<2>());
      }
    }
  return on;
}

platform::PlatformSolid platformOf(const GroundPlan& plan, const LoadStage& placed) {
  platform::PlatformSolid platform;
  if (const auto body = platformBody(plan.platform)) {
    const auto mesh = std::make_shared<geometry::TriangleMesh>(
        moved(*body, placed.scale, motionToMiddle(*body, placed.scale)));
    platform.polygon = geometry::convexPolygon(standing(*mesh, plan.standsMm));
    platform.mesh = mesh;
  } else {
    platform.polygon = plan.platform.plateAround(standing(*placed.part, plan.standsMm));
  }
  return platform;
}

substrate::GroundDistance groundOf(const platform::PlatformSolid& platform) {
  return platform.mesh ? substrate::distanceFrom(*platform.mesh) : substrate::plateGround();
}

SurfacePlan surfacePlan(const ModeChoices& in) {
  return {groundPlan(in),
          project::parsedScale(in.choices.item().scale),
          levelOptions(in),
          shapeOf(in),
          in.values.text("layerCentre"),
          {in.values.text("endSurface")},
          overhangRule(in)};
}

std::shared_ptr<const DecomposeStage>
decompose(const SurfacePlan& plan, const DecomposeInput& input, const base::RunContext& ctx) {
  const base::Stopwatch watch;
  ctx.report(0.0, "subtract the surface from the part"_text);
  auto stage = std::make_shared<DecomposeStage>();
  const substrate::SubstrateOptions options = substrateOptions(plan);
  stage->platform = platformOf(plan.ground, input.placed);
  project::ReducedPlatform less;
  if (stage->platform.mesh)
    less.part = std::make_shared<geometry::TriangleMesh>(
        substrate::partOnBody(*input.placed.part, *stage->platform.mesh));
  stage->result = less;
  const geometry::TriangleMesh& part = less.part ? *less.part : *input.placed.part;
  ctx.checkpoint();
  const substrate::LevelFamily family =
      substrate::substrateLevels(part, groundOf(stage->platform), options, ctx);
  const substrate::Overhang overhang =
      substrate::findOverhang(part, family.ground, family.outward, plan.overhang);
  reportLevels(plan.overhang, family.count, overhang, substrate::GroundKind::Surface, *stage);
  stage->timings.decompose = watch.seconds();
  return stage;
}

std::shared_ptr<const LayersStage> layersOf(const SurfacePlan& plan,
                                            const DecomposeStage& decomposed,
                                            const LayersInput& input, const base::RunContext& ctx) {
  const geometry::TriangleMesh& part = input.part;
  const base::Stopwatch watch;
  const substrate::SubstrateOptions options = substrateOptions(plan);
  const substrate::LevelFamily family =
      substrate::substrateLevels(part, groundOf(decomposed.platform), options, ctx.sub(0.0, 0.1));
  substrate::StackedLevels stacked =
      substrate::stackLevels(part, family, options, ctx.sub(0.1, 1.0));
  return layersStage(std::move(stacked), watch.seconds());
}

} // namespace

Mode substrateMode() {
  Mode mode{"substrate",
            "On a given surface"_text,
            {surfacePlan, decompose},
            {surfacePlan, layersOf},
            project::ResultKind::OnGround,
            {"layerShape", "layerCentre", "endSurface", "firstLayerMm", "overhangAngle"}};
  mode.platforms = {project::PlatformUse::Body, project::PlatformUse::Plate};
  mode.place = {placePlan, placeOnSurface};
  mode.platform = {groundPlan, platformOf};
  return mode;
}

base::ParameterTable substrateParameters() {
  return base::ParameterTable({
      base::choiceParameter("layerShape", "offset",
                            {{"offset", "offset"_text},
                             {"sphere", "sphere"_text},
                             {"cylinder", "cylinder"_text},
                             {"flatten", "flatten"_text}},
                            "Surface"_text, "layer shape"_text,
                            "Mode substrate: layers at constant distance from the "
                            "surface, on spheres, on cylinders along x, or flattening "
                            "from the surface to an end surface with varying thickness."_text,
                            true),
      base::textParameter(
          "layerCentre", "Surface"_text, "layer centre"_text,
          "Centre of spheres and cylinders: x,y,z in mm. Empty: that of the sphere or "
          "cylinder below the part, or a point below the part."_text),
      base::withFile(
          base::textParameter(
              "endSurface", "Surface"_text, "end surface"_text,
              "Surface on which flattening layers end: flat (at the part's top), flat:Z, "
              "radius:R (a larger cylinder) or mesh:FILE, placed together with the "
              "platform's mesh."_text),
          {project::filePatterns(project::NamedFiles::Meshes), "mesh:", nullptr}),
  });
}

} // namespace voluta::modes
