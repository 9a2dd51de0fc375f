#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "profidrive/channel/parameter_channel.hpp"
#include "unit/runner.hpp"

namespace profidrive {

/// A whole drive unit that is asked what bytes say. A new input finds it as a new one.
class FuzzedUnit : private unit::ParameterKeeper {
 public:
  FuzzedUnit();
  ~FuzzedUnit() override = default;
  FuzzedUnit(const FuzzedUnit&) = delete;
  FuzzedUnit& operator=(const FuzzedUnit&) = delete;

  /// Plays @p input: steps of a kind, a length, and so many bytes, cut where the input ends. A kind that is odd is
  /// a request of a parameter channel, any other one a record. The rule that an answer breaks; empty if none does.
  [[nodiscard]] std::string play(std::span<const std::uint8_t> input);

 private:
  unit::Keeping on_store(std::span<const std::byte> image) noexcept override;
  void on_restore() noexcept override {}
  std::string record(std::span<const std::uint8_t> request);
  std::string exchange(std::span<const std::uint8_t> request);

  unit::Runner runner_;
  ParameterChannel channel_{2};
};

}  // namespace profidrive
