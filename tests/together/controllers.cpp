#include "together/controllers.h"

#include <algorithm>
#include <cmath>

namespace voluta::test {

namespace {
constexpr double kMaxLatencyS = 0.3;

double durationOf(std::mt19937& random) {
  return std::uniform_real_distribution<double>(1.0, 20.0)(random);
}

// Every mark begins with the first statement behind the last one, and ends where the machine that
// leads sees the other's first signal go off, or the one that follows withdraws its own.
void reportMarks(Statements& statements) {
  std::array<bool, plan::kMarkChannels> isAtMark{}, hasAwaited{}, leads{};
  std::array<std::size_t, plan::kMarkChannels> count{};
  for (std::size_t s = 0; s < statements.size(); ++s) {
    Statement& statement = statements[s];
    if (statement.kind == Statement::Kind::Move)
      continue;
    const auto channel = static_cast<std::size_t>(statement.signal / 2);
    const bool sets = statement.kind == Statement::Kind::Set, isFirst = statement.signal % 2 == 0;
    const bool withdraws = sets && isFirst && !statement.on && !isAtMark[channel];
    const bool endsAll =
        std::none_of(statements.begin() + static_cast<std::ptrdiff_t>(s), statements.end(),
                     [](const Statement& later) { return later.kind == Statement::Kind::Await; });
    if (!isAtMark[channel]) {
      if (withdraws || endsAll)
        continue;
      isAtMark[channel] = true;
      hasAwaited[channel] = false;
      statement.arrives = static_cast<int>(channel);
    }
    // Which end it is shows in the start mark: the one that leads first awaits an input that is
    // off.
    if (!sets && !hasAwaited[channel]) {
      if (count[channel] == 0)
        leads[channel] = !statement.on;
      hasAwaited[channel] = true;
    }
    if (isFirst && !statement.on && sets != leads[channel]) {
      statement.passes = static_cast<int>(channel);
      isAtMark[channel] = false;
      ++count[channel];
    }
  }
}
} // namespace

Statements statementsOf(const plan::ReadProgram& program, std::mt19937& random) {
  Statements statements;
  std::size_t motion = 0;
  for (const plan::StatedFact& fact : program.facts) {
    if (fact.kind != plan::FactKind::MarkSet && fact.kind != plan::FactKind::MarkAwaited)
      continue;
    if (fact.before > motion)
      statements.push_back({Statement::Kind::Move, durationOf(random)});
    motion = std::max(motion, fact.before);
    const int code = static_cast<int>(fact.number);
    statements.push_back(
        {fact.kind == plan::FactKind::MarkSet ? Statement::Kind::Set : Statement::Kind::Await, 0.0,
         plan::markSignalOf(code), plan::markIsOn(code)});
  }
  if (program.motions.size() > motion)
    statements.push_back({Statement::Kind::Move, durationOf(random)});
  reportMarks(statements);
  return statements;
}

Controllers::Controllers(const std::vector<Statements>& programs, std::mt19937::result_type seed)
    : programs_(programs), machines_(programs.size()), random_(seed) {}

void Controllers::setSignals(std::size_t machine, unsigned bits) {
  for (std::size_t s = 0; s < plan::kMarkSignals; ++s)
    machines_[machine].outputs[s] = {(bits >> s & 1U) != 0, {}};
}

bool Controllers::allOff() const {
  for (std::size_t k = 0; k < machines_.size(); ++k)
    for (const Statement& statement : programs_[k])
      if (statement.kind == Statement::Kind::Set) {
        const Wire& wire = machines_[k].outputs.at(static_cast<std::size_t>(statement.signal));
        if (wire.pending.empty() ? wire.seen : wire.pending.back().second)
          return false;
      }
  return true;
}

void Controllers::start(std::size_t machine, double delayS) {
  const auto outputs = machines_[machine].outputs;
  machines_[machine] = {};
  machines_[machine].outputs = outputs;
  machines_[machine].runs = true;
  machines_[machine].freeAtS = nowS_ + delayS;
}

void Controllers::stop(std::size_t machine) {
  machines_[machine].runs = machines_[machine].moves = false;
  // Nobody restarts it before its signals have arrived.
  for (Wire& wire : machines_[machine].outputs)
    if (!wire.pending.empty())
      wire = {wire.pending.back().second, {}};
}

void Controllers::stopAll() {
  for (std::size_t k = 0; k < machines_.size(); ++k)
    stop(k);
}

bool Controllers::ended(std::size_t machine) const {
  return machines_[machine].next == programs_[machine].size() && !machines_[machine].moves;
}

bool Controllers::allEnded() const {
  for (std::size_t k = 0; k < machines_.size(); ++k)
    if (!ended(k))
      return false;
  return true;
}

std::size_t Controllers::arrived(std::size_t machine, std::size_t other) const {
  return machines_[machine].arrived.at(static_cast<std::size_t>(plan::markChannel(machine, other)));
}
std::size_t Controllers::passed(std::size_t machine, std::size_t other) const {
  return machines_[machine].passed.at(static_cast<std::size_t>(plan::markChannel(machine, other)));
}

bool Controllers::passedAllStarts(std::size_t machine) const {
  std::array<bool, plan::kMarkChannels> has{};
  for (const Statement& statement : programs_[machine])
    if (statement.passes)
      has.at(static_cast<std::size_t>(*statement.passes)) = true;
  for (std::size_t channel = 0; channel < has.size(); ++channel)
    if (has[channel] && machines_[machine].passed[channel] == 0)
      return false;
  return true;
}

Controllers::Wire& Controllers::inputOf(std::size_t machine, int signal) {
  const std::size_t other = plan::markPeer(machine, signal / 2);
  return machines_.at(other).outputs.at(
      static_cast<std::size_t>(2 * plan::markChannel(other, machine) + signal % 2));
}

// Of pairs that meet at all.
void Controllers::checkMove(std::size_t machine) {
  for (std::size_t other = 0; other < machines_.size(); ++other) {
    if (other == machine || !machines_[other].moves)
      continue;
    const int channel = plan::markChannel(machine, other);
    if (std::ranges::none_of(programs_[machine],
                             [&](const Statement& s) { return s.passes == channel; }))
      continue;
    const std::size_t own = passed(machine, other), theirs = passed(other, machine);
    if (own != theirs && !(ignoresWayToStart_ && (own == 0 || theirs == 0)))
      ++conflicts_;
  }
}

bool Controllers::step(std::size_t k) {
  Machine& machine = machines_[k];
  if (!machine.runs || nowS_ < machine.freeAtS)
    return false;
  if (machine.moves) {
    machine.moves = false;
    return true;
  }
  if (machine.next == programs_[k].size())
    return false;
  const Statement& statement = programs_[k][machine.next];
  bool arrivesNow = false;
  if (statement.arrives) {
    const auto channel = static_cast<std::size_t>(*statement.arrives);
    arrivesNow = !std::exchange(machine.isAtMark[channel], true);
    machine.arrived[channel] += arrivesNow ? 1 : 0;
  }
  switch (statement.kind) {
  case Statement::Kind::Move:
    machine.freeAtS = nowS_ + statement.seconds;
    machine.moves = true;
    checkMove(k);
    break;
  case Statement::Kind::Set: {
    Wire& wire = machine.outputs.at(static_cast<std::size_t>(statement.signal));
    double atS = nowS_ + std::uniform_real_distribution<double>(0.0, kMaxLatencyS)(random_);
    if (!wire.pending.empty())
      atS = std::max(atS, wire.pending.back().first);
    wire.pending.emplace_back(atS, statement.on);
    break;
  }
  case Statement::Kind::Await:
    if (inputOf(k, statement.signal).seen != statement.on)
      return arrivesNow;
    break;
  }
  if (statement.passes) {
    const auto channel = static_cast<std::size_t>(*statement.passes);
    machine.isAtMark[channel] = false;
    ++machine.passed[channel];
  }
  ++machine.next;
  return true;
}

void Controllers::deliver() {
  for (Machine& machine : machines_)
    for (Wire& wire : machine.outputs)
      while (!wire.pending.empty() && wire.pending.front().first <= nowS_) {
        wire.seen = wire.pending.front().second;
        wire.pending.pop_front();
      }
}

std::optional<double> Controllers::nextTime() const {
  std::optional<double> next;
  const auto add = [&](double timeS) {
    if (timeS > nowS_ && (!next || timeS < *next))
      next = timeS;
  };
  for (std::size_t k = 0; k < machines_.size(); ++k) {
    if (machines_[k].runs)
      add(machines_[k].freeAtS);
    for (const Wire& wire : machines_[k].outputs)
      if (!wire.pending.empty())
        add(wire.pending.front().first);
  }
  return next;
}

void Controllers::run(double seconds) {
  const double endS = nowS_ + seconds;
  for (;;) {
    deliver();
    bool moved = false;
    for (std::size_t k = 0; k < machines_.size(); ++k)
      moved = step(k) || moved;
    if (moved)
      continue;
    const std::optional<double> next = nextTime();
    if (!next || *next > endS) {
      nowS_ = next ? endS : nowS_;
      return;
    }
    nowS_ = *next;
  }
}

} // namespace voluta::test
