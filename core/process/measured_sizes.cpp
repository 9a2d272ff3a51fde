#include "process/measured_sizes.h"

#include "base/error.h"
#include "process/process_numbers.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace voluta::process {

namespace {

struct KindRow {
  std::string_view word;
  SizeKind kind;
  bool hasAxis;
};
constexpr std::array kKinds{KindRow{"length", SizeKind::Length, true},
                            KindRow{"slot", SizeKind::Slot, true},
                            KindRow{"hole", SizeKind::Hole, false}};

[[noreturn]] void refuse(const base::Message& why, const base::Value& place) {
  throw base::Error(base::ErrorCode::UnusableInput, why, place,
                    "give rows such as: length x 50 49.8; slot y 5 4.8; hole 10 9.6"_text);
}

std::vector<std::string_view> wordsOf(std::string_view line) {
  constexpr std::string_view kBetween = ",; \t\r";
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(kBetween), line.size()));
    if (line.empty())
      return words;
    words.push_back(line.substr(0, line.find_first_of(kBetween)));
    line.remove_prefix(words.back().size());
  }
}

double sizeOf(std::string_view word, const base::Message& place) {
  double value = 0.0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (status != std::errc{} || end != word.data() + word.size() || !std::isfinite(value) ||
      value <= 0.0)
    refuse(base::message("'{word}' is not a size"_text, word), place);
  return value;
}

MeasuredSize sizeOfRow(const std::vector<std::string_view>& words, const base::Message& place) {
  const auto row = std::ranges::find(kKinds, words.front(), &KindRow::word);
  if (row == kKinds.end())
    refuse(base::message("'{word}' is not a kind of size"_text, words.front()), place);
  const std::size_t first = row->hasAxis ? 2 : 1;
  if (words.size() != first + 2 || (row->hasAxis && words[1] != "x" && words[1] != "y"))
    refuse("not a kind, an axis and two sizes"_text, place);
  MeasuredSize size{row->kind, row->hasAxis ? words[1].front() : 'x', sizeOf(words[first], place),
                    sizeOf(words[first + 1], place)};
  constexpr double kMaxShare = 0.2, kMaxMm = 2.0;
  const double error = std::abs(size.measuredMm - size.nominalMm);
  if (error > kMaxMm && error > kMaxShare * size.nominalMm)
    refuse(base::message("{measured} is too far from {nominal}"_text, base::mm(size.measuredMm),
                         base::mm(size.nominalMm)),
           place);
  return size;
}

// Lengths in which factors are fitted, so that all unknowns are millimetres.
constexpr double kFactorMm = 100.0;

enum Unknown { FactorX, FactorY, Outline, Holes, Unknowns };

struct Equation {
  std::array<double, Unknowns> row{};
  double errorMm = 0.0; // measured size less the planned one
};

// measured = factor * planned + 2 * excess of outlines, or - 2 * excess in holes.
Equation equationOf(const MeasuredSize& size, const Process& printed) {
  const double scale = size.kind == SizeKind::Hole ? 0.5 * (printed.scaleX + printed.scaleY)
                       : size.axis == 'x'          ? printed.scaleX
                                                   : printed.scaleY;
  const bool isOuter = size.kind == SizeKind::Length;
  const double planned =
      scale * size.nominalMm + 2.0 * (isOuter ? printed.outlineOffsetMm : printed.holeOffsetMm);
  Equation e;
  const double share = planned / kFactorMm;
  if (size.kind == SizeKind::Hole)
    e.row[FactorX] = e.row[FactorY] = 0.5 * share;
  else
    e.row[size.axis == 'x' ? FactorX : FactorY] = share;
  e.row[isOuter ? Outline : Holes] = isOuter ? 2.0 : -2.0;
  e.errorMm = size.measuredMm - planned;
  return e;
}

struct Likeliest {
  Eigen::Vector4d values, deviations; // of the unknowns [mm]
};

