#include "replay/clashes.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace voluta::replay {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr std::size_t kGrain = 2048;

// What two bodies do at one sample; `pair` tells contacts apart.
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

// Touches of the chunks, in order of samples within each pair, become clashes.
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
        continue;
      }
      Clash c;
      c.motion = motionOf(t.sample);
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

} // namespace

std::vector<Clash> headClashes(const ExecutedPath& path, const std::vector<BeadPiece>& pieces,
                               const PrintedPart& printed, const process::Process& process,
                               const std::vector<robot::Shape>& platform,
                               const base::RunContext& ctx) {
  const double tolerance = process.contactToleranceMm;
  const HeadSolid againstPlatform(process::erodedHead(process.head, tolerance));
  const HeadSolid againstPart(
      process::erodedHead(process.head, tolerance + 0.5 * printed.grid().pitch));
  const std::vector<std::uint32_t> firstPiece = firstPieceOfMotions(pieces, path.motionCount());
  double platformTop = -1e9;
  std::vector<Ball> platformBalls;
  for (const robot::Shape& shape : platform) {
    platformBalls.push_back(ballRound(shape));
    const auto* prism = std::get_if<robot::Prism>(&shape);
    platformTop = std::max(platformTop, prism != nullptr ? prism->zMax
                                                         : platformBalls.back().centre.z() +
                                                               platformBalls.back().radius);
  }
  enum Pair { kPart, kPlatform };

  std::vector<std::vector<Touch>> chunks((path.motionCount() + kGrain - 1) / kGrain);
  const auto motionOf = [&](std::size_t s) {
    return static_cast<std::size_t>(
               std::upper_bound(path.firstSample.begin(), path.firstSample.end(), s) -
               path.firstSample.begin()) -
           1;
  };
  base::parallelChunks(ctx, path.motionCount(), kGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<Touch>& touches = chunks[begin / kGrain];
    for (std::size_t m = begin; m < end && !ctx.cancelled(); ++m) {
      std::size_t p = firstPiece[m];
      for (std::size_t s = path.firstSample[m]; s < path.firstSample[m + 1]; ++s) {
        const Isometry3d work_T_head = headFrame(path.tip[s], path.direction[s]);
        // The pieces of a motion are its samples' intervals.
        p = std::min<std::size_t>(firstPiece[m] + (s - path.firstSample[m]) + 1, firstPiece[m + 1]);
        Moment moment;
        if (p > 0) {
          const BeadPiece& last = pieces[p - 1];
          const double width = sectionOf(last, 2.0 * process.beadWidthMaxMm).widthMm;
          moment = {static_cast<std::uint32_t>(p), last.run, last.runMm,
                    static_cast<float>(2.0 * width)};
          const Isometry3d head_T_work = work_T_head.inverse(Eigen::Isometry);
          const auto within = [&](const Vector3d& q, double reach) {
            return againstPart.within(head_T_work * q, reach);
          };
          const Ball ball = againstPart.ball();
          if (const auto cell =
                  printed.firstWithin(work_T_head * ball.centre, ball.radius, moment, within)) {
            const Eigen::Vector3i c = printed.grid().cell(*cell);
            touches.push_back({s, kPart, printed.grid().centre(c.x(), c.y(), c.z())});
          }
        }
        if (againstPlatform.lowest(path.tip[s].z(), path.direction[s].z()) > platformTop)
          continue;
        const Ball headBall = againstPlatform.ball();
        for (std::size_t b = 0; b < platform.size(); ++b) {
          if ((work_T_head * headBall.centre - platformBalls[b].centre).norm() >
              headBall.radius + platformBalls[b].radius)
            continue;
          const bool touching = std::any_of(
              againstPlatform.frusta().begin(), againstPlatform.frusta().end(),
              [&](const robot::Shape& f) {
                return distanceBetween(f, work_T_head, platform[b], Isometry3d::Identity()) <= 0.0;
              });
          if (touching) {
            touches.push_back({s, kPlatform, path.tip[s]});
            break;
          }
        }
      }
    }
  });
  ctx.checkpoint();
  return gather(
      chunks, motionOf,
      [&](std::size_t s) {
        const std::size_t m = motionOf(s);
        const double share = static_cast<double>(s - path.firstSample[m] + 1) /
                             static_cast<double>(path.firstSample[m + 1] - path.firstSample[m]);
        return path.startS[m] + share * path.durationS[m];
      },
      [](int pair, std::string& first, std::string& second) {
        first = "head";
        second = pair == kPart ? "printed part" : "platform";
      });
}

namespace {

struct Pair {
  int a = 0, b = 0; // bodies; b == -1: the printed part
};

// Follows the cell's bodies from sample to sample.
class ArmFollower {
public:
  ArmFollower(const robot::Cell& cell, const PrintedPart& printed, const std::vector<Pair>& pairs)
      : cell_(cell), printed_(printed), pairs_(pairs), slack_(pairs.size(), -1.0) {
    for (const robot::Body& body : cell.bodies()) {
      std::vector<Ball> balls;
      for (const robot::Shape& shape : body.shapes)
        balls.push_back(ballRound(shape));
      double reach = 0.0;
      for (const Ball& b : balls)
        reach = std::max(reach, b.centre.norm() + b.radius);
      balls_.push_back(std::move(balls));
      reach_.push_back(reach);
    }
    const voxel::VoxelGrid& g = printed.grid();
    const Vector3d half = 0.5 * g.pitch * g.size.cast<double>();
    partBox_ = robot::Box{Isometry3d(Eigen::Translation3d(g.origin + half)), half};
  }

