#include "geometry/repair/repair.h"

#include "base/error.h"
#include "geometry/append_mesh.h"
#include "geometry/measures.h"
#include "geometry/repair/orientation.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/repair/self_intersections.h"
#include "geometry/repair/winding_union.h"

#include <algorithm>
#include <set>

namespace voluta::geometry {

namespace {

// With more intersecting pairs the union would take minutes: exact constructions manage some ten
// thousand pairs a second.
constexpr std::size_t kMaxPairs = 250'000;
// Rounding after a union can create new crossings, fewer in each round.
constexpr int kRounds = 5;

class Repair {
public:
  Repair(const TriangleMesh& mesh, Diagnosis found, OpenSurfaces how, const base::RunContext& ctx)
      : mesh_(mesh), found_(std::move(found)), how_(how), ctx_(ctx) {}

  RepairResult run() {
    mendConnections();
    ctx_.report(0.4, "repair: orientation"_text);
    mendOrientation();
    assessSheets();
    ctx_.report(0.5, "repair: holes"_text);
    mendHoles();
    noteSheets();
    flipShells();
    ctx_.report(0.7, "repair: self-intersections"_text);
    mendIntersections();
    if (keepsOpen())
      appendMesh(mesh_, sheets_);
    dropUnusedVertices(mesh_);
    if (mesh_.empty())
      throw base::Error(base::ErrorCode::UnusableInput,
                        "nothing is left: no triangle has area or encloses a volume"_text);
    ctx_.report(0.9, "repair: check"_text);
    RepairResult result{std::move(mesh_), std::move(notes_), {}, {}, std::move(found_), {}};
    // Of millions of crossings each count takes many seconds.
    const bool isAsFound = tooMany_ && result.repairs.empty();
    result.diagnosis = isAsFound ? result.found : diagnose(result.mesh, ctx_);
    if (keepsOpen()) {
      result.open = open_;
      result.remains = {open_.sentence()};
    } else {
      result.remains = result.diagnosis.sentences();
    }
    for (const std::optional<base::Message>& more : {lost_, tooMany_})
      if (more)
        result.remains.push_back(*more);
    return result;
  }

private:
  bool keepsOpen() const {
    return how_ == OpenSurfaces::Keep && (open_.hasOpenRims() || open_.isSheetModel());
  }

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
    if (open || found_.duplicateFaces.count > 0) {
      const std::size_t dropped = dropDuplicateFaces(mesh_, sheets_);
      note(dropped - sheets_.triangles.size(),
           "dropped {count} duplicate triangle|dropped {count} duplicate triangles"_plural);
    }
    if (open) {
      const std::size_t split = splitTJunctions(mesh_, 1e-5 * found_.boundsMm.diagonal().norm());
      note(split, "split edges at {count} T-junction|split edges at {count} T-junctions"_plural);
    }
    separateSheets(mesh_, sheets_);
  }

  void mendOrientation() {
    const std::size_t turned = orientConsistently(mesh_);
    note(turned, "flipped {count} triangle to match its neighbours|flipped {count} triangles "
                 "to match their neighbours"_plural);
    bool closed = true;
    for (const bool c : closedComponents(mesh_, components(mesh_)))
      closed = closed && c;
    if (!closed) {
      const std::size_t separated = separateNonManifold(mesh_);
      note(separated, "separated non-manifold edges at {count} point|"
                      "separated non-manifold edges at {count} points"_plural);
      separateSheets(mesh_, sheets_);
    }
  }

  void assessSheets() {
    open_.sheetTriangles = sheets_.triangles.size();
    const double sheets = area(sheets_), all = sheets + area(mesh_);
    open_.sheetShare = all > 0.0 ? sheets / all : 0.0;
  }

  // Known only after the rims were assessed as well.
  void noteSheets() {
    if (!keepsOpen())
      note(open_.sheetTriangles, "dropped {count} triangle of sheets without volume|"
                                 "dropped {count} triangles of sheets without volume"_plural);
  }

