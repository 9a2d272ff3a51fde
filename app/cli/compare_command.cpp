#include "base/data_files.h"
#include "base/files.h"
#include "cli/commands.h"
#include "cli/run_interruptibly.h"
#include "cli/verdict_words.h"
#include "curved/decomposition.h"
#include "pictures/job_picture.h"
#include "pipeline/cell_advice.h"
#include "pipeline/outputs.h"
#include "planar/planar_decomposition.h"

#include <algorithm>
#include <fmt/format.h>

namespace voluta::cli {

namespace {

using pipeline::CompareRow;
using pipeline::RowState;

// Fills the folders of the rows during planning: each plan is released once it is written.
class Writer {
public:
  Writer(std::filesystem::path folder, bool pictures)
      : folder_(std::move(folder)), pictures_(pictures) {}

  void write(std::size_t index, const CompareRow& row, pipeline::PlanResult* result,
             const base::RunContext& ctx) {
    files_.push_back({});
    if (!result)
      return;
    pipeline::RowFiles& files = files_.back();
    files.folder = pipeline::rowFolder(index, row.combination);
    const std::filesystem::path folder = folder_ / files.folder;
    std::error_code failed; // Writing into it will report the error
    std::filesystem::create_directories(folder, failed);
    pipeline::writeOutputs(*result, folder, ctx.quiet());
    if (pictures_)
      draw(*result, files);
  }

  const std::vector<pipeline::RowFiles>& files() const { return files_; }
  const std::string& pictureTrouble() const { return pictureTrouble_; }

private:
  void draw(const pipeline::PlanResult& result, pipeline::RowFiles& files) {
    for (const std::string& name : pictures::pictureNames()) {
      const project::Job& job = result.job;
      const bool there =
          name == "part" ? !job.item().decomposition() && !job.item().layers
          : name == "voxels"
              ? job.item().decomposition() &&
                    (!job.item().layers || job.item().decomposition()->missedVoxels > 0)
          : name == "pieces" ? job.item().pieces() && job.item().pieces()->pieces.size() > 1
          : name == "layers" ? job.item().layers != nullptr
                             : false;
      if (!there)
        continue;
      pictures::PictureOptions look;
      look.show = name;
      look.width = 800;
      look.height = 600;
      look.colour =
          job.item().pieces() && job.item().pieces()->pieces.size() > 1 ? "group" : "layer";
      const std::string file = files.folder + "/" + name + ".png";
      try {
        const std::string png = scene::pngBytes(pictures::jobPicture(job, look));
        base::writeFile(folder_ / file, png);
        files.pictures.push_back(file);
      } catch (const base::Error& error) {
        if (error.code() == base::ErrorCode::CannotWrite)
          throw;
        pictureTrouble_ = error.what(); // A comparison is useful without pictures
        pictures_ = false;
        return;
      }
    }
  }

