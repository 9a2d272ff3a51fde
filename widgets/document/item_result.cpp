#include "document/item_result.h"

namespace voluta::document {

pipeline::PlanResult onlyItem(const pipeline::PlanResult& plan, std::size_t item) {
  pipeline::PlanResult one = plan;
  one.items = {plan.item(item)};
  one.job.choices = project::onlyItem(plan.job.choices, item);
  one.job.items = {plan.job.item(item)};
  one.job.report.items = {plan.job.report.item(item)};
  return one;
}

} // namespace voluta::document
