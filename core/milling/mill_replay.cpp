#include "milling/mill_replay.h"

#include "milling/mill_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::milling {

using Eigen::Vector3d;

namespace {

constexpr double kBelowMm = 0.01;      // rounding
constexpr double kTouchMm3 = 1e-3;     // rounding
constexpr double kSamePlaceMm = 0.002; // digits of the text
constexpr double kSameShare = 0.01;
constexpr std::size_t kReported = 256;
constexpr double kSecondsPerMinute = 60.0;

class Run {
public:
  Run(const MillPlan& plan, const MillRule& rule, const base::RunContext& ctx)
      : plan_(plan), rule_(rule), ctx_(ctx), stock_(plan.block, rule.pitchMm) {
    for (const MillPasses& passes : plan.sides)
      for (const MillMove& move : passes.moves)
        planned_.push_back(&move);
  }

  MillVerdict run(const ReadMilling& program) {
    verdict_.refusals = program.defects;
    if (!program.complete)
      refuse(0, "the program does not end"_text);
    const double whole = stock_.volumeMm3();
    for (std::size_t i = 0; i < program.moves.size(); ++i) {
      if (i % kReported == 0)
        ctx_.report(static_cast<double>(i) / static_cast<double>(program.moves.size()),
                    "milling the block"_text);
      take(program.moves[i]);
    }
    if (!isOther_ && next_ < planned_.size())
      refuse(0, "motions of the plan are missing"_text);
    verdict_.removedMm3 = whole - stock_.volumeMm3();
    measure();
    verdict_.passed = verdict_.refusals.empty();
    verdict_.rest = isTurned_ ? stock_.turned() : std::move(stock_);
    verdict_.left = leftMaterial(*verdict_.rest, plan_, rule_);
    return std::move(verdict_);
  }

private:
  void refuse(std::size_t line, base::Message reason) {
    verdict_.refusals.push_back({line, std::move(reason)});
  }

  void take(const ReadMove& move) {
    if (move.turned != isTurned_) {
      if (move.turned)
        judgeUpper(); // before the contour frees the part
      stock_ = stock_.turned();
      isTurned_ = move.turned;
      isKnown_ = false;
    }
    if (move.home) {
      isKnown_ = false;
      return;
    }
    const Vector3d to = move.to + originOf(isTurned_ ? MillSide::B : MillSide::A, plan_.block);
    // From the reference position the machine comes from above.
    const Vector3d from = isKnown_ ? at_ : to;
    compare(move, to);
    const double removed = stock_.cut(rule_.cutter, from, to);
    if (removed > kTouchMm3 && (move.rapid || !isKnown_))
      refuse(move.line, "a rapid move through the block"_text);
    else if (removed > kTouchMm3 && !isSame(move.rpm, rule_.data.rpm))
      refuse(move.line, "the spindle has another speed than planned"_text);
    else if (removed > kTouchMm3 &&
             !isSame(move.feedMmPerMin, feedMmPerMin(rule_.cutter, rule_.data)))
      refuse(move.line, "another feed than planned"_text);
    const double bottom = isTurned_ ? -plan_.block.max().z() : plan_.block.min().z();
    if (to.z() < bottom - kBelowMm)
      refuse(move.line, "the cutter goes through the block into what holds it"_text);
    const double speed = move.rapid ? kRapidMmPerMin : move.feedMmPerMin;
    if (speed > 0.0)
      verdict_.seconds += kSecondsPerMinute * (to - from).norm() / speed;
    at_ = to;
    isKnown_ = true;
  }
  // Refuses the first motion that is not the next one of the plan.
  void compare(const ReadMove& move, const Vector3d& to) {
    if (isOther_)
      return;
    isOther_ = next_ == planned_.size() || (planned_[next_]->to - to).norm() > kSamePlaceMm ||
               (planned_[next_]->step == MillStep::Rapid) != move.rapid;
    if (isOther_)
      refuse(move.line, "another motion than planned"_text);
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
      refuse(0, base::message("the cutter takes up to {depth} from the part"_text,
                              base::mm(verdict_.deepestMm)));
  }

  const MillPlan& plan_;
  const MillRule& rule_;
  const base::RunContext& ctx_;
  Stock stock_;
  std::vector<const MillMove*> planned_; // of all sides
  std::size_t next_ = 0;                 // of them
  bool isOther_ = false;
  Vector3d at_ = Vector3d::Zero();
  bool isKnown_ = false, isTurned_ = false;
  MillVerdict verdict_;
};

} // namespace

MillVerdict replayMilling(const ReadMilling& program, const MillPlan& plan, const MillRule& rule,
                          const base::RunContext& ctx) {
  return Run(plan, rule, ctx).run(program);
}

} // namespace voluta::milling
