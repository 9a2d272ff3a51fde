#include "motion/refusal_findings.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace voluta::motion {

namespace {

constexpr std::size_t kMostFindings = 100;

const plan::ToolPath* pathOf(const plan::ToolPlan& plan, std::size_t waypoint) {
  const auto after =
      std::upper_bound(plan.paths.begin(), plan.paths.end(), waypoint,
                       [](std::size_t w, const plan::ToolPath& p) { return w < p.first; });
  return after == plan.paths.begin() ? nullptr : &*(after - 1);
}

std::string kindOf(Refusal why) {
  switch (why) {
  case Refusal::Unreachable:
    return "unreachable";
  case Refusal::NoConnection:
    return "unconnected";
  case Refusal::BeyondRod:
    return "beyondRod";
  default:
    return "collision";
  }
}

std::string reasonOf(const Refused& r, const MotionScene& scene) {
  switch (r.why) {
  case Refusal::Unreachable:
    return "the robot cannot bring this place under the nozzle: out of reach, or beyond a joint's "
           "limits, however the part is turned about the nozzle";
  case Refusal::NoConnection:
    return "the robot can be here, but cannot come from or go on to a neighbouring place without "
           "lifting";
  case Refusal::HeadPart:
    return "the print head would cut into what is printed already";
  case Refusal::HeadPlatform:
    return "the print head would cut into the platform";
  case Refusal::BeyondRod:
    return fmt::format("the cell prints up to {:g} mm from the rod's axis and {:g} mm from its "
                       "middle",
                       scene.cell.rod()->printableRadiusMm, 0.5 * scene.cell.rod()->lengthMm);
  default:
    return fmt::format("{} would meet {}, however the part is turned about the nozzle",
                       scene.collision.nameOf(r.contact.first),
                       scene.collision.nameOf(r.contact.second));
  }
}

std::string remedyOf(Refusal why) {
  switch (why) {
  case Refusal::Unreachable:
    return "scale the part down (--scale fit), turn it, or use a larger robot";
  case Refusal::NoConnection:
    return "turn the part about the vertical, or try more turns (redundancySamples)";
  case Refusal::HeadPart:
    return "use a slimmer print head or thinner layers";
  case Refusal::HeadPlatform:
    return "use a smaller platform or place the part higher";
  case Refusal::BeyondRod:
    return "scale the part down, or move it along the rod";
  default:
    return "turn the part, use a smaller platform, or allow less clearance";
  }
}

} // namespace

std::string placeOf(const MotionScene& scene, std::size_t waypoint) {
  const Eigen::Vector3d& p = scene.plan.position[waypoint];
  const plan::ToolPath* path = pathOf(scene.plan, waypoint);
  return fmt::format("layer {}, x {:.1f} y {:.1f} z {:.1f}", path != nullptr ? path->layer : 0,
                     p.x(), p.y(), p.z());
}

plan::Findings findingsOf(const std::vector<Refused>& refused, const MotionScene& scene,
                          const std::function<double(std::size_t)>& whenS) {
  plan::Findings findings;
  std::map<Refusal, plan::Finding> rest;
  for (std::size_t b = 0, e = 0; b < refused.size(); b = e) {
    const Refused& r = refused[b];
    for (e = b + 1; e < refused.size() && refused[e].waypoint <= refused[e - 1].waypoint + 1 &&
                    refused[e].why == r.why && refused[e].contact.first == r.contact.first &&
                    refused[e].contact.second == r.contact.second;)
      ++e;
    plan::Finding finding;
    finding.stage = "motion";
    finding.kind = kindOf(r.why);
    finding.where = scene.plan.position[r.waypoint];
    finding.whenS = whenS(r.waypoint);
    finding.count = e - b;
    finding.reason = placeOf(scene, r.waypoint) + ": " + reasonOf(r, scene);
    finding.remedy = remedyOf(r.why);
    if (findings.size() < kMostFindings) {
      findings.push_back(finding);
      continue;
    }
    const auto [at, isNew] = rest.emplace(r.why, finding);
    if (isNew)
      at->second.reason = "and further places, the first at " + finding.reason;
    else
      at->second.count += finding.count;
  }
  for (const auto& [why, finding] : rest)
    findings.push_back(finding);
  return findings;
}

} // namespace voluta::motion
