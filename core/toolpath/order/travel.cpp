#include "toolpath/order/travel.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr int kRounds = 6;          // of orders and begins, at most
constexpr int kPasses = 8;          // over the moves within a turn
constexpr std::size_t kWindow = 60; // stops: the furthest of a move within a turn
constexpr std::size_t kSegment = 3; // stops that an Or-opt move shifts at once
constexpr double kGainMm = 1e-6;    // moves that gain less are rounding
constexpr std::size_t kBegins = 12; // candidates of a closed stop

const Vector3d& entry(std::span<const Stop> stops, const Visit& v) {
  return stops[v.stop].ends[v.begin];
}
const Vector3d& exit(std::span<const Stop> stops, const Visit& v) {
  const Stop& stop = stops[v.stop];
  return stop.ends[stop.closed ? v.begin : 1 - v.begin];
}
Visit reversed(std::span<const Stop> stops, const Visit& v) {
  return stops[v.stop].closed ? v : Visit{v.stop, 1 - v.begin};
}

std::size_t nearestOf(const std::vector<Vector3d>& points, const Vector3d& to) {
  const auto nearest = std::ranges::min_element(
      points, {}, [&](const Vector3d& p) { return (p - to).squaredNorm(); });
  return static_cast<std::size_t>(nearest - points.begin());
}

// Whether the begin of a stop depends on where the neighbours are.
bool isFree(const Stop& stop) {
  return stop.closed && stop.ends.size() > 1;
}

// Appends the ends of the next visit, forwards or backwards, that cannot begin anywhere.
void appendAnchors(std::span<const Stop> stops, std::span<const Visit> visits, std::size_t k,
                   bool forwards, std::vector<Vector3d>& anchors) {
  while (forwards ? k + 1 < visits.size() : k > 0) {
    k = forwards ? k + 1 : k - 1;
    const Stop& stop = stops[visits[k].stop];
    if (isFree(stop))
      continue;
    anchors.insert(anchors.end(), stop.ends.begin(), stop.ends.end());
    return;
  }
}

// Returns the begins worth trying: all of an open stop; of a closed one, the current begin, and the
// points nearest to the anchors around and between them.
std::vector<std::size_t> candidates(std::span<const Stop> stops, std::span<const Visit> visits,
                                    std::size_t k) {
  const Stop& stop = stops[visits[k].stop];
  if (!stop.closed)
    return {0, 1};
  std::vector<std::size_t> begins{visits[k].begin};
  if (!isFree(stop))
    return begins;
  std::vector<Vector3d> anchors;
  appendAnchors(stops, visits, k, false, anchors);
  const std::size_t before = anchors.size();
  appendAnchors(stops, visits, k, true, anchors);
  if (k > 0)
    anchors.push_back(exit(stops, visits[k - 1]));
  if (k + 1 < visits.size())
    anchors.push_back(entry(stops, visits[k + 1]));
  std::array<double, kBegins> minimum;
  minimum.fill(std::numeric_limits<double>::infinity());
  std::array<std::size_t, kBegins> best{};
  std::array<double, 6> distance{};
  for (std::size_t p = 0; p < stop.ends.size(); ++p) {
    std::size_t slot = 0;
    const auto offer = [&](double d) {
      if (d < minimum[slot]) {
        minimum[slot] = d;
        best[slot] = p;
      }
      ++slot;
    };
    for (std::size_t a = 0; a < anchors.size(); ++a)
      offer(distance[a] = (stop.ends[p] - anchors[a]).norm());
    const std::size_t after = std::min(anchors.size(), before + 2);
    for (std::size_t a = 0; a < before; ++a)
      for (std::size_t b = before; b < after; ++b)
        offer(distance[a] + distance[b]);
  }
  for (std::size_t slot = 0; slot < kBegins; ++slot)
    if (minimum[slot] < std::numeric_limits<double>::infinity() &&
        std::ranges::find(begins, best[slot]) == begins.end())
      begins.push_back(best[slot]);
  return begins;
}

// One turn's part of the visits, between two points that stay.
class GroupOrder {
public:
  GroupOrder(std::span<const Stop> stops, std::span<Visit> visits, const Vector3d* before,
             const Vector3d* after)
      : stops_(stops), visits_(visits), before_(before), after_(after) {}

  void shorten() {
    for (int pass = 0; pass < kPasses; ++pass)
      if (const bool turned = twoOpt(); !orOpt() && !turned)
        return;
  }

private:
  using Index = std::ptrdiff_t;
  Index size() const { return std::ssize(visits_); }
  const Visit& at(Index k) const { return visits_[static_cast<std::size_t>(k)]; }
  // nullptr: no move begins or ends there.
  const Vector3d* exitOf(Index k) const { return k < 0 ? before_ : &exit(stops_, at(k)); }
  const Vector3d* entryOf(Index k) const { return k < size() ? &entry(stops_, at(k)) : after_; }
  static double between(const Vector3d* a, const Vector3d* b) {
    return a && b ? (*b - *a).norm() : 0.0;
  }

  void reverse(Index first, Index last) {
    const auto part = visits_.subspan(static_cast<std::size_t>(first),
                                      static_cast<std::size_t>(last - first + 1));
    std::ranges::reverse(part);
    for (Visit& v : part)
      v = reversed(stops_, v);
  }

  bool twoOpt() {
    bool any = false;
    for (Index i = 0; i < size(); ++i)
      for (Index j = i; j < std::min(size(), i + static_cast<Index>(kWindow)); ++j) {
        const Vector3d *from = exitOf(i - 1), *to = entryOf(j + 1);
        const double now = between(from, entryOf(i)) + between(exitOf(j), to);
        if (between(from, exitOf(j)) + between(entryOf(i), to) < now - kGainMm) {
          reverse(i, j);
          any = true;
        }
      }
    return any;
  }

