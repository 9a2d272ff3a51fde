// Gaussian mixture models of scalar values.
#pragma once

#include <cstddef>
#include <vector>

namespace voluta::planar {

struct Gaussian {
  double share = 1.0; // weight of the component; the sum is 1
  double mean = 0.0, deviation = 1.0;
};

struct GaussianMixture {
  std::vector<Gaussian> parts; // sorted by mean
  double logLikelihood = 0.0;  // of all values

  // Returns the share of each component in a value; the sum is 1.
  std::vector<double> sharesOf(double value) const;
};

// Fits a mixture by expectation maximisation, starting from quantiles; deterministic. `weights` sum
// up to the number of values. Standard deviations stay above 1 % of that of all values.
// Preconditions (Error{Internal}): as many weights as values, count >= 1, values not empty.
GaussianMixture fitMixture(const std::vector<double>& values, const std::vector<double>& weights,
                           std::size_t count);

// Returns the mixture of 1 to `maxComponents` components with the minimum integrated completed
// likelihood (Biernacki, Celeux, Govaert, Assessing a mixture model for clustering with the
// integrated completed likelihood, 2000): the Bayesian information criterion, -2 log L + (3 k - 1)
// log n, plus twice the entropy of the values' shares. BIC alone selects as many components as
// approximate the distribution; this criterion selects as many as are distinct.
GaussianMixture bestMixture(const std::vector<double>& values, const std::vector<double>& weights,
                            std::size_t maxComponents);

} // namespace voluta::planar
