#include "window/mesh_summary.h"

namespace voluta::window {

panels::MeshSummary meshSummary(const project::LoadedPart& part, double volumeMm3) {
  panels::MeshSummary summary;
  summary.name = part.name;
  summary.triangles = part.mesh->triangles.size();
  summary.volumeMm3 = volumeMm3;
  // A mesh repaired without remaining defects counts as watertight.
  summary.watertight = part.repair ? part.remains.empty() : part.found.watertight;
  summary.found = part.found.sentences();
  summary.repaired = part.repair ? part.notes : part.readNotes;
  if (!part.units.note.empty())
    summary.found.push_back(part.units.note);
  summary.remains = part.remains;
  return summary;
}

} // namespace voluta::window
