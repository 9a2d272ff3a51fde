// Meshes to try that are not part of the project: tests that use them skip where they are absent.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>

namespace voluta::test {

// VOLUTA_MODELS, or ../shared/models beside the checkout.
inline std::filesystem::path modelFolder() {
  if (const char* folder = std::getenv("VOLUTA_MODELS"))
    return folder;
  return std::filesystem::path(VOLUTA_SOURCE_DIR).parent_path() / "shared" / "models";
}

} // namespace voluta::test

// Declares `variable` as the path of a model, or skips the test.
#define VOLUTA_MODEL_OR_SKIP(variable, name)                                                       \
  const std::filesystem::path variable = voluta::test::modelFolder() / (name);                     \
  if (!std::filesystem::exists(variable))                                                          \
  GTEST_SKIP() << "model not here: " << (name) << " (set VOLUTA_MODELS)"
