// The learned indicator on a planar arm of three joints (Dai 2020, 4.4.3, figs. 4.5 and 4.6):
// planar_indicator [--seed N] [--penalty C] [--gamma G] [--first M]. The tip follows a line among
// three discs. Samples of algorithm 7 after each phase, as many random samples on the contact space
// and in the whole joint space, and as many as give the same number of kernels. Judged on 100,000
// other poses of the contact space, for a bias of 1 (the source's) and of 0. Columns: samples n,
// kernels N; TNR: share of free poses that are called free (eq. 4.16); right: share of poses called
// free that are free (the words beside the equation); missed: share of colliding poses that are
// called free; all: share of poses that are judged correctly.
#include "base/run_context.h"
#include "indicator/contact_samples.h"
#include "indicator/learned_indicator.h"
#include "indicator/planar_arm.h"

#include <cstdio>
#include <random>
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

void rows(const char* name, std::size_t n, const LearnedIndicator& learned, double bias,
          const std::vector<JudgedJoints>& checks) {
  row(name, n, learned, checks);
  row("  bias 0", n, learned.withBias(-bias), checks);
}

std::vector<JointVector> inJointSpace(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> angle(-base::kPi, base::kPi);
  std::vector<JointVector> all;
  while (all.size() < count)
    all.push_back(Eigen::Vector3d(angle(engine), angle(engine), angle(engine)));
  return all;
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
    else if (word == "--gamma")
      learning.gamma = std::stod(argv[i + 1]);
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
    rows(phases == 1   ? "up-scaled once"
         : phases == 2 ? "and refined once"
                       : "algorithm 7",
         chosen.size(), learned, learning.bias, checks);
    samples = chosen.size();
    kernels = learned.kernels();
  }
  using Draw = std::vector<JointVector> (*)(std::size_t, std::uint64_t);
  for (const auto& [where, draw] :
       {std::pair<std::string, Draw>("contact", test::PlanarArm::onTheLine),
        {"joint space", inJointSpace}}) {
    const auto random = [&](std::size_t count) {
      return LearnedIndicator(judged(draw(count, seed + 50)), limits, learning);
    };
    rows((where + ", as many samples").c_str(), samples, random(samples), learning.bias, checks);
    std::size_t count = samples;
    while (count < 64 * samples && random(count).kernels() < kernels)
      count += count / 4;
    rows((where + ", as many kernels").c_str(), count, random(count), learning.bias, checks);
  }
  return 0;
}
