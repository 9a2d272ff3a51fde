// The text of a proof for the operator and the recipient of the part: first the verdict, then each
// margin as a sentence with its limit and its worst place.
#include "base/duration.h"
#include "base/shown_number.h"
#include "pipeline/proof.h"
#include "plan/finding.h"
#include "project/shown_figures.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace voluta::pipeline {

namespace {

using base::message;
using page::Mark;

base::Quantity share(double fraction) {
  return base::percent(100.0 * fraction);
}
// With these decimals, and beyond a limit that it does not keep.
base::Quantity share(double fraction, double limit, int decimals) {
  return base::percent(base::roundedBeyond(100.0 * fraction, 100.0 * limit, decimals));
}

// Classes of the fill map, fullest first. Touching beads with round edges fill nine tenths of the
// volume, the material pressed between them the rest. The colours are safe for colour-blind readers
// and none of them is the red of failed checks.
struct FillClass {
  double minimum; // share
  page::Colour colour;
};
constexpr std::array<FillClass, 5> kFillClasses{{{0.90, {0x1f, 0x4e, 0x79}},
                                                 {0.80, {0x5b, 0x8d, 0xb8}},
                                                 {0.70, {0xa9, 0xc7, 0xde}},
                                                 {0.50, {0xf3, 0xc7, 0x6b}},
                                                 {0.00, {0xd9, 0x82, 0x2b}}}};

int fillClassOf(double filled) {
  const auto* found = std::ranges::find_if(
      kFillClasses, [&](const FillClass& row) { return filled >= row.minimum; });
  return static_cast<int>(
      std::min<std::ptrdiff_t>(found - kFillClasses.begin(), std::ssize(kFillClasses) - 1));
}

// Returns the filled share of what is meant to be filled along the view. `across`: the axis that
// points right; z is up.
page::CellMap viewOf(const FillMap& fill, int across) {
  const int along = 1 - across;
  page::CellMap map{fill.size[across], fill.size.z(), {}, {}};
  for (int k = map.height - 1; k >= 0; --k)
    for (int i = 0; i < map.width; ++i) {
      double sum = 0.0, intended = 0.0;
      bool isPart = false;
      for (int j = 0; j < fill.size[along]; ++j) {
        Eigen::Vector3i cell(0, 0, k);
        cell[across] = i;
        cell[along] = j;
        const auto cube =
            static_cast<std::size_t>(cell.x() + fill.size.x() * (cell.y() + fill.size.y() * k));
        if (fill.filled[cube] >= 0.0) {
          isPart = true;
          sum += fill.filled[cube];
          intended += fill.intended[cube];
        }
      }
      const double share = sum < intended ? sum / intended : 1.0;
      map.swatch.push_back(isPart ? fillClassOf(share) : page::CellMap::kNothing);
    }
  return map;
}

// Keeps numbers and their units on one line (no-break spaces).
std::string unbroken(std::string text) {
  constexpr std::string_view kUnits[] = {" %", " mm", " g", " min", " h", " s", " cm"};
  constexpr std::string_view kFixedSpace = "\u00a0";
  for (const std::string_view unit : kUnits)
    for (std::size_t at = text.find(unit); at != std::string::npos; at = text.find(unit, at + 1)) {
      const std::size_t end = at + unit.size();
      const bool ends =
          end == text.size() || std::isalpha(static_cast<unsigned char>(text[end])) == 0;
      if (at > 0 && std::isdigit(static_cast<unsigned char>(text[at - 1])) != 0 && ends)
        text.replace(at, 1, kFixedSpace);
    }
  return text;
}

class SheetMaker {
public:
  SheetMaker(const Proof& proof, const base::Language& language)
      : proof_(proof), verdict_(project::shownFigures(proof.verdict)), language_(language) {}

  page::Sheet make() {
    sheet_.title = say(message("{part}: verification report of the {format} program"_text,
                               proof_.part, proof_.format));
    sheet_.issued = say(message("Voluta {version}, {date}"_text, proof_.version, proof_.date));
    facts();
    sheet_.checksTitle = say("Checks, with the closest approach to each limit"_text);
    beadChecks();
    programChecks();
    motionChecks();
    planChecks();
    verdict();
    maps();
    files();
    sheet_.footer = say(
        message("Positions are in mm in the work frame: origin at the centre of the "
                "platform's top, z pointing out of it. The printed part as a solid: {file}"_text,
                proof_.printed));
    return std::move(sheet_);
  }

private:
  std::string say(const base::Message& what) const {
    return unbroken(base::inWords(what, language_));
  }

