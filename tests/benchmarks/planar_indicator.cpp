// The learned indicator on a planar arm of three joints (Dai 2020, 4.4.3, figs. 4.5 and 4.6):
// planar_indicator [--seed N] [--penalty C] [--first M]. The tip follows a line among three discs.
// Samples of algorithm 7 after each phase, as many random samples on the contact space, and as many
// as give the same number of kernels. Judged on 100,000 other poses of the contact space. Columns:
// samples n, kernels N; of what is free, how much is called free (eq. 4.16); of what is called
// free, how much is (the words beside it); of what collides, how much is called free; of all, how
// much is right.
#include "base/run_context.h"
#include "indicator/contact_samples.h"
#include "indicator/learned_indicator.h"
#include "indicator/planar_arm.h"

#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace voluta;
using indicator::JudgedJoints;
using indicator::LearnedIndicator;
using robot::JointVector;

bool collides(const JointVector& q) {
  for (const test::PlanarArm& arm :
       {test::PlanarArm{{1.0, 0.2}, 0.35}, test::PlanarArm{{-1.2, 0.3}, 0.3},
        test::PlanarArm{{0.1, 1.5}, 0.25}})
    if (arm.collides(q))
      return true;
  return false;
}

std::vector<JudgedJoints> judged(const std::vector<JointVector>& all) {
  std::vector<JudgedJoints> samples;
  for (const JointVector& q : all)
    samples.push_back({q, collides(q)});
  return samples;
}

void row(const char* name, std::size_t n, const LearnedIndicator& learned,
         const std::vector<JudgedJoints>& checks) {
  double free = 0, called = 0, right = 0, hit = 0, missed = 0;
  for (const JudgedJoints& s : checks) {
    const bool says = learned.saysFree(s.q);
    free += !s.collides;
    hit += s.collides;
    called += says;
    right += says && !s.collides;
    missed += says && s.collides;
  }
  std::printf("%-28s n %5zu  N %5zu  TNR %.3f  right %.3f  missed %5.2f %%  all %.3f\n", name, n,
              learned.kernels(), right / free, called > 0 ? right / called : 1.0,
              100.0 * missed / hit, (right + hit - missed) / static_cast<double>(checks.size()));
}

} // namespace

int main(int argc, char** argv) {
  std::uint64_t seed = 1;
  std::size_t first = 100;
  indicator::LearningOptions learning;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string word = argv[i];
    if (word == "--seed")
      seed = std::stoul(argv[i + 1]);
    else if (word == "--first")
      first = std::stoul(argv[i + 1]);
    else if (word == "--penalty")
      learning.penalty = std::stod(argv[i + 1]);
  }
  const auto limits = test::PlanarArm().limits();
  const std::vector<JudgedJoints> checks = judged(test::PlanarArm::onTheLine(100000, 99));
  indicator::ContactSampling sampling;
  sampling.samples = 1698;
  sampling.seed = seed;
  std::size_t samples = 0, kernels = 0;
  for (const int phases : {1, 2, 0}) {
    sampling.phases = phases;
    const auto chosen = indicator::contactSamples(
        test::PlanarArm::onTheLine(first, seed), limits, collides,
        [](const JointVector& q) { return test::PlanarArm::project(q); }, sampling, {});
    const LearnedIndicator learned(chosen, limits, learning);
    row(phases == 1   ? "up-scaled once"
        : phases == 2 ? "and refined once"
                      : "algorithm 7",
        chosen.size(), learned, checks);
    samples = chosen.size();
    kernels = learned.kernels();
  }
  const auto random = [&](std::size_t count) {
    return LearnedIndicator(judged(test::PlanarArm::onTheLine(count, seed + 50)), limits, learning);
  };
  row("as many random samples", samples, random(samples), checks);
  std::size_t count = samples;
  while (count < 64 * samples && random(count).kernels() < kernels)
    count += count / 4;
  row("random, as many kernels", count, random(count), checks);
  return 0;
}
