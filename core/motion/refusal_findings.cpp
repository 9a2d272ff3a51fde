#include "motion/refusal_findings.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"

#include <map>

namespace voluta::motion {

namespace {

constexpr std::size_t kMaxFindings = 100;

plan::FindingKind kindOf(Refusal why) {
  using enum plan::FindingKind;
  switch (why) {
  case Refusal::Unreachable:
    return Unreachable;
  case Refusal::NoConnection:
    return Unconnected;
  case Refusal::CloserLook:
    return MeetsOnCloserLook;
  case Refusal::Leans:
    return StaysUpright;
  case Refusal::BeyondRod:
    return BeyondRod;
  case Refusal::HeadPart:
    return HeadInPart;
  case Refusal::HeadPlatform:
    return HeadInPlatform;
  default:
    return Collision;
  }
}

std::vector<plan::NamedValue> valuesOf(const Refused& r, const MotionScene& scene) {
  std::vector<plan::NamedValue> values{{"place", placeOf(scene, r.waypoint)}};
  if (r.why == Refusal::BeyondRod) {
    values.push_back({"radius", base::mm(scene.cell.rod()->printableRadiusMm)});
    values.push_back({"along", base::mm(0.5 * scene.cell.rod()->lengthMm)});
  } else if (kindOf(r.why) == plan::FindingKind::Collision) {
    values.push_back({"first", scene.collision.nameOf(r.contact.first)});
    values.push_back({"second", scene.collision.nameOf(r.contact.second)});
  }
  return values;
}

} // namespace

base::Message placeOf(const MotionScene& scene, std::size_t waypoint) {
  const Eigen::Vector3d& p = scene.plan.position[waypoint];
  const plan::ToolPath* path = plan::pathOf(scene.plan, waypoint);
  return base::message("layer {layer}, x {x:.1f} y {y:.1f} z {z:.1f}"_text,
                       path != nullptr ? path->layer : 0, base::number(p.x()), base::number(p.y()),
                       base::number(p.z()));
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
    const bool own = r.why != Refusal::Leans && findings.size() < kMaxFindings;
    const auto make = own || r.why == Refusal::Leans ? plan::makeFinding : plan::makeMoreFinding;
    plan::Finding finding =
        make(kindOf(r.why), valuesOf(r, scene), scene.plan.position[r.waypoint], e - b);
    finding.whenS = whenS(r.waypoint);
    if (own) {
      findings.push_back(std::move(finding));
      continue;
    }
    const auto [at, isNew] = rest.emplace(r.why, finding);
    if (!isNew)
      at->second.count += finding.count;
  }
  for (const auto& [why, finding] : rest)
    findings.push_back(finding);
  return findings;
}

} // namespace voluta::motion
