#include "libcanopen/emcy/error_keeper.hpp"

namespace canopen {

ErrorKeeper::ErrorKeeper(Context& context, EmcyProducer& producer) : context_{context}, producer_{producer} {}

void ErrorKeeper::raise(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept {
  producer_.send(code, error_register,
                 {static_cast<std::uint8_t>(detail), static_cast<std::uint8_t>(detail >> 8), 0, 0, 0});
}

void ErrorKeeper::clear(std::uint16_t, std::uint16_t) noexcept {
  (void)context_;
}

void ErrorKeeper::reload() noexcept {}

Result<std::int64_t> ErrorKeeper::read(const Entry&, std::int64_t stored) {
  return stored;
}

Result<void> ErrorKeeper::write(const Entry&, std::int64_t) {
  return {};
}

}  // namespace canopen