  void step(const robot::JointVector& q, std::size_t sample, const Moment& moment,
            std::vector<Touch>& touches) {
    frames_.clear();
    cell_.framePoses(q, frames_);
    moveOn();
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      if (slack_[p] > 0.0)
        continue;
      Vector3d where = Vector3d::Zero();
      const double d = pairs_[p].b < 0 ? partDistance(pairs_[p].a, moment, where)
                                       : bodyDistance(pairs_[p].a, pairs_[p].b);
      if (d <= 0.0) {
        if (pairs_[p].b >= 0)
          where = frames_[static_cast<std::size_t>(cell_.workFrame())].inverse(Eigen::Isometry) *
                  frames_[static_cast<std::size_t>(cell_.toolFrame())].translation();
        touches.push_back({sample, static_cast<int>(p), where});
      }
      slack_[p] = d;
    }
  }

private:
  const Isometry3d& frameOf(int body) const {
    return frames_[static_cast<std::size_t>(cell_.bodies()[static_cast<std::size_t>(body)].frame)];
  }

  // Takes off each pair's slack what its bodies have moved towards each other at most.
  void moveOn() {
    if (!last_.empty()) {
      std::vector<double>& moved = moved_;
      moved.resize(cell_.bodies().size());
      for (std::size_t b = 0; b < moved.size(); ++b) {
        const auto f = static_cast<std::size_t>(cell_.bodies()[b].frame);
        moved[b] = motionBound(last_[f], frames_[f], reach_[b]);
      }
      const auto w = static_cast<std::size_t>(cell_.workFrame());
      const double partMoved =
          motionBound(last_[w], frames_[w],
                      std::get<robot::Box>(partBox_).frame_T_box.translation().norm() +
                          std::get<robot::Box>(partBox_).half.norm());
      for (std::size_t p = 0; p < pairs_.size(); ++p)
        slack_[p] -= moved[static_cast<std::size_t>(pairs_[p].a)] +
                     (pairs_[p].b < 0 ? partMoved : moved[static_cast<std::size_t>(pairs_[p].b)]);
    }
    last_ = frames_;
  }
  static double motionBound(const Isometry3d& from, const Isometry3d& to, double reach) {
    // |R1 - R0| in the Frobenius norm is no less than in the spectral one.
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
        // Far apart the balls say enough.
        nearest = std::min(nearest, apart > 50.0 ? apart
                                                 : distanceBetween(x.shapes[i], frameOf(a),
                                                                   y.shapes[j], frameOf(b)));
      }
    return nearest;
  }

  // Distance to the box of what is printed; within it, 0 if a printed cell is touched and else the
  // least slack, so that it is asked again at once.
  double partDistance(int a, const Moment& moment, Vector3d& where) const {
    const robot::Body& body = cell_.bodies()[static_cast<std::size_t>(a)];
    const Isometry3d& base_T_work = frames_[static_cast<std::size_t>(cell_.workFrame())];
    double nearest = 1e9;
    for (std::size_t i = 0; i < body.shapes.size(); ++i) {
      const Ball& ball = balls_[static_cast<std::size_t>(a)][i];
      const Isometry3d work_T_body = base_T_work.inverse(Eigen::Isometry) * frameOf(a);
      const Vector3d centre = work_T_body * ball.centre;
      const double apart = distanceToPoint(partBox_, centre) - ball.radius;
      if (apart > 0.0) {
        nearest = std::min(nearest, apart);
        continue;
      }
      const double exact =
          distanceBetween(body.shapes[i], work_T_body, partBox_, Isometry3d::Identity());
      if (exact > 0.0) {
        nearest = std::min(nearest, exact);
        continue;
      }
      const Isometry3d body_T_work = work_T_body.inverse(Eigen::Isometry);
      const auto cell =
          printed_.firstWithin(centre, ball.radius, moment, [&](const Vector3d& q, double reach) {
            return distanceToPoint(body.shapes[i], body_T_work * q) <= reach;
          });
      if (cell) {
        const Eigen::Vector3i c = printed_.grid().cell(*cell);
        where = printed_.grid().centre(c.x(), c.y(), c.z());
        return 0.0;
      }
      nearest = std::min(nearest, 1e-6);
    }
    return nearest;
  }

  const robot::Cell& cell_;
  const PrintedPart& printed_;
  const std::vector<Pair>& pairs_;
  robot::Shape partBox_;
  std::vector<std::vector<Ball>> balls_;
  std::vector<double> reach_, slack_, moved_;
  std::vector<Isometry3d> frames_, last_;
};

} // namespace

std::vector<Clash> armClashes(const ExecutedPath& path, const std::vector<BeadPiece>& pieces,
                              const PrintedPart& printed, const robot::Cell& cell,
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
  for (const int b : cell.bodiesAgainstPart())
    if (roleOf(b) != robot::BodyRole::Head)
      pairs.push_back({b, -1});

  const std::vector<std::uint32_t> firstPiece = firstPieceOfMotions(pieces, path.motionCount());
  const std::size_t samples = path.armMotion.size();
  std::vector<std::vector<Touch>> chunks((samples + kGrain - 1) / kGrain);
  base::parallelChunks(ctx, samples, kGrain, [&](std::size_t begin, std::size_t end) {
    ArmFollower follower(cell, printed, pairs);
    for (std::size_t s = begin; s < end && !ctx.cancelled(); ++s) {
      const robot::JointVector q = Eigen::Map<const Eigen::VectorXd>(
          path.armJoints.data() + s * static_cast<std::size_t>(path.dof), path.dof);
      Moment moment;
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
      [&](int p, std::string& first, std::string& second) {
        const Pair& pair = pairs[static_cast<std::size_t>(p)];
        first = cell.bodies()[static_cast<std::size_t>(pair.a)].name;
        second = pair.b < 0 ? "printed part" : cell.bodies()[static_cast<std::size_t>(pair.b)].name;
      });
}

} // namespace voluta::replay
