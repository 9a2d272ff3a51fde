#include "replay/clashes.h"

#include "base/parallel.h"
#include "replay/head_follower.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace voluta::replay {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr std::size_t kGrain = 2048;
// Returned for cells that are not filled yet: no contact, but contact may arise without any motion
// as the part grows.
constexpr double kAskAgainMm = 1e-6;

// A contact of two bodies at one sample; `pair` identifies the two.
struct Touch {
  std::size_t sample = 0;
  int pair = 0;
  Vector3d where = Vector3d::Zero();
};

Isometry3d headFrame(const Vector3d& tip, const Vector3d& direction) {
  Isometry3d work_T_head = Isometry3d::Identity();
  const Vector3d x = direction.unitOrthogonal();
  work_T_head.linear() << x, direction.cross(x), direction;
  work_T_head.translation() = tip;
  return work_T_head;
}

// Merges the touches of all chunks, in order of samples within each pair, into clashes.
template <typename MotionOf, typename WhenOf, typename NameOf>
std::vector<Clash> gather(const std::vector<std::vector<Touch>>& chunks, const MotionOf& motionOf,
                          const WhenOf& whenOf, const NameOf& nameOf) {
  std::vector<Clash> clashes;
  struct Open {
    int pair;
    std::size_t sample, clash;
  };
  std::vector<Open> open;
  for (const std::vector<Touch>& chunk : chunks)
    for (const Touch& t : chunk) {
      const auto it =
          std::find_if(open.begin(), open.end(), [&](const Open& o) { return o.pair == t.pair; });
      if (it != open.end() && t.sample <= it->sample + 4) {
        it->sample = t.sample;
        ++clashes[it->clash].samples;
        clashes[it->clash].lastMotion = motionOf(t.sample);
        continue;
      }
      Clash c;
      c.motion = c.lastMotion = motionOf(t.sample);
      c.whenS = whenOf(t.sample);
      c.where = t.where;
      nameOf(t.pair, c.first, c.second);
      if (it != open.end())
        *it = {t.pair, t.sample, clashes.size()};
      else
        open.push_back({t.pair, t.sample, clashes.size()});
      clashes.push_back(std::move(c));
    }
  return clashes;
}

enum HeadPair { kPart, kPlatform, kInserted };

// The head, eroded by the contact tolerance; against cells by another half of a cell.
struct ErodedHead {
  ErodedHead(const process::Process& process, const PrintedPart& printed,
             const GroundSolids& ground)
      : againstPlatform(process::erodedHead(process.head, process.contactToleranceMm)),
        againstPart(process::erodedHead(process.head,
                                        process.contactToleranceMm + 0.5 * printed.grid().pitch)) {
    for (const GroundSolids::Body& body : ground.bodies())
      againstBody.emplace_back(process::erodedHead(
          process.head, process.contactToleranceMm + 0.5 * body.cells->part().grid().pitch));
  }

  HeadSolid againstPlatform, againstPart;
  std::vector<HeadSolid> againstBody; // of the ground
};

std::vector<Ball> ballsRound(const GroundSolids& ground) {
  std::vector<Ball> balls;
  for (const PlacedShape& solid : ground.solids()) {
    balls.push_back(ballRound(solid.shape));
    balls.back().centre = solid.work_T_shape * balls.back().centre;
  }
  return balls;
}

// Follows the head from sample to sample.
class HeadWalk {
public:
  HeadWalk(const ErodedHead& head, const PrintedPart& printed, const Underside& underside,
           const GroundSolids& ground, const std::vector<Ball>& groundBalls)
      : againstPlatform_(head.againstPlatform), underside_(underside), ground_(ground),
        groundBalls_(groundBalls), overPart_(head.againstPart, printed) {
    overBody_.reserve(head.againstBody.size());
    for (std::size_t b = 0; b < head.againstBody.size(); ++b)
      overBody_.emplace_back(head.againstBody[b], ground.bodies()[b].cells->part());
  }

