#include "base/markup.h"
#include "page/sheet.h"
#include "page/valid_text.h"

#include <fmt/format.h>
#include <string_view>

namespace voluta::page {

namespace {

using base::escapedMarkup;

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[three >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

std::string style() {
  const SheetColours c;
  std::string css =
      "@page{size:A4;margin:12mm}"
      "body{font:8pt/1.3 'DejaVu Sans',Verdana,Arial,sans-serif;color:INK;background:#fff;"
      "max-width:186mm;margin:8mm auto}"
      "@media print{body{margin:0}}"
      "*{print-color-adjust:exact;-webkit-print-color-adjust:exact}"
      "h1{font-size:13pt;line-height:1.2;margin:0;overflow-wrap:anywhere}"
      "h2{font-size:9pt;margin:2.5mm 0 .8mm}"
      "header{display:flex;justify-content:space-between;align-items:baseline;gap:6mm}"
      ".issued,.place,figcaption,footer,.label{color:QUIET;font-size:7pt}"
      ".issued{text-align:right;white-space:nowrap}"
      ".verdict{margin:3mm 0;padding:2.5mm 4mm;border-left:2mm solid}"
      ".verdict b{font-size:11pt;display:block}"
      ".pictures,.maps{display:flex;gap:4mm;align-items:flex-end}"
      "figure{margin:0}.pictures figure{flex:1 1 0}.pictures "
      "img{width:100%;display:block;max-height:58mm;object-fit:contain}"
      ".facts{display:grid;grid-template-columns:1fr 1fr;gap:.6mm 6mm;margin-top:2mm}"
      ".facts div{display:flex;gap:2mm}.label{flex:0 0 24mm;padding-top:.3mm}"
      ".facts span+span{overflow-wrap:anywhere}"
      "table{border-collapse:collapse;width:100%}"
      "td{padding:.4mm 2mm .4mm 0;border-top:.2mm solid RULE;vertical-align:top}"
      ".mark{width:4mm;font-weight:bold}.place{width:34%;padding-top:.6mm}"
      ".map svg{display:block;height:30mm;width:auto;max-width:58mm}"
      ".legend{font-size:7pt;list-style:none;margin:0;padding:0}"
      ".legend svg{width:3.2mm;height:3.2mm;vertical-align:-.5mm;margin-right:1.5mm}"
      "code{font:7pt 'DejaVu Sans Mono',monospace;overflow-wrap:anywhere}"
      "footer{margin-top:2mm}";
  const auto put = [&css](std::string_view name, Colour colour) {
    for (std::size_t at = css.find(name); at != std::string::npos; at = css.find(name, at))
      css.replace(at, name.size(), hex(colour));
  };
  put("QUIET", c.quiet);
  put("RULE", c.rule);
  put("INK", c.ink);
  return css;
}

std::string pictures(const Sheet& sheet) {
  if (sheet.pictures.empty())
    return {};
  std::string text = "<div class=\"pictures\">\n";
  for (const Picture& picture : sheet.pictures) {
    const std::string caption = escapedMarkup(picture.caption);
    text += fmt::format("<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\">"
                        "<figcaption>{0}</figcaption></figure>\n",
                        caption, base64(picture.png));
  }
  return text + "</div>\n";
}

std::string facts(const Sheet& sheet) {
  std::string text = "<div class=\"facts\">\n";
  for (const Fact& fact : sheet.facts)
    text += fmt::format("<div><span class=\"label\">{}</span><span>{}</span></div>\n",
                        escapedMarkup(fact.label), escapedMarkup(fact.value));
  return text + "</div>\n";
}

std::string checks(const Sheet& sheet) {
  if (sheet.checks.empty())
    return {};
  const SheetColours colours;
  std::string text = fmt::format("<h2>{}</h2>\n<table>\n", escapedMarkup(sheet.checksTitle));
  for (const Check& check : sheet.checks) {
    text += fmt::format("<tr><td class=\"mark\" style=\"color:{}\">{}</td><td>{}</td>"
                        "<td class=\"place\">{}</td></tr>\n",
                        hex(colours.of(check.mark)), signOf(check.mark),
                        escapedMarkup(check.sentence), escapedMarkup(check.place));
  }
  return text + "</table>\n";
}

// Draws consecutive cells of one colour in a row as one rectangle.
std::string svg(const CellMap& map, const std::vector<Swatch>& legend) {
  std::string text = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" "
                                 "shape-rendering=\"crispEdges\"><title>{}</title>\n",
                                 map.width, map.height, escapedMarkup(map.caption));
  for (int row = 0; row < map.height; ++row)
    for (int i = 0, end = 0; i < map.width; i = end) {
      const auto at = [&](int column) {
        return map.swatch[static_cast<std::size_t>(row * map.width + column)];
      };
      for (end = i + 1; end < map.width && at(end) == at(i);)
        ++end;
      if (at(i) != CellMap::kNothing)
        text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"1\" fill=\"{}\"/>\n", i,
                            row, end - i, hex(legend[static_cast<std::size_t>(at(i))].colour));
    }
  return text + "</svg>";
}

std::string maps(const Sheet& sheet) {
  if (sheet.maps.empty())
    return {};
  std::string text =
      fmt::format("<h2>{}</h2>\n<div class=\"maps\">\n", escapedMarkup(sheet.mapsTitle));
  for (const CellMap& map : sheet.maps)
    text += fmt::format("<figure class=\"map\">{}<figcaption>{}</figcaption></figure>\n",
                        svg(map, sheet.legend), escapedMarkup(map.caption));
  text += "<ul class=\"legend\">\n";
  for (const Swatch& swatch : sheet.legend)
    text += fmt::format("<li><svg viewBox=\"0 0 1 1\"><rect width=\"1\" height=\"1\" fill=\"{}\"/>"
                        "</svg>{}</li>\n",
                        hex(swatch.colour), escapedMarkup(swatch.label));
  return text + "</ul></div>\n";
}

std::string files(const Sheet& sheet) {
  if (sheet.files.empty())
    return {};
  std::string text = fmt::format("<h2>{}</h2>\n<table>\n", escapedMarkup(sheet.filesTitle));
  for (const HashedFile& file : sheet.files)
    text +=
        fmt::format("<tr><td>{} <span class=\"issued\">{}</span><br><code>{}</code></td></tr>\n",
                    escapedMarkup(file.name), escapedMarkup(file.detail), file.sha256);
  return text + "</table>\n";
}

} // namespace

