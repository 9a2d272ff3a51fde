// Numbers as a mixture of normal distributions.
#pragma once

#include <cstddef>
#include <vector>

namespace voluta::planar {

struct Gaussian {
  double share = 1.0; // of the whole, sums up to 1
  double mean = 0.0, deviation = 1.0;
};

struct GaussianMixture {
  std::vector<Gaussian> parts; // by mean
  double logLikelihood = 0.0;  // of all values

  // Share of each part in a value, sums up to 1.
  std::vector<double> sharesOf(double value) const;
};

// Expectation maximisation from quantiles: the same for the same input. `weights` sum up to the
// number of values. Deviations stay above 1 % of the spread of all. Preconditions
// (Error{Internal}): as many weights as values, count >= 1, values not empty.
GaussianMixture fitMixture(const std::vector<double>& values, const std::vector<double>& weights,
                           std::size_t count);

// The mixture of 1 to `most` parts with the least integrated completed likelihood (Biernacki,
// Celeux, Govaert, Assessing a mixture model for clustering with the integrated completed
// likelihood, 2000): the Bayesian information criterion, -2 log L + (3 k - 1) log n, plus twice the
// entropy of the values' shares. BIC alone asks for as many parts as approximate the distribution;
// this for as many as are apart.
GaussianMixture bestMixture(const std::vector<double>& values, const std::vector<double>& weights,
                            std::size_t most);

} // namespace voluta::planar
