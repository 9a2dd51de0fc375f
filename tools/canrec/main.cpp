#include <exception>
#include <iostream>
#include <string_view>

#include "tools/canrec/command_line.hpp"

namespace {

using canrec::Status;

int complain(std::string_view text, Status status) {
  std::cerr << "canrec: " << text << '\n';
  return static_cast<int>(status);
}

int run(const canrec::Invocation& invocation) {
  if (invocation.run)
    if (const auto done = invocation.run(invocation.server); !done)
      return complain(done.error().text, done.error().status);
  std::cout.flush();
  return std::cout ? static_cast<int>(Status::Done)
                   : complain("standard output: cannot be written", Status::Failed);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(canrec::parse_command_line(argc, argv));
  } catch (const canrec::UsageError& error) {
    return complain(error.what(), Status::Usage);
  } catch (const std::exception& error) {
    return complain(error.what(), Status::Failed);
  }
}
