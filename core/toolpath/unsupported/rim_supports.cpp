#include "toolpath/unsupported/rim_supports.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "geometry/convex_polygon.h"
#include "geometry/polyline.h"
#include "layers/layer_stack.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "platform/platform_solid.h"
#include "process/bead_model.h"
#include "toolpath/order/travel.h"
#include "toolpath/unsupported/bridges.h"
#include "toolpath/unsupported/head_clearance.h"
#include "voxel/voxel_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace voluta::toolpath {

namespace {

using Eigen::Vector3d;

constexpr double kSlender = 6.0;           // widths: higher walls tip over
constexpr double kBreakShare = 1.0 / 14.0; // of a bead's height, between it and its support
constexpr double kMinShare = 0.5; // of the minimum layer height: thinner beads do not stick
constexpr std::array kLeansDeg{20.0, -20.0, 40.0, -40.0};
// Courses of one height; less than the height of a course, so that none rests on another.
constexpr double kSameHeightMm = 0.05;
constexpr double kUpright = 0.5; // cosine of the maximum tilt of courses over or to the side

void append(plan::ToolPlan& plan, const Vector3d& tip, const Vector3d& direction, float widthMm,
            float heightMm, float speedMmPerS) {
  plan.position.push_back(tip);
  plan.direction.push_back(direction);
  plan.widthMm.push_back(widthMm);
  plan.heightMm.push_back(heightMm);
  plan.speedMmPerS.push_back(speedMmPerS);
}

// Returns whether a path is the first of its patch. The prime belongs to no patch.
bool beginsPatch(const plan::ToolPlan& plan, std::size_t path) {
  return path == 0 || plan.paths[path - 1].patch != plan.paths[path].patch ||
         plan::isWaste(plan.paths[path - 1].kind);
}

// One support bead below another, with one waypoint for each of its waypoints.
struct Course {
  std::vector<Vector3d> tip, direction;
  std::vector<std::size_t> above; // waypoint of the bead that it supports
  std::vector<float> heightMm;
  double widthMm = 0.0;

  double meanAlong(const Vector3d& up) const {
    double sum = 0.0;
    for (const Vector3d& t : tip)
      sum += t.dot(up);
    return sum / static_cast<double>(tip.size());
  }

  Course reversed() const {
    Course other = *this;
    std::ranges::reverse(other.tip);
    std::ranges::reverse(other.direction);
    std::ranges::reverse(other.above);
    std::ranges::reverse(other.heightMm);
    return other;
  }
};

// Returns the visits of least travel from `last` to `next`: low courses first, in any order where
// they are equally high along `up`. Precondition: courses ascend along `up`.
std::vector<Visit> visitsOf(const std::vector<const Course*>& courses, const Vector3d& up,
                            const Vector3d& last, const Vector3d& next) {
  std::vector<Stop> stops;
  std::vector<StopGroup> turns;
  double lowest = -std::numeric_limits<double>::infinity();
  for (const Course* course : courses) {
    const double height = course->meanAlong(up);
    if (height > lowest + kSameHeightMm) {
      turns.emplace_back();
      lowest = height;
    }
    turns.back().push_back(stops.size());
    stops.push_back({{course->tip.front(), course->tip.back()}});
  }
  turns.insert(turns.begin(), StopGroup{stops.size()});
  stops.push_back({{last}, true});
  turns.push_back({stops.size()});
  stops.push_back({{next}, true});
  std::vector<Visit> visits = visitShortly(stops, turns, last);
  visits.erase(visits.begin());
  visits.pop_back();
  return visits;
}

// The space below a waypoint, along its direction, that support may fill.
struct Room {
  double mm = 0.0; // height; 0: no space
  Vector3d foot = Vector3d::Zero(), nozzle = Vector3d::UnitZ();
};

// Finds room for support beads below one path.
class Underlayer {
public:
  // `before`: the first waypoint of the path's patch.
  Underlayer(const plan::ToolPlan& plan, const collision::GrowingPart& part, const PassScene& scene,
             const HeadClearance& head, const plan::ToolPath& path, std::size_t before)
      : plan_(plan), part_(part), platform_(scene.platform), head_(head),
        process_(scene.tooling.of(path).process), path_(path), before_(before),
        canTilt_(scene.canTilt), isBlocked_(scene.isBlocked) {}