  // `begun`: the first piece of this motion or of a later one.
  void step(std::size_t sample, const Vector3d& tip, const Vector3d& direction,
            const PrintState& moment, std::uint32_t begun, std::vector<Touch>& touches) {
    if (moment.before > 0) {
      auto where = overPart_.touched(tip, direction, moment);
      if (!where)
        where = underside_.touched(tip, direction, moment);
      if (where)
        touches.push_back({sample, kPart, *where});
    }
    bool isOnPlatform = false;
    for (std::size_t b = 0; b < overBody_.size(); ++b) {
      const GroundSolids::Body& body = ground_.bodies()[b];
      if (begun < body.firstPiece)
        continue;
      if (const auto where = overBody_[b].touched(tip, direction, GroundCells::always())) {
        touches.push_back({sample, body.isPlatform ? kPlatform : kInserted, *where});
        isOnPlatform = isOnPlatform || body.isPlatform;
      }
    }
    if (isOnPlatform)
      return;
    if (touchesSolids(tip, direction))
      touches.push_back({sample, kPlatform, tip});
  }

private:
  bool touchesSolids(const Vector3d& tip, const Vector3d& direction) const {
    const Vector3d outward = ground_.outward(direction);
    if (againstPlatform_.lowest(tip.dot(outward), direction.dot(outward)) > ground_.reachMm())
      return false;
    const Isometry3d work_T_head = headFrame(tip, direction);
    const Ball headBall = againstPlatform_.ball();
    for (std::size_t b = 0; b < groundBalls_.size(); ++b) {
      if ((work_T_head * headBall.centre - groundBalls_[b].centre).norm() >
          headBall.radius + groundBalls_[b].radius)
        continue;
      const PlacedShape& solid = ground_.solids()[b];
      if (std::any_of(againstPlatform_.frusta().begin(), againstPlatform_.frusta().end(),
                      [&](const robot::Shape& f) {
                        return distanceBetween(f, work_T_head, solid.shape, solid.work_T_shape) <=
                               0.0;
                      }))
        return true;
    }
    return false;
  }

  const HeadSolid& againstPlatform_;
  const Underside& underside_;
  const GroundSolids& ground_;
  const std::vector<Ball>& groundBalls_;
  HeadFollower overPart_;
  std::vector<HeadFollower> overBody_; // as ground.bodies()
};

std::size_t motionOfSample(const ExecutedPath& path, std::size_t s) {
  return static_cast<std::size_t>(
             std::upper_bound(path.firstSample.begin(), path.firstSample.end(), s) -
             path.firstSample.begin()) -
         1;
}

double timeOfSample(const ExecutedPath& path, std::size_t s) {
  const std::size_t m = motionOfSample(path, s);
  const double share = static_cast<double>(s - path.firstSample[m] + 1) /
                       static_cast<double>(path.firstSample[m + 1] - path.firstSample[m]);
  return path.startS[m] + share * path.durationS[m];
}

} // namespace

std::vector<Clash> headClashes(const ExecutedPath& path, const std::vector<DepositedPiece>& pieces,
                               const std::vector<std::uint32_t>& firstPiece,
                               const PrintedPart& printed, const Underside& underside,
                               const process::Process& process, const GroundSolids& ground,
                               const std::vector<char>& known, const base::RunContext& ctx) {
  const ErodedHead head(process, printed, ground);
  const std::vector<Ball> groundBalls = ballsRound(ground);
  std::vector<std::vector<Touch>> chunks((path.motionCount() + kGrain - 1) / kGrain);
  base::parallelChunks(ctx, path.motionCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    HeadWalk walk(head, printed, underside, ground, groundBalls);
    for (std::size_t m = begin; m < end && !ctx.cancelled(); ++m) {
      if (!known.empty() && known[m])
        continue;
      for (std::size_t s = path.firstSample[m]; s < path.firstSample[m + 1]; ++s) {
        // The pieces of a motion are its samples' intervals.
        const std::size_t p =
            std::min<std::size_t>(firstPiece[m] + (s - path.firstSample[m]) + 1, firstPiece[m + 1]);
        PrintState moment;
        if (p > 0) {
          const DepositedPiece& last = pieces[p - 1];
          moment = {static_cast<std::uint32_t>(p), last.run, last.runMm, last.recentMm};
        }
        walk.step(s, path.tip[s], path.direction[s], moment, firstPiece[m], chunks[begin / kGrain]);
      }
    }
  });
  ctx.checkpoint();
  return gather(
      chunks, [&](std::size_t s) { return motionOfSample(path, s); },
      [&](std::size_t s) { return timeOfSample(path, s); },
      [](int pair, base::Value& first, base::Value& second) {
        first = "head"_text;
        second = pair == kPart       ? "printed part"_text
                 : pair == kPlatform ? "platform"_text
                                     : "inserted part"_text;
      });
}

