#include "record/run_comparison.h"

#include "base/error.h"
#include "base/run_context.h"
#include "record/run_alignment.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <optional>

namespace voluta::record {

namespace {

constexpr float kNotMeasured = std::numeric_limits<float>::quiet_NaN();

// One sample on the plan.
struct OnPlan {
  std::size_t sample = 0;
  PlannedPlace place;
  double distanceMm = 0.0;
};

// Consecutive samples on one bead: [begin, end) of the samples on the plan.
struct Bead {
  std::size_t begin = 0, end = 0;
};

std::vector<OnPlan> onPlan(const PathAlignment& aligned, const PlannedRun& planned) {
  std::vector<OnPlan> all;
  all.reserve(aligned.samples.size());
  for (std::size_t k = 0; k < aligned.samples.size(); ++k)
    all.push_back({aligned.first + k, placeAt(planned, aligned.samples[k].alongMm),
                   aligned.samples[k].distanceMm});
  return all;
}

std::vector<Bead> beadsOf(const std::vector<OnPlan>& samples, const PlannedRun& planned) {
  // The segments of each bead have consecutive numbers.
  std::vector<std::size_t> beadOfSegment(planned.size(), 0);
  std::size_t count = 0;
  for (std::size_t s = 1; s < planned.size(); ++s)
    beadOfSegment[s] = planned.prints[s] == 0 ? 0 : planned.prints[s - 1] != 0 ? count : ++count;
  std::vector<Bead> beads;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const std::size_t bead = beadOfSegment[samples[k].place.segment];
    if (bead == 0)
      continue;
    if (k > 0 && !beads.empty() && beads.back().end == k &&
        beadOfSegment[samples[k - 1].place.segment] == bead)
      ++beads.back().end;
    else
      beads.push_back({k, k + 1});
  }
  return beads;
}

// Errors at a sample; NaN: not measured.
struct Errors {
  double speed = kNotMeasured, flow = kNotMeasured;
};

class Comparer {
public:
  Comparer(const RecordedRun& record, const PlannedRun& planned, const RunTolerances& tolerances)
      : record_(record), planned_(planned), tolerances_(tolerances) {}

  RunComparison compare(const PathAlignment& aligned, const base::RunContext& ctx) {
    samples_ = onPlan(aligned, planned_);
    result_.flowIsRecorded = !record_.extrudedMm3.empty();
    result_.beginS = record_.timeS[aligned.first];
    result_.endS = record_.timeS[aligned.end - 1];
    for (std::size_t s = 1; s < planned_.size(); ++s)
      if (planned_.prints[s] != 0)
        result_.beadsMm += planned_.alongMm[s] - planned_.alongMm[s - 1];
    const std::vector<Bead> beads = beadsOf(samples_, planned_);
    for (std::size_t b = 0; b < beads.size(); ++b) {
      if (b % 256 == 0)
        ctx.checkpoint();
      addBead(beads[b]);
    }
    addBeads();
    finish();
    return std::move(result_);
  }

private:
  double timeOf(std::size_t k) const { return record_.timeS[samples_[k].sample]; }

  // Returns the errors of the stretch between two samples.
  Errors errorsOf(std::size_t from, std::size_t to) const {
    const PlannedPlace &a = samples_[from].place, &b = samples_[to].place;
    const double plannedS = b.timeS - a.timeS, recordedS = timeOf(to) - timeOf(from);
    Errors e;
    if (plannedS <= 0.0 || recordedS <= 0.0)
      return e;
    e.speed = plannedS / recordedS - 1.0;
    e.flow = recordedS / plannedS - 1.0;
    if (result_.flowIsRecorded) {
      const double plannedMm3 = b.extrudedMm3 - a.extrudedMm3;
      e.flow = plannedMm3 > 0.0 ? (record_.extrudedMm3[samples_[to].sample] -
                                   record_.extrudedMm3[samples_[from].sample]) /
                                          plannedMm3 -
                                      1.0
                                : kNotMeasured;
    }
    return e;
  }

