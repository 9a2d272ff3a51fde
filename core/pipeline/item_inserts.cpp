#include "pipeline/item_inserts.h"

#include "base/ascii_text.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "motion/layer_event_text.h"
#include "motion/layer_events.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace voluta::pipeline {

namespace {
using Eigen::Vector3d;

constexpr double kSlackMm = 0.05; // of places

plan::LayerEvent pauseOf(const PlacedInsert& insert, int item) {
  plan::LayerEvent pause;
  pause.item = item;
  pause.layer = insert.layer;
  if (insert.layer == 0)
    pause.heightMm = geometry::bounds(insert.body).max().z();
  pause.text = base::asciiText("Put in " + (insert.name.empty() ? "the insert" : insert.name))
                   .substr(0, motion::kOwnTextLength);
  return pause;
}

std::optional<motion::EventPlace> placeOf(const plan::ToolPlan& plan, const PlacedInsert& insert,
                                          int item) {
  const std::vector<motion::EventPlace> places = motion::eventPlaces(plan, {pauseOf(insert, item)});
  return places.empty() ? std::nullopt : std::optional(places.front());
}

// Where beads are, seen from a body.
class BeadsAround {
public:
  BeadsAround(const plan::ToolPlan& plan, const geometry::TriangleMesh& body)
      : plan_(plan), box_(geometry::bounds(body)), query_(body) {}

  // Returns the first waypoint whose bead is in the body, deeper than half its width or height.
  std::optional<std::size_t> firstWithin() const {
    for (std::size_t i = 0; i < plan_.waypointCount(); ++i) {
      const double deepMm = 0.5 * std::min(plan_.widthMm[i], plan_.heightMm[i]);
      if (const Vector3d middle = middleOf(i);
          box_.contains(middle) && query_.signedDistance(middle) < -deepMm)
        return i;
    }
    return std::nullopt;
  }

  // Returns the first waypoint before `end` whose bead is vertically above the body.
  std::optional<std::size_t> firstAbove(std::size_t end) const {
    for (std::size_t i = 0; i < end; ++i)
      if (const auto top = extreme(middleOf(i), true); top && middleOf(i).z() > *top)
        return i;
    return std::nullopt;
  }

  // Returns whether the body stands on the plate, or on a bead before `end`.
  bool isCarried(std::size_t end) const {
    constexpr double kOnMm = 0.5, kHeights = 2.0;
    if (box_.min().z() < kOnMm)
      return true;
    for (std::size_t i = 0; i < end; ++i) {
      const Vector3d middle = middleOf(i);
      const double reachMm = kHeights * static_cast<double>(plan_.heightMm[i]);
      const auto bottom = extreme(middle, false);
      if (bottom && middle.z() < *bottom && middle.z() > *bottom - reachMm)
        return true;
    }
    return false;
  }

private:
  Vector3d middleOf(std::size_t i) const {
    return plan_.position[i] - 0.5 * static_cast<double>(plan_.heightMm[i]) * plan_.direction[i];
  }
  // Returns the height of the highest or lowest point of the body on the vertical line through a
  // point.
  std::optional<double> extreme(const Vector3d& point, bool highest) const {
    if (!(point.head<2>().array() >= box_.min().head<2>().array()).all() ||
        !(point.head<2>().array() <= box_.max().head<2>().array()).all())
      return std::nullopt;
    const double top = box_.max().z() + 1.0, bottom = box_.min().z() - 1.0;
    const double from = highest ? top : bottom, to = highest ? bottom : top;
    const auto hit = query_.firstHit({point.x(), point.y(), from}, {point.x(), point.y(), to});
    return hit ? std::optional(from + hit->t * (to - from)) : std::nullopt;
  }

