#include "record/run_alignment.h"

#include "base/run_context.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace voluta::record {

namespace {
using Eigen::Vector3d;

constexpr double kNodeMm = 0.5;   // spacing of the places that samples are assigned to
constexpr double kSampleMm = 0.2; // samples nearer to each other are assigned together
constexpr int kBand = 192;        // places considered for each sample
constexpr double kInfinite = std::numeric_limits<double>::infinity();

struct Nodes {
  std::vector<Vector3d> tip;
  std::vector<double> alongMm;
};

Nodes nodesOf(const PlannedRun& planned) {
  Nodes nodes;
  const auto add = [&](const Vector3d& tip, double alongMm) {
    nodes.tip.push_back(tip);
    nodes.alongMm.push_back(alongMm);
  };
  add(planned.tip.front(), 0.0);
  for (std::size_t i = 1; i < planned.size(); ++i) {
    const double from = planned.alongMm[i - 1], length = planned.alongMm[i] - from;
    // Dense vertices share a node, so that the band has the same length everywhere.
    while (planned.alongMm[i] - nodes.alongMm.back() >= kNodeMm) {
      const double along = nodes.alongMm.back() + kNodeMm;
      const double share = length > 0.0 ? std::clamp((along - from) / length, 0.0, 1.0) : 1.0;
      add(planned.tip[i - 1] + share * (planned.tip[i] - planned.tip[i - 1]), along);
    }
  }
  add(planned.tip.back(), planned.lengthMm());
  return nodes;
}

// Returns the samples that move away from the one before, and the last one.
std::vector<std::size_t> movingSamples(const std::vector<Vector3d>& tip, std::size_t first) {
  std::vector<std::size_t> moving{first};
  for (std::size_t i = first + 1; i < tip.size(); ++i)
    if ((tip[i] - tip[moving.back()]).norm() >= kSampleMm)
      moving.push_back(i);
  return moving;
}

constexpr std::size_t kFollowed = 200; // samples that decide where a record meets the path

// Returns the mean of the capped squared distances of the next samples, from `first` on, from the
// nodes that follow `node`, taken greedily [mm2].
double costFrom(const std::vector<Vector3d>& tip, const std::vector<std::size_t>& moving,
                std::size_t first, const Nodes& nodes, std::size_t node) {
  constexpr std::size_t kMinAhead = 12, kMaxAhead = 2000;
  const std::size_t end = std::min(moving.size(), first + kFollowed);
  double sum = 0.0;
  for (std::size_t k = first; k < end; ++k) {
    const double movedMm = k > first ? (tip[moving[k]] - tip[moving[k - 1]]).norm() : 0.0;
    const std::size_t ahead = std::clamp(
        static_cast<std::size_t>(std::ceil(1.5 * movedMm / kNodeMm)) + 1, kMinAhead, kMaxAhead);
    double minimum = kInfinite;
    std::size_t at = node;
    for (std::size_t j = node; j < std::min(node + ahead, nodes.tip.size()); ++j)
      if (const double d = (nodes.tip[j] - tip[moving[k]]).squaredNorm(); d < minimum) {
        minimum = d;
        at = j;
      }
    node = at;
    sum += std::min(minimum, kNearMm * kNearMm);
  }
  return sum / static_cast<double>(end - first);
}

struct Meeting {
  std::size_t node = 0;
  double costMm2 = 0.0; // of costFrom
};

// Returns where the path, from node `from` on, is near the moving sample `first`: of its passes the
// one that the next samples follow best, of equal ones the first.
std::optional<Meeting> meetingOf(const std::vector<Vector3d>& tip,
                                 const std::vector<std::size_t>& moving, std::size_t first,
                                 const Nodes& nodes, std::size_t from) {
  constexpr double kSameMm2 = 0.005;
  const Vector3d& p = tip[moving[first]];
  std::vector<std::size_t> near; // the nearest node of each pass
  bool within = false;
  for (std::size_t j = from; j < nodes.tip.size(); ++j) {
    const double d = (nodes.tip[j] - p).squaredNorm();
    if (d > kNearMm * kNearMm) {
      within = false;
      continue;
    }
    if (!within)
      near.push_back(j);
    else if (d < (nodes.tip[near.back()] - p).squaredNorm())
      near.back() = j;
    within = true;
  }
  std::optional<Meeting> best;
  for (const std::size_t node : near)
    if (const double cost = costFrom(tip, moving, first, nodes, node);
        !best || cost < best->costMm2 - kSameMm2)
      best = Meeting{node, cost};
  return best;
}

struct Start {
  std::size_t sample = 0, node = 0;
};

// Returns where the record meets the path first. Its samples may be anywhere before.
std::optional<Start> startOf(const std::vector<Vector3d>& tip, const Nodes& nodes,
                             const base::RunContext& ctx) {
  // An arm that waits, perhaps for minutes, is as far from the path as before.
  const std::vector<std::size_t> moving = movingSamples(tip, 0);
  for (std::size_t k = 0; k < moving.size(); ++k) {
    ctx.checkpoint();
    if (const auto met = meetingOf(tip, moving, k, nodes, 0))
      return Start{moving[k], met->node};
  }
  return std::nullopt;
}

// One row of the dynamic programme: costs of the nodes [low, low + kBand).
struct Row {
  std::size_t low = 0;
  std::array<double, kBand> cost;
};

class Band {
public:
  Band(const std::vector<Vector3d>& tip, const Nodes& nodes, const std::vector<std::size_t>& moving,
       std::size_t startNode)
      : tip_(tip), nodes_(nodes), moving_(moving) {
    low_.reserve(moving.size());
    from_.reserve(moving.size());
    Row row;
    row.low = startNode > kBand / 4 ? startNode - kBand / 4 : 0;
    for (int k = 0; k < kBand; ++k)
      row.cost[static_cast<std::size_t>(k)] = own(0, row.low + static_cast<std::size_t>(k));
    push(row, {});
    last_ = row;
  }

