// Compares a learned indicator with the exact check (Dai 2020, 4.5.1 and table 4.1):
// indicator_table [--cell ID] [--layers N] [--samples N] [--checks N] [--penalty C] [--gamma G]
// [--bias B] [--sweep] JOB. For N layers spread over the job's it learns from samples about the
// layer's contact space, against the bodies of the cell and the part as it is when the layer is
// done, and from as many random ones. "bias found": the bias is such that of other samples beside
// contact that collide one in a hundred is called free. --sweep: other gammas and penalties.
// Verified on samples of contact and on such with each joint up to 0.1 rad beside them. Columns:
// TNR of eq. 4.16 (share of the free samples that is called free); share of the samples called free
// that is free (as its text defines it); share of the colliding samples that is called free. Then
// processor time a question: true check, its distances, indicator, its gradient, FCL's check and
// distances; and after how many questions the learning has paid.
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "fcl_cell.h"
#include "indicator/contact_samples.h"
#include "indicator/contact_space.h"
#include "motion/motion_options.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "process/tooling.h"
#include "project/job.h"
#include "replay/replay_scene.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace voluta;
using indicator::JudgedJoints;
using indicator::LearnedIndicator;
using robot::JointVector;

constexpr double kBesideRad = 0.1;
constexpr double kFclPitchMm = 1.0;
constexpr double kMaxMissed = 0.01;

struct Settings {
  indicator::ContactSampling sampling;
  indicator::LearningOptions learning;
  std::size_t checks = 100000;
  int layers = 3;
  bool sweep = false;
};

double processorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// Processor time of one call, s; `ask` returns a number, so that the compiler cannot drop the call.
template <typename Ask> double secondsEach(const std::vector<JointVector>& all, Ask&& ask) {
  double sum = 0.0;
  const double start = processorSeconds();
  for (const JointVector& q : all)
    sum += static_cast<double>(ask(q));
  const double seconds = processorSeconds() - start;
  if (sum == -1.0)
    std::printf(" ");
  return all.empty() ? 0.0 : seconds / static_cast<double>(all.size());
}

std::vector<JudgedJoints> judged(const std::vector<JointVector>& all,
                                 const indicator::TrueCheck& collides,
                                 const base::RunContext& ctx) {
  std::vector<JudgedJoints> samples(all.size());
  base::parallelChunks(ctx, all.size(), 256, [&](std::size_t b, std::size_t e) {
    for (std::size_t i = b; i < e; ++i)
      samples[i] = {all[i], collides(all[i])};
  });
  return samples;
}

std::vector<JointVector> beside(std::vector<JointVector> all, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> step(-kBesideRad, kBesideRad);
  for (JointVector& q : all)
    for (double& joint : q)
      joint += step(engine);
  return all;
}

// `count` of them, half on contact and half beside.
std::vector<JointVector> random(const indicator::ContactSpace& space, std::size_t count,
                                std::uint64_t seed) {
  std::vector<JointVector> all = space.random(count / 2, seed), more = beside(all, seed + 1);
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

struct Counts {
  double free = 0, calledFree = 0, rightlyFree = 0, collides = 0, missed = 0;
};

Counts verify(const LearnedIndicator& learned, const std::vector<JudgedJoints>& samples,
              const base::RunContext& ctx) {
  std::vector<char> says(samples.size());
  base::parallelChunks(ctx, samples.size(), 256, [&](std::size_t b, std::size_t e) {
    for (std::size_t i = b; i < e; ++i)
      says[i] = learned.saysFree(samples[i].q);
  });
  Counts c;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool collides = samples[i].collides, free = says[i] != 0;
    c.free += !collides;
    c.collides += collides;
    c.calledFree += free;
    c.rightlyFree += free && !collides;
    c.missed += free && collides;
  }
  return c;
}

void row(const char* name, std::size_t samples, const LearnedIndicator& learned,
         const std::vector<JudgedJoints>& near, const std::vector<JudgedJoints>& on,
         const base::RunContext& ctx) {
  std::printf("  %-18s n %6zu  N %5zu", name, samples, learned.kernels());
  for (const auto& [where, set] : {std::pair("near", &near), {"contact", &on}}) {
    const Counts c = verify(learned, *set, ctx);
    std::printf("  %s: TNR %.3f  right %.3f  missed %.2f %%", where,
                c.free > 0 ? c.rightlyFree / c.free : 1.0,
                c.calledFree > 0 ? c.rightlyFree / c.calledFree : 1.0,
                c.collides > 0 ? 100.0 * c.missed / c.collides : 0.0);
  }
  std::printf("\n");
}

