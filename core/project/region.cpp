#include "project/region.h"

#include "base/key_text.h"
#include "project/content_hash.h"

namespace voluta::project {

std::string keyOf(const Region& region) {
  std::string key = base::keyText(region.shape, region.use,
                                  region.mesh ? contentHash(*region.mesh) : std::string());
  for (const auto& [name, value] : region.parameters)
    key += base::keyText(name, value);
  return key;
}

bool operator==(const Region& a, const Region& b) {
  return a.name == b.name && keyOf(a) == keyOf(b);
}

} // namespace voluta::project
