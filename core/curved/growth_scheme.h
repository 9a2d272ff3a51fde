// The chosen growth scheme.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voluta::curved {

struct GrowthRow;

class GrowthScheme {
public:
  GrowthScheme(); // Automatic
  // Throws Error{Usage} for an unknown id, naming the nearest.
  explicit GrowthScheme(std::string_view id);
  // Precondition: a row of growthRows().
  explicit GrowthScheme(const GrowthRow& row) : row_(&row) {}

  std::string id() const;
  const GrowthRow& row() const { return *row_; }

  friend bool operator==(const GrowthScheme&, const GrowthScheme&) = default;

private:
  const GrowthRow* row_;
};

// For base::keyText().
inline std::string keyOf(const GrowthScheme& scheme) {
  return scheme.id();
}

// Returns all schemes in display order.
std::vector<GrowthScheme> growthSchemes();

} // namespace voluta::curved
