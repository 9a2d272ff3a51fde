#include "sliced/sliced_reader.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "base/valid_utf8.h"
#include "build3mf/bead_cells.h"
#include "plan/layer_event.h"
#include "sliced/gcode_machine.h"
#include "sliced/layer_solid.h"
#include "sliced/sliced_sections.h"
#include "sliced/stated_amount.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace voluta::sliced {

namespace {
using base::Error;
using base::ErrorCode;

constexpr double kUsualFilamentMm = 1.75;
constexpr double kSparseShare = 0.9; // Infill without comments is solid from here on

// Returns the temperatures that the file sets, "215 °C, 230 °C (T1), 60 °C (M140)"; empty if none.
std::string heatOf(const SlicedFile& file) {
  std::string text;
  for (const auto& [tool, celsius] : file.nozzleC) {
    text += (text.empty() ? "" : ", ") + std::to_string(celsius) + " °C";
    text += tool > 0 ? " (T" + std::to_string(tool) + ")" : "";
  }
  if (file.bedC > 0)
    text += (text.empty() ? "" : ", ") + std::to_string(file.bedC) + " °C (M140)";
  return text;
}

std::vector<base::Message> notesOf(const SlicedFile& file, double filamentMm2) {
  std::vector<base::Message> notes;
  if (file.cutLine > 0)
    notes.push_back(base::message(
        "the file ends within line {line}, without a line end: it may be cut there, and the part unfinished; export it again"_text,
        file.cutLine));
  if (!file.volumetric && !file.header.oddDiameters.empty())
    notes.push_back(base::message(
        "the file states the filament diameter '{text}': {diameter} assumed for values that cannot be used; for another one set `pathsFlow`"_text,
        file.header.oddDiameters,
        base::mm(file.header.filamentMm > 0.0 ? file.header.filamentMm : kUsualFilamentMm)));
  else if (!file.volumetric && file.header.filamentMm <= 0.0)
    notes.push_back(base::message(
        "the file states no filament diameter: {diameter} assumed; for another one set `pathsFlow`"_text,
        base::mm(kUsualFilamentMm)));
  if (file.inStartCode > 0.0)
    notes.push_back(base::message("{volume:.0f} extruded before the first layer are left out"_text,
                                  base::mm3(file.inStartCode * filamentMm2)));
  if (file.inOwnCode > 0.0)
    notes.push_back(base::message(
        "{volume:.0f} extruded by the printer's own code are left out, from line {line} on"_text,
        base::mm3(file.inOwnCode * filamentMm2), file.ownLine));
  if (file.atRest > 0.0)
    notes.push_back(
        base::message("{volume:.1f} extruded at rest are left out, from line {line} on"_text,
                      base::mm3(file.atRest * filamentMm2), file.restLine));
  if (file.purged > 0.0)
    notes.push_back(base::message(
        "purge lines beside the part are left out: {volume:.0f} from line {line} on"_text,
        base::mm3(file.purged * filamentMm2), file.purgeLine));
  if (file.header.ultiGcode && file.volumetric)
    notes.push_back("amounts are taken as volumes, as UltiGCode states them"_text);
  else if (file.header.volumetric && file.volumetric)
    notes.push_back(
        "amounts are taken as volumes, as the setting use_volumetric_e of the file says"_text);
  const std::string heat = heatOf(file);
  if (!heat.empty())
    notes.push_back(base::message(
        "the file heats {heat}: programs heat as the material states, choose one that fits"_text,
        heat));
  notes.insert(notes.end(), file.unused.begin(), file.unused.end());
  return notes;
}

// Returns a sentence for each stop between beads, one for all stops behind the last bead, and one
// for all before the first bead, for which the operator's question at the start of each program
// stands. `lines`: of the beads.
std::vector<base::Message> stopNotes(const SlicedFile& file, const plan::ToolPlan& plan,
                                     const std::vector<std::size_t>& lines) {
  std::vector<base::Message> notes;
  std::size_t before = 0, behind = 0;
  for (const SlicedStop& stop : file.stops) {
    const auto bead =
        static_cast<std::size_t>(std::ranges::upper_bound(lines, stop.line) - lines.begin());
    if (bead == 0)
      ++before;
    else if (bead < lines.size())
      notes.push_back(base::message(kStopNote, stop.line, bead + 1, plan.paths[bead].layer + 1,
                                    base::validText(stop.text, plan::kPauseTextLength),
                                    stop.command));
    else
      ++behind;
  }
  if (behind > 0)
    notes.emplace_back(
        "not used: {count} stop behind the last bead, where the print is done|"
        "not used: {count} stops behind the last bead, where the print is done"_plural,
        std::vector<base::Value>{behind});
  if (before > 0)
    notes.emplace_back(
        "not used: {count} stop before the first bead, since programs begin with a question|"
        "not used: {count} stops before the first bead, since programs begin with a question"_plural,
        std::vector<base::Value>{before});
  return notes;
}

// Returns the amounts of a file as read, line by line.
std::vector<AmountAt> readAmounts(const SlicedFile& file) {
  std::vector<AmountAt> amounts = file.outside;
  for (const SlicedPath& path : file.paths)
    for (const SlicedPoint& point : path.points)
      if (point.extruded > 0.0)
        amounts.push_back({point.line, point.extruded});
  std::ranges::stable_sort(amounts, {}, &AmountAt::line);
  return amounts;
}

// Returns the first line whose amount is not the same in both; 0: there is none.
std::size_t firstOtherLine(const std::vector<AmountAt>& stated, const std::vector<AmountAt>& read) {
  constexpr double kSame = 1e-6, kSameShare = 1e-3;
  auto a = stated.begin(), b = read.begin();
  while (a != stated.end() || b != read.end()) {
    const std::size_t line =
        std::min(a == stated.end() ? SIZE_MAX : a->line, b == read.end() ? SIZE_MAX : b->line);
    double first = 0.0, second = 0.0;
    for (; a != stated.end() && a->line == line; ++a)
      first += a->amount;
    for (; b != read.end() && b->line == line; ++b)
      second += b->amount;
    if (std::abs(first - second) > kSame + kSameShare * std::max(first, second))
      return line;
  }
  return 0;
}

// Returns a sentence if the beads and what is left out are not the material that the file states.
std::vector<base::Message> amountNotes(const SlicedFile& file, double beadsMm3,
                                       const StatedAmount& stated, double filamentMm2) {
  constexpr double kSameShare = 0.002, kSameMm3 = 1.0;
  const double statedMm3 = filamentMm2 * stated.sum;
  const double readMm3 =
      beadsMm3 + filamentMm2 * (file.atRest + file.inStartCode + file.inOwnCode + file.purged);
  if (std::abs(readMm3 - statedMm3) <= kSameMm3 + kSameShare * statedMm3)
    return {};
  const std::size_t line = firstOtherLine(stated.increments, readAmounts(file));
  return {base::message(kAmountNote, base::mm3(statedMm3), base::mm3(readMm3),
                        line > 0 ? base::message("in line {line} first"_text, line)
                                 : base::Message("in no single line"_text))};
}
} // namespace

