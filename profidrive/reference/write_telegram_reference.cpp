// Prints docs/reference/telegrams.md.
#include <fmt/format.h>

#include "profidrive/reference/telegram_reference.hpp"

int main() {
  fmt::print("{}", profidrive::telegram_reference());
}