namespace {

struct Pair {
  int a = 0, b = 0; // indices of bodies, or one of these
};
constexpr int kPrintedPart = -1, kGroundBodies = -2; // of the ground: -2, -3, ...

// Material as grid cells, and a simple solid around all of them.
struct Cells {
  Cells(const PrintedPart& printed, const robot::Cell& cell) : part(printed) {
    const voxel::VoxelGrid& g = printed.grid();
    const Vector3d half = 0.5 * g.pitch * g.size.cast<double>(), centre = g.origin + half;
    if (!cell.rod()) {
      hull = robot::Box{Isometry3d(Eigen::Translation3d(centre)), half};
      reach = centre.norm() + half.norm();
    } else {
      // A rod turns the work frame about x; a solid of revolution about x does not move.
      const double r = (centre.cwiseAbs() + half).tail<2>().norm(), x = centre.x();
      hull = robot::Frustum{{x - half.x(), 0, 0}, {x + half.x(), 0, 0}, r, r};
    }
  }
  const PrintedPart& part;
  robot::Shape hull;
  double reach = 0.0; // maximum distance of its points from the work frame's origin
};

// Follows the poses of the cell's bodies from sample to sample.
class ArmFollower {
public:
  ArmFollower(const robot::Cell& cell, const PrintedPart& printed, const GroundSolids& ground,
              const std::vector<Pair>& pairs)
      : cell_(cell), printed_(printed, cell), pairs_(pairs), slack_(pairs.size(), -1.0) {
    for (const GroundSolids::Body& body : ground.bodies())
      ground_.push_back({{body.cells->part(), cell}, body.firstPiece});
    for (const robot::Body& body : cell.bodies()) {
      std::vector<Ball> balls;
      for (const robot::Shape& shape : body.shapes)
        balls.push_back(ballRound(shape));
      double reach = 0.0;
      for (const Ball& b : balls)
        reach = std::max(reach, b.centre.norm() + b.radius);
      balls_.push_back(std::move(balls));
      // A rod is rotationally symmetric about its axis of rotation.
      const bool turnsInItself =
          cell.rod() && (body.frame == cell.workFrame() || body.frame == cell.axisFrame(0));
      reach_.push_back(turnsInItself ? 0.0 : reach);
    }
  }

  void step(const robot::JointVector& q, std::size_t sample, const PrintState& moment,
            std::vector<Touch>& touches) {
    frames_.clear();
    cell_.framePoses(q, frames_);
    moveOn();
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      if (slack_[p] > 0.0)
        continue;
      Vector3d where = Vector3d::Zero();
      double d = 0.0;
      if (pairs_[p].b == kPrintedPart)
        d = cellsDistance(pairs_[p].a, printed_, moment, where);
      else if (pairs_[p].b < kPrintedPart)
        d = groundDistance(pairs_[p].a, groundOf(pairs_[p].b), moment, where);
      else
        d = bodyDistance(pairs_[p].a, pairs_[p].b);
      if (d <= 0.0) {
        if (pairs_[p].b >= 0)
          where = frames_[static_cast<std::size_t>(cell_.workFrame())].inverse(Eigen::Isometry) *
                  frames_[static_cast<std::size_t>(cell_.toolFrame())].translation();
        touches.push_back({sample, static_cast<int>(p), where});
      }
      slack_[p] = d > kAskAgainMm ? d : 0.0;
    }
  }

private:
  struct Ground {
    Cells cells;
    std::uint32_t firstPiece;
  };
  const Ground& groundOf(int body) const {
    return ground_[static_cast<std::size_t>(kGroundBodies - body)];
  }
  const Isometry3d& frameOf(int body) const {
    return frames_[static_cast<std::size_t>(cell_.bodies()[static_cast<std::size_t>(body)].frame)];
  }