bool changesFilament(std::string_view command) {
  return command.starts_with("M600") || command.starts_with("m600");
}

ReadSliced readSliced(std::string_view text, const std::string& name, const base::RunContext& ctx) {
  if (text.starts_with("GCDE"))
    throw Error(ErrorCode::UnreadableFile, "is binary G-code"_text, name,
                "export G-code as text from the slicer"_text);
  if (constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; text.starts_with(kByteOrderMark))
    text.remove_prefix(kByteOrderMark.size());
  const SlicedFile file = followGcode(text, name, ctx.sub(0.0, 0.4));
  if (file.paths.empty())
    throw Error(ErrorCode::UnusableInput, "contains no beads: no motion extrudes"_text, name,
                "export the G-code with extrusion (E) from a slicer"_text);
  ReadSliced read;
  read.filamentMm = file.volumetric                ? 0.0
                    : file.header.filamentMm > 0.0 ? file.header.filamentMm
                                                   : kUsualFilamentMm;
  const double filamentMm2 =
      file.volumetric ? 1.0 : base::kPi / 4.0 * read.filamentMm * read.filamentMm;
  std::vector<std::size_t> lines;
  read.plan = beadsOf(file, filamentMm2, &lines);
  read.volumeMm3 = beadsMm3(read.plan);
  read.notes = notesOf(file, filamentMm2);
  const std::vector<base::Message> stops = stopNotes(file, read.plan, lines);
  read.notes.insert(read.notes.end(), stops.begin(), stops.end());
  const std::vector<base::Message> amounts =
      amountNotes(file, read.volumeMm3, statedAmount(text, file.header), filamentMm2);
  read.notes.insert(read.notes.end(), amounts.begin(), amounts.end());
  if (isLevel(read.plan)) {
    LayerSolid solid =
        solidOfLayers(read.plan, file.header.hasKinds ? 0.0 : kSparseShare, ctx.sub(0.4, 1.0));
    read.solid = std::move(solid.mesh);
    if (!std::isinf(solid.fill.shellMm))
      read.plan.fill = {solid.fill};
  } else {
    constexpr double kCellMm = 0.25;
    read.solid = build3mf::solidOfBeads(read.plan, kCellMm, ctx.sub(0.4, 1.0));
  }
  return read;
}

} // namespace voluta::sliced
