#include "program/read_hash.h"

#include <Eigen/Geometry>
#include <bit>
#include <string_view>
#include <vector>

namespace voluta::program {

namespace {

// Mixes whole words, as programs have a million motions.
class WordHash {
public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15U;
    value_ ^= value_ >> 29U;
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text)
      add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  void add(const std::vector<double>& values) {
    add(static_cast<std::uint64_t>(values.size()));
    for (const double value : values)
      add(value);
  }
  void add(const Eigen::Vector3d& p) {
    for (const double value : p)
      add(value);
  }
  void add(const Eigen::Isometry3d& pose) {
    for (const double value : pose.matrix().reshaped())
      add(value);
  }
  template <typename T> void addInteger(T value) { add(static_cast<std::uint64_t>(value)); }
  template <typename... T> void addAll(const T&... values) { (add(values), ...); }
  template <typename... T> void addIntegers(T... values) { (addInteger(values), ...); }

  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

void addMotion(WordHash& hash, const plan::ProgramMotion& m) {
  hash.addIntegers(m.file, m.line, m.target, m.elbow, m.jointInterpolated, m.detour, m.extruding,
                   m.trailing, m.tool, m.viaPoints.size());
  hash.addAll(m.joints, m.externals, m.frame_T_tcp, m.position, m.direction, m.speedMmPerS,
              m.jointSpeedRadPerS, m.durationS, m.accelerationMmPerS2, m.jointAccelerationRadPerS2,
              m.blendMm, m.flowMm3PerS, m.volumeMm3);
  for (const plan::NozzlePoint& via : m.viaPoints)
    hash.addAll(via.position, via.direction);
}
} // namespace

std::uint64_t readHash(const plan::ReadProgram& program) {
  WordHash hash;
  hash.add(std::string_view(program.format));
  hash.add(program.flange_T_tcp);
  if (program.base_T_nozzle)
    hash.add(*program.base_T_nozzle);
  hash.addIntegers(program.motions.size(), program.pauses.size(), program.facts.size(),
                   program.postures.size(), program.approaches.size(), program.defects.size(),
                   program.complete);
  for (const plan::ProgramMotion& motion : program.motions)
    addMotion(hash, motion);
  for (const plan::ProgramPause& p : program.pauses) {
    hash.addIntegers(p.file, p.line, p.before, p.tool, p.cuts);
    hash.addAll(p.durationS, p.volumeMm3, p.drawnMm);
  }
  for (const plan::ProgramApproach& a : program.approaches) {
    hash.addIntegers(a.file, a.line, a.heightMm.has_value());
    hash.addAll(a.heightMm.value_or(0.0), a.mmPerS, a.radPerS);
  }
  if (program.load)
    hash.addAll(program.load->kg, program.load->centreMm.value_or(Eigen::Vector3d::Zero().eval()));
  for (const plan::StatedFact& f : program.facts) {
    hash.addIntegers(f.kind, f.file, f.line, f.before, f.beforePause, f.tool);
    hash.addAll(f.number, std::string_view(f.word));
  }
  for (const plan::StatedPosture& p : program.postures)
    hash.addIntegers(p.motion, p.posture.structure, p.posture.turns);
  for (const plan::ProgramDefect& d : program.defects)
    hash.addIntegers(d.file, d.line);
  return hash.value();
}

} // namespace voluta::program