  // Returns the courses, from the lowest upwards. `unsupported`: unsupportedWaypoints() of the plan
  // and its beads.
  std::vector<Course> courses(const std::vector<char>& unsupported) const {
    std::vector<Course> found;
    for (const UnsupportedStretch& s :
         unsupportedStretches(plan_, path_, unsupported, 0.5 * process_.bridgeMm))
      addCourses(s.begin, s.end, found);
    return found;
  }

private:
  double lengthOf(std::size_t b, std::size_t e) const {
    return geometry::polylineLength(e - b, [&](std::size_t i) { return plan_.position[b + i]; });
  }
  Vector3d bottomOf(std::size_t i) const {
    return plan_.position[i] - static_cast<double>(plan_.heightMm[i]) * plan_.direction[i];
  }

  // Returns the distance from the bottom of a bead to the material printed before the patch, or the
  // plate. 0 if there is none, or if later material, printed before waypoint i, is in between.
  double gapBeneath(std::size_t i) const {
    const Vector3d& d = plan_.direction[i];
    const Vector3d bottom = bottomOf(i);
    const double maximum = kSlender * process_.beadWidthMaxMm;
    const double plate = d.z() >= kUpright ? bottom.z() / d.z() : 2.0 * maximum;
    const double pitch = part_.grid().pitch, step = 0.25 * pitch;
    for (double depth = 0.5 * step; depth <= std::min(maximum, plate); depth += step) {
      const Vector3d at = bottom - depth * d;
      if (part_.holds(at, before_))
        return depth > pitch ? depth - 0.5 * step : 0.0;
      if (part_.holds(at, i))
        return 0.0;
    }
    return plate > 0.0 && plate <= maximum &&
                   geometry::inConvexPolygon(platform_.polygon, (bottom - plate * d).head<2>())
               ? plate
               : 0.0;
  }

  Room roomBeneath(std::size_t i) const {
    const Vector3d& d = plan_.direction[i];
    if (isBlocked_ && isBlocked_(path_, 0.5 * (plan_.position[i] + bottomOf(i))))
      return {};
    const double gap = gapBeneath(i);
    const double minimum = kMinShare * process_.layerHeightMinMm;
    const double apart = gap - kBreakShare * static_cast<double>(plan_.heightMm[i]);
    Room room{apart >= minimum ? apart : gap, bottomOf(i) - gap * d};
    if (room.mm < minimum)
      return {};
    return room;
  }

  // Returns whether the head is clear for the lowest and for the highest support bead in the space.
  bool clears(const Room& room, std::size_t i) const {
    const Vector3d& d = plan_.direction[i];
    const double lowest = std::min(room.mm, process_.layerHeightMaxMm);
    const auto at = [&](double from, double to) {
      return head_.clears(part_,
                          room.foot + 0.5 * (from + to) * d +
                              0.5 * (to - from) * d.dot(room.nozzle) * room.nozzle,
                          room.nozzle, before_);
    };
    return room.nozzle.dot(d) >= kUpright && at(0.0, lowest) && at(room.mm - lowest, room.mm);
  }

  // Returns candidate nozzle directions over a stretch, best first: upright, as for the supported
  // bead, tilted to either side of the path.
  std::vector<std::vector<Vector3d>> nozzles(std::size_t b, std::size_t e) const {
    if (!canTilt_)
      return {std::vector<Vector3d>(e - b, Vector3d::UnitZ())};
    std::vector<std::vector<Vector3d>> ways(2 + kLeansDeg.size());
    for (std::size_t i = b; i < e; ++i) {
      ways[0].push_back(Vector3d::UnitZ());
      ways[1].push_back(plan_.direction[i]);
      const Vector3d side = sideOf(plan_, path_, i);
      const Vector3d level = Vector3d(side.x(), side.y(), 0.0);
      for (std::size_t k = 0; k < kLeansDeg.size(); ++k) {
        const double lean = base::degreesToRadians(kLeansDeg[k]);
        ways[2 + k].push_back(std::cos(lean) * Vector3d::UnitZ() +
                              std::sin(lean) * level.stableNormalized());
      }
    }
    return ways;
  }

  // Returns the number of courses that the highest place needs. Stretches are split where the
  // lowest place is too low for that many.
  int coursesFor(double maxMm) const {
    return static_cast<int>(std::ceil(maxMm / process_.layerHeightMaxMm - 1e-9));
  }

