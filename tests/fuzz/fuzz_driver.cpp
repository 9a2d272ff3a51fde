// Drives a fuzz target where there is no libFuzzer. Inputs are damaged seeds, the same on every
// run; each batch runs in a process of its own, so that a fatal input is kept and named.
//   fuzz_NAME            VOLUTA_FUZZ_RUNS inputs (5000), or VOLUTA_FUZZ_SECONDS long
//   fuzz_NAME FILE...    those inputs only, in this process: under a debugger
// Inputs that fail are left beside it as fuzz_NAME.NUMBER.
#include "fuzz_target.h"
#include "mutation.h"

#include "base/files.h"
#include "base/stopwatch.h"
#include "helpers/temporary_folder.h"

#include <atomic>
#include <csignal>
#include <limits>
#include <new>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace voluta;

constexpr std::uint64_t kBatch = 500;
constexpr int kMaxFailures = 10;
constexpr unsigned kPatienceS = 60; // for one input

std::uint64_t fromEnvironment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

void run(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

// The seeds themselves come first.
std::string inputOf(const std::vector<std::string>& seeds, std::uint64_t number) {
  return number < seeds.size() ? seeds[number] : fuzz::mutated(seeds, number);
}

// A number that this process and its children see.
class SharedNumber {
public:
  SharedNumber()
      : memory_(::mmap(nullptr, sizeof(std::atomic<std::uint64_t>), PROT_READ | PROT_WRITE,
                       MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    base::require(memory_ != MAP_FAILED, "memory to share with a child");
    value_ = new (memory_) std::atomic<std::uint64_t>(0);
  }
  ~SharedNumber() { ::munmap(memory_, sizeof(std::atomic<std::uint64_t>)); }
  SharedNumber(const SharedNumber&) = delete;
  SharedNumber& operator=(const SharedNumber&) = delete;
  std::atomic<std::uint64_t>& value() const { return *value_; }

private:
  void* memory_;
  std::atomic<std::uint64_t>* value_;
};

// Did the child come through all of [first, last)? Where not, `current` is the one that ended it.
bool runBatch(const std::vector<std::string>& seeds, std::uint64_t first, std::uint64_t last,
              std::atomic<std::uint64_t>& current) {
  const pid_t child = ::fork();
  base::require(child >= 0, "a process for the batch");
  if (child == 0) {
    // A wait for a lock counts as hanging too.
    std::signal(SIGALRM, SIG_DFL);
    const rlimit noDumps{0, 0};
    ::setrlimit(RLIMIT_CORE, &noDumps);
    for (std::uint64_t i = first; i < last; ++i) {
      current = i;
      ::alarm(kPatienceS);
      run(inputOf(seeds, i));
    }
    std::exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
    return true;
  std::fprintf(stderr, "input %llu: %s\n", static_cast<unsigned long long>(current.load()),
               WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM ? "does not come to an end"
                                                                  : "ended the program");
  return false;
}

} // namespace

int main(int argc, char** argv) {
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
    files.push_back(base::readFile(argv[i]));
  const std::string name = std::filesystem::absolute(argv[0]).filename().string();
  const auto here = std::filesystem::current_path();
  // Targets may write files where they run.
  const test::TemporaryFolder folder;
  std::filesystem::current_path(folder.path());
  if (!files.empty()) {
    for (const std::string& file : files)
      run(file);
    std::filesystem::current_path(here);
    return 0;
  }

  const std::vector<std::string> seeds = fuzz::seeds();
  const double seconds = static_cast<double>(fromEnvironment("VOLUTA_FUZZ_SECONDS", 0));
  const std::uint64_t begin = fromEnvironment("VOLUTA_FUZZ_FIRST", 0);
  const std::uint64_t end = seconds > 0.0 ? std::numeric_limits<std::uint64_t>::max()
                                          : begin + fromEnvironment("VOLUTA_FUZZ_RUNS", 5000);
  const SharedNumber current;
  const base::Stopwatch watch;
  int failures = 0;
  std::uint64_t next = begin;
  while (next < end && failures < kMaxFailures && !(seconds > 0.0 && watch.seconds() > seconds)) {
    const std::uint64_t last = end - next < kBatch ? end : next + kBatch;
    if (runBatch(seeds, next, last, current.value())) {
      next = last;
      continue;
    }
    ++failures;
    const std::uint64_t bad = current.value();
    base::writeFile(here / (name + "." + std::to_string(bad)), inputOf(seeds, bad));
    next = bad + 1;
  }
  std::filesystem::current_path(here);
  std::printf("%s: %llu inputs, %d failures\n", name.c_str(),
              static_cast<unsigned long long>(next - begin), failures);
  return failures == 0 ? 0 : 1;
}
