// The result of a job as a value: everything a stage can end with (docs/design.md, Errors).
#pragma once

#include "base/error.h"

#include <exception>
#include <new>
#include <type_traits>
#include <utility>
#include <variant>

namespace voluta::base {

template <typename T> using Outcome = std::variant<T, Error, Cancelled>;

// Runs `f` and returns its value, the Error it threw (any other exception becomes one of code
// Internal) or Cancelled. Never throws.
template <typename F> auto outcomeOf(F&& f) noexcept -> Outcome<std::invoke_result_t<F>> {
  try {
    return std::forward<F>(f)();
  } catch (const Cancelled&) {
    return Cancelled{};
  } catch (const Error& e) {
    return e;
  } catch (const std::bad_alloc&) {
    return Error(ErrorCode::Internal, "out of memory"_text, {},
                 "try a larger `voxelMm` or a smaller part"_text);
  } catch (const std::exception& e) {
    return Error(ErrorCode::Internal, message("{what}"_text, std::string(e.what())));
  } catch (...) {
    return Error(ErrorCode::Internal, "unknown failure"_text);
  }
}

} // namespace voluta::base
