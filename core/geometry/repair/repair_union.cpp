#include "geometry/append_mesh.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/mesh_boolean.h"
#include "geometry/repair/orientation.h"
#include "geometry/repair/repair_steps.h"

namespace voluta::geometry {

std::size_t uniteComponents(TriangleMesh& mesh, const std::vector<std::pair<int, int>>& pairs,
                            const base::RunContext& ctx) {
  const Components parts = components(mesh);
  const std::vector<bool> closed = closedComponents(mesh, parts);
  const auto count = static_cast<std::size_t>(parts.count);
  const auto partOf = [&](int t) { return parts.ofTriangle[static_cast<std::size_t>(t)]; };
  std::vector<bool> cutsItself(count, false);
  for (const auto& [a, b] : pairs)
    if (partOf(a) == partOf(b))
      cutsItself[static_cast<std::size_t>(partOf(a))] = true;
  std::vector<TriangleMesh> shells(count);
  std::vector<bool> fit(count, false);
  for (std::size_t c = 0; c < count; ++c) {
    ctx.checkpoint();
    std::vector<bool> keep(mesh.triangles.size());
    for (std::size_t t = 0; t < keep.size(); ++t)
      keep[t] = parts.ofTriangle[t] == static_cast<int>(c);
    shells[c] = subMesh(mesh, keep);
    fit[c] = closed[c] && !cutsItself[c] && volume(shells[c]) > 0.0;
  }
  UnionFind groups(count);
  for (const auto& [a, b] : pairs)
    if (partOf(a) != partOf(b) && fit[static_cast<std::size_t>(partOf(a))] &&
        fit[static_cast<std::size_t>(partOf(b))])
      groups.join(partOf(a), partOf(b));

  TriangleMesh result;
  std::size_t united = 0;
  for (std::size_t root = 0; root < count; ++root) {
    if (groups.find(static_cast<int>(root)) != static_cast<int>(root))
      continue;
    TriangleMesh sum = shells[root];
    std::size_t members = 1;
    std::vector<const TriangleMesh*> apart;
    for (std::size_t c = root + 1; c < count; ++c) {
      if (groups.find(static_cast<int>(c)) != static_cast<int>(root))
        continue;
      ctx.checkpoint();
      if (auto both = meshBoolean(BooleanOperation::Union, sum, shells[c], false)) {
        sum = std::move(*both);
        ++members;
      } else {
        apart.push_back(&shells[c]);
      }
    }
    appendMesh(result, sum);
    for (const TriangleMesh* shell : apart)
      appendMesh(result, *shell);
    united += members > 1 ? members : 0;
  }
  if (united > 0)
    mesh = std::move(result);
  return united;
}

} // namespace voluta::geometry
