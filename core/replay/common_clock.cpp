#include "replay/common_clock.h"

#include "base/error.h"
#include "replay/marked_run.h"

#include <algorithm>
#include <numeric>

namespace voluta::replay {

double MachineClock::waitS() const {
  return std::accumulate(marks.begin(), marks.end(), 0.0, [](double sum, const PassedMark& mark) {
    return sum + mark.toS - mark.fromS;
  });
}

std::vector<PassedMark> MachineClock::meetings() const {
  std::vector<PassedMark> meetings;
  std::vector<std::size_t> met;
  for (const PassedMark& mark : marks)
    if (std::ranges::find(met, mark.other) != met.end())
      meetings.push_back(mark);
    else
      met.push_back(mark.other);
  return meetings;
}

CommonClock commonClock(std::span<const plan::ReadProgram* const> programs,
                        std::span<const std::vector<double>> motionS, const Start& start) {
  base::require(motionS.size() == programs.size(), "commonClock: machines with times");
  std::vector<std::vector<MarkedAction>> actions;
  for (std::size_t k = 0; k < programs.size(); ++k)
    actions.push_back(markedActions(*programs[k], motionS[k]));
  return runMarked(actions, start);
}

} // namespace voluta::replay
