#include "pipeline/stage_context.h"

#include <algorithm>
#include <array>

namespace voluta::pipeline {

namespace {
// Where each stage ends in the time of a whole plan of a usual part.
constexpr std::array<double, project::kStageCount> kEnds{0.02, 0.14, 0.22, 0.44, 0.6, 1.0};
} // namespace

base::RunContext StageContext::span(project::Stage stage) const {
  const std::size_t s = project::indexOf(stage);
  const double all = kEnds[project::indexOf(until_)];
  return ctx_.sub((s > 0 ? kEnds[s - 1] : 0.0) / all, std::min(1.0, kEnds[s] / all));
}

bool StageContext::reject(project::Stage stage, const plan::Findings& findings) const {
  if (!trial_ || trial_->rejection)
    return isRejected();
  if (const auto blocking = std::ranges::find_if(findings, &plan::Finding::blocking);
      blocking != findings.end())
    trial_->rejection = {stage, *blocking};
  return isRejected();
}

} // namespace voluta::pipeline
