#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "control/writer/writers.hpp"

namespace {

constexpr const char* kUsage =
    "usage: compile_protocol [--table FILE] [--schema FILE] [--page FILE] [--update PAGE] PROTOCOL...\n";

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file{path, std::ios::binary};
  if (!(file << text).flush()) throw std::runtime_error{path + ": cannot be written"};
}

void write_table(const control::ProtocolText& text, const std::string& path) {
  write_file(path, control::write_table(text));
}

void write_schema(const control::ProtocolText& text, const std::string& path) {
  write_file(path, control::write_schema(text));
}

void write_page(const control::ProtocolText& text, const std::string& path) {
  write_file(path, control::write_page(text));
}

/// Puts what is made from the protocol into the page at @p path.
void update_page(const control::ProtocolText& text, const std::string& path) {
  std::ifstream file{path};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  write_file(path, control::with_part(page, control::write_page(text)));
}

/// What an option asks for, in the order of the command line.
struct Step {
  std::string_view option;
  void (*run)(const control::ProtocolText&, const std::string& path);
};
constexpr std::array kSteps{Step{"--table", write_table}, Step{"--schema", write_schema},
                            Step{"--page", write_page}, Step{"--update", update_page}};

}  // namespace

int main(int count, char** words) try {
  struct Order {
    const Step* step;
    std::string path;
  };
  std::vector<Order> orders;
  int next = 1;
  for (; next + 1 < count; next += 2) {
    const Step* found = nullptr;
    for (const Step& step : kSteps)
      if (step.option == words[next]) found = &step;
    if (found == nullptr) break;
    orders.push_back({found, words[next + 1]});
  }
  const std::vector<std::string> files{words + next, words + count};
  if (orders.empty() || files.empty()) return std::fputs(kUsage, stderr), 2;
  const control::ProtocolText text = control::read_protocol(files);
  for (const Order& order : orders) order.step->run(text, order.path);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "compile_protocol: %s\n", error.what());
  return 1;
}