struct Layer {
  int number;
  std::size_t first, count;
};

std::vector<Layer> layersOf(const plan::ToolPlan& plan) {
  std::map<int, std::pair<std::size_t, std::size_t>> spans;
  for (const plan::ToolPath& p : plan.paths) {
    const auto [at, fresh] = spans.try_emplace(p.layer, p.first, p.first + p.count);
    at->second.first = std::min(at->second.first, p.first);
    at->second.second = std::max(at->second.second, p.first + p.count);
  }
  std::vector<Layer> layers;
  for (const auto& [number, span] : spans)
    layers.push_back({number, span.first, span.second - span.first});
  return layers;
}

void measure(const Layer& layer, const robot::Cell& cell, const collision::CellCollision& bodies,
             const plan::ToolPlan& plan, const collision::GrowingPart& part,
             const collision::GrowingPart& coarse, const Settings& settings,
             const base::RunContext& ctx) {
  const std::size_t before = layer.first + layer.count;
  const collision::Margins margins = motion::MotionOptions().printing;
  const indicator::TrueCheck collides = [&](const JointVector& q) {
    collision::CellCollision::Frames frames;
    cell.framePoses(q, frames);
    return bodies.bodies(frames, margins) || bodies.bodiesAndPart(frames, part, before, margins);
  };
  const indicator::ContactSpace space(cell, plan, layer.first, layer.count);
  const indicator::Projection project = [&](const JointVector& q) { return space.project(q); };

  const std::vector<JointVector> on = space.random(settings.checks, 21);
  if (on.empty()) {
    std::printf("layer %d: out of reach\n", layer.number);
    return;
  }
  const std::vector<JudgedJoints> contact = judged(on, collides, ctx);
  const std::vector<JudgedJoints> near = judged(beside(on, 22), collides, ctx);
  const auto share = [](const std::vector<JudgedJoints>& all) {
    return 100.0 *
           static_cast<double>(
               std::count_if(all.begin(), all.end(), [](const auto& s) { return s.collides; })) /
           static_cast<double>(all.size());
  };
  std::printf("layer %d: %zu waypoints; colliding: near %.1f %%, contact %.1f %%\n", layer.number,
              layer.count, share(near), share(contact));

  double start = processorSeconds();
  const std::vector<JudgedJoints> samples =
      indicator::contactSamples(space.random(settings.sampling.samples / 6, 1), cell.limits(),
                                collides, project, settings.sampling, ctx);
  const double sampling = processorSeconds() - start;
  start = processorSeconds();
  const LearnedIndicator learned(samples, cell.limits(), settings.learning);
  const double training = processorSeconds() - start;
  row("contact samples", samples.size(), learned, near, contact, ctx);
  start = processorSeconds();
  const std::vector<JudgedJoints> heldOut =
      judged(beside(space.random(2 * settings.sampling.samples, 31), 32), collides, ctx);
  const double extra = carefulBias(learned, heldOut, kMaxMissed);
  const double calibrating = processorSeconds() - start;
  row("bias found", samples.size(), learned.withBias(extra), near, contact, ctx);
  std::printf("    bias %.2f, found in %.2f s\n", settings.learning.bias + extra, calibrating);
  if (settings.sweep)
    for (const double gamma : {0.7, 2.0, 6.0})
      for (const double penalty : {1.0, 100.0, 10000.0}) {
        indicator::LearningOptions learning = settings.learning;
        learning.gamma = gamma;
        learning.penalty = penalty;
        const double begin = processorSeconds();
        const LearnedIndicator other(samples, cell.limits(), learning);
        std::printf("    gamma %g, penalty %g, %.2f s\n", gamma, penalty,
                    processorSeconds() - begin);
        row("as asked for", samples.size(), other, near, contact, ctx);
        row("bias found", samples.size(), other.withBias(carefulBias(other, heldOut, kMaxMissed)),
            near, contact, ctx);
      }
  for (const std::size_t count : {samples.size(), 2 * samples.size()}) {
    const std::vector<JudgedJoints> many = judged(random(space, count, 11), collides, ctx);
    const LearnedIndicator other(many, cell.limits(), settings.learning);
    row("random samples", many.size(), other, near, contact, ctx);
    row("bias found", many.size(), other.withBias(carefulBias(other, heldOut, kMaxMissed)), near,
        contact, ctx);
  }

  constexpr std::size_t kTimed = 20000;
  const std::vector<JointVector> asked(
      on.begin(), on.begin() + static_cast<std::ptrdiff_t>(std::min(kTimed, on.size())));
  const std::vector<JointVector> few(
      asked.begin(),
      asked.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(40, asked.size())));
  collision::CellCollision::Frames frames;
  test::FclCell fcl(cell, coarse, before);
  std::vector<JointVector> free;
  for (std::size_t i = 0; i < contact.size() && free.size() < kTimed; ++i)
    if (!contact[i].collides)
      free.push_back(contact[i].q);
  const double check = secondsEach(asked, collides), freeCheck = secondsEach(free, collides);
  const double frame = secondsEach(asked, [&](const JointVector& q) {
    cell.framePoses(q, frames);
    return frames.back().translation().x();
  });
  const double distances = secondsEach(asked, [&](const JointVector& q) {
    cell.framePoses(q, frames);
    return bodies.clearanceToPart(frames, part, before, bodies.clearance(frames, 100.0));
  });
  const double value = secondsEach(asked, [&](const JointVector& q) { return learned.value(q); });
  const double gradient =
      secondsEach(asked, [&](const JointVector& q) { return learned.gradient(q)[0]; });
  const double fclCheck = secondsEach(asked, [&](const JointVector& q) {
    cell.framePoses(q, frames);
    return fcl.collides(frames);
  });
  const double fclDistance = secondsEach(few, [&](const JointVector& q) {
    cell.framePoses(q, frames);
    return fcl.distance(frames);
  });
  std::printf("  us a question: check %.2f (of free ones %.2f, poses alone %.2f)  distances %.2f  "
              "indicator %.2f  "
              "gradient %.2f  FCL %.1f  FCL distances %.1f (part of %zu triangles)\n",
              1e6 * check, 1e6 * freeCheck, 1e6 * frame, 1e6 * distances, 1e6 * value,
              1e6 * gradient, 1e6 * fclCheck, 1e6 * fclDistance, fcl.partTriangles());
  const double saved = freeCheck - value;
  std::printf("  s: sampling %.2f, learning %.2f: as much as %.0f true checks", sampling, training,
              (sampling + training) / check);
  if (saved > 0.0)
    std::printf("; pays after %.0f questions that are free", (sampling + training) / saved);
  std::printf("\n");
}

} // namespace