  void fact(base::Text label, const base::Message& value) {
    sheet_.facts.push_back({say(label), say(value)});
  }
  void check(Mark mark, const base::Message& sentence, const std::string& place = {}) {
    sheet_.checks.push_back({mark, say(sentence), place});
  }
  void check(bool passed, const base::Message& sentence, const std::string& place = {}) {
    check(passed ? Mark::Passed : Mark::Failed, sentence, place);
  }
  // A check of the printed part: beyond its limit the program is still safe to run.
  void quality(bool passed, const base::Message& sentence, const std::string& place = {}) {
    check(passed ? Mark::Passed : Mark::Caution, sentence, place);
  }

  std::string place(const ProofPlace& at) const {
    std::vector<std::string> parts;
    if (at.at)
      parts.push_back(say(message("at {place:.1f}"_text, plan::pointOf(*at.at))));
    if (at.layer > 0)
      parts.push_back(say(message("layer {layer}"_text, at.layer)));
    if (at.atS >= 0.0)
      parts.push_back(say(message("after {time}"_text, base::duration(at.atS))));
    if (at.line > 0)
      parts.push_back(say(message("line {line} of {file}"_text, at.line, at.file)));
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  void facts() {
    const process::Process& p = proof_.process;
    fact("Part"_text, message("{part}, {x:.1f#} x {y:.1f#} x {z:.1f}"_text, proof_.part,
                              base::mm(proof_.sizeMm.x()), base::mm(proof_.sizeMm.y()),
                              base::mm(proof_.sizeMm.z())));
    fact("Robot"_text, message("{name}"_text, proof_.robot));
    fact("Built in"_text, message("{layers} layer, {way}|{layers} layers, {way}"_plural,
                                  proof_.layers, proof_.mode));
    fact("Cell"_text, message("{name}"_text, proof_.cell));
    fact("Print time"_text,
         message("{time} on its controller"_text, base::duration(proof_.programS)));
    fact("Tool"_text,
         message("nozzle {nozzle}, bead {width#} x {height}"_text, base::mm(p.nozzleDiameterMm),
                 base::mm(p.beadWidthMm), base::mm(p.layerHeightMm)));
    limits();
    choices();
    fact("Mass"_text,
         message("{mass:.1f} g, supports and waste included"_text, base::number(proof_.massG)));
    if (!proof_.tools.empty()) {
      tools();
      return;
    }
    fact("Material"_text,
         message("{material}, {volume:.1f} cm3 at {density:.2f} g/cm3"_text, p.material.label,
                 base::number(1e-3 * proof_.materialMm3), base::number(p.material.densityGPerCm3)));
  }

  void limits() {
    const project::ThresholdsReport& t = verdict_.thresholds;
    fact("Quality"_text,
         t.accepted.empty() ? message("{quality}"_text, t.quality)
                            : message("{quality}; accepted: {shares}"_text, t.quality, t.accepted));
  }

  void choices() {
    const ReportedChoices& c = proof_.choices;
    fact("Preset"_text, c.changed.empty() ? message("{name}"_text, c.preset)
                                          : message("{name}; changed: {settings}"_text, c.preset,
                                                    fmt::format("{}", fmt::join(c.changed, ", "))));
    if (!c.pauses.empty())
      fact("Pauses before layers"_text,
           message("{layers}"_text, fmt::format("{}", fmt::join(c.pauses, ", "))));
  }

  void tools() {
    double purgedG = 0.0;
    for (std::size_t i = 0; i < proof_.tools.size(); ++i) {
      const Proof::Tool& tool = proof_.tools[i];
      purgedG += tool.purgedG;
      fact("Material"_text,
           message("tool {number}: {material}, {process}, {mass:.1f} g"_text, i + 1, tool.material,
                   tool.process, base::number(tool.printedG)));
    }
    fact("Tool changes"_text,
         message("{changes}, {mass:.1f} g purged"_text, proof_.toolChanges, base::number(purgedG)));
  }

  void beadChecks() {
    const project::ThresholdsReport& limits = verdict_.thresholds;
    quality(verdict_.coveredFraction >= limits.covered,
            message("Fill: {share:.1f} of the part is filled; at least {limit:.4g} required."_text,
                    share(verdict_.coveredFraction, limits.covered, 1), share(limits.covered)),
            place(proof_.gap));
    quality(verdict_.thinFraction <= limits.thin,
            message("Thin: {share:.1f} of the part is narrower than the narrowest bead and stays "
                    "open; at most {limit:.4g} allowed."_text,
                    share(verdict_.thinFraction, limits.thin, 1), share(limits.thin)),
            place(proof_.thin));
    quality(verdict_.overfillFraction <= limits.overfill,
            message("Overfill: {share:.1f} of the part's volume lies outside it or in places "
                    "already full; at most {limit:.4g} allowed."_text,
                    share(verdict_.overfillFraction, limits.overfill, 1), share(limits.overfill)),
            place(proof_.overfill));
    quality(std::abs(verdict_.massRatio - 1.0) <= limits.mass,
            message("Amount: {share:.1f} of the part's volume is deposited; {least:.4g#} to "
                    "{most:.4g} allowed."_text,
                    share(verdict_.massRatio,
                          verdict_.massRatio < 1.0 ? 1.0 - limits.mass : 1.0 + limits.mass, 1),
                    share(1.0 - limits.mass), share(1.0 + limits.mass)));
    quality(
        verdict_.unsupportedFraction <= limits.unsupported,
        message("Unsupported: {share:.2f} of the bead length; at most {limit:.4g} allowed."_text,
                share(verdict_.unsupportedFraction, limits.unsupported, 2),
                share(limits.unsupported)),
        place(proof_.unsupported));
    check(Mark::Note,
          message("Partly supported: {share:.1f} of the bead length is supported over less "
                  "than half its width."_text,
                  share(verdict_.halfCarriedFraction)),
          place(proof_.halfCarried));
    const double bridge = proof_.process.bridgeMm;
    check(verdict_.longestUnsupportedMm <= bridge ? Mark::Passed : Mark::Note,
          message("Longest unsupported run: {length:.1f}; this material bridges {bridge:.1f}."_text,
                  base::mm(base::roundedBeyond(verdict_.longestUnsupportedMm, bridge, 1)),
                  base::mm(bridge)),
          place(proof_.longestUnsupported));
    layerTimes();
  }

  void layerTimes() {
    if (verdict_.longestLayerTimeS <= 0.0)
      return;
    const base::Quantity shortest = base::seconds(verdict_.shortestLayerTimeS),
                         longest = base::seconds(verdict_.longestLayerTimeS),
                         mean = base::seconds(verdict_.meanLayerTimeS);
    const double minimum = proof_.minLayerTimeS;
    if (minimum <= 0.0) {
      check(Mark::Note,
            message("Time between layers: {shortest:.1f} to {longest:.1f} on its controller, "
                    "{mean:.1f} on average."_text,
                    shortest, longest, mean),
            place(proof_.layerTime));
      return;
    }
    constexpr double kTolerance = 0.02;
    quality(verdict_.shortestLayerTimeS >= (1.0 - kTolerance) * minimum,
            message("Time between layers: {shortest:.1f} to {longest:.1f} on its controller, "
                    "{mean:.1f} on average; at least {limit:.0f} required."_text,
                    shortest, longest, mean, base::seconds(minimum)),
            place(proof_.layerTime));
  }

  void programChecks() {
    const project::ThresholdsReport& limits = verdict_.thresholds;
    check(verdict_.flowErrorFraction <= limits.flowError,
          message("Bead section: off by more than 5 % over {share:.2f} of the printed length; "
                  "at most {limit:.0f} allowed."_text,
                  share(verdict_.flowErrorFraction, limits.flowError, 2), share(limits.flowError)),
          place(proof_.flowError));
    check(verdict_.maxDeviationMm <= limits.deviationMm,
          message("Path: the nozzle deviates from the planned path by up to {way:.3f}; at most "
                  "{limit:.2f} allowed."_text,
                  base::mm(base::roundedBeyond(verdict_.maxDeviationMm, limits.deviationMm, 3)),
                  base::mm(limits.deviationMm)),
          place(proof_.deviation));
    if (proof_.deviations > 0)
      check(false, message("{places} place where the program differs from the plan|{places} places "
                           "where the program differs from the plan"_plural,
                           proof_.deviations));
  }

  void motionChecks() {
    if (proof_.armChecked)
      armChecks();
    else
      nozzleChecks();
  }

  // For programs that contain nozzle positions but no joint values.
  void nozzleChecks() {
    const project::ThresholdsReport& limits = verdict_.thresholds;
    check(verdict_.collisions <= limits.collisions,
          message("Collisions of head, plate and part: {collisions}; none allowed."_text,
                  verdict_.collisions));
    check(verdict_.limitViolations <= limits.limitViolations,
          message("Limits of flow and blends: {violations} violations; none allowed."_text,
                  verdict_.limitViolations));
    check(Mark::Note, "Arm, joints and their limits: not checked, as the program contains nozzle "
                      "positions but no joint values."_text);
  }

  void armChecks() {
    const project::ThresholdsReport& limits = verdict_.thresholds;
    check(verdict_.collisions <= limits.collisions,
          message("Collisions: {collisions}; none allowed."_text, verdict_.collisions));
    check(verdict_.collisions <= limits.collisions ? Mark::Passed : Mark::Note,
          message("Minimum clearance between arm, plate and part: {way:.1f}."_text,
                  base::mm(proof_.clearance.value)),
          place(proof_.clearance.place));
    check(verdict_.limitViolations <= limits.limitViolations,
          message("Limits of joints, speeds and flow: {violations} violations; none allowed."_text,
                  verdict_.limitViolations));
    jointChecks();
    check(Mark::Note,
          message("Singularities: isotropy is at least {ratio:.3f} (0 is singular, 1 is "
                  "isotropic)."_text,
                  base::number(proof_.isotropy.value)),
          place(proof_.isotropy.place));
  }

  void jointChecks() {
    if (proof_.joints.empty())
      return;
    // Compares degrees with mm: a small margin is small in either unit.
    const auto nearest = std::ranges::min_element(
        proof_.joints, {}, [](const Proof::Joint& joint) { return joint.margin.value; });
    check(
        nearest->margin.value >= 0.0 ? Mark::Passed : Mark::Note,
        message("Joint range: joint {name} has the smallest margin to its limit, {angle:.1f}."_text,
                nearest->name,
                nearest->slides ? base::mm(nearest->margin.value)
                                : base::degrees(nearest->margin.value)),
        place(nearest->margin.place));
    const auto fastest = std::ranges::max_element(
        proof_.joints, {}, [](const Proof::Joint& joint) { return joint.speed.value; });
    check(fastest->speed.value <= 1.0 ? Mark::Passed : Mark::Note,
          message("Joint speed: joint {name} is closest to its limit, at {share:.0f} of it."_text,
                  fastest->name, share(fastest->speed.value)),
          place(fastest->speed.place));
  }

  base::Message howItWasMeasured() const {
    return proof_.armChecked
               ? "Voluta read the program back, ran it on a model of the robot and its "
                 "controller, and measured what it prints."_text
               : "Voluta read the program back, moved the nozzle along it without an arm, and "
                 "measured what it prints."_text;
  }
  base::Message howItDiffers(std::ptrdiff_t checks) const {
    return {
        "Nothing that was checked endangers robot or cell: {checks} check of the part is beyond "
        "its limit.|Nothing that was checked endangers robot or cell: {checks} checks of the "
        "part are beyond their limits."_plural,
        {checks}};
  }
  base::Message howItFailed(std::ptrdiff_t checks) const {
    const base::Text failed =
        proof_.armChecked
            ? "Voluta read the program back, ran it on a model of the robot and its controller, "
              "and found {checks} check failed.|Voluta read the program back, ran it on a model "
              "of the robot and its controller, and found {checks} checks failed."_plural
            : "Voluta read the program back, moved the nozzle along it without an arm, and found "
              "{checks} check failed.|Voluta read the program back, moved the nozzle along it "
              "without an arm, and found {checks} checks failed."_plural;
    return {failed, {checks}};
  }

  // Findings on the plan that no replay of a program measures.
  void planChecks() {
    constexpr std::size_t kMaxShown = 8;
    for (std::size_t i = 0; i < std::min(kMaxShown, proof_.blockers.size()); ++i)
      check(proof_.blockers[i].concernsSafety ? Mark::Failed : Mark::Caution,
            message("Plan: {finding}."_text, proof_.blockers[i].reason),
            place(proof_.blockers[i].place));
    if (proof_.blockers.size() > kMaxShown)
      check(isRefused(proof_.decision) ? Mark::Failed : Mark::Caution,
            message(
                "Plan: {count} more blocking finding.|Plan: {count} more blocking findings."_plural,
                proof_.blockers.size() - kMaxShown));
  }

  base::Text decision() const {
    switch (proof_.decision) {
    case PlanVerdict::Passed:
      return "Passed: this program prints the part as planned."_text;
    case PlanVerdict::NotAsAsked:
      return "Safe to run, but it does not print the part as asked."_text;
    case PlanVerdict::Unchecked:
      return "Safe to run but for your own statements, which nothing checks."_text;
    case PlanVerdict::Blocked:
      return "Not approved: the plan has blocking findings."_text;
    case PlanVerdict::Refused:
      break;
    }
    return "Refused: do not run this program."_text;
  }

  void verdict() {
    const auto count = [&](Mark mark) {
      return std::ranges::count(sheet_.checks, mark, &page::Check::mark);
    };
    sheet_.verdict = say(decision());
    switch (proof_.decision) {
    case PlanVerdict::Passed:
      sheet_.verdictMark = Mark::Passed;
      sheet_.verdictDetail = say(howItWasMeasured());
      break;
    case PlanVerdict::NotAsAsked:
    case PlanVerdict::Unchecked:
      sheet_.verdictMark = Mark::Caution;
      sheet_.verdictDetail = say(howItDiffers(count(Mark::Caution)));
      break;
    default:
      sheet_.verdictMark = Mark::Failed;
      sheet_.verdictDetail = say(howItFailed(count(Mark::Failed)));
    }
    if (proof_.foreign)
      sheet_.verdictDetail += " " + say("It is for another controller than the cell's."_text);
    if (proof_.rest)
      sheet_.verdictDetail += " " + say("It prints the rest of a stopped print."_text);
  }

  void maps() {
    sheet_.mapsTitle = say(
        "Fill of what is meant to be solid: mean along the view, for beads with round edges"_text);
    sheet_.maps = {viewOf(proof_.fill, 0), viewOf(proof_.fill, 1)};
    sheet_.maps[0].caption = say("from the front (x to the right, z up)"_text);
    sheet_.maps[1].caption = say("from the side (y to the right, z up)"_text);
    for (std::size_t i = 0; i < kFillClasses.size(); ++i) {
      const base::Quantity minimum = share(kFillClasses[i].minimum);
      const base::Message label =
          i == 0 ? message("at least {share:.0f} filled"_text, minimum)
          : i + 1 == kFillClasses.size()
              ? message("less than {share:.0f}"_text, share(kFillClasses[i - 1].minimum))
              : message("{least:.0f#} to {most:.0f}"_text, minimum,
                        share(kFillClasses[i - 1].minimum));
      sheet_.legend.push_back({kFillClasses[i].colour, say(label)});
    }
  }

  void files() {
    sheet_.filesTitle = say("Program files with their SHA-256"_text);
    for (const Proof::File& file : proof_.files)
      sheet_.files.push_back(
          {file.name, say(message("{bytes} bytes"_text, file.bytes)), file.sha256});
  }

  const Proof& proof_;
  const project::ReplayReport verdict_;
  const base::Language& language_;
  page::Sheet sheet_;
};

} // namespace

page::Sheet proofSheet(const Proof& proof, const base::Language& language) {
  return SheetMaker(proof, language).make();
}

} // namespace voluta::pipeline
