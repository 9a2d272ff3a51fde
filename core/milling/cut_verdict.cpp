#include "milling/cut_verdict.h"

#include "milling/mill_program.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

namespace voluta::milling {

using Eigen::Vector3d;
using enum plan::FindingKind;
using plan::FactKind;

namespace {

constexpr double kBelowMm = 0.01;  // rounding
constexpr double kTouchMm3 = 1e-3; // rounding
constexpr double kSameShare = 0.01;
constexpr std::size_t kReported = 256;
constexpr double kSecondsPerMinute = 60.0;
constexpr double kUnturnedDeg = 0.0, kTurnedDeg = 180.0;

class CutJudge {
public:
  CutJudge(const plan::ReadProgram& program, const MillPlan& plan, const MillRule& rule,
           const base::RunContext& ctx)
      : program_(program), plan_(plan), rule_(rule), ctx_(ctx), stock_(plan.block, rule.pitchMm) {
    for (const MillPasses& passes : plan.sides)
      for (const MillMove& move : passes.moves)
        planned_.push_back(&move);
  }

  CutVerdict judge() {
    for (const plan::ProgramDefect& defect : program_.defects)
      refuse(UnreadableLine, defect.line, {{"defect", defect.reason}});
    const double whole = stock_.volumeMm3();
    const std::size_t count = program_.motions.size();
    for (motion_ = 0; motion_ < count; ++motion_) {
      if (motion_ % kReported == 0)
        ctx_.report(static_cast<double>(motion_) / static_cast<double>(count),
                    "milling the block"_text);
      takeFacts();
      take(program_.motions[motion_]);
    }
    takeFacts();
    const std::size_t last = count > 0 ? program_.motions.back().line : 0;
    if (!isOther_ && next_ < planned_.size())
      refuse(ProgramCutShort, last, {{"motions", static_cast<long long>(planned_.size() - next_)}});
    if (!program_.complete)
      refuse(EndMissing, last);
    verdict_.removedMm3 = whole - stock_.volumeMm3();
    measure();
    verdict_.passed = verdict_.findings.empty();
    verdict_.rest = isTurned_ ? stock_.turned() : std::move(stock_);
    verdict_.left = leftMaterial(*verdict_.rest, plan_, rule_);
    if (verdict_.passed && verdict_.left.volumeMm3 > 0.0)
      verdict_.findings.push_back(
          plan::makeFinding(MaterialLeft,
                            {{"volume", base::mm3(verdict_.left.volumeMm3)},
                             {"height", base::mm(verdict_.left.thickestMm)}},
                            verdict_.left.atMm));
    return std::move(verdict_);
  }

private:
  plan::Finding& refuse(plan::FindingKind kind, std::size_t line,
                        std::vector<plan::NamedValue> values = {}) {
    plan::Finding& finding =
        verdict_.findings.emplace_back(plan::makeFinding(kind, std::move(values)));
    finding.program.line = line;
    return finding;
  }
  // Refuses the present motion. Motions that are refused for the same are one finding.
  void refuseMotion(plan::FindingKind kind, const Vector3d& at) {
    plan::Findings& findings = verdict_.findings;
    const auto known = std::ranges::find(findings, kind, &plan::Finding::kind);
    if (known != findings.end()) {
      ++known->count;
      return;
    }
    plan::Finding& finding = refuse(kind, program_.motions[motion_].line);
    finding.where = isTurned_ ? Vector3d(at.x(), -at.y(), -at.z()) : at;
    finding.whenS = verdict_.seconds;
  }

  // Takes the statements before the present motion.
  void takeFacts() {
    for (; nextFact_ < program_.facts.size() && program_.facts[nextFact_].before <= motion_;
         ++nextFact_) {
      const plan::StatedFact& fact = program_.facts[nextFact_];
      if (fact.kind == FactKind::Spindle)
        rpm_ = fact.number;
      else if (fact.kind == FactKind::TargetFrame)
        frame_ = fact.word;
      else if (fact.kind == FactKind::BlockTurned)
        turnBlock(fact);
      else if (fact.kind == FactKind::Home)
        isHome_ = true;
    }
    // From the reference position the machine comes from above.
    isKnown_ = isKnown_ && !isHome_;
  }

  void turnBlock(const plan::StatedFact& fact) {
    if (!isHome_)
      refuse(BlockTurnedBelow, fact.line);
    if (fact.number != kUnturnedDeg && fact.number != kTurnedDeg)
      refuse(BlockTurnedElsewhere, fact.line);
    const bool turned = fact.number == kTurnedDeg;
    if (turned == isTurned_)
      return;
    if (turned)
      judgeUpper(); // before the contour frees the part
    stock_ = stock_.turned();
    isTurned_ = turned;
    isKnown_ = false;
  }

