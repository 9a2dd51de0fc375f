#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "libcanopen/sdo/command.hpp"

namespace audit {

/// Values of entries of a node, as transfers have told them. A bounded number is kept.
class KnownValues {
 public:
  /// More than the communication profile and eight axes have.
  static constexpr std::size_t kMostValues = 8192;

  /// The entry at @p at has @p value now.
  void learn(const canopen::sdo::Address& at, std::uint64_t value);
  /// What was told last; nothing if it was not, or is not sure any more.
  [[nodiscard]] std::optional<std::uint64_t> find(std::uint16_t index, std::uint8_t sub_index) const noexcept;
  /// How many are kept.
  [[nodiscard]] std::size_t size() const noexcept { return values_.size(); }
  /// The node has stored what it has.
  void save() { saved_ = values_; }
  /// The node was told to restore defaults by @p sub_index of 1011h: all of them (1), those of communication (2),
  /// or others.
  void forget_saved(std::uint8_t sub_index);
  /// It has what was stored; @p communication_only: objects 1000h to 1FFFh alone.
  void reset(bool communication_only);

 private:
  using Values = std::unordered_map<std::uint32_t, std::uint64_t>;

  Values values_, saved_;
};

}  // namespace audit
