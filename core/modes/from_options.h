// A function of a mode that sees the user's choices only through typed options. Its cache key is
// made from the same options and therefore covers everything its result depends on.
#pragma once

#include "base/key_text.h"

#include <functional>
#include <string>
#include <utility>

namespace voluta::base {
class ParameterValues;
}
namespace voluta::process {
struct Process;
}
namespace voluta::project {
struct Choices;
}

namespace voluta::modes {

struct ModeChoices {
  const project::Choices& choices;
  const base::ParameterValues& values;
  const process::Process& process;
};

template <typename Signature> class FromOptions;

template <typename Out, typename... In> class FromOptions<Out(In...)> {
public:
  FromOptions() = default; // empty
  template <typename Options>
  FromOptions(Options (*options)(const ModeChoices&), Out (*make)(const Options&, In...))
      : key_([options](const ModeChoices& in) { return base::keyText(options(in)); }),
        make_([options, make](const ModeChoices& in, In... input) {
          return make(options(in), std::forward<In>(input)...);
        }) {}

  explicit operator bool() const { return static_cast<bool>(make_); }
  // Returns the cache key; an empty string if this is empty. Throws as the conversion to Options
  // does.
  std::string key(const ModeChoices& in) const { return key_ ? key_(in) : std::string(); }
  // Precondition: not empty.
  Out operator()(const ModeChoices& in, In... input) const {
    return make_(in, std::forward<In>(input)...);
  }

private:
  std::function<std::string(const ModeChoices&)> key_;
  std::function<Out(const ModeChoices&, In...)> make_;
};

} // namespace voluta::modes
