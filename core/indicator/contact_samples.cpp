#include "indicator/contact_samples.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "indicator/joint_circle.h"

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <set>
#include <tuple>
#include <utility>

namespace voluta::indicator {

using robot::JointVector;

namespace {

constexpr std::size_t kChunk = 16;
// A round adds at most 1 / kRoundShare of the present samples, so that later rounds take them into
// account.
constexpr std::size_t kRoundShare = 4;

struct Pair {
  double apart;
  std::size_t a, b;
};

class Sampler {
public:
  Sampler(const std::vector<robot::JointLimits>& limits, const TrueCheck& collides,
          const Projection& project, const ContactSampling& options, const base::RunContext& ctx)
      : limits_(limits), collides_(collides), project_(project), options_(options), ctx_(ctx),
        engine_(options.seed),
        points_(circleSize(limits), static_cast<Eigen::Index>(options.samples)) {}

  void begin(const std::vector<JointVector>& first) {
    std::vector<Fresh> fresh;
    for (std::size_t i = 0; i < std::min(first.size(), options_.samples); ++i)
      fresh.push_back({first[i], true, false});
    judge(fresh);
    for (const Fresh& f : fresh)
      add(f);
  }

  // One round over pairs that are further apart than `minDistance` and not yet halved; `ofBorder`:
  // over pairs of which exactly one collides. Returns false if there are none, or no room.
  bool round(double minDistance, bool ofBorder, std::size_t maxCount) {
    if (samples_.size() >= maxCount)
      return false;
    std::vector<Pair> pairs = pairsApart(minDistance, ofBorder);
    std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) {
      return std::tie(y.apart, x.a, x.b) < std::tie(x.apart, y.a, y.b);
    });
    const std::size_t room =
        std::min(maxCount - samples_.size(), samples_.size() / kRoundShare + 1);
    // Some will be too near to others; the rest beyond this number waits for the next round.
    pairs.resize(std::min(pairs.size(), 2 * room));
    std::bernoulli_distribution half(0.5);
    std::vector<Fresh> fresh;
    for (const Pair& pair : pairs)
      fresh.push_back(
          {jointMidpoint(samples_[pair.a].q, samples_[pair.b].q, limits_), half(engine_), false});
    base::parallelChunks(ctx_, fresh.size(), kChunk, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e; ++i)
        if (fresh[i].onContact) {
          const std::optional<JointVector> q = project_(fresh[i].q);
          fresh[i].onContact = q.has_value();
          if (q)
            fresh[i].q = *q;
        }
    });
    std::vector<Fresh> kept;
    for (std::size_t i = 0; i < fresh.size() && kept.size() < room; ++i) {
      halved_[ofBorder].emplace(pairs[i].a, pairs[i].b);
      if (isApart(fresh[i].q, kept, 0.5 * minDistance))
        kept.push_back(fresh[i]);
    }
    judge(kept);
    for (const Fresh& f : kept)
      add(f);
    ctx_.checkpoint();
    return !pairs.empty();
  }

  std::size_t size() const { return samples_.size(); }
  std::vector<JudgedJoints> take() { return std::move(samples_); }