  void run(const base::RunContext& ctx) {
    for (std::size_t r = 1; r < moving_.size(); ++r) {
      if (r % 1024 == 0)
        ctx.report(static_cast<double>(r) / static_cast<double>(moving_.size()), "aligning"_text);
      step(r);
    }
  }

  // Returns the node of each moving sample.
  std::vector<std::size_t> nodesOfSamples() const {
    std::vector<std::size_t> node(moving_.size());
    std::size_t at = last_.low + static_cast<std::size_t>(std::ranges::min_element(last_.cost) -
                                                          last_.cost.begin());
    for (std::size_t r = moving_.size(); r-- > 0;) {
      node[r] = at;
      if (r > 0)
        at = low_[r - 1] + from_[r][at - low_[r]];
    }
    return node;
  }

private:
  // Far samples cost the same everywhere: they do not pull the band along.
  double own(std::size_t r, std::size_t node) const {
    if (node >= nodes_.tip.size())
      return kInfinite;
    return std::min((tip_[moving_[r]] - nodes_.tip[node]).squaredNorm(), 4.0 * kNearMm * kNearMm);
  }

  void push(const Row& row, const std::array<std::uint8_t, kBand>& from) {
    low_.push_back(row.low);
    from_.push_back(from);
  }

  void step(std::size_t r) {
    constexpr double kSkipMm2PerMm = 1.0; // for what the plan has moved more than the record
    const auto best =
        static_cast<std::size_t>(std::ranges::min_element(last_.cost) - last_.cost.begin());
    Row row;
    row.low = std::max(last_.low, last_.low + best > kBand / 4 ? last_.low + best - kBand / 4 : 0);
    const double movedMm = (tip_[moving_[r]] - tip_[moving_[r - 1]]).norm();
    const auto free = static_cast<std::size_t>(std::ceil(1.5 * movedMm / kNodeMm)) + 1;
    std::array<std::uint8_t, kBand> from{};
    // Least cost of the nodes before the free ones, each with the skip up to the present node.
    double skipped = kInfinite;
    std::size_t skippedFrom = 0, next = 0;
    for (std::size_t k = 0; k < kBand; ++k) {
      const std::size_t node = row.low + k;
      const std::size_t end = std::min<std::size_t>(node - last_.low + 1, kBand);
      const std::size_t begin = node - last_.low > free ? node - last_.low - free : 0;
      skipped += kSkipMm2PerMm * kNodeMm;
      for (; next < std::min<std::size_t>(begin, kBand); ++next)
        if (const double cost =
                last_.cost[next] + kSkipMm2PerMm * kNodeMm * static_cast<double>(begin - next);
            cost < skipped) {
          skipped = cost;
          skippedFrom = next;
        }
      double minimum = skipped;
      std::size_t at = skippedFrom;
      for (std::size_t j = std::min<std::size_t>(begin, kBand); j < end; ++j)
        if (last_.cost[j] <= minimum) {
          minimum = last_.cost[j];
          at = j;
        }
      row.cost[k] = minimum + own(r, node);
      from[k] = static_cast<std::uint8_t>(at);
    }
    if (isLost(r, row.low))
      searchAhead(r, best, row, from);
    push(row, from);
    last_ = row;
  }

