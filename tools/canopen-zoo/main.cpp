#include <exception>
#include <fstream>
#include <iostream>

#include "can/port/interface.hpp"
#include "tools/canopen-zoo/options.hpp"
#include "tools/canopen-zoo/residents.hpp"
#include "tools/canopen-zoo/serve.hpp"

namespace {

/// Writes @p text to the file @p path, or standard output for "-". Throws zoo::UsageError if that cannot be done.
void write(const std::string& path, const std::string& text) {
  std::ofstream file;
  if (path != "-") file.open(path, std::ios::binary);
  std::ostream& out = path == "-" ? std::cout : file;
  out << text << std::flush;
  if (!out) throw zoo::UsageError{(path == "-" ? "standard output" : path) + ": cannot be written"};
}

void run(const zoo::Options& options) {
  if (options.list) return write("-", zoo::list_of_residents(*options.list));
  if (!options.eds.empty()) write(options.eds, zoo::eds_of(options.slave));
  if (options.interface) zoo::serve(options.slave, *options.interface, options.node_id);
}

int complain(const std::exception& error, int status) {
  std::cerr << "canopen-zoo: " << error.what() << '\n';
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::optional<zoo::Options> options = zoo::parse_command_line(argc, argv);
    if (options) run(*options);
    return zoo::kDone;
  } catch (const zoo::UsageError& error) {
    return complain(error, zoo::kUsage);
  } catch (const std::exception& error) {
    return complain(error, zoo::kFailed);
  }
}