  // Moves the stops [i, i + n) between k and k + 1, reversed or not.
  bool shift(Index i, Index n, Index k) {
    const Vector3d *begin = entryOf(i), *end = exitOf(i + n - 1);
    const Vector3d *a = exitOf(k), *b = entryOf(k + 1);
    const double gain = between(exitOf(i - 1), begin) + between(end, entryOf(i + n)) -
                        between(exitOf(i - 1), entryOf(i + n)) + between(a, b);
    const double straight = between(a, begin) + between(end, b);
    const double turned = between(a, end) + between(begin, b);
    if (std::min(straight, turned) > gain - kGainMm)
      return false;
    if (turned < straight)
      reverse(i, i + n - 1);
    const auto first = visits_.begin();
    if (k < i)
      std::rotate(first + k + 1, first + i, first + i + n);
    else
      std::rotate(first + i, first + i + n, first + k + 1);
    return true;
  }

  bool orOpt() {
    bool any = false;
    for (Index n = 1; n <= std::min(static_cast<Index>(kSegment), size() - 1); ++n)
      for (Index i = 0; i + n <= size(); ++i) {
        const Index low = std::max<Index>(-1, i - static_cast<Index>(kWindow));
        const Index high = std::min(size() - 1, i + n + static_cast<Index>(kWindow));
        for (Index k = low; k <= high; ++k)
          if ((k < i - 1 || k > i + n - 1) && shift(i, n, k)) {
            any = true;
            break;
          }
      }
    return any;
  }

  std::span<const Stop> stops_;
  std::span<Visit> visits_;
  const Vector3d *before_, *after_;
};
} // namespace

double travelMm(std::span<const Stop> stops, std::span<const Visit> visits,
                const std::optional<Vector3d>& from) {
  double mm = from && !visits.empty() ? (entry(stops, visits.front()) - *from).norm() : 0.0;
  for (std::size_t k = 1; k < visits.size(); ++k)
    mm += (entry(stops, visits[k]) - exit(stops, visits[k - 1])).norm();
  return mm;
}

std::vector<Visit> visitNearestFirst(std::span<const Stop> stops, std::span<const StopGroup> groups,
                                     const Vector3d& from) {
  std::vector<Visit> visits;
  Vector3d here = from;
  for (const StopGroup& group : groups) {
    StopGroup left = group;
    while (!left.empty()) {
      double nearest = std::numeric_limits<double>::infinity();
      auto next = left.begin();
      Visit visit;
      for (auto it = left.begin(); it != left.end(); ++it) {
        const std::vector<Vector3d>& ends = stops[*it].ends;
        const std::size_t begin = nearestOf(ends, here);
        if (const double d = (ends[begin] - here).squaredNorm(); d < nearest) {
          nearest = d;
          next = it;
          visit = {*it, begin};
        }
      }
      left.erase(next);
      visits.push_back(visit);
      here = exit(stops, visit);
    }
  }
  return visits;
}

void chooseBegins(std::span<const Stop> stops, std::span<Visit> visits,
                  const std::optional<Vector3d>& from) {
  if (visits.empty())
    return;
  struct State {
    std::size_t begin, previous;
    double mm;
  };
  // The least travel to each begin of each visit, given that of the visit before.
  std::vector<std::vector<State>> states(visits.size());
  for (std::size_t k = 0; k < visits.size(); ++k)
    for (const std::size_t begin : candidates(stops, visits, k)) {
      const Visit here{visits[k].stop, begin};
      State state{begin, 0, from && k == 0 ? (entry(stops, here) - *from).norm() : 0.0};
      if (k > 0) {
        state.mm = std::numeric_limits<double>::infinity();
        for (std::size_t s = 0; s < states[k - 1].size(); ++s) {
          const Visit last{visits[k - 1].stop, states[k - 1][s].begin};
          const double mm = states[k - 1][s].mm + (entry(stops, here) - exit(stops, last)).norm();
          if (mm < state.mm) {
            state.mm = mm;
            state.previous = s;
          }
        }
      }
      states[k].push_back(state);
    }
  const auto minimum = std::ranges::min_element(states.back(), {}, &State::mm);
  auto s = static_cast<std::size_t>(minimum - states.back().begin());
  for (std::size_t k = visits.size(); k-- > 0;) {
    visits[k].begin = states[k][s].begin;
    s = states[k][s].previous;
  }
}

void reorderWithinGroups(std::span<const Stop> stops, std::span<const StopGroup> groups,
                         std::span<Visit> visits, const std::optional<Vector3d>& from) {
  std::size_t first = 0;
  for (const StopGroup& group : groups) {
    const std::size_t end = first + group.size();
    base::require(end <= visits.size(), "all stops of the turns are visited");
    const Vector3d* before = first > 0 ? &exit(stops, visits[first - 1]) : from ? &*from : nullptr;
    const Vector3d* after = end < visits.size() ? &entry(stops, visits[end]) : nullptr;
    if (group.size() > 1)
      GroupOrder(stops, visits.subspan(first, group.size()), before, after).shorten();
    first = end;
  }
}

std::vector<Visit> visitShortly(std::span<const Stop> stops, std::span<const StopGroup> groups,
                                const Vector3d& from) {
  std::vector<Visit> visits = visitNearestFirst(stops, groups, from);
  chooseBegins(stops, visits);
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Visit> before = visits;
    reorderWithinGroups(stops, groups, visits);
    if (visits == before)
      break;
    chooseBegins(stops, visits);
  }
  return visits;
}

} // namespace voluta::toolpath