  void addBead(const Bead& bead) {
    const Errors none;
    std::size_t from = bead.begin, to = bead.begin;
    for (std::size_t k = bead.begin; k < bead.end; ++k) {
      const auto isWide = [&](std::size_t a, std::size_t b) {
        return samples_[b].place.alongMm - samples_[a].place.alongMm >= kWindowMm &&
               timeOf(b) - timeOf(a) >= kWindowS;
      };
      // The smallest window with the sample in its middle.
      const double atMm = samples_[k].place.alongMm;
      while (from < k && isWide(from + 1, k) &&
             2.0 * (atMm - samples_[from + 1].place.alongMm) >= kWindowMm)
        ++from;
      to = std::max(to, k);
      while (to + 1 < bead.end &&
             !(isWide(from, to) && samples_[to].place.alongMm - atMm >= 0.5 * kWindowMm))
        ++to;
      addSample(samples_[k], isWide(from, to) ? errorsOf(from, to) : none);
    }
    plannedS_ += samples_[bead.end - 1].place.timeS - samples_[bead.begin].place.timeS;
    recordedS_ += timeOf(bead.end - 1) - timeOf(bead.begin);
    if (result_.flowIsRecorded) {
      plannedMm3_ +=
          samples_[bead.end - 1].place.extrudedMm3 - samples_[bead.begin].place.extrudedMm3;
      recordedMm3_ += record_.extrudedMm3[samples_[bead.end - 1].sample] -
                      record_.extrudedMm3[samples_[bead.begin].sample];
    }
    for (std::optional<ErrorPlace>& open : open_)
      close(open);
  }

  void addSample(const OnPlan& sample, const Errors& errors) {
    result_.curve.planS.push_back(static_cast<float>(sample.place.timeS));
    result_.curve.recordS.push_back(static_cast<float>(record_.timeS[sample.sample]));
    result_.curve.pathMm.push_back(static_cast<float>(sample.distanceMm));
    result_.curve.speed.push_back(static_cast<float>(errors.speed));
    result_.curve.flow.push_back(static_cast<float>(errors.flow));
    result_.pathMaxMm = std::max(result_.pathMaxMm, sample.distanceMm);
    pathSumMm_ += sample.distanceMm;
    widen(errors.speed, result_.speedSlowest, result_.speedFastest);
    widen(errors.flow, result_.flowLowest, result_.flowHighest);
    watch(ErrorKind::Path, sample.distanceMm, tolerances_.pathMm, sample);
    watch(ErrorKind::Speed, errors.speed, tolerances_.speed, sample);
    watch(ErrorKind::Flow, errors.flow, tolerances_.flow, sample);
  }

  static void widen(double value, double& minimum, double& maximum) {
    if (std::isnan(value))
      return;
    minimum = std::min(minimum, value);
    maximum = std::max(maximum, value);
  }

  // Begins, extends or closes the stretch of one kind of error.
  void watch(ErrorKind kind, double value, double tolerance, const OnPlan& sample) {
    std::optional<ErrorPlace>& open = open_[static_cast<std::size_t>(kind)];
    if (std::isnan(value))
      return;
    if (std::abs(value) <= tolerance || (open && (value > 0.0) != (open->worst > 0.0)))
      close(open);
    if (std::abs(value) <= tolerance)
      return;
    if (!open) {
      open = ErrorPlace{kind};
      begunMm_[static_cast<std::size_t>(kind)] = sample.place.alongMm;
    }
    open->lengthMm = sample.place.alongMm - begunMm_[static_cast<std::size_t>(kind)];
    if (std::abs(value) <= std::abs(open->worst))
      return;
    open->worst = value;
    locate(*open, sample.place, record_.timeS[sample.sample]);
  }

  void locate(ErrorPlace& place, const PlannedPlace& at, double recordS) const {
    const std::size_t a = at.segment - 1, b = at.segment;
    const double length = planned_.alongMm[b] - planned_.alongMm[a];
    const double share = length > 0.0 ? (at.alongMm - planned_.alongMm[a]) / length : 1.0;
    place.where = planned_.tip[a] + share * (planned_.tip[b] - planned_.tip[a]);
    place.point = planned_.point[b];
    place.planS = at.timeS;
    place.recordS = recordS;
  }

  void close(std::optional<ErrorPlace>& open) {
    if (open)
      result_.places.push_back(*open);
    open.reset();
  }

