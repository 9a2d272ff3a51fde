#include "replay/limit_findings.h"

#include "plan/finding_kinds.h"

namespace voluta::replay {

using enum plan::FindingKind;

plan::Finding limitFinding(const LimitViolation& v, const robot::Cell& cell) {
  const robot::JointKind kind = v.joint >= 0 ? cell.limits()[static_cast<std::size_t>(v.joint)].kind
                                             : robot::JointKind::Turning;
  const bool slides = kind == robot::JointKind::Sliding;
  const auto place = [&](double value) {
    return base::Quantity{robot::shownValue(kind, value),
                          slides ? base::Unit::Mm : base::Unit::Degree};
  };
  const auto speed = [&](double value) {
    return base::Quantity{robot::shownValue(kind, value),
                          slides ? base::Unit::Mm : base::Unit::DegreePerS};
  };
  const int external = v.joint - cell.armDof();
  const base::Value joint =
      external < 0 ? base::Value(base::message("joint {number}"_text, v.joint + 1))
                   : base::Value(cell.externalAxes()[static_cast<std::size_t>(external)].name);
  switch (v.kind) {
  case LimitKind::OutOfReach:
    break;
  case LimitKind::JointRange:
    return plan::makeFinding(
        JointRange, {{"joint", joint}, {"angle", place(v.value)}, {"limit", place(v.limit)}});
  case LimitKind::JointSpeed:
    return plan::makeFinding(
        slides ? SlideSpeed : JointSpeed,
        {{"joint", joint}, {"speed", speed(v.value)}, {"limit", speed(v.limit)}});
  case LimitKind::BranchJump:
    return plan::makeFinding(BranchJump, {{"joint", joint}, {"angle", place(v.value)}});
  case LimitKind::BlendOverlap:
    return plan::makeFinding(BlendOverlap,
                             {{"blend", base::mm(v.value)}, {"way", base::mm(v.limit)}});
  case LimitKind::Flow:
    return plan::makeFinding(plan::FindingKind::Flow,
                             {{"flow", base::Quantity{v.value, base::Unit::Mm3PerS}},
                              {"limit", base::Quantity{v.limit, base::Unit::Mm3PerS}}});
  }
  return plan::makeFinding(OutOfReach);
}

} // namespace voluta::replay