int main(int argc, char** argv) {
  std::string cellId, file;
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool more = i + 1 < argc;
    if (word == "--cell" && more)
      cellId = argv[++i];
    else if (word == "--layers" && more)
      settings.layers = std::stoi(argv[++i]);
    else if (word == "--samples" && more)
      settings.sampling.samples = std::stoul(argv[++i]);
    else if (word == "--checks" && more)
      settings.checks = std::stoul(argv[++i]);
    else if (word == "--penalty" && more)
      settings.learning.penalty = std::stod(argv[++i]);
    else if (word == "--gamma" && more)
      settings.learning.gamma = std::stod(argv[++i]);
    else if (word == "--bias" && more)
      settings.learning.bias = std::stod(argv[++i]);
    else if (word == "--sweep")
      settings.sweep = true;
    else
      file = word;
  }
  test::usesSourceTreeResources();
  const project::Job job = project::readJob(file, pipeline::allParameters());
  const process::Process process = process::loadProcess(job.choices.tool().process);
  const robot::Cell cell =
      robot::loadCell(cellId.empty() ? job.choices.cell : cellId, process, job.item().platform);
  const plan::ToolPlan& plan = *job.toolPlan;
  const base::RunContext ctx(base::CancelToken(), 2);
  const collision::GrowingPart part(plan, collision::growingPitch(plan, process::Tooling(process)),
                                    ctx);
  const collision::GrowingPart coarse(plan, kFclPitchMm, ctx);
  const collision::CellCollision bodies(cell, process);
  const std::vector<Layer> layers = layersOf(plan);
  std::printf("%s: %zu layers, %zu waypoints; gamma %g, penalty %g, bias %g\n", cell.id().c_str(),
              layers.size(), plan.waypointCount(), settings.learning.gamma,
              settings.learning.penalty, settings.learning.bias);
  for (int k = 0; k < settings.layers; ++k)
    measure(layers[layers.size() * static_cast<std::size_t>(2 * k + 1) /
                   static_cast<std::size_t>(2 * settings.layers)],
            cell, bodies, plan, part, coarse, settings, ctx);
  return 0;
}