  const plan::ToolPlan& plan_;
  const Eigen::AlignedBox3d box_;
  const geometry::MeshQuery query_;
};

// How two bodies that are put in are to each other.
enum class Meeting { Apart, Touch, Overlap };
Meeting meetingOf(const PlacedInsert& insert, const PlacedInsert& other) {
  constexpr int kSamples = 16; // per axis
  const Eigen::AlignedBox3d own = geometry::bounds(insert.body), its = geometry::bounds(other.body);
  const Eigen::AlignedBox3d reach(its.min() - Vector3d::Constant(kSlackMm),
                                  its.max() + Vector3d::Constant(kSlackMm));
  if (!own.intersects(reach))
    return Meeting::Apart;
  const Eigen::AlignedBox3d shared = own.intersection(its);
  if (shared.isEmpty() || shared.sizes().minCoeff() < kSlackMm)
    return Meeting::Touch;
  const geometry::MeshQuery first(insert.body), second(other.body);
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j)
      for (int k = 0; k < kSamples; ++k) {
        const Eigen::Array3d at = (Eigen::Array3d(i, j, k) + 0.5) / kSamples;
        const Vector3d point = shared.min() + (at * shared.sizes().array()).matrix();
        if (first.inside(point) && second.inside(point))
          return Meeting::Overlap;
      }
  return Meeting::Touch;
}

std::string shownName(const PlacedInsert& insert) {
  return insert.name.empty() ? insert.shape : insert.name;
}

plan::Finding misplaced(const PlacedInsert& insert, const base::Message& reason,
                        const Vector3d& where, int item, bool blocking) {
  plan::Finding finding =
      plan::makeFinding(plan::FindingKind::InsertMisplaced,
                        {{"insert", shownName(insert)}, {"reason", reason}}, where);
  finding.blocking = blocking;
  finding.item = item;
  return finding;
}
} // namespace

std::vector<plan::LayerEvent> insertPauses(const plan::ToolPlan& plan,
                                           std::span<const PlacedInsert> inserts, int item) {
  std::vector<plan::LayerEvent> pauses;
  for (const PlacedInsert& insert : inserts)
    if (placeOf(plan, insert, item))
      pauses.push_back(pauseOf(insert, item));
  return pauses;
}

std::vector<plan::Insert> insertsAmong(const plan::ToolPlan& plan,
                                       std::span<const PlacedInsert> inserts, int item) {
  std::vector<plan::Insert> among;
  for (const PlacedInsert& insert : inserts)
    if (const auto place = placeOf(plan, insert, item))
      among.push_back({insert.name, item, plan.paths[place->path].layer,
                       std::make_shared<const geometry::TriangleMesh>(insert.body)});
  return among;
}

plan::Findings insertFindings(const plan::ToolPlan& plan, std::span<const PlacedInsert> inserts,
                              int item, bool isOnPlate) {
  plan::Findings findings;
  for (const PlacedInsert& insert : inserts) {
    const Eigen::AlignedBox3d box = geometry::bounds(insert.body);
    const Vector3d middle = box.center();
    if (isOnPlate && box.min().z() < -kSlackMm)
      findings.push_back(misplaced(insert, "it reaches below the plate"_text, middle, item, true));
    bool isOnOther = false;
    for (const PlacedInsert& other : inserts) {
      if (&other == &insert)
        continue;
      const Meeting meeting = meetingOf(insert, other);
      isOnOther = isOnOther || meeting == Meeting::Touch;
      if (meeting == Meeting::Overlap && &other < &insert)
        findings.push_back(
            misplaced(insert, base::message("it takes the place of {other}"_text, shownName(other)),
                      middle, item, true));
    }
    const auto place = placeOf(plan, insert, item);
    if (!place) {
      findings.push_back(
          misplaced(insert, "nothing is printed after it: the print does not pause for it"_text,
                    middle, item, true));
      continue;
    }
    const std::size_t first = plan.paths[place->path].first;
    if (box.sizes().z() < static_cast<double>(plan.heightMm[first]) - kSlackMm)
      findings.push_back(misplaced(insert,
                                   "it is thinner than a layer, which leaves no room for it"_text,
                                   middle, item, true));
    const BeadsAround beads(plan, insert.body);
    if (const auto above = beads.firstAbove(first))
      findings.push_back(misplaced(insert, "beads lie above its place before the print pauses"_text,
                                   plan.position[*above], item, true));
    if (const auto in = beads.firstWithin())
      findings.push_back(
          misplaced(insert, "beads lie in its place"_text, plan.position[*in], item, true));
    if (box.max().z() > plan.position[first].z())
      findings.push_back(misplaced(
          insert, "it stands above the first layer after it, so the head keeps away from it"_text,
          middle, item, false));
    if (!isOnOther && !beads.isCarried(first))
      findings.push_back(
          misplaced(insert, "nothing is below it when the print pauses"_text, middle, item, true));
  }
  return findings;
}

} // namespace voluta::pipeline
