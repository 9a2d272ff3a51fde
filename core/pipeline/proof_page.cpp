// The page of a proof: tables, and the fill map seen from the front and from the side.
#include "base/markup.h"
#include "base/text.h"
#include "pipeline/proof.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

using base::english;

std::string row(const std::string& what, const std::string& value, const std::string& where = {}) {
  return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", what, value, where);
}

std::string place(const ProofValue& value) {
  if (value.line == 0)
    return english(base::message("at {time:.1f}"_text, base::seconds(value.atS)));
  return base::escapedMarkup(
      english(base::message("{file}, line {line}, at {time:.1f}"_text, value.file, value.line,
                            base::seconds(value.atS))));
}

// Colours that eyes of every kind tell apart; red is kept for what is blocked.
std::string colourOf(double share) {
  constexpr double kFull = 0.97;
  if (share >= kFull)
    return "#1f4e79";
  const double t = std::clamp(share / kFull, 0.0, 1.0);
  return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(240 - 150 * t),
                     static_cast<int>(180 - 20 * t), static_cast<int>(40 + 160 * t));
}

// The mean over the axis that one looks along. `across`: the axis to the right; z is up.
std::string view(const FillMap& fill, int across, const std::string& title) {
  const int along = 1 - across;
  constexpr int kPixels = 8;
  const int width = fill.size[across], height = fill.size.z();
  std::string svg =
      fmt::format("<figure><svg width=\"{}\" height=\"{}\" role=\"img\"><title>{}</title>\n",
                  kPixels * width, kPixels * height, title);
  for (int k = 0; k < height; ++k)
    for (int i = 0; i < width; ++i) {
      double sum = 0.0, count = 0.0;
      for (int j = 0; j < fill.size[along]; ++j) {
        Eigen::Vector3i cell(0, 0, k);
        cell[across] = i;
        cell[along] = j;
        const double share = fill.filled[static_cast<std::size_t>(
            cell.x() + fill.size.x() * (cell.y() + fill.size.y() * k))];
        if (share >= 0.0) {
          sum += share;
          count += 1.0;
        }
      }
      if (count > 0.0)
        svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                           kPixels * i, kPixels * (height - 1 - k), kPixels, kPixels,
                           colourOf(sum / count));
    }
  return svg + fmt::format("</svg><figcaption>{}</figcaption></figure>\n", title);
}

std::string replayRows(const project::ReplayReport& v) {
  const auto percent = [](double share) {
    return english(base::message("{share:.2f}"_text, base::percent(100.0 * share)));
  };
  return row(english("share of the part inside beads"_text), percent(v.coveredFraction),
             "&ge; " + percent(v.thresholds.covered)) +
         row(english("bead length with nothing beneath"_text), percent(v.unsupportedFraction),
             "&le; " + percent(v.thresholds.unsupported)) +
         row(english("material outside the part or without room"_text), percent(v.overfillFraction),
             "&le; " + percent(v.thresholds.overfill)) +
         row(english("material laid by the part's volume"_text), percent(v.massRatio),
             "100 % &plusmn; " + percent(v.thresholds.mass)) +
         row(english("collisions"_text), std::to_string(v.collisions),
             "&le; " + std::to_string(v.thresholds.collisions)) +
         row(english("violations of limits"_text), std::to_string(v.limitViolations),
             "&le; " + std::to_string(v.thresholds.limitViolations)) +
         row(english("deviation from the planned path"_text),
             english(base::message("{way:.4f}"_text, base::mm(v.maxDeviationMm))),
             "&le; " +
                 english(base::message("{way:.4f}"_text, base::mm(v.thresholds.deviationMm))));
}

} // namespace

std::string proofPage(const Proof& proof) {
  const std::string title = base::escapedMarkup(english(
      base::message("{part}: proof of the {format} program"_text, proof.part, proof.format)));
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
      "<style>body{{font-family:sans-serif;margin:2em;max-width:60em}}td{{padding:.2em 1em .2em 0;"
      "vertical-align:top}}figure{{display:inline-block;margin:1em 2em 0 0}}"
      "code{{word-break:break-all}}</style></head><body>\n<h1>{0}</h1>\n<table>\n",
      title);
  for (const Proof::File& file : proof.files)
    page += row(base::escapedMarkup(file.name), fmt::format("<code>{}</code>", file.sha256),
                english(base::message("{bytes} bytes, SHA-256"_text, file.bytes)));
  const auto seconds = [](double s) {
    return english(base::message("{time:.1f}"_text, base::seconds(s)));
  };
  page += row(english("duration by the plan"_text), seconds(proof.plannedS));
  page += row(english("duration as the program is run"_text), seconds(proof.programS));
  page += row(english("material"_text),
              english(base::message("{volume:.1f}"_text, base::mm3(proof.materialMm3))));
  page += "</table>\n<h2>" + english("Replay"_text) + "</h2>\n<table>\n" +
          replayRows(proof.verdict) + "</table>\n";
  page += "<h2>" + english("Nearest to its limits, from start to end"_text) + "</h2>\n<table>\n";
  page += row(english("least clearance of arm, plate and part"_text),
              english(base::message("{way:.2f}"_text, base::mm(proof.clearance.value))),
              place(proof.clearance));
  for (const Proof::Joint& joint : proof.joints)
    page += row(base::escapedMarkup(
                    english(base::message("joint {name}, to its nearer limit"_text, joint.name))),
                english(base::message("{angle:.1f}"_text, joint.slides
                                                              ? base::mm(joint.margin.value)
                                                              : base::degrees(joint.margin.value))),
                place(joint.margin));
  page += row(english("isotropy of the arm (0: singular, 1: even)"_text),
              english(base::message("{ratio:.4f}"_text, base::number(proof.isotropy.value))),
              place(proof.isotropy));
  page += "</table>\n<h2>" + english("How full the part is"_text) + "</h2>\n";
  page += view(proof.fill, 0, english("from the front (x to the right, z up)"_text));
  page += view(proof.fill, 1, english("from the side (y to the right, z up)"_text));
  page += fmt::format("<p>{}</p>\n",
                      base::escapedMarkup(english(base::message(
                          "Dark blue: 97 % and more. The part as it will be printed: {file}"_text,
                          proof.printed))));
  return page + "</body></html>\n";
}

} // namespace voluta::pipeline
