#include "page/valid_text.h"

#include <glib.h>
#include <memory>

namespace voluta::page {

std::string validText(std::string_view bytes) {
  const std::unique_ptr<char, decltype(&g_free)> valid(
      g_utf8_make_valid(bytes.data(), static_cast<gssize>(bytes.size())), &g_free);
  return valid.get();
}

} // namespace voluta::page
