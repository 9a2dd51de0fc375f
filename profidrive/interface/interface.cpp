#include "profidrive/interface/interface.hpp"

namespace profidrive {

Interface::Interface(unit::Runner& runner) {
  static_cast<void>(runner);
}
bool Interface::has(std::uint8_t object) const noexcept {
  return object != 0;
}
void Interface::receive(std::uint8_t object, std::span<const std::uint16_t> words, std::size_t first) noexcept {
  static_cast<void>(object), static_cast<void>(words), static_cast<void>(first);
}
void Interface::touch(std::uint8_t object) noexcept {
  static_cast<void>(object);
}
void Interface::on_connection_lost(std::uint8_t object) noexcept {
  static_cast<void>(object);
}
std::span<const std::uint16_t> Interface::sent(std::uint8_t object) const noexcept {
  static_cast<void>(object);
  return {};
}
std::span<const std::uint16_t> Interface::received(std::uint8_t object) const noexcept {
  static_cast<void>(object);
  return {};
}
void Interface::bring() noexcept {}
void Interface::show() noexcept {}

}  // namespace profidrive
