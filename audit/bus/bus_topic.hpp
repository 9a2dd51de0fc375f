#pragma once

#include <cstdint>
#include <optional>

#include "audit/base/topic.hpp"

namespace audit {

/// The line as a whole: identifiers, load, errors.
class BusTopic final : public Topic {
 public:
  /// @p bit_rate of the bus (bit/s), 0: not known.
  explicit BusTopic(std::uint32_t bit_rate) : bit_rate_{bit_rate} {}

  void on_frame(const Passage& passage, const Scene& scene) override;
  void on_transfer(const Transfer& transfer, const Scene& scene) override;

 private:
  void take_bits(const Passage& passage, const Scene& scene);
  void take_load(const Heard& heard, std::uint64_t bits, const Scene& scene);
  void take_burst(const Heard& heard, std::uint64_t bits, const Scene& scene);

  std::uint32_t bit_rate_;
  std::optional<Heard> begin_;  ///< of the second whose load is counted
  std::uint64_t bits_ = 0;      ///< in it
  std::optional<Heard> burst_;  ///< the first of the frames without a gap
  std::uint64_t burst_bits_ = 0;
  bool is_burst_said_ = false;
};

}  // namespace audit
