#pragma once

#include <filesystem>

namespace gateway {

/// What was installed beside the program: PREFIX/share/axisd of PREFIX/bin/axisd-http. Empty if there is none.
[[nodiscard]] std::filesystem::path share_folder();

}  // namespace gateway
