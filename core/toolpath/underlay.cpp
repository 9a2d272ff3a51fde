#include "toolpath/underlay.h"

#include "base/error.h"
#include "base/run_context.h"
#include "collision/growing_part.h"
#include "geometry/convex_polygon.h"
#include "layers/layer_stack.h"
#include "plan/waypoints.h"
#include "process/bead_model.h"
#include "toolpath/bridges.h"
#include "toolpath/head_clearance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace voluta::toolpath {

namespace {

using Eigen::Vector3d;

constexpr double kSlender = 6.0;          // widths: higher walls one bead wide tip over
constexpr double kBreakShare = 1.0 / 7.0; // of a bead's height, between it and what carries it
constexpr double kLeastShare = 0.5;       // of the least layer height: thinner beads don't hold

void append(plan::ToolPlan& plan, const Vector3d& tip, const Vector3d& direction, float widthMm,
            float heightMm, float speedMmPerS) {
  plan.position.push_back(tip);
  plan.direction.push_back(direction);
  plan.widthMm.push_back(widthMm);
  plan.heightMm.push_back(heightMm);
  plan.speedMmPerS.push_back(speedMmPerS);
}

struct Low {
  plan::ToolPlan plan;
  std::vector<std::size_t> waypoint, path; // of the whole plan
  std::vector<std::size_t> patchFirst;     // a path: the first waypoint here of its patch
};

// The paths that come near the plate, in order: what is higher carries none of them.
Low lowPaths(const plan::ToolPlan& plan, double belowMm) {
  Low low;
  for (std::size_t p = 0; p < plan.paths.size(); ++p) {
    plan::ToolPath path = plan.paths[p];
    const auto begin = plan.position.begin() + static_cast<std::ptrdiff_t>(path.first);
    if (std::none_of(begin, begin + static_cast<std::ptrdiff_t>(path.count),
                     [&](const Vector3d& tip) { return tip.z() < belowMm; }))
      continue;
    const std::size_t first = low.plan.waypointCount();
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      plan::appendWaypoint(low.plan, plan, i);
      low.waypoint.push_back(i);
    }
    path.first = first;
    const bool goesOn = !low.path.empty() && low.plan.paths.back().patch == path.patch;
    low.patchFirst.push_back(goesOn ? low.patchFirst.back() : first);
    low.plan.paths.push_back(path);
    low.path.push_back(p);
  }
  return low;
}

// One bead beneath another, laid upright: a waypoint each.
struct Course {
  std::vector<Vector3d> tip;
  std::vector<std::size_t> above; // waypoint of the bead that it is for
  std::vector<float> heightMm;

  double meanHeight() const { // over the plate
    double sum = 0.0;
    for (const Vector3d& t : tip)
      sum += t.z();
    return sum / static_cast<double>(tip.size());
  }
};

class Underlayer {
public:
  Underlayer(const plan::ToolPlan& all, const platform::PlatformSolid& platform,
             const robot::Cell& cell, const process::Process& process, const base::RunContext& ctx)
      : platform_(platform), process_(process), head_(cell, process),
        low_(lowPaths(all, kSlender * process.beadWidthMinMm + process.layerHeightMaxMm)),
        part_(low_.plan, collision::growingPitch(low_.plan, process), ctx),
        hanging_(hangingWaypoints(low_.plan, part_, platform, ctx)) {}

  // By path of the whole plan, courses from the plate upwards.
  std::map<std::size_t, std::vector<Course>> courses() const {
    std::map<std::size_t, std::vector<Course>> result;
    for (std::size_t k = 0; k < low_.plan.paths.size(); ++k) {
      const plan::ToolPath& path = low_.plan.paths[k];
      for (const HangingStretch& s :
           hangingStretches(low_.plan, path, hanging_, 0.5 * process_.bridgeMm))
        addCourses(s.begin, s.end, low_.patchFirst[k], result[low_.path[k]]);
    }
    std::erase_if(result, [](const auto& entry) { return entry.second.empty(); });
    return result;
  }

private:
  double lengthOf(std::size_t b, std::size_t e) const {
    double length = 0.0;
    for (std::size_t i = b + 1; i < e; ++i)
      length += (low_.plan.position[i] - low_.plan.position[i - 1]).norm();
    return length;
  }

  // How thick the beads under a waypoint may be together, along its direction, laid before another
  // waypoint; 0: none can be laid.
  double roomBeneath(std::size_t i, std::size_t before) const {
    const Vector3d& d = low_.plan.direction[i];
    if (d.z() < 0.5)
      return 0.0;
    const auto height = static_cast<double>(low_.plan.heightMm[i]);
    const Vector3d bottom = low_.plan.position[i] - height * d;
    const double gap = bottom.z() / d.z();
    const Vector3d foot = bottom - gap * d;
    if (gap <= 0.0 || gap > kSlender * process_.beadWidthMinMm ||
        !geometry::inConvexPolygon(platform_.polygon, foot.head<2>()))
      return 0.0;
    const double step = part_.grid().pitch;
    for (double depth = 0.5 * step; depth < gap; depth += step)
      if (part_.holds(bottom - depth * d, i))
        return 0.0;
    const double least = kLeastShare * process_.layerHeightMinMm;
    const double apart = gap - kBreakShare * height;
    const double room = apart >= least ? apart : gap;
    const Vector3d top(0.0, 0.0, 0.5 * room * d.z());
    return room >= least &&
                   head_.clears(part_, foot + 0.5 * room * d + top, Vector3d::UnitZ(), before)
               ? room
               : 0.0;
  }

