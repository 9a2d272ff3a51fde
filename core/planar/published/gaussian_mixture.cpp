#include "planar/published/gaussian_mixture.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voluta::planar {

namespace {

constexpr double kMinDeviation = 0.01; // relative to the deviation of all values

double logDensity(const Gaussian& g, double x) {
  const double z = (x - g.mean) / g.deviation;
  return -0.5 * z * z - std::log(g.deviation) - 0.5 * std::log(2.0 * base::kPi);
}

// Returns the logarithm of the sum of share x density; the logarithms of the components in `logs`.
double logSum(const std::vector<Gaussian>& parts, double x, std::vector<double>& logs) {
  logs.resize(parts.size());
  double maximum = -1e300;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    logs[k] = std::log(std::max(1e-300, parts[k].share)) + logDensity(parts[k], x);
    maximum = std::max(maximum, logs[k]);
  }
  double sum = 0.0;
  for (const double l : logs)
    sum += std::exp(l - maximum);
  return maximum + std::log(sum);
}

Gaussian overAll(const std::vector<double>& values, const std::vector<double>& weights) {
  Gaussian all;
  double weight = 0.0, square = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    weight += weights[i];
    all.mean += weights[i] * values[i];
  }
  all.mean /= weight;
  for (std::size_t i = 0; i < values.size(); ++i)
    square += weights[i] * (values[i] - all.mean) * (values[i] - all.mean);
  all.deviation = std::max(1e-9, std::sqrt(square / weight));
  return all;
}

// Returns twice the weighted entropy of the shares of all values.
double twiceEntropy(const GaussianMixture& mixture, const std::vector<double>& values,
                    const std::vector<double>& weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (const double share : mixture.sharesOf(values[i]))
      if (share > 0.0)
        sum -= 2.0 * weights[i] * share * std::log(share);
  return sum;
}

} // namespace

std::vector<double> GaussianMixture::sharesOf(double value) const {
  std::vector<double> logs;
  const double sum = logSum(parts, value, logs);
  for (double& l : logs)
    l = std::exp(l - sum);
  return logs;
}

GaussianMixture fitMixture(const std::vector<double>& values, const std::vector<double>& weights,
                           std::size_t count) {
  base::require(!values.empty() && values.size() == weights.size() && count >= 1,
                "fitMixture: a weight a value, a part at least");
  constexpr int kMaxSteps = 300;
  constexpr double kConverged = 1e-7;
  const Gaussian all = overAll(values, weights);
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  GaussianMixture out;
  double passed = 0.0;
  for (const std::size_t i : order) {
    passed += weights[i];
    const auto k = static_cast<double>(out.parts.size());
    if (out.parts.size() < count && passed >= total * (k + 0.5) / static_cast<double>(count))
      out.parts.push_back({1.0 / static_cast<double>(count), values[i],
                           all.deviation / static_cast<double>(count)});
  }
  while (out.parts.size() < count)
    out.parts.push_back(out.parts.back());
  std::vector<double> logs;
  double last = -1e300;
  for (int step = 0; step < kMaxSteps; ++step) {
    std::vector<double> weight(count, 0.0), sum(count, 0.0), square(count, 0.0);
    out.logLikelihood = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double whole = logSum(out.parts, values[i], logs);
      out.logLikelihood += weights[i] * whole;
      for (std::size_t k = 0; k < count; ++k) {
        const double w = weights[i] * std::exp(logs[k] - whole), d = values[i] - all.mean;
        weight[k] += w;
        sum[k] += w * d;
        square[k] += w * d * d;
      }
    }
    if (out.logLikelihood - last < kConverged * std::abs(out.logLikelihood))
      break;
    last = out.logLikelihood;
    for (std::size_t k = 0; k < count; ++k) {
      Gaussian& g = out.parts[k];
      g.share = weight[k] / total;
      if (weight[k] < 1e-12 * total)
        continue;
      const double mean = sum[k] / weight[k];
      g.mean = all.mean + mean;
      g.deviation = std::max(kMinDeviation * all.deviation,
                             std::sqrt(std::max(0.0, square[k] / weight[k] - mean * mean)));
    }
  }
  std::stable_sort(out.parts.begin(), out.parts.end(),
                   [](const Gaussian& a, const Gaussian& b) { return a.mean < b.mean; });
  return out;
}

GaussianMixture bestMixture(const std::vector<double>& values, const std::vector<double>& weights,
                            std::size_t maxComponents) {
  base::require(maxComponents >= 1, "bestMixture: a part at least");
  GaussianMixture best;
  double minimum = 0.0;
  for (std::size_t k = 1; k <= maxComponents; ++k) {
    GaussianMixture mixture = fitMixture(values, weights, k);
    const double criterion =
        -2.0 * mixture.logLikelihood +
        (3.0 * static_cast<double>(k) - 1.0) * std::log(static_cast<double>(values.size())) +
        twiceEntropy(mixture, values, weights);
    if (k == 1 || criterion < minimum) {
      minimum = criterion;
      best = std::move(mixture);
    }
  }
  return best;
}

} // namespace voluta::planar
