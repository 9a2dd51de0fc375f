#pragma once

#include <string>

namespace profidrive {

/// The page docs/reference/telegrams.md: every telegram and every word, as the tables have them.
std::string telegram_reference();

}  // namespace profidrive
