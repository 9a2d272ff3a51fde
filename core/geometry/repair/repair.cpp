#include "geometry/repair/repair.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/repair/orientation.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/repair/self_intersections.h"

#include <cmath>
#include <fmt/format.h>

namespace voluta::geometry {

namespace {

// What cutting out self-intersections may change the volume by.
constexpr double kVolumeChange = 0.05;

std::string amount(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

class Repair {
public:
  Repair(const TriangleMesh& mesh, Diagnosis found, const base::RunContext& ctx)
      : mesh_(mesh), found_(std::move(found)), ctx_(ctx) {}

  RepairResult run() {
    mendConnections();
    ctx_.report(0.4, "repair: orientation");
    mendOrientation();
    ctx_.report(0.5, "repair: holes");
    mendHoles();
    turnShells();
    ctx_.report(0.7, "repair: self-intersections");
    mendIntersections();
    dropUnusedVertices(mesh_);
    if (mesh_.empty())
      throw base::Error(base::ErrorCode::UnusableInput, "no triangle with area is left");
    ctx_.report(0.9, "repair: check");
    RepairResult result{std::move(mesh_), std::move(notes_), {}, {}, std::move(found_)};
    result.diagnosis = diagnose(result.mesh, ctx_);
    result.remains = result.diagnosis.sentences();
    return result;
  }

private:
  void note(std::size_t count, const std::string& what) {
    if (count > 0)
      notes_.push_back(what);
    ctx_.checkpoint();
  }

  void mendConnections() {
    const bool open = found_.boundaryEdges.count > 0;
    if (open) {
      const std::size_t merged = mergeNearbyPoints(mesh_);
      note(merged, "merged " + amount(merged, "duplicate point", "duplicate points"));
    }
    const std::size_t collapsed = dropCollapsedFaces(mesh_);
    note(collapsed,
         "dropped " + amount(collapsed, "triangle without area", "triangles without area"));
    const std::size_t doubled = dropDuplicateFaces(mesh_);
    note(doubled, "dropped " + amount(doubled, "duplicate triangle", "duplicate triangles"));
    if (open) {
      const std::size_t split = splitTJunctions(mesh_, 1e-5 * found_.boundsMm.diagonal().norm());
      note(split, "split edges at " + amount(split, "T-junction", "T-junctions"));
    }
    dropSheets();
  }

  void dropSheets() {
    const std::size_t loose = dropLooseSheets(mesh_);
    note(loose, "dropped " + amount(loose, "triangle", "triangles") + " of sheets without volume");
  }

  void mendOrientation() {
    const std::size_t turned = orientConsistently(mesh_);
    note(turned, "turned " + amount(turned, "triangle", "triangles") + " to face as the others do");
    bool closed = true;
    for (const bool c : closedComponents(mesh_, components(mesh_)))
      closed = closed && c;
    if (!closed) {
      const std::size_t separated = separateNonManifold(mesh_);
      note(separated, "separated non-manifold edges at " + amount(separated, "point", "points"));
      dropSheets();
    }
  }

  void mendHoles() {
    const ClosedHoles holes = closeHoles(mesh_, ctx_);
    note(holes.count, fmt::format("closed {}, {} {} edges at ({:.2f}, {:.2f}, {:.2f})",
                                  amount(holes.count, "hole", "holes"),
                                  holes.count == 1 ? "of" : "the largest of", holes.largestEdges,
                                  holes.largestAt.x(), holes.largestAt.y(), holes.largestAt.z()));
  }

  void turnShells() {
    const std::size_t shells = turnInsideOut(mesh_);
    note(shells, "turned " + amount(shells, "component", "components") + " that faced inside out");
  }

  void mendIntersections() {
    auto pairs = selfIntersections(mesh_, ctx_);
    if (pairs.empty())
      return;
    const std::size_t united = uniteComponents(mesh_, pairs, ctx_);
    if (united > 0) {
      note(united, fmt::format("united {} overlapping components", united));
      pairs = selfIntersections(mesh_, ctx_);
      if (pairs.empty())
        return;
    }
    // Taken only where the outcome is closed, has fewer cuts and the same volume.
    TriangleMesh trial = mesh_;
    if (!removeSelfIntersections(trial, ctx_))
      return;
    closeHoles(trial, ctx_);
    const Diagnosis before = diagnose(mesh_, ctx_), after = diagnose(trial, ctx_);
    const bool sameVolume =
        std::abs(after.volumeMm3 - before.volumeMm3) <= kVolumeChange * std::abs(before.volumeMm3);
    if (after.watertight && sameVolume && after.selfIntersections.count < pairs.size()) {
      mesh_ = std::move(trial);
      note(1, fmt::format("cut out {} of {} self-intersections",
                          pairs.size() - after.selfIntersections.count, pairs.size()));
    }
  }

  TriangleMesh mesh_;
  Diagnosis found_;
  const base::RunContext& ctx_;
  std::vector<std::string> notes_;
};

} // namespace

RepairResult repair(const TriangleMesh& mesh, const base::RunContext& ctx) {
  ctx.report(0.0, "repair: diagnosis");
  const Diagnosis found = diagnose(mesh, ctx);
  if (found.clean())
    return {mesh, {}, {}, found, found};
  return Repair(mesh, found, ctx).run();
}

} // namespace voluta::geometry
