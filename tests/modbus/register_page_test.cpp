// The table of registers in docs/reference/modbus.md against the one that is served.
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "modbus/register_map.hpp"

namespace modbus {
namespace {

std::string registers_of(const RegisterRow& row) {
  return row.first == row.last ? std::to_string(row.first) : fmt::format("{} to {}", row.first, row.last);
}

std::string parameter_of(const RegisterRow& row) {
  if (row.parameter == 0) return "";
  const bool is_received = row.content == Content::ReceivedWord;
  const char letter = row.is_writable() && !is_received ? 'p' : 'r';
  const std::string text = fmt::format("{}{:04}", letter, row.parameter);
  return row.first == row.last ? text : fmt::format("{}[0..{}]", text, row.last - row.first);
}

std::string scale_of(const Scale& scale) {
  const std::string text =
      scale.divisor == 1 ? std::to_string(scale.multiplier) : fmt::format("1/{}", scale.divisor);
  return scale.is_signed ? text + ", signed" : text;
}

std::string table() {
  std::string text = "| register | holds | parameter | access | factor |\n|---|---|---|---|---|\n";
  for (const RegisterRow& row : register_map())
    text += fmt::format("| {} | {} | {} | {} | {} |\n", registers_of(row), row.what, parameter_of(row),
                        row.is_writable() ? "rw" : "r", scale_of(row.scale));
  return text;
}

TEST(PageOfRegisters, HasEveryRegisterThatIsServed) {
  std::ifstream file{MODBUS_PAGE};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  EXPECT_NE(page.find("\n" + table() + "\n"), std::string::npos) << "docs/reference/modbus.md has to have:\n"
                                                                 << table();
}

}  // namespace
}  // namespace modbus
