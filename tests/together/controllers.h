// Controllers that run programs with marks, for tests: each does one statement after another, and
// a signal arrives at the other machine some time after it was set. Written without the replay.
#pragma once

#include "plan/marks.h"
#include "plan/program.h"

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace voluta::test {

struct Statement {
  enum class Kind { Move, Set, Await };
  Kind kind = Kind::Move;
  double seconds = 0.0;         // Move
  int signal = 0;               // Set, Await: over all channels
  bool on = false;              // Set, Await
  std::optional<int> arrives{}; // channel whose next mark begins here
  std::optional<int> passes{};  // channel whose mark ends here
};
using Statements = std::vector<Statement>;

// Returns the statements of a program's text as it was read; its motions between two statements of
// marks are one, of random duration.
Statements statementsOf(const plan::ReadProgram& program, std::mt19937& random);

class Controllers {
public:
  // `programs` has to outlive it.
  Controllers(const std::vector<Statements>& programs, std::mt19937::result_type seed);

  void setSignals(std::size_t machine, unsigned bits);
  bool allOff() const; // those that the programs set
  void start(std::size_t machine, double delayS);
  void stop(std::size_t machine);
  void stopAll();
  // Runs until all that are started have ended, nothing moves any more, or `seconds` have passed.
  void run(double seconds);

  double nowS() const { return nowS_; }
  bool ended(std::size_t machine) const;
  bool allEnded() const;
  // Marks with another machine since the last start.
  std::size_t arrived(std::size_t machine, std::size_t other) const;
  std::size_t passed(std::size_t machine, std::size_t other) const;
  bool passedAllStarts(std::size_t machine) const;
  // Two machines moved at the same time between other marks of theirs. A machine on the way to its
  // first point counts as well, unless it is started alone (ignoreWayToStart).
  std::size_t conflicts() const { return conflicts_; }
  void ignoreWayToStart(bool ignore) { ignoresWayToStart_ = ignore; }

private:
  struct Wire {
    bool seen = false;
    std::deque<std::pair<double, bool>> pending; // arrive later
  };
  struct Machine {
    std::size_t next = 0;
    bool runs = false, moves = false;
    double freeAtS = 0.0;
    std::array<std::size_t, plan::kMarkChannels> arrived{}, passed{};
    std::array<bool, plan::kMarkChannels> isAtMark{};
    std::array<Wire, plan::kMarkSignals> outputs{};
  };
  bool step(std::size_t machine);
  void checkMove(std::size_t machine);
  Wire& inputOf(std::size_t machine, int signal);
  void deliver();
  std::optional<double> nextTime() const;

  const std::vector<Statements>& programs_;
  std::vector<Machine> machines_;
  std::mt19937 random_;
  double nowS_ = 0.0;
  std::size_t conflicts_ = 0;
  bool ignoresWayToStart_ = false;
};

} // namespace voluta::test
