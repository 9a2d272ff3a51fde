#include "toolpath/infill/regions.h"

namespace voluta::toolpath {

Regions regionsAbove(const PatchSurface& s, const std::vector<double>& values, double level) {
  Regions r;
  r.ofVertex.assign(s.position.size(), -1);
  std::vector<int> stack;
  for (std::size_t v = 0; v < s.position.size(); ++v) {
    if (r.ofVertex[v] >= 0 || !(values[v] >= level))
      continue;
    r.ofVertex[v] = r.count;
    stack.push_back(static_cast<int>(v));
    while (!stack.empty()) {
      const int u = stack.back();
      stack.pop_back();
      for (const int* t = s.ringBegin(u); t != s.ringEnd(u); ++t)
        for (const int w : s.triangles[static_cast<std::size_t>(*t)]) {
          const auto i = static_cast<std::size_t>(w);
          if (r.ofVertex[i] < 0 && values[i] >= level) {
            r.ofVertex[i] = r.count;
            stack.push_back(w);
          }
        }
    }
    ++r.count;
  }
  return r;
}

} // namespace voluta::toolpath