const char* signOf(Mark mark) {
  switch (mark) {
  case Mark::Passed:
    return "\u2713";
  case Mark::Caution:
    return "!";
  case Mark::Failed:
    return "\u2717";
  case Mark::Note:
    break;
  }
  return "\u2022";
}

std::string hex(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

std::string html(const Sheet& sheet) {
  const std::string title = escapedMarkup(sheet.title);
  const SheetColours colours;
  const std::string colour = hex(colours.of(sheet.verdictMark));
  return validText(
      fmt::format("<!DOCTYPE html>\n<html lang=\"{}\"><head><meta charset=\"utf-8\">"
                  "<meta name=\"viewport\" content=\"width=device-width\">"
                  "<title>{}</title>\n<style>{}</style></head><body>\n",
                  escapedMarkup(sheet.language), title, style()) +
      fmt::format("<header><h1>{}</h1><div class=\"issued\">{}</div></header>\n", title,
                  escapedMarkup(sheet.issued)) +
      fmt::format("<div class=\"verdict\" style=\"border-color:{0};background:{1}\">"
                  "<b style=\"color:{0}\">{2}</b>{3}</div>\n",
                  colour, hex(colours.backOf(sheet.verdictMark)), escapedMarkup(sheet.verdict),
                  escapedMarkup(sheet.verdictDetail)) +
      pictures(sheet) + facts(sheet) + checks(sheet) + maps(sheet) + files(sheet) +
      fmt::format("<footer>{}</footer>\n</body></html>\n", escapedMarkup(sheet.footer)));
}

} // namespace voluta::page
