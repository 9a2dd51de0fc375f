#pragma once

#include <filesystem>

namespace os {

/// Folder of the program that runs, whatever it was called by; empty if the kernel does not say.
[[nodiscard]] std::filesystem::path program_folder();

}  // namespace os
