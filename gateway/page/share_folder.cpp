#include "gateway/page/share_folder.hpp"

#include <system_error>

#include "os/own_program.hpp"

namespace gateway {

std::filesystem::path share_folder() {
  std::error_code error;
  for (const char* const beside : {"../share/axisd", "../../share/axisd"})  // the second one of a test program
    if (auto folder = (os::program_folder() / beside).lexically_normal();
        std::filesystem::is_directory(folder, error))
      return folder;
  return {};
}

}  // namespace gateway
