#include "project/region.h"

#include "base/key_text.h"
#include "project/content_hash.h"

#include <tuple>

namespace voluta::project {

std::string keyOf(const Region& region) {
  std::string key = base::keyText(region.shape, region.use,
                                  region.mesh ? contentHash(*region.mesh) : std::string());
  for (const auto& [name, value] : region.parameters)
    key += base::keyText(name, value);
  return key;
}

bool operator==(const Region& a, const Region& b) {
  const auto tied = [](const Region& r) { return std::tie(r.name, r.shape, r.use, r.parameters); };
  if (tied(a) != tied(b) || (a.mesh == nullptr) != (b.mesh == nullptr))
    return false;
  return a.mesh == b.mesh ||
         (a.mesh->vertices == b.mesh->vertices && a.mesh->triangles == b.mesh->triangles);
}

} // namespace voluta::project
