#include "os/own_program.hpp"

#include <system_error>

namespace os {

std::filesystem::path program_folder() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

}  // namespace os