  // Reduces each pair's slack by the maximum displacement of its two bodies.
  void moveOn() {
    if (!last_.empty()) {
      std::vector<double>& moved = moved_;
      moved.resize(cell_.bodies().size());
      for (std::size_t b = 0; b < moved.size(); ++b) {
        const auto f = static_cast<std::size_t>(cell_.bodies()[b].frame);
        moved[b] = motionBound(last_[f], frames_[f], reach_[b]);
      }
      const auto w = static_cast<std::size_t>(cell_.workFrame());
      const auto cellsMoved = [&](const Cells& cells) {
        return motionBound(last_[w], frames_[w], cells.reach);
      };
      const double partMoved = cellsMoved(printed_);
      for (std::size_t p = 0; p < pairs_.size(); ++p) {
        const auto [a, b] = pairs_[p];
        slack_[p] -= moved[static_cast<std::size_t>(a)] +
                     (b == kPrintedPart  ? partMoved
                      : b < kPrintedPart ? cellsMoved(groundOf(b).cells)
                                         : moved[static_cast<std::size_t>(b)]);
      }
    }
    last_ = frames_;
  }
  static double motionBound(const Isometry3d& from, const Isometry3d& to, double reach) {
    // The Frobenius norm of R1 - R0 is an upper bound for its spectral norm.
    return (to.translation() - from.translation()).norm() +
           reach * (to.linear() - from.linear()).norm();
  }

  double bodyDistance(int a, int b) const {
    const robot::Body &x = cell_.bodies()[static_cast<std::size_t>(a)],
                      &y = cell_.bodies()[static_cast<std::size_t>(b)];
    const auto &bx = balls_[static_cast<std::size_t>(a)], &by = balls_[static_cast<std::size_t>(b)];
    double nearest = 1e9;
    for (std::size_t i = 0; i < x.shapes.size(); ++i)
      for (std::size_t j = 0; j < y.shapes.size(); ++j) {
        const double apart = (frameOf(a) * bx[i].centre - frameOf(b) * by[j].centre).norm() -
                             bx[i].radius - by[j].radius;
        if (apart >= nearest)
          continue;
        // For distant bodies the distance between their balls suffices.
        nearest = std::min(nearest, apart > 50.0 ? apart
                                                 : distanceBetween(x.shapes[i], frameOf(a),
                                                                   y.shapes[j], frameOf(b)));
      }
    return nearest;
  }

  // Returns the distance to the solid around the cells. Inside the solid, returns 0 if a printed
  // cell is touched, otherwise kAskAgainMm.
  double cellsDistance(int a, const Cells& cells, const PrintState& moment, Vector3d& where) const {
    const robot::Body& body = cell_.bodies()[static_cast<std::size_t>(a)];
    const Isometry3d& base_T_work = frames_[static_cast<std::size_t>(cell_.workFrame())];
    double nearest = 1e9;
    for (std::size_t i = 0; i < body.shapes.size(); ++i) {
      const Ball& ball = balls_[static_cast<std::size_t>(a)][i];
      const Isometry3d work_T_body = base_T_work.inverse(Eigen::Isometry) * frameOf(a);
      const Vector3d centre = work_T_body * ball.centre;
      const double apart = distanceToPoint(cells.hull, centre) - ball.radius;
      if (apart > 0.0) {
        nearest = std::min(nearest, apart);
        continue;
      }
      const double exact =
          distanceBetween(body.shapes[i], work_T_body, cells.hull, Isometry3d::Identity());
      if (exact > 0.0) {
        nearest = std::min(nearest, exact);
        continue;
      }
      const Isometry3d body_T_work = work_T_body.inverse(Eigen::Isometry);
      const auto cell =
          cells.part.firstWithin(centre, ball.radius, moment, [&](const Vector3d& q, double reach) {
            return distanceToPoint(body.shapes[i], body_T_work * q) <= reach;
          });
      if (cell) {
        const Eigen::Vector3i c = cells.part.grid().cell(*cell);
        where = cells.part.grid().centre(c.x(), c.y(), c.z());
        return 0.0;
      }
      nearest = std::min(nearest, kAskAgainMm);
    }
    return nearest;
  }

