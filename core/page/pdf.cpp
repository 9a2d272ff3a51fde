// Pango sets the text and cairo writes the file: fonts are found and embedded, lines wrap, and no
// window system is needed.
#include "base/error.h"
#include "page/sheet.h"
#include "page/valid_text.h"

#include <algorithm>
#include <cairo-pdf.h>
#include <cstring>
#include <memory>
#include <pango/pangocairo.h>

namespace voluta::page {

namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kWidth = 210.0, kHeight = 297.0, kMargin = 12.0; // [mm], as all lengths below
constexpr double kText = kWidth - 2.0 * kMargin;
constexpr double kBodyPt = 8.0, kSmallPt = 6.8;

template <auto Free> struct Freed {
  template <typename T> void operator()(T* object) const { Free(object); }
};
using Surface = std::unique_ptr<cairo_surface_t, Freed<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Freed<cairo_destroy>>;
using Layout = std::unique_ptr<PangoLayout, Freed<g_object_unref>>;
using Font = std::unique_ptr<PangoFontDescription, Freed<pango_font_description_free>>;

struct TextStyle {
  double sizePt = kBodyPt;
  Colour colour = SheetColours().ink;
  bool bold = false, fixed = false, right = false;
};

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int count) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), count);
  return CAIRO_STATUS_SUCCESS;
}

struct Reading {
  const std::string& bytes;
  std::size_t at = 0;
};
cairo_status_t readOn(void* reading, unsigned char* into, unsigned int count) {
  auto& from = *static_cast<Reading*>(reading);
  if (from.at + count > from.bytes.size())
    return CAIRO_STATUS_READ_ERROR;
  std::memcpy(into, from.bytes.data() + from.at, count);
  from.at += count;
  return CAIRO_STATUS_SUCCESS;
}

class Writer {
public:
  explicit Writer(const Sheet& sheet)
      : sheet_(sheet), surface_(cairo_pdf_surface_create_for_stream(
                           append, &bytes_, kWidth * kPointsPerMm, kHeight * kPointsPerMm)),
        cairo_(cairo_create(surface_.get())) {
    cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_TITLE,
                                   validText(sheet.title).c_str());
    cairo_scale(cairo_.get(), kPointsPerMm, kPointsPerMm);
  }

  std::string write() {
    header();
    verdict();
    pictures();
    facts();
    checks();
    maps();
    files();
    breakBefore(text(sheet_.footer, 0.0, kText, {kSmallPt, colours_.quiet}, false));
    text(sheet_.footer, 0.0, kText, {kSmallPt, colours_.quiet});
    cairo_show_page(cairo_.get());
    cairo_.reset();
    cairo_surface_finish(surface_.get());
    if (const cairo_status_t status = cairo_surface_status(surface_.get());
        status != CAIRO_STATUS_SUCCESS)
      throw base::Error(base::ErrorCode::CannotWrite,
                        base::message("the PDF could not be created: {why}"_text,
                                      std::string(cairo_status_to_string(status))));
    return std::move(bytes_);
  }