  void mendHoles() {
    const std::vector<RimCap> caps = rimCaps(mesh_, ctx_);
    double ending = 0.0, all = area(mesh_);
    for (const RimCap& cap : caps) {
      all += cap.areaMm2;
      ending += cap.endsSurface ? cap.areaMm2 : 0.0;
      if (cap.endsSurface)
        addRim(cap);
    }
    open_.capShare = all > 0.0 ? ending / all : 0.0;
    const bool keeps = how_ == OpenSurfaces::Keep && open_.hasOpenRims();
    std::vector<const RimCap*> closed;
    for (const RimCap& cap : caps)
      if (!cap.triangles.empty() && !(keeps && cap.endsSurface))
        closed.push_back(&cap);
    for (const RimCap* cap : closed)
      mesh_.triangles.insert(mesh_.triangles.end(), cap->triangles.begin(), cap->triangles.end());
    reportClosed(closed);
    ctx_.checkpoint();
  }

  Eigen::AlignedBox3d boxOf(const RimCap& cap) const {
    Eigen::AlignedBox3d box;
    for (const int v : cap.rim)
      box.extend(mesh_.vertices[static_cast<std::size_t>(v)]);
    return box;
  }
  // Returns the largest distance of a rim from the plane through its middle.
  double bulgeOf(const RimCap& cap) const {
    const auto at = [&](std::size_t i) -> const Eigen::Vector3d& {
      return mesh_.vertices[static_cast<std::size_t>(cap.rim[i % cap.rim.size()])];
    };
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), normal = middle;
    for (std::size_t i = 0; i < cap.rim.size(); ++i)
      middle += at(i) / static_cast<double>(cap.rim.size());
    for (std::size_t i = 0; i < cap.rim.size(); ++i)
      normal += (at(i) - middle).cross(at(i + 1) - middle);
    double bulge = 0.0;
    for (std::size_t i = 0; i < cap.rim.size(); ++i)
      bulge = std::max(bulge, std::abs((at(i) - middle).dot(normal.normalized())));
    return bulge;
  }
  void addRim(const RimCap& cap) {
    constexpr double kFlat = 0.01, kSmall = 0.1; // of the rim's width; of the whole mesh's
    const Eigen::AlignedBox3d box = boxOf(cap);
    const bool isPlain = bulgeOf(cap) <= kFlat * box.diagonal().norm() ||
                         box.diagonal().norm() <= kSmall * found_.boundsMm.diagonal().norm();
    open_.hasPlainRims = isPlain && (open_.rims == 0 || open_.hasPlainRims);
    ++open_.rims;
    if (const double width = box.diagonal().norm(); width > open_.widestMm) {
      open_.widestMm = width;
      open_.widestAt = box.center();
    }
  }

  void reportClosed(const std::vector<const RimCap*>& closed) {
    if (closed.empty())
      return;
    const RimCap& largest =
        **std::ranges::max_element(closed, {}, [](const RimCap* cap) { return cap->rim.size(); });
    const Eigen::Vector3d at = boxOf(largest).center();
    notes_.push_back(
        base::message("closed {count} hole, of {edges} edges at {at:.2f}|"
                      "closed {count} holes, the largest of {edges} edges at {at:.2f}"_plural,
                      closed.size(), largest.rim.size(), base::Point{at.x(), at.y(), at.z()}));
  }

  void flipShells() {
    const std::size_t shells = flipInsideOut(mesh_);
    note(shells,
         "flipped {count} inside-out component|flipped {count} inside-out components"_plural);
  }

