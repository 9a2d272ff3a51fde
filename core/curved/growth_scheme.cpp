#include "curved/growth_scheme.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "curved/growth_row.h"
#include "curved/growth_rows.h"

namespace voluta::curved {

namespace {
const GrowthRow& rowOf(std::string_view id) {
  std::vector<std::string> ids;
  for (const GrowthRow& row : growthRows()) {
    if (row.id == id)
      return row;
    ids.emplace_back(row.id);
  }
  const std::string asked(id);
  throw base::Error(base::ErrorCode::Usage, base::message("unknown growth '{name}'"_text, asked),
                    {}, base::didYouMean(asked, ids));
}
} // namespace

GrowthScheme::GrowthScheme() : row_(&growthRows().front()) {}

GrowthScheme::GrowthScheme(std::string_view id) : row_(&rowOf(id)) {}

std::string GrowthScheme::id() const {
  return std::string(row_->id);
}

std::vector<GrowthScheme> growthSchemes() {
  std::vector<GrowthScheme> all;
  for (const GrowthRow& row : growthRows())
    all.emplace_back(row);
  return all;
}

} // namespace voluta::curved
