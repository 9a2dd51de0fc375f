// Prints docs/reference/parameters.md.
#include <cstdio>
#include <string>

#include "drive/reference/parameter_reference.hpp"

int main() {
  const std::string page = drive::parameter_reference();
  const bool written = std::fwrite(page.data(), 1, page.size(), stdout) == page.size() && std::fflush(stdout) == 0;
  return written ? 0 : 1;
}
