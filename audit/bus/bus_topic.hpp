#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "audit/base/topic.hpp"
#include "audit/base/transfer.hpp"
#include "audit/network/network.hpp"

namespace audit {

/// The line as a whole: identifiers, load, errors.
class BusTopic final : public Topic {
 public:
  /// @p bit_rate of the bus (bit/s), 0: not known.
  explicit BusTopic(std::uint32_t bit_rate) : bit_rate_{bit_rate} {}

  void on_frame(const Passage& passage, const Scene& scene) override;
  void on_transfer(const Transfer& transfer, const Scene& scene) override;
  void on_end(canopen::Duration at, const Scene& scene) override;

 private:
  void take_bits(const Passage& passage, const Scene& scene);
  void take_load(const Heard& heard, std::uint64_t bits, const Scene& scene);
  void take_burst(const Heard& heard, std::uint64_t bits, const Scene& scene);

  void judge_given(const Scene& scene);
  void judge_given(const Node& other, const Scene& scene) const;
  static void report_twice(const Transfer& transfer, const Node& other, const canopen::sdo::Address& at,
                           const Scene& scene);

  std::uint32_t bit_rate_;
  std::vector<Transfer>
      given_;                   ///< those that have given a node an identifier to send with, until they are judged
  std::optional<Heard> begin_;  ///< of the second whose load is counted
  std::uint64_t bits_ = 0;      ///< in it
  std::optional<Heard> burst_;  ///< the first of the frames without a gap
  std::uint64_t burst_bits_ = 0;
  bool is_burst_said_ = false;
};

}  // namespace audit