// Returns the unknowns of a machine whose errors are of the size that Castelli 5.1.1 measured (up
// to 0.8 mm in 360, 0.25 mm in 20 and 0.4 mm in a hole of 10), from sizes read on a calliper: so
// that a doubtful hundredth on a small part does not become a factor of percents.
Likeliest likeliest(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& errors) {
  constexpr double kFactorErrorMm = kUnknownFactor * kFactorMm, kOffsetErrorMm = 0.15,
                   kReadingErrorMm = 0.01;
  Eigen::Vector4d expected;
  expected << kFactorErrorMm, kFactorErrorMm, kOffsetErrorMm, kOffsetErrorMm;
  const Eigen::Matrix4d prior = (kReadingErrorMm / expected.array()).square().matrix().asDiagonal();
  const Eigen::Matrix4d normal = matrix.transpose() * matrix + prior;
  const Eigen::LDLT<Eigen::Matrix4d> solver = normal.ldlt();
  const Eigen::Matrix4d inverse = solver.solve(Eigen::Matrix4d::Identity());
  return {solver.solve(matrix.transpose() * errors),
          kReadingErrorMm * inverse.diagonal().cwiseSqrt()};
}

// Returns a correction as a file states it: more digits mean nothing.
double rounded(double value, double digits) {
  return std::round(value * digits) / digits;
}

void checkRanges(const Process& process) {
  for (const ProcessNumber& row : processNumbers())
    if (row.omitDefault && (process.*row.value < row.minimum || process.*row.value > row.maximum))
      throw base::Error(base::ErrorCode::UnusableInput,
                        base::message("{key} would be {value}, beyond {least} to {most}"_text,
                                      row.key, base::number(process.*row.value),
                                      base::number(row.minimum), base::number(row.maximum)),
                        {}, "check the measured sizes"_text);
}

} // namespace

std::vector<MeasuredSize> readMeasuredSizes(std::string_view text, std::string_view source) {
  std::vector<MeasuredSize> sizes;
  for (long long line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::vector<std::string_view> words = wordsOf(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!words.empty())
      sizes.push_back(sizeOfRow(words, base::lineOf(source, line)));
  }
  if (sizes.empty())
    refuse("no measured sizes"_text, std::string(source));
  return sizes;
}

SizeFit fitSizes(std::span<const MeasuredSize> sizes, const Process& printed) {
  base::require(!sizes.empty(), "fitSizes: measured sizes");
  const auto count = static_cast<Eigen::Index>(sizes.size());
  Eigen::MatrixXd matrix(count, static_cast<int>(Unknowns));
  Eigen::VectorXd errors(count);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const Equation e = equationOf(sizes[i], printed);
    for (int k = 0; k < Unknowns; ++k)
      matrix(static_cast<Eigen::Index>(i), k) = e.row[static_cast<std::size_t>(k)];
    errors[static_cast<Eigen::Index>(i)] = e.errorMm;
  }
  const Likeliest likely = likeliest(matrix, errors);
  const Eigen::Vector4d& found = likely.values;
  const double factorX = 1.0 + found[FactorX] / kFactorMm,
               factorY = 1.0 + found[FactorY] / kFactorMm, factor = 0.5 * (factorX + factorY);
  constexpr double kFactorDigits = 1e6, kMmDigits = 1e4;
  SizeFit fit{printed, (matrix * found - errors).cwiseAbs().maxCoeff(),
              likely.deviations[FactorX] / kFactorMm, likely.deviations[FactorY] / kFactorMm};
  fit.process.scaleX = rounded(1.0 / factorX, kFactorDigits);
  fit.process.scaleY = rounded(1.0 / factorY, kFactorDigits);
  fit.process.outlineOffsetMm = rounded(-found[Outline] / factor, kMmDigits);
  fit.process.holeOffsetMm = rounded(found[Holes] / factor, kMmDigits);
  checkRanges(fit.process);
  return fit;
}

} // namespace voluta::process