  // As cellsDistance(), for a body that may not be there yet.
  double groundDistance(int a, const Ground& ground, const PrintState& moment,
                        Vector3d& where) const {
    const bool isThere = ground.firstPiece <= moment.before;
    return cellsDistance(a, ground.cells, isThere ? GroundCells::always() : PrintState{}, where);
  }

  const robot::Cell& cell_;
  const Cells printed_;
  std::vector<Ground> ground_;
  const std::vector<Pair>& pairs_;
  std::vector<std::vector<Ball>> balls_;
  std::vector<double> reach_, slack_, moved_;
  std::vector<Isometry3d> frames_, last_;
};

} // namespace

std::vector<Clash> armClashes(const ExecutedPath& path,
                              const std::vector<std::uint32_t>& firstPiece,
                              const PrintedPart& printed, const GroundSolids& ground,
                              const robot::Cell& cell, const std::vector<char>& known,
                              const base::RunContext& ctx) {
  if (!path.arm)
    return {};
  const auto roleOf = [&](int b) { return cell.bodies()[static_cast<std::size_t>(b)].role; };
  std::vector<Pair> pairs;
  for (const auto& [a, b] : cell.checkedPairs()) {
    const bool headAndPlatform =
        (roleOf(a) == robot::BodyRole::Head && roleOf(b) == robot::BodyRole::Platform) ||
        (roleOf(b) == robot::BodyRole::Head && roleOf(a) == robot::BodyRole::Platform);
    if (!headAndPlatform)
      pairs.push_back({a, b});
  }
  for (const int b : cell.bodiesAgainstPart()) {
    if (roleOf(b) == robot::BodyRole::Head)
      continue;
    pairs.push_back({b, kPrintedPart});
    for (std::size_t g = 0; g < ground.bodies().size(); ++g)
      pairs.push_back({b, kGroundBodies - static_cast<int>(g)});
  }

  const std::size_t samples = path.armMotion.size();
  std::vector<std::vector<Touch>> chunks((samples + kGrain - 1) / kGrain);
  base::parallelChunks(ctx, samples, kGrain, [&](std::size_t begin, std::size_t end) {
    ArmFollower follower(cell, printed, ground, pairs);
    for (std::size_t s = begin; s < end && !ctx.cancelled(); ++s) {
      if (!known.empty() && known[path.armMotion[s]])
        continue;
      const robot::JointVector q = Eigen::Map<const Eigen::VectorXd>(
          path.armJoints.data() + s * static_cast<std::size_t>(path.dof), path.dof);
      PrintState moment;
      moment.before = firstPiece[path.armMotion[s]];
      follower.step(q, s, moment, chunks[begin / kGrain]);
    }
  });
  ctx.checkpoint();
  return gather(
      chunks, [&](std::size_t s) { return static_cast<std::size_t>(path.armMotion[s]); },
      [&](std::size_t s) {
        const std::size_t m = path.armMotion[s];
        return path.startS[m] + static_cast<double>(path.armFraction[s]) * path.durationS[m];
      },
      [&](int p, base::Value& first, base::Value& second) {
        const Pair& pair = pairs[static_cast<std::size_t>(p)];
        const auto named = [&](int body) -> base::Value {
          if (body == kPrintedPart)
            return "printed part"_text;
          if (body >= 0)
            return robot::nameOf(cell.bodies()[static_cast<std::size_t>(body)]);
          return ground.bodies()[static_cast<std::size_t>(kGroundBodies - body)].isPlatform
                     ? "platform"_text
                     : "inserted part"_text;
        };
        first = named(pair.a);
        second = named(pair.b);
      });
}

} // namespace voluta::replay