  void mendIntersections() {
    if (found_.selfIntersections.count > kMaxPairs)
      return reportTooMany(found_.selfIntersections.count);
    auto [united, rest] = closedAndOpen();
    auto pairs = selfIntersections(united, ctx_);
    if (pairs.size() > kMaxPairs)
      return reportTooMany(pairs.size());
    if (pairs.empty())
      return;
    const std::size_t before = pairs.size();
    const auto [overlapping, cutThemselves] = involved(united, pairs);
    std::size_t left = before;
    for (int round = 0; round < kRounds && left > 0; ++round) {
      std::optional<WindingUnion> next = windingUnion(united, pairs, ctx_);
      if (!next)
        break;
      if (next->losesTooMuch()) { // the shape is in doubt
        reportLost(next->lostShare());
        break;
      }
      pairs = selfIntersections(next->mesh, ctx_);
      if (round > 0 && pairs.size() >= left)
        break;
      united = std::move(next->mesh);
      left = pairs.size();
    }
    if (left == before)
      return;
    mesh_ = std::move(united);
    appendMesh(mesh_, rest);
    note(overlapping,
         "merged {count} overlapping component|merged {count} overlapping components"_plural);
    note(cutThemselves, "removed the self-intersections of {count} component|removed the "
                        "self-intersections of {count} components"_plural);
  }

  void reportTooMany(std::size_t pairs) {
    tooMany_ = base::message(
        "too many intersecting triangles to unite them ({pairs} pairs, at most {most}): shells "
        "stay as they are, overlaps count as one solid when layers are made"_text,
        pairs, kMaxPairs);
  }

  void reportLost(double share) {
    lost_ =
        base::message("self-intersecting surface: {share:.3g} of the enclosed volume is inside out "
                      "and counts as outside"_text,
                      base::percent(100.0 * share));
  }

  std::pair<TriangleMesh, TriangleMesh> closedAndOpen() const {
    const Components parts = components(mesh_);
    const std::vector<bool> closed = closedComponents(mesh_, parts);
    std::vector<bool> isClosed(mesh_.triangles.size()), isOpen(mesh_.triangles.size());
    for (std::size_t t = 0; t < isClosed.size(); ++t) {
      isClosed[t] = closed[static_cast<std::size_t>(parts.ofTriangle[t])];
      isOpen[t] = !isClosed[t];
    }
    return {subMesh(mesh_, isClosed), subMesh(mesh_, isOpen)};
  }

  // Returns the numbers of components that intersect others, and of those that intersect
  // themselves.
  static std::pair<std::size_t, std::size_t>
  involved(const TriangleMesh& mesh, const std::vector<std::pair<int, int>>& pairs) {
    const Components parts = components(mesh);
    std::set<int> overlapping, cutThemselves;
    for (const auto& [a, b] : pairs) {
      const int partA = parts.ofTriangle[static_cast<std::size_t>(a)],
                partB = parts.ofTriangle[static_cast<std::size_t>(b)];
      if (partA == partB)
        cutThemselves.insert(partA);
      else
        overlapping.insert({partA, partB});
    }
    return {overlapping.size(), cutThemselves.size()};
  }

  TriangleMesh mesh_;
  TriangleMesh sheets_; // removed from the mesh
  Diagnosis found_;
  OpenSurfaces how_;
  const base::RunContext& ctx_;
  OpenSurface open_;
  std::vector<base::Message> notes_;
  std::optional<base::Message> lost_;    // volume that the union would have dropped
  std::optional<base::Message> tooMany_; // intersections
};

} // namespace

base::Message OpenSurface::sentence() const {
  if (isSheetModel())
    return base::message(
        "sheet model: {share:.3g} of the surface has no thickness, {triangles} triangles"_text,
        base::percent(100.0 * sheetShare), sheetTriangles);
  if (hasOpenRims())
    return base::message(
        "open surface: it ends at {rims} rim, {width:.3g} wide at {at:.1f}|"
        "open surface: it ends at {rims} rims, the widest {width:.3g} wide at {at:.1f}"_plural,
        rims, base::mm(widestMm), base::Point{widestAt.x(), widestAt.y(), widestAt.z()});
  return {};
}

RepairResult repair(const TriangleMesh& mesh, const base::RunContext& ctx, OpenSurfaces how) {
  ctx.report(0.0, "repair: diagnosis"_text);
  const Diagnosis found = diagnose(mesh, ctx);
  if (found.clean())
    return {mesh, {}, {}, found, found, {}};
  return Repair(mesh, found, how, ctx).run();
}

} // namespace voluta::geometry
