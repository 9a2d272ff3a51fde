#include "geometry/repair/repair.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/repair/orientation.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/repair/self_intersections.h"

#include <cmath>

namespace voluta::geometry {

namespace {

// What cutting out self-intersections may change the volume by.
constexpr double kVolumeChange = 0.05;

class Repair {
public:
  Repair(const TriangleMesh& mesh, Diagnosis found, const base::RunContext& ctx)
      : mesh_(mesh), found_(std::move(found)), ctx_(ctx) {}

  RepairResult run() {
    mendConnections();
    ctx_.report(0.4, "repair: orientation"_text);
    mendOrientation();
    ctx_.report(0.5, "repair: holes"_text);
    mendHoles();
    turnShells();
    ctx_.report(0.7, "repair: self-intersections"_text);
    mendIntersections();
    dropUnusedVertices(mesh_);
    if (mesh_.empty())
      throw base::Error(base::ErrorCode::UnusableInput, "no triangle with area is left"_text);
    ctx_.report(0.9, "repair: check"_text);
    RepairResult result{std::move(mesh_), std::move(notes_), {}, {}, std::move(found_)};
    result.diagnosis = diagnose(result.mesh, ctx_);
    result.remains = result.diagnosis.sentences();
    return result;
  }

private:
  void note(std::size_t count, base::Text what) {
    if (count > 0)
      notes_.emplace_back(what, std::vector<base::Value>{count});
    ctx_.checkpoint();
  }

  void mendConnections() {
    const bool open = found_.boundaryEdges.count > 0;
    if (open) {
      const std::size_t merged = mergeNearbyPoints(mesh_);
      note(merged, "merged {count} duplicate point|merged {count} duplicate points"_plural);
    }
    const std::size_t collapsed = dropCollapsedFaces(mesh_);
    note(collapsed, "dropped {count} triangle without area|"
                    "dropped {count} triangles without area"_plural);
    const std::size_t doubled = dropDuplicateFaces(mesh_);
    note(doubled, "dropped {count} duplicate triangle|dropped {count} duplicate triangles"_plural);
    if (open) {
      const std::size_t split = splitTJunctions(mesh_, 1e-5 * found_.boundsMm.diagonal().norm());
      note(split, "split edges at {count} T-junction|split edges at {count} T-junctions"_plural);
    }
    dropSheets();
  }

  void dropSheets() {
    const std::size_t loose = dropLooseSheets(mesh_);
    note(loose, "dropped {count} triangle of sheets without volume|"
                "dropped {count} triangles of sheets without volume"_plural);
  }

  void mendOrientation() {
    const std::size_t turned = orientConsistently(mesh_);
    note(turned, "turned {count} triangle to face as the others do|"
                 "turned {count} triangles to face as the others do"_plural);
    bool closed = true;
    for (const bool c : closedComponents(mesh_, components(mesh_)))
      closed = closed && c;
    if (!closed) {
      const std::size_t separated = separateNonManifold(mesh_);
      note(separated, "separated non-manifold edges at {count} point|"
                      "separated non-manifold edges at {count} points"_plural);
      dropSheets();
    }
  }

  void mendHoles() {
    const ClosedHoles holes = closeHoles(mesh_, ctx_);
    const Eigen::Vector3d& at = holes.largestAt;
    if (holes.count > 0)
      notes_.push_back(
          base::message("closed {count} hole, of {edges} edges at {at:.2f}|"
                        "closed {count} holes, the largest of {edges} edges at {at:.2f}"_plural,
                        holes.count, holes.largestEdges, base::Point{at.x(), at.y(), at.z()}));
    ctx_.checkpoint();
  }

  void turnShells() {
    const std::size_t shells = turnInsideOut(mesh_);
    note(shells, "turned {count} component that faced inside out|"
                 "turned {count} components that faced inside out"_plural);
  }

  void mendIntersections() {
    auto pairs = selfIntersections(mesh_, ctx_);
    if (pairs.empty())
      return;
    const std::size_t united = uniteComponents(mesh_, pairs, ctx_);
    if (united > 0) {
      note(united, "united {count} overlapping component|"
                   "united {count} overlapping components"_plural);
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
      notes_.push_back(base::message("cut out {removed} of {all} self-intersections"_text,
                                     pairs.size() - after.selfIntersections.count, pairs.size()));
      ctx_.checkpoint();
    }
  }

  TriangleMesh mesh_;
  Diagnosis found_;
  const base::RunContext& ctx_;
  std::vector<base::Message> notes_;
};

} // namespace

RepairResult repair(const TriangleMesh& mesh, const base::RunContext& ctx) {
  ctx.report(0.0, "repair: diagnosis"_text);
  const Diagnosis found = diagnose(mesh, ctx);
  if (found.clean())
    return {mesh, {}, {}, found, found};
  return Repair(mesh, found, ctx).run();
}

} // namespace voluta::geometry