  // Beads between consecutive samples are recorded, unless the record has passed over them or was
  // not near the path.
  void addBeads() {
    constexpr double kMinMm = 2.0;
    for (std::size_t k = 1; k < samples_.size(); ++k) {
      const PlannedPlace &a = samples_[k - 1].place, &b = samples_[k].place;
      const double movedMm =
          (record_.tip[samples_[k].sample] - record_.tip[samples_[k - 1].sample]).norm();
      double beadMm = 0.0;
      for (std::size_t s = a.segment; s <= b.segment; ++s)
        if (planned_.prints[s] != 0)
          beadMm += std::max(0.0, std::min(b.alongMm, planned_.alongMm[s]) -
                                      std::max(a.alongMm, planned_.alongMm[s - 1]));
      if (beadMm < kMinMm + 2.0 * movedMm) {
        if (std::max(samples_[k - 1].distanceMm, samples_[k].distanceMm) <= kNearMm)
          result_.printedMm += beadMm;
        continue;
      }
      ErrorPlace place{ErrorKind::Missing, beadMm, b.alongMm - a.alongMm};
      locate(place, a, timeOf(k - 1));
      result_.missingMm += beadMm;
      result_.places.push_back(place);
    }
  }

  void finish() {
    const auto count = static_cast<double>(result_.curve.pathMm.size());
    if (count > 0.0)
      result_.pathMeanMm = pathSumMm_ / count;
    if (recordedS_ > 0.0 && plannedS_ > 0.0) {
      result_.speedMean = plannedS_ / recordedS_ - 1.0;
      result_.flowMean = recordedS_ / plannedS_ - 1.0;
    }
    if (result_.flowIsRecorded)
      result_.flowMean = plannedMm3_ > 0.0 ? recordedMm3_ / plannedMm3_ - 1.0 : 0.0;
    std::ranges::stable_sort(result_.places, [](const ErrorPlace& a, const ErrorPlace& b) {
      return a.kind != b.kind ? a.kind < b.kind : std::abs(a.worst) > std::abs(b.worst);
    });
  }

  const RecordedRun& record_;
  const PlannedRun& planned_;
  const RunTolerances tolerances_;
  std::vector<OnPlan> samples_;
  std::array<std::optional<ErrorPlace>, 3> open_;
  std::array<double, 3> begunMm_ = {};
  double pathSumMm_ = 0.0, plannedS_ = 0.0, recordedS_ = 0.0, plannedMm3_ = 0.0, recordedMm3_ = 0.0;
  RunComparison result_;
};

} // namespace

base::Text kindName(ErrorKind kind) {
  switch (kind) {
  case ErrorKind::Path:
    return "path"_text;
  case ErrorKind::Speed:
    return "speed"_text;
  case ErrorKind::Flow:
    return "flow"_text;
  case ErrorKind::Missing:
    return "missing"_text;
  }
  return {};
}

RunVerdict RunComparison::verdict() const {
  if (printedMm < kSameJobShare * beadsMm)
    return RunVerdict::OtherJob;
  if (printedMm < kCompleteShare * beadsMm)
    return RunVerdict::Incomplete;
  return places.empty() ? RunVerdict::Within : RunVerdict::Beyond;
}

base::Message verdictSentence(const RunComparison& c) {
  switch (c.verdict()) {
  case RunVerdict::Within:
    return "no place differs from the plan by more than the tolerances"_text;
  case RunVerdict::Beyond:
    return base::message(
        "{count} place is beyond the tolerances|{count} places are beyond the tolerances"_plural,
        c.places.size());
  case RunVerdict::Incomplete:
    return base::message("only {recorded:.1f} of {planned:.1f} of beads are recorded"_text,
                         base::mm(c.printedMm), base::mm(c.beadsMm));
  case RunVerdict::OtherJob:
    return base::message(
        "this is no record of this job: {recorded:.1f} of {planned:.1f} of beads agree"_text,
        base::mm(c.printedMm), base::mm(c.beadsMm));
  }
  return {};
}

RunComparison compareRun(const RecordedRun& record, const PlannedRun& planned,
                         const RunTolerances& tolerances, const base::RunContext& ctx) {
  const std::optional<PathAlignment> aligned = alignRecord(record.tip, planned, ctx.sub(0.0, 0.8));
  if (!aligned)
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the record does not come near the planned path"_text, {},
                      "choose the project and the cell that it was recorded with"_text);
  return Comparer(record, planned, tolerances).compare(*aligned, ctx);
}

std::string curveCsv(const ErrorCurve& curve) {
  std::string text = "planS,recordS,pathMm,speed,flow\n";
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < curve.planS.size(); ++i)
    fmt::format_to(out, "{:.3f},{:.3f},{:.4f},{:.5f},{:.5f}\n", curve.planS[i], curve.recordS[i],
                   curve.pathMm[i], curve.speed[i], curve.flow[i]);
  return text;
}

} // namespace voluta::record
