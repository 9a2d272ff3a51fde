// Planned runs of random beads, and records of them.
#pragma once

#include "record/run_comparison.h"

#include <cmath>
#include <functional>
#include <random>

namespace voluta::test {

// Beads of corners joined by straight travels, at their own speeds.
class PlannedBeads {
public:
  void travelTo(const Eigen::Vector3d& p) { add(p, kTravelMmPerS, 0.0, false); }
  void printTo(const Eigen::Vector3d& p, double mmPerS) { add(p, mmPerS, kSectionMm2, true); }
  const record::PlannedRun& run() const { return run_; }

private:
  static constexpr double kTravelMmPerS = 100.0, kSectionMm2 = 0.9;

  void add(const Eigen::Vector3d& p, double mmPerS, double section, bool prints) {
    const double mm = run_.tip.empty() ? 0.0 : (p - run_.tip.back()).norm();
    const auto last = [](const std::vector<double>& v) { return v.empty() ? 0.0 : v.back(); };
    run_.alongMm.push_back(last(run_.alongMm) + mm);
    run_.timeS.push_back(last(run_.timeS) + mm / mmPerS);
    run_.extrudedMm3.push_back(last(run_.extrudedMm3) + section * mm);
    run_.prints.push_back(prints ? 1 : 0);
    run_.point.push_back(run_.point.size());
    run_.tip.push_back(p);
  }
  record::PlannedRun run_;
};

// Layers of zigzag lines 1.2 mm apart with corners every 2 mm, 0.8 mm above each other, each begun
// elsewhere; a wall around each.
inline record::PlannedRun randomBeads(unsigned seed) {
  std::mt19937 random(seed);
  const auto pick = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  PlannedBeads beads;
  beads.travelTo({-30, -30, 40});
  const int layers = 2 + static_cast<int>(pick(0, 3)), lines = 4 + static_cast<int>(pick(0, 6));
  const double width = pick(15, 40);
  for (int layer = 0; layer < layers; ++layer) {
    const double z = 0.8 * (layer + 1), side = 1.2 * (lines + 1), speed = pick(10, 30);
    beads.travelTo({-1.2, -1.2, z + 3});
    beads.travelTo({-1.2, -1.2, z});
    beads.printTo({width + 1.2, -1.2, z}, speed);
    beads.printTo({width + 1.2, side, z}, speed);
    beads.printTo({-1.2, side, z}, speed);
    beads.printTo({-1.2, -1.2, z}, speed);
    beads.travelTo({0, 0, z + 3});
    beads.travelTo({0, 0, z});
    for (int line = 0; line < lines; ++line) {
      const bool back = line % 2 == 1;
      if (line > 0)
        beads.printTo({back ? width : 0.0, 1.2 * line, z}, speed);
      for (double x = 2.0; x < width; x += 2.0)
        beads.printTo({back ? width - x : x, 1.2 * line, z}, speed);
      beads.printTo({back ? 0.0 : width, 1.2 * line, z}, speed);
    }
    beads.travelTo({0, 0, z + 10});
  }
  return beads.run();
}

// Changes of a record: a factor of speed and an offset, both by the length along the plan.
struct RecordErrors {
  std::function<double(double alongMm)> speed = [](double) { return 1.0; };
  std::function<Eigen::Vector3d(double alongMm)> offset = [](double) {
    return Eigen::Vector3d(0, 0, 0);
  };
  double noiseMm = 0.0;
  unsigned seed = 1;
};

// Samples the plan each cycle, between the plan's places at two lengths.
inline record::RecordedRun recordOf(const record::PlannedRun& planned, const RecordErrors& errors,
                                    double cycleS, double fromS = 0.0, double toS = 1e9) {
  std::mt19937 random(errors.seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  record::RecordedRun run;
  run.format = "test";
  std::size_t s = 1;
  double recordS = 0.0;
  for (double planS = fromS; planS <= std::min(toS, planned.timeS.back());) {
    while (s + 1 < planned.size() && planned.timeS[s] < planS)
      ++s;
    const double length = planned.timeS[s] - planned.timeS[s - 1];
    const double share = length > 0.0 ? (planS - planned.timeS[s - 1]) / length : 1.0;
    const double along =
        planned.alongMm[s - 1] + share * (planned.alongMm[s] - planned.alongMm[s - 1]);
    Eigen::Vector3d tip =
        planned.tip[s - 1] + share * (planned.tip[s] - planned.tip[s - 1]) + errors.offset(along);
    if (errors.noiseMm > 0.0)
      tip += errors.noiseMm * Eigen::Vector3d(noise(random), noise(random), noise(random));
    run.tip.push_back(tip);
    run.timeS.push_back(recordS);
    recordS += cycleS;
    planS += cycleS * errors.speed(along);
  }
  return run;
}

inline std::vector<record::ErrorPlace> placesOf(const record::RunComparison& c,
                                                record::ErrorKind kind) {
  std::vector<record::ErrorPlace> places;
  for (const record::ErrorPlace& place : c.places)
    if (place.kind == kind)
      places.push_back(place);
  return places;
}

} // namespace voluta::test