  std::filesystem::path folder_;
  bool pictures_;
  std::vector<pipeline::RowFiles> files_;
  std::string pictureTrouble_;
};

std::string valueText(const pipeline::Figure& figure, const CompareRow& row) {
  const std::optional<double> value = figure.of(row);
  if (!value && figure.key == "layers" && row.report.item().decomposition.layers > 0)
    return fmt::format("{} steps", row.report.item().decomposition.layers);
  if (!value)
    return "-";
  if (figure.unit == "%")
    return fmt::format("{:.2f}", 100.0 * *value);
  if (figure.unit == "mm")
    return fmt::format("{:.3f}", *value);
  return figure.unit.empty() ? fmt::format("{:.0f}", *value) : fmt::format("{:.1f}", *value);
}

std::string headOf(const pipeline::Figure& figure) {
  return figure.unit.empty() ? base::english(figure.label)
                             : fmt::format("{} {}", base::english(figure.label), figure.unit);
}

// "auto (reverse)": the requested scheme and the one chosen.
std::string growthText(const CompareRow& row) {
  if (!row.combination.growth)
    return "-";
  const std::string asked = row.combination.growth->id();
  const std::string& scheme = row.report.item().decomposition.growth;
  return scheme.empty() || scheme == asked ? asked : fmt::format("{} ({})", asked, scheme);
}

using TextTable = std::vector<std::vector<std::string>>;

// Width in a terminal; the units are not ASCII.
std::size_t shownWidth(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void print(const TextTable& table, std::size_t leftAligned) {
  std::vector<std::size_t> widths(table.front().size(), 0);
  for (const auto& line : table)
    for (std::size_t c = 0; c < line.size(); ++c)
      widths[c] = std::max(widths[c], shownWidth(line[c]));
  for (const auto& line : table) {
    std::string text;
    for (std::size_t c = 0; c < line.size(); ++c) {
      const std::string pad(widths[c] - shownWidth(line[c]), ' ');
      text += (c ? "  " : "") + (c < leftAligned ? line[c] + pad : pad + line[c]);
    }
    fmt::print("{}\n", text);
  }
}

void sayTable(const pipeline::Comparison& comparison, const pipeline::Ranking& ranking) {
  TextTable table;
  std::vector<std::string> head{"", "mode", "growth", "platform"};
  const bool cells = !comparison.rows.front().combination.cell.empty();
  if (cells)
    head.insert(head.begin() + 1, "cell");
  for (const pipeline::Figure& figure : pipeline::figures())
    head.push_back(headOf(figure));
  for (const char* last : {"replay", "verdict", "planned in s"})
    head.emplace_back(last);
  table.push_back(std::move(head));
  for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
    const CompareRow& row = comparison.rows[i];
    std::vector<std::string> line{fmt::format("{}{}", i + 1, ranking.best == i ? " best" : ""),
                                  row.combination.mode, growthText(row),
                                  row.combination.platform.text()};
    if (cells)
      line.insert(line.begin() + 1, base::dataName(row.combination.cell));
    for (const pipeline::Figure& figure : pipeline::figures())
      line.push_back(valueText(figure, row));
    line.emplace_back(!pipeline::replayPassed(row) ? "-"
                                                   : verdictWords(pipeline::verdictOf(row.report)));
    line.emplace_back(pipeline::stateName(row.state()));
    line.push_back(fmt::format("{:.1f}", row.seconds));
    table.push_back(std::move(line));
  }
  constexpr std::size_t kTextColumns = 4;
  print(table, kTextColumns + (cells ? 1 : 0));
}

void sayVerdict(const pipeline::Comparison& comparison, const pipeline::Ranking& ranking,
                const pipeline::Weights& weights) {
  for (std::size_t i = 0; i < comparison.rows.size(); ++i)
    if (const std::string reason = base::english(comparison.rows[i].reason()); !reason.empty())
      fmt::print("{}: {}{}\n", i + 1, reason,
                 moreFindings(std::max<std::size_t>(comparison.rows[i].blocking(), 1) - 1));
  fmt::print("rule: {}\n", pipeline::ruleText(weights));
  if (!ranking.best) {
    fmt::print("best: none, as every row has blocking findings; ranked first is row {}\n",
               ranking.order.front() + 1);
    return;
  }
  std::string tied;
  for (const std::size_t row : ranking.tied)
    tied += fmt::format("{}{}", tied.empty() ? "; equal: row " : ", ", row + 1);
  fmt::print("best: row {}{}\n", *ranking.best + 1, tied);
}

// Done if there is a best row; kNotAll if all planned rows are blocked; the first error if none was
// planned.
ExitCode exitCodeOf(const std::vector<CompareRow>& rows) {
  const auto any = [&](RowState state) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const CompareRow& row) { return row.state() == state; });
  };
  if (any(RowState::Clear))
    return kDone;
  return any(RowState::Blocked) ? kNotAll : cli::exitCodeOf(rows.front().errorCode);
}

} // namespace

ExitCode compareCommand(const CompareCommandOptions& options) {
  ResultFolder staged(options.folder, pipeline::FolderKind::Comparison, options.replace);
  const std::filesystem::path folder = staged.path();
  struct Done {
    pipeline::Comparison comparison;
    std::string pictureTrouble;
    base::Message advice; // on the cells, if several are compared
  };
  auto outcome = runInterruptibly(
      [options, folder](const base::RunContext& ctx) {
        Writer writer(folder, options.pictures);
        pipeline::CompareWatch watch;
        watch.ended = [&](std::size_t index, const CompareRow& row,
                          const std::shared_ptr<pipeline::PlanResult>& result) {
          writer.write(index, row, result.get(), ctx);
        };
        Done done;
        done.comparison = pipeline::compare(options.compared, ctx, watch);
        base::writeFile(folder / "compare.json",
                        pipeline::compareJson(done.comparison, options.weights, writer.files()));
        done.pictureTrouble = writer.pictureTrouble();
        if (options.compared.cells.size() > 1)
          done.advice =
              pipeline::compareCells(options.compared.plan, options.compared.cells, ctx.quiet())
                  .reason;
        return done;
      },
      options.threads, progressSink(options.progress), [&] { staged.discard(); });
  endProgress(options.progress);
  const auto done = settled(std::move(outcome), staged);
  if (!done)
    return kCancelled;
  const pipeline::Ranking ranking = pipeline::rank(done->comparison.rows, options.weights);
  sayTable(done->comparison, ranking);
  sayVerdict(done->comparison, ranking, options.weights);
  if (const base::Message cells =
          pipeline::cellSentence(done->comparison.rows, ranking, done->advice);
      !cells.empty())
    fmt::print("cells: {}\n", base::english(cells));
  if (!done->pictureTrouble.empty())
    fmt::print(stderr, "no pictures: {}\n", done->pictureTrouble);
  return exitCodeOf(done->comparison.rows);
}

} // namespace voluta::cli