  void take(const plan::ProgramMotion& move) {
    const Vector3d to =
        move.position + originOf(isTurned_ ? MillSide::B : MillSide::A, plan_.block);
    const Vector3d from = isKnown_ ? at_ : to;
    const bool isRapid = move.speedMmPerS == 0.0;
    if (frame_ != (isTurned_ ? "G55" : "G54"))
      refuseMotion(OtherSide, to);
    compare(isRapid, to);
    const double removed = stock_.cut(rule_.cutter, from, to);
    if (removed > kTouchMm3 && (isRapid || !isKnown_))
      refuseMotion(RapidInBlock, to);
    else if (removed > kTouchMm3 && !isSame(rpm_, rule_.data.rpm))
      refuseMotion(SpindleChanged, to);
    else if (removed > kTouchMm3 &&
             !isSame(kSecondsPerMinute * move.speedMmPerS, feedMmPerMin(rule_.cutter, rule_.data)))
      refuseMotion(FeedChanged, to);
    const double bottom = isTurned_ ? -plan_.block.max().z() : plan_.block.min().z();
    if (to.z() < bottom - kBelowMm)
      refuseMotion(CutterBelowBlock, to);
    const double speed = isRapid ? kRapidMmPerMin / kSecondsPerMinute : move.speedMmPerS;
    verdict_.seconds += (to - from).norm() / speed;
    at_ = to;
    isKnown_ = true;
    isHome_ = false;
  }
  // Refuses the first motion that is not the next one of the plan.
  void compare(bool isRapid, const Vector3d& to) {
    if (isOther_)
      return;
    const double offMm = next_ == planned_.size() ? std::numeric_limits<double>::infinity()
                                                  : (planned_[next_]->to - to).norm();
    isOther_ = offMm > kSamePlaceMm || (planned_[next_]->step == MillStep::Rapid) != isRapid;
    if (isOther_)
      refuseMotion(OtherMotion, to);
    else
      verdict_.maxDeviationMm = std::max(verdict_.maxDeviationMm, offMm);
    ++next_;
  }
  static bool isSame(double value, double planned) {
    return std::abs(value - planned) <= kSameShare * planned;
  }

  // Returns the upward component of the unit normal of the part's top.
  static double steepness(const HeightMap& part, std::size_t cell) {
    const auto row = static_cast<std::size_t>(part.grid.countX);
    if (cell < row || cell + row >= part.grid.size())
      return 1.0;
    const auto slope = [&](std::size_t before, std::size_t after) {
      const bool isKnown = part.isPart(before) && part.isPart(after);
      return isKnown ? (part.top[after] - part.top[before]) / (2.0 * part.grid.pitchMm)
                     : std::numeric_limits<double>::infinity();
    };
    const double x = slope(cell - 1, cell + 1), y = slope(cell - row, cell + row);
    return 1.0 / std::sqrt(1.0 + x * x + y * y); // 0 at the rim
  }

  // Compares the cells of the part with those of the block.
  void judge(const Stock& stock, const HeightMap& part, double& residue) {
    for (std::size_t c = 0; c < part.grid.size(); ++c) {
      if (!part.isPart(c))
        continue;
      const double high = stock.highAt(c);
      verdict_.deepestMm = std::max(verdict_.deepestMm, part.top[c] - high);
      residue = std::max(residue, (high - part.top[c]) * steepness(part, c));
    }
  }
  void judgeUpper() { judge(stock_, plan_.above, verdict_.residueMm); }

  void measure() {
    if (isTurned_)
      judge(stock_, plan_.below, verdict_.sideResidueMm);
    else
      judgeUpper();
    judge(isTurned_ ? stock_.turned() : stock_, plan_.above, verdict_.residueMm);
    if (verdict_.deepestMm > kGougeMm)
      refuse(PartCut, 0, {{"depth", base::mm(verdict_.deepestMm)}});
  }

  const plan::ReadProgram& program_;
  const MillPlan& plan_;
  const MillRule& rule_;
  const base::RunContext& ctx_;
  Stock stock_;
  std::vector<const MillMove*> planned_; // of all sides
  std::size_t next_ = 0;                 // of them
  bool isOther_ = false;
  std::size_t motion_ = 0, nextFact_ = 0; // in the program
  std::string_view frame_;
  double rpm_ = 0.0;
  Vector3d at_ = Vector3d::Zero();
  bool isKnown_ = false, isTurned_ = false, isHome_ = false;
  CutVerdict verdict_;
};

} // namespace

CutVerdict judgeCuts(const plan::ReadProgram& program, const MillPlan& plan, const MillRule& rule,
                     const base::RunContext& ctx) {
  return CutJudge(program, plan, rule, ctx).judge();
}

} // namespace voluta::milling