  void addCourses(std::size_t b, std::size_t e, std::size_t before, std::vector<Course>& to) const {
    std::vector<double> room(e - b);
    for (std::size_t i = b; i < e; ++i)
      room[i - b] = roomBeneath(i, before);
    for (std::size_t s = b; s < e;) {
      if (room[s - b] <= 0.0) {
        ++s;
        continue;
      }
      std::size_t t = s;
      double most = 0.0;
      while (t < e && room[t - b] > 0.0)
        most = std::max(most, room[t++ - b]);
      // Too short a bead does not stick.
      if (t - s >= 2 && lengthOf(s, t) > process_.beadWidthMm)
        stack(s, t, room.data() + (s - b), most, to);
      s = t;
    }
  }

  void stack(std::size_t s, std::size_t t, const double* room, double most,
             std::vector<Course>& to) const {
    const int count = static_cast<int>(std::ceil(most / process_.layerHeightMaxMm - 1e-9));
    for (int c = 0; c < count; ++c) {
      Course course;
      for (std::size_t i = s; i < t; ++i) {
        const Vector3d& d = low_.plan.direction[i];
        const Vector3d bottom =
            low_.plan.position[i] - static_cast<double>(low_.plan.heightMm[i]) * d;
        const Vector3d foot = bottom - bottom.z() / d.z() * d;
        const double height = room[i - s] / count;
        const double upright = height * d.z();
        course.tip.push_back(foot + (c + 0.5) * height * d + 0.5 * upright * Vector3d::UnitZ());
        course.heightMm.push_back(static_cast<float>(upright));
        course.above.push_back(low_.waypoint[i]);
      }
      to.push_back(std::move(course));
    }
  }

  const platform::PlatformSolid& platform_;
  const process::Process& process_;
  HeadClearance head_;
  Low low_;
  collision::GrowingPart part_;
  std::vector<char> hanging_;
};

} // namespace

UnderlaidPlan underlay(plan::ToolPlan plan, std::vector<Vector3d> clearDirection,
                       const platform::PlatformSolid& platform, const robot::Cell& cell,
                       const process::Process& process, const base::RunContext& ctx) {
  base::require(clearDirection.size() == plan.waypointCount(), "one clear direction per waypoint");
  UnderlaidPlan out{std::move(plan), std::move(clearDirection)};
  if (platform.polygon.size() < 3 || platform.mesh || platform.rod || out.plan.paths.empty())
    return out;
  const auto courses = Underlayer(out.plan, platform, cell, process, ctx).courses();
  if (courses.empty())
    return out;

  const UnderlaidPlan was = std::exchange(out, {});
  const auto width = static_cast<float>(process.beadWidthMinMm);
  const auto sectionOf = [&](float height) {
    return process::beadArea(static_cast<double>(width), static_cast<double>(height));
  };
  const auto addCourse = [&](const Course& course, plan::ToolPath under) {
    under.first = out.plan.waypointCount();
    under.count = course.tip.size();
    under.kind = plan::PathKind::Support;
    under.group = layers::kSupportGroup;
    under.closed = false;
    for (std::size_t i = 0; i < course.tip.size(); ++i) {
      const std::size_t above = course.above[i];
      const double section = sectionOf(course.heightMm[i]);
      append(out.plan, course.tip[i], Vector3d::UnitZ(), width, course.heightMm[i],
             static_cast<float>(std::min(process.speedMmPerS, process.maxFlowMm3PerS / section)));
      out.clearDirection.push_back(was.clearDirection[above]);
      if (i > 0)
        out.volumeMm3 += process::beadVolume(sectionOf(course.heightMm[i - 1]), section,
                                             (course.tip[i] - course.tip[i - 1]).norm());
    }
    out.plan.paths.push_back(under);
  };
  for (std::size_t p = 0; p < was.plan.paths.size(); ++p) {
    const plan::ToolPath& path = was.plan.paths[p];
    // Before the first path of the patch come the beads under all its paths, low ones first: the
    // head cuts into none that is higher.
    if (p == 0 || was.plan.paths[p - 1].patch != path.patch) {
      std::vector<std::pair<const Course*, const plan::ToolPath*>> beneath;
      for (std::size_t q = p; q < was.plan.paths.size() && was.plan.paths[q].patch == path.patch;
           ++q) {
        const auto found = courses.find(q);
        if (found == courses.end())
          continue;
        if (out.underlaid++ == 0)
          out.where = found->second.front().tip.front();
        for (const Course& course : found->second)
          beneath.emplace_back(&course, &was.plan.paths[q]);
      }
      std::ranges::stable_sort(beneath, {}, [](const auto& b) { return b.first->meanHeight(); });
      for (const auto& [course, under] : beneath)
        addCourse(*course, *under);
    }
    plan::ToolPath same = path;
    same.first = out.plan.waypointCount();
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      plan::appendWaypoint(out.plan, was.plan, i);
      out.clearDirection.push_back(was.clearDirection[i]);
    }
    out.plan.paths.push_back(same);
  }
  return out;
}

} // namespace voluta::toolpath