private:
  struct Fresh {
    JointVector q;
    bool onContact, collides;
  };

  void judge(std::vector<Fresh>& fresh) const {
    base::parallelChunks(ctx_, fresh.size(), kChunk, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e; ++i)
        fresh[i].collides = collides_(fresh[i].q);
    });
  }

  void add(const Fresh& f) {
    points_.col(static_cast<Eigen::Index>(samples_.size())) = onCircle(f.q, limits_);
    samples_.push_back({f.q, f.collides});
    onContact_.push_back(f.onContact);
  }

  // Returns the squared distances of all samples to a point.
  Eigen::VectorXd distances(const Eigen::VectorXd& point) const {
    return (points_.leftCols(static_cast<Eigen::Index>(samples_.size())).colwise() - point)
        .colwise()
        .squaredNorm();
  }

  bool isApart(const JointVector& q, const std::vector<Fresh>& others, double minDistance) const {
    const Eigen::VectorXd point = onCircle(q, limits_);
    return distances(point).minCoeff() >= minDistance * minDistance &&
           std::none_of(others.begin(), others.end(), [&](const Fresh& o) {
             return (onCircle(o.q, limits_) - point).squaredNorm() < minDistance * minDistance;
           });
  }

  // Returns the pairs of a sample on the contact space and one of its nearest neighbours that are
  // further apart than `minDistance`.
  std::vector<Pair> pairsApart(double minDistance, bool ofBorder) const {
    std::vector<std::vector<Pair>> found(samples_.size());
    base::parallelChunks(ctx_, samples_.size(), kChunk, [&](std::size_t b, std::size_t e) {
      std::vector<std::pair<double, std::size_t>> near;
      for (std::size_t i = b; i < e; ++i) {
        if (!onContact_[i])
          continue;
        const Eigen::VectorXd apart = distances(points_.col(static_cast<Eigen::Index>(i)));
        near.clear();
        for (std::size_t o = 0; o < samples_.size(); ++o)
          if (o != i)
            near.emplace_back(apart[static_cast<Eigen::Index>(o)], o);
        const std::size_t k = std::min(options_.neighbours, near.size());
        std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(k), near.end());
        for (std::size_t n = 0; n < k; ++n) {
          const auto& [squared, o] = near[n];
          const bool wanted = !ofBorder || samples_[i].collides != samples_[o].collides;
          if (wanted && squared > minDistance * minDistance &&
              !halved_[ofBorder].contains({std::min(i, o), std::max(i, o)}))
            found[i].push_back({std::sqrt(squared), std::min(i, o), std::max(i, o)});
        }
      }
    });
    std::vector<Pair> all;
    for (const std::vector<Pair>& of : found)
      all.insert(all.end(), of.begin(), of.end());
    std::sort(all.begin(), all.end(),
              [](const Pair& x, const Pair& y) { return std::tie(x.a, x.b) < std::tie(y.a, y.b); });
    all.erase(std::unique(all.begin(), all.end(),
                          [](const Pair& x, const Pair& y) { return x.a == y.a && x.b == y.b; }),
              all.end());
    return all;
  }

  const std::vector<robot::JointLimits>& limits_;
  const TrueCheck& collides_;
  const Projection& project_;
  const ContactSampling& options_;
  const base::RunContext& ctx_;
  std::mt19937_64 engine_;
  Eigen::MatrixXd points_; // a column per sample
  std::vector<JudgedJoints> samples_;
  std::vector<char> onContact_;
  // Inside, and across the border
  std::array<std::set<std::pair<std::size_t, std::size_t>>, 2> halved_;
};

} // namespace

std::vector<JudgedJoints> contactSamples(const std::vector<JointVector>& first,
                                         const std::vector<robot::JointLimits>& limits,
                                         const TrueCheck& collides, const Projection& project,
                                         const ContactSampling& options,
                                         const base::RunContext& ctx) {
  base::require(!first.empty() && options.samples > 0, "there is a sample to begin with");
  base::require(0.0 < options.borderRad && options.borderRad < options.evenRad,
                "samples are denser at the border");
  Sampler sampler(limits, collides, project, options, ctx);
  sampler.begin(first);
  // Half of the samples are reserved for the border, regardless of the surface's size. If it needs
  // fewer, the spacing is reduced everywhere, the border included.
  const std::size_t even = (options.samples + sampler.size()) / 2;
  int phases = 0;
  const auto ends = [&] { return options.phases > 0 && ++phases >= options.phases; };
  for (double apart = options.evenRad; apart > options.borderRad; apart *= 0.5) {
    while (sampler.round(apart, false, even)) {
    }
    if (ends())
      break;
    while (sampler.round(options.borderRad, true, options.samples)) {
    }
    if (ends())
      break;
  }
  return sampler.take();
}

} // namespace voluta::indicator