  bool isLost(std::size_t r, std::size_t low) const {
    for (std::size_t k = 0; k < kBand; ++k)
      if (own(r, low + k) <= kNearMm * kNearMm)
        return false;
    return true;
  }

  // Moves the row of a sample that the band has lost to where the path meets the record again, from
  // the node `best` of the row before.
  void searchAhead(std::size_t r, std::size_t best, Row& row,
                   std::array<std::uint8_t, kBand>& from) {
    constexpr std::size_t kMaxWait = 50; // bounds the searches of a record that stays away
    constexpr double kFollowsMm2 = 0.25 * kNearMm * kNearMm;
    if (r < nextSearch_)
      return;
    searches_ = std::min(searches_ + 1, kMaxWait);
    nextSearch_ = r + searches_;
    const auto met = meetingOf(tip_, moving_, r, nodes_, row.low + kBand);
    if (!met || met->costMm2 > kFollowsMm2)
      return;
    searches_ = 0;
    row.low = met->node - kBand / 4;
    for (std::size_t k = 0; k < kBand; ++k)
      row.cost[k] = last_.cost[best] + own(r, row.low + k);
    from.fill(static_cast<std::uint8_t>(best));
  }

  const std::vector<Vector3d>& tip_;
  const Nodes& nodes_;
  const std::vector<std::size_t>& moving_;
  std::vector<std::size_t> low_;
  std::vector<std::array<std::uint8_t, kBand>> from_;
  Row last_;
  std::size_t searches_ = 0, nextSearch_ = 0; // of samples that the band has lost
};

// Returns the place of the path between two lengths that is nearest to a point.
AlignedSample nearest(const Vector3d& p, const PlannedRun& planned, double fromMm, double toMm) {
  AlignedSample best{fromMm, kInfinite};
  for (std::size_t s = placeAt(planned, fromMm).segment; s < planned.size(); ++s) {
    const double begin = planned.alongMm[s - 1], end = planned.alongMm[s];
    if (begin > toMm)
      break;
    const Vector3d &a = planned.tip[s - 1], chord = planned.tip[s] - a;
    const double length = end - begin;
    double share = length > 0.0 ? (p - a).dot(chord) / (length * length) : 1.0;
    const double low = length > 0.0 ? std::clamp((fromMm - begin) / length, 0.0, 1.0) : 1.0;
    const double high = length > 0.0 ? std::clamp((toMm - begin) / length, low, 1.0) : 1.0;
    share = std::clamp(share, low, high);
    if (const double d = (p - a - share * chord).norm(); d < best.distanceMm)
      best = {std::max(fromMm, begin + share * length), d};
  }
  return best;
}

} // namespace

std::optional<PathAlignment> alignRecord(const std::vector<Vector3d>& tip,
                                         const PlannedRun& planned, const base::RunContext& ctx) {
  if (planned.size() < 2)
    return std::nullopt;
  const Nodes nodes = nodesOf(planned);
  const std::optional<Start> start = startOf(tip, nodes, ctx);
  if (!start)
    return std::nullopt;
  const std::vector<std::size_t> moving = movingSamples(tip, start->sample);
  Band band(tip, nodes, moving, start->node);
  band.run(ctx);
  const std::vector<std::size_t> node = band.nodesOfSamples();

  PathAlignment out;
  out.first = start->sample;
  double reached = 0.0;
  for (std::size_t r = 0; r < moving.size(); ++r) {
    const std::size_t until = r + 1 < moving.size() ? moving[r + 1] : tip.size();
    const double low = nodes.alongMm[node[r]] - kNodeMm;
    // Samples up to the next moving one have hardly left this one, even where that one is far on.
    const double high = std::min(nodes.alongMm[r + 1 < moving.size() ? node[r + 1] : node[r]],
                                 nodes.alongMm[node[r]] + 2.0 * kNodeMm) +
                        kNodeMm;
    for (std::size_t i = moving[r]; i < until; ++i) {
      // A sample between two moving ones is beside the first of them.
      const double maximum = i == moving[r] ? nodes.alongMm[node[r]] + kNodeMm : high;
      const AlignedSample at =
          nearest(tip[i], planned, std::max(reached, low), std::max(reached, maximum));
      reached = at.alongMm;
      out.samples.push_back(at);
    }
  }
  out.end = tip.size();
  while (out.end > out.first && out.samples.back().distanceMm > kNearMm) {
    out.samples.pop_back();
    --out.end;
  }
  return out.samples.empty() ? std::nullopt : std::optional(std::move(out));
}

} // namespace voluta::record