  // Returns the spaces below a stretch, with the nozzle direction for which most of them are clear.
  std::vector<Room> roomsBeneath(std::size_t b, std::size_t e) const {
    std::vector<Room> rooms(e - b), best(e - b);
    std::size_t any = 0, maximum = 0;
    for (std::size_t i = b; i < e; ++i)
      any += (rooms[i - b] = roomBeneath(i)).mm > 0.0 ? 1 : 0;
    if (any == 0)
      return best;
    for (const std::vector<Vector3d>& tips : nozzles(b, e)) {
      std::vector<Room> clear(e - b);
      std::size_t count = 0;
      for (std::size_t i = b; i < e; ++i) {
        Room room = rooms[i - b];
        room.nozzle = tips[i - b];
        if (room.mm > 0.0 && clears(room, i)) {
          clear[i - b] = room;
          ++count;
        }
      }
      if (count > maximum) {
        maximum = count;
        best = std::move(clear);
      }
      if (maximum == any)
        break;
    }
    return best;
  }

  void addCourses(std::size_t b, std::size_t e, std::vector<Course>& to) const {
    const std::vector<Room> room = roomsBeneath(b, e);
    const double thinnest = kMinShare * process_.layerHeightMinMm;
    for (std::size_t s = b; s < e;) {
      double maximum = room[s - b].mm, minimum = maximum;
      std::size_t t = s + 1;
      for (; maximum > 0.0 && t < e; ++t) {
        const double mm = room[t - b].mm;
        if (mm <= 0.0 ||
            coursesFor(std::max(maximum, mm)) * thinnest > std::min(minimum, mm) + 1e-9)
          break;
        maximum = std::max(maximum, mm);
        minimum = std::min(minimum, mm);
      }
      // A bead that is too short does not stick.
      if (maximum > 0.0 && t - s >= 2 && lengthOf(s, t) > process_.beadWidthMm)
        stack(s, t, room.data() + (s - b), maximum, to);
      s = t;
    }
  }

  void stack(std::size_t s, std::size_t t, const Room* room, double maximum,
             std::vector<Course>& to) const {
    const int count = coursesFor(maximum);
    for (int c = 0; c < count; ++c) {
      Course course;
      course.widthMm =
          std::clamp(maximum / kSlender, process_.beadWidthMinMm, process_.beadWidthMaxMm);
      for (std::size_t i = s; i < t; ++i) {
        const Vector3d& d = plan_.direction[i];
        const Room& r = room[i - s];
        const double height = r.mm / count, beadHeight = height * d.dot(r.nozzle);
        course.tip.push_back(r.foot + (c + 0.5) * height * d + 0.5 * beadHeight * r.nozzle);
        course.direction.push_back(r.nozzle);
        course.heightMm.push_back(static_cast<float>(beadHeight));
        course.above.push_back(i);
      }
      to.push_back(std::move(course));
    }
  }

  const plan::ToolPlan& plan_;
  const collision::GrowingPart& part_;
  const platform::PlatformSolid& platform_;
  const HeadClearance& head_;
  const process::Process& process_;
  const plan::ToolPath& path_;
  std::size_t before_;
  bool canTilt_;
  const decltype(PassScene::isBlocked)& isBlocked_;
};

// Returns the courses per path that has some.
std::map<std::size_t, std::vector<Course>> coursesOf(const UnsupportedBeads& beads,
                                                     const collision::GrowingPart& part,
                                                     const PassScene& scene,
                                                     const base::RunContext& ctx) {
  const plan::ToolPlan& plan = beads.plan;
  // The cell has the head of the first tool.
  const HeadClearance head(scene.cell, scene.tooling.first().process);
  std::vector<std::vector<Course>> of(plan.paths.size());
  std::vector<std::size_t> patchFirst(plan.paths.size()); // its first waypoint
  for (std::size_t p = 0; p < plan.paths.size(); ++p)
    patchFirst[p] = beginsPatch(plan, p) ? plan.paths[p].first : patchFirst[p - 1];
  base::parallelChunks(ctx, of.size(), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e && !ctx.cancelled(); ++p) {
      const plan::ToolPath& path = plan.paths[p];
      of[p] = Underlayer(plan, part, scene, head, path, patchFirst[p]).courses(beads.unsupported);
    }
  });
  ctx.checkpoint();
  std::map<std::size_t, std::vector<Course>> result;
  for (std::size_t p = 0; p < of.size(); ++p)
    if (!of[p].empty())
      result.emplace(p, std::move(of[p]));
  return result;
}

// Puts the support beads into the plan.
class Inserter {
public:
  Inserter(const UnsupportedBeads& was, const std::map<std::size_t, std::vector<Course>>& courses,
           const process::Tooling& tooling)
      : was_(was), courses_(courses), tooling_(tooling), isHeld_(was.unsupported.size(), 0) {
    for (const auto& [path, of] : courses)
      for (const Course& course : of)
        for (const std::size_t above : course.above)
          isHeld_[above] = 1;
  }