private:
  // Returns the height of the text; draws it at y_, `x` from the left margin.
  double text(const std::string& bytes, double x, double width, const TextStyle& style,
              bool draw = true) {
    const std::string words = validText(bytes); // Cairo fails on invalid UTF-8
    cairo_save(cairo_.get());
    cairo_translate(cairo_.get(), kMargin + x, y_);
    // Glyphs are measured in points
    cairo_scale(cairo_.get(), 1.0 / kPointsPerMm, 1.0 / kPointsPerMm);
    const Layout layout(pango_cairo_create_layout(cairo_.get()));
    const Font font(pango_font_description_from_string(style.fixed ? "DejaVu Sans Mono, monospace"
                                                                   : "DejaVu Sans, sans"));
    pango_font_description_set_absolute_size(font.get(), style.sizePt * PANGO_SCALE);
    if (style.bold)
      pango_font_description_set_weight(font.get(), PANGO_WEIGHT_BOLD);
    pango_layout_set_font_description(layout.get(), font.get());
    pango_layout_set_width(layout.get(), static_cast<int>(width * kPointsPerMm * PANGO_SCALE));
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    if (style.right)
      pango_layout_set_alignment(layout.get(), PANGO_ALIGN_RIGHT);
    pango_layout_set_text(layout.get(), words.c_str(), static_cast<int>(words.size()));
    int height = 0;
    pango_layout_get_size(layout.get(), nullptr, &height);
    if (draw) {
      take(style.colour);
      cairo_move_to(cairo_.get(), 0.0, 0.0);
      pango_cairo_show_layout(cairo_.get(), layout.get());
    }
    cairo_restore(cairo_.get());
    return static_cast<double>(height) / PANGO_SCALE / kPointsPerMm;
  }

  void take(Colour c) {
    cairo_set_source_rgb(cairo_.get(), c.red / 255.0, c.green / 255.0, c.blue / 255.0);
  }
  void fill(Colour colour, double x, double y, double width, double height) {
    take(colour);
    cairo_rectangle(cairo_.get(), kMargin + x, y, width, height);
    cairo_fill(cairo_.get());
  }
  void rule() { fill(colours_.rule, 0.0, y_, kText, 0.15); }

  void breakBefore(double height) {
    if (y_ + height <= kHeight - kMargin)
      return;
    cairo_show_page(cairo_.get());
    y_ = kMargin;
  }

  void heading(const std::string& words) {
    y_ += 2.2;
    y_ += text(words, 0.0, kText, {9.0, colours_.ink, true}) + 0.6;
  }

  void header() {
    constexpr double kIssued = 58.0;
    const double left = text(sheet_.title, 0.0, kText - kIssued - 4.0, {13.0, colours_.ink, true});
    const double right = text(sheet_.issued, kText - kIssued, kIssued,
                              {kSmallPt, colours_.quiet, false, false, true});
    y_ += std::max(left, right) + 2.0;
  }

  void verdict() {
    const TextStyle large{11.0, colours_.of(sheet_.verdictMark), true}, small;
    constexpr double kInside = 5.0, kPadding = 1.8;
    const double width = kText - kInside - 2.0;
    const double title = text(sheet_.verdict, kInside, width, large, false);
    const double detail = text(sheet_.verdictDetail, kInside, width, small, false);
    const double height = title + detail + 2.0 * kPadding;
    fill(colours_.backOf(sheet_.verdictMark), 0.0, y_, kText, height);
    fill(colours_.of(sheet_.verdictMark), 0.0, y_, 1.6, height);
    y_ += kPadding;
    text(sheet_.verdict, kInside, width, large);
    y_ += title;
    text(sheet_.verdictDetail, kInside, width, small);
    y_ += detail + kPadding + 2.0;
  }

  void pictures() {
    if (sheet_.pictures.empty())
      return;
    constexpr double kGap = 4.0;
    const auto count = static_cast<double>(sheet_.pictures.size());
    const double width = (kText - kGap * (count - 1.0)) / count;
    double x = 0.0, height = 0.0;
    for (const Picture& picture : sheet_.pictures) {
      const double tall = image(picture.png, x, width);
      y_ += tall;
      height = std::max(height, tall + text(picture.caption, x, width, {kSmallPt, colours_.quiet}));
      y_ -= tall;
      x += width + kGap;
    }
    y_ += height + 1.5;
  }

  // Returns its height.
  double image(const std::string& png, double x, double width) {
    Reading reading{png};
    const Surface picture(cairo_image_surface_create_from_png_stream(readOn, &reading));
    if (cairo_surface_status(picture.get()) != CAIRO_STATUS_SUCCESS)
      throw base::Error(base::ErrorCode::Internal, "a picture of the sheet is not a PNG"_text);
    const double scale = width / cairo_image_surface_get_width(picture.get());
    cairo_save(cairo_.get());
    cairo_translate(cairo_.get(), kMargin + x, y_);
    cairo_scale(cairo_.get(), scale, scale);
    cairo_set_source_surface(cairo_.get(), picture.get(), 0.0, 0.0);
    cairo_paint(cairo_.get());
    cairo_restore(cairo_.get());
    return scale * cairo_image_surface_get_height(picture.get());
  }

  void facts() {
    constexpr double kLabel = 24.0, kGap = 4.0;
    const double column = (kText - kGap) / 2.0;
    double row = 0.0;
    for (std::size_t i = 0; i < sheet_.facts.size(); ++i) {
      const Fact& fact = sheet_.facts[i];
      const double x = i % 2 == 0 ? 0.0 : column + kGap;
      text(fact.label, x, kLabel - 1.0, {kSmallPt, colours_.quiet});
      row = std::max(row, text(fact.value, x + kLabel, column - kLabel, {}));
      if (i % 2 == 1 || i + 1 == sheet_.facts.size()) {
        y_ += row + 0.5;
        row = 0.0;
      }
    }
  }

  void checks() {
    constexpr double kSign = 4.5, kPlace = 60.0;
    if (sheet_.checks.empty())
      return;
    heading(sheet_.checksTitle);
    for (const Check& check : sheet_.checks) {
      const double sentenceWidth = kText - kSign - kPlace - 3.0;
      const double height =
          std::max(text(check.sentence, 0.0, sentenceWidth, {}, false),
                   text(check.place, 0.0, kPlace, {kSmallPt, colours_.quiet}, false));
      breakBefore(height + 1.0);
      rule();
      y_ += 0.6;
      text(signOf(check.mark), 0.0, kSign, {kBodyPt, colours_.of(check.mark), true});
      text(check.sentence, kSign, sentenceWidth, {});
      text(check.place, kText - kPlace, kPlace, {kSmallPt, colours_.quiet});
      y_ += height + 0.4;
    }
  }

  void maps() {
    if (sheet_.maps.empty())
      return;
    constexpr double kTall = 30.0, kWide = 60.0, kGap = 5.0, kLegend = 48.0;
    breakBefore(kTall + 12.0);
    heading(sheet_.mapsTitle);
    double x = 0.0, caption = 0.0;
    for (const CellMap& map : sheet_.maps) {
      const double cell = std::min(kTall / map.height, kWide / map.width);
      drawMap(map, x, y_ + kTall - cell * map.height, cell);
      y_ += kTall + 0.4;
      caption = std::max(caption, text(map.caption, x, kWide, {kSmallPt, colours_.quiet}));
      y_ -= kTall + 0.4;
      x += kWide + kGap;
    }
    const double top = y_;
    for (const Swatch& swatch : sheet_.legend) {
      fill(swatch.colour, kText - kLegend, y_ + 0.2, 2.6, 2.6);
      y_ += text(swatch.label, kText - kLegend + 4.0, kLegend - 4.0, {kSmallPt}) + 0.9;
    }
    y_ = top + kTall + caption + 0.8;
  }

  void drawMap(const CellMap& map, double left, double top, double cell) {
    cairo_save(cairo_.get());
    cairo_set_antialias(cairo_.get(), CAIRO_ANTIALIAS_NONE);
    for (int row = 0; row < map.height; ++row)
      for (int i = 0; i < map.width; ++i) {
        const int swatch = map.swatch[static_cast<std::size_t>(row * map.width + i)];
        if (swatch != CellMap::kNothing)
          fill(sheet_.legend[static_cast<std::size_t>(swatch)].colour, left + cell * i,
               top + cell * row, cell, cell);
      }
    cairo_restore(cairo_.get());
  }

  void files() {
    if (sheet_.files.empty())
      return;
    heading(sheet_.filesTitle);
    for (const HashedFile& file : sheet_.files) {
      const std::string name = file.name + "  (" + file.detail + ")";
      const TextStyle hash{kSmallPt, colours_.quiet, false, true};
      const double height =
          text(name, 0.0, kText, {}, false) + text(file.sha256, 0.0, kText, hash, false);
      breakBefore(height + 1.0);
      rule();
      y_ += 0.5;
      y_ += text(name, 0.0, kText, {});
      y_ += text(file.sha256, 0.0, kText, hash) + 0.4;
    }
    y_ += 1.0;
  }

  const Sheet& sheet_;
  const SheetColours colours_;
  std::string bytes_;
  Surface surface_;
  Context cairo_;
  double y_ = kMargin;
};

} // namespace

std::string pdf(const Sheet& sheet) {
  return Writer(sheet).write();
}

} // namespace voluta::page
