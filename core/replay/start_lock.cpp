#include "replay/start_lock.h"

#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "replay/wait_tolerance.h"
#include "robot/tool_changer.h"

#include <algorithm>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;
using plan::EventKind, plan::FactKind, plan::StatedFact;

bool isLock(const StatedFact& fact) {
  return fact.kind == FactKind::ToolLocked && fact.number > 0.0;
}

bool beginsFile(const plan::ReadProgram& program, std::size_t motion) {
  return motion > program.firstMotion && motion < program.motions.size() &&
         program.motions[motion].file != program.motions[motion - 1].file;
}

// Returns the last such statement before the first motion; nullptr: none.
template <typename Fits>
const StatedFact* lastAtStart(const plan::ReadProgram& program, const Fits& fits) {
  const StatedFact* last = nullptr;
  for (const StatedFact& fact : program.facts)
    if (fact.before <= program.firstMotion && fits(fact))
      last = &fact;
  return last;
}

TextFinding changedLock(const plan::ReadProgram& program, const StatedFact& lock,
                        base::Message statement, base::Message found, base::Message planned) {
  return textFinding(program, StatementChanged, {lock.file + 1U, lock.line},
                     {{"statement", std::move(statement)},
                      {"found", std::move(found)},
                      {"planned", std::move(planned)}});
}

TextFinding missingLock(const plan::ReadProgram& program, std::size_t motion) {
  return textFinding(program, StatementMissing, placeOf(program, motion),
                     {{"statement", base::Message(program::nameOf(EventKind::Lock))}});
}

// Of the program's first motion.
void compareFirst(const plan::ReadProgram& program, std::vector<TextFinding>& found) {
  const StatedFact* lock = lastAtStart(program, isLock);
  if (!lock) {
    found.push_back(missingLock(program, program.firstMotion));
    return;
  }
  const StatedFact* stop = lastAtStart(program, [](const StatedFact& fact) {
    return fact.kind == FactKind::OperatorStop && fact.number > 0.0;
  });
  const base::Message name = program::nameOf(EventKind::Lock),
                      pause = program::nameOf(EventKind::Pause);
  if (stop && lock < stop)
    found.push_back(changedLock(program, *lock, name, base::message("before {event}"_text, pause),
                                base::message("behind {event}"_text, pause)));
  if (program::findDialect(program.format).waitsByMotion)
    return;
  double seconds = 0.0;
  for (std::size_t p = lock->beforePause; p < program.pauses.size(); ++p)
    if (program.pauses[p].before <= program.firstMotion && program.pauses[p].volumeMm3 <= 0.0)
      seconds += program.pauses[p].durationS;
  if (seconds < robot::kChangerS - waitTolerance(robot::kChangerS))
    found.push_back(changedLock(program, *lock, base::message("the time for {event}"_text, name),
                                base::message("{time:.1f}"_text, base::seconds(seconds)),
                                base::message("{time:.1f}"_text, base::seconds(robot::kChangerS))));
}

} // namespace

std::vector<TextFinding> compareStartLock(const plan::ReadProgram& program,
                                          const robot::Cell& cell) {
  std::vector<TextFinding> found;
  if (!robot::hasChanger(cell) || program.firstMotion >= program.motions.size() ||
      !program::hasWordFor(program::findDialect(program.format), EventKind::Lock))
    return found;
  compareFirst(program, found);
  for (std::size_t m = program.firstMotion + 1; m < program.motions.size(); ++m)
    if (beginsFile(program, m) && std::ranges::none_of(program.facts, [&](const StatedFact& fact) {
          return isLock(fact) && fact.before == m && fact.file == program.motions[m].file;
        }))
      found.push_back(missingLock(program, m));
  return found;
}

bool locksAtFile(const plan::ReadProgram& program, const plan::StatedFact& fact) {
  return isLock(fact) && beginsFile(program, fact.before) &&
         fact.file == program.motions[fact.before].file;
}

double fileLockS(const plan::ReadProgram& program, std::size_t pause) {
  const std::size_t motion = program.pauses[pause].before;
  const bool isForLock =
      beginsFile(program, motion) && std::ranges::any_of(program.facts, [&](const StatedFact& f) {
        return f.before == motion && f.beforePause == pause && locksAtFile(program, f);
      });
  return isForLock ? robot::kChangerS : 0.0;
}

} // namespace voluta::replay