  PassResult run() {
    const std::vector<plan::ToolPath>& paths = was_.plan.paths;
    out_.beads.plan.fill = was_.plan.fill;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      if (beginsPatch(was_.plan, p) && !plan::isWaste(paths[p].kind))
        addSupports(p);
      addPath(paths[p]);
    }
    out_.finding =
        plan::makeFinding(plan::FindingKind::RimSupports,
                          {{"volume", base::mm3(out_.addedMm3)}, {"paths", courses_.size()}},
                          courses_.begin()->second.front().tip.front(), courses_.size());
    return std::move(out_);
  }

private:
  // Adds the support beads of all paths of a patch, low ones first, so that the head does not
  // collide with higher ones.
  void addSupports(std::size_t firstPath) {
    const std::vector<plan::ToolPath>& paths = was_.plan.paths;
    std::vector<std::pair<const Course*, const plan::ToolPath*>> beneath;
    Vector3d up = Vector3d::Zero();
    for (std::size_t q = firstPath; q < paths.size() && paths[q].patch == paths[firstPath].patch;
         ++q)
      if (const auto found = courses_.find(q); found != courses_.end())
        for (const Course& course : found->second)
          beneath.emplace_back(&course, &paths[q]);
    for (const auto& [course, under] : beneath)
      for (const Vector3d& d : course->direction)
        up += d;
    std::ranges::stable_sort(beneath, {}, [&](const auto& b) { return b.first->meanAlong(up); });
    std::vector<const Course*> courses;
    for (const auto& [course, under] : beneath)
      courses.push_back(course);
    const std::vector<Vector3d>& printed = out_.beads.plan.position;
    const Vector3d next = was_.plan.position[paths[firstPath].first];
    const Vector3d last = printed.empty() ? next : printed.back();
    for (const Visit& visit : visitsOf(courses, up.normalized(), last, next))
      addCourse(visit.begin == 0 ? *courses[visit.stop] : courses[visit.stop]->reversed(),
                *beneath[visit.stop].second);
  }

  void addCourse(const Course& course, plan::ToolPath under) {
    UnsupportedBeads& to = out_.beads;
    const auto sectionOf = [&](float height) {
      return process::beadArea(course.widthMm, static_cast<double>(height));
    };
    const process::Process& process = tooling_.of(under).process;
    under.first = to.plan.waypointCount();
    under.count = course.tip.size();
    under.kind = plan::PathKind::Support;
    under.group = layers::kSupportGroup;
    under.closed = false;
    for (std::size_t i = 0; i < course.tip.size(); ++i) {
      const double section = sectionOf(course.heightMm[i]);
      append(
          to.plan, course.tip[i], course.direction[i], static_cast<float>(course.widthMm),
          course.heightMm[i],
          static_cast<float>(std::min(process.speedMmPerS, process::flowLimit(process) / section)));
      to.unsupported.push_back(0);
      to.clearDirection.push_back(was_.clearDirection[course.above[i]]);
      if (i > 0)
        out_.addedMm3 += process::beadVolume(sectionOf(course.heightMm[i - 1]), section,
                                             (course.tip[i] - course.tip[i - 1]).norm());
    }
    to.plan.paths.push_back(under);
  }

  void addPath(plan::ToolPath path) {
    UnsupportedBeads& to = out_.beads;
    const std::size_t first = std::exchange(path.first, to.plan.waypointCount());
    for (std::size_t i = first; i < first + path.count; ++i) {
      plan::appendWaypoint(to.plan, was_.plan, i);
      to.unsupported.push_back(was_.unsupported[i] && !isHeld_[i]);
      to.clearDirection.push_back(was_.clearDirection[i]);
    }
    to.plan.paths.push_back(path);
  }

  const UnsupportedBeads& was_;
  const std::map<std::size_t, std::vector<Course>>& courses_;
  const process::Tooling tooling_;
  std::vector<char> isHeld_; // per waypoint: a support bead is below it
  PassResult out_;
};

} // namespace

std::optional<PassResult> addRimSupports(const UnsupportedBeads& beads, const SeenPart& part,
                                         const PassScene& scene, const base::RunContext& ctx) {
  base::require(beads.unsupported.size() == beads.plan.waypointCount() &&
                    beads.clearDirection.size() == beads.plan.waypointCount(),
                "a mark and a clear direction for each waypoint");
  ctx.checkpoint();
  const auto courses = coursesOf(beads, part(), scene, ctx);
  if (courses.empty())
    return std::nullopt;
  return Inserter(beads, courses, scene.tooling).run();
}

} // namespace voluta::toolpath
