#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "audit/base/heard.hpp"
#include "audit/network/known_values.hpp"
#include "eds/description/description.hpp"
#include "libcanopen/base/nmt_state.hpp"

namespace audit {

struct Transfer;

/// How a node that was read differs from its EDS.
struct Misfit {
  canopen::sdo::Address at{};
  bool is_missing = false;  ///< the node does not have this entry
  std::uint64_t value = 0;  ///< else what it has told of an entry that tells devices apart
};

/// What is known of a node.
struct Node {
  std::uint8_t id = 0;
  eds::Description description{};            ///< empty: there is no EDS
  std::optional<canopen::NmtState> state{};  ///< as it has told, or was told since; nothing: not known
  std::optional<Heard> told{};               ///< the NMT command that it was told last
  std::optional<Heard> boot_up{};            ///< its last boot-up message
  std::optional<Heard> error_control{};      ///< its last heartbeat or answer of node guarding
  bool resets = false;                       ///< it was told to reset, and there was no boot-up message since
  bool is_there = false;                     ///< it has sent something
  bool has_default_pdos = true;              ///< as far as is known its PDOs are those of the EDS at first
  bool has_sent_emcy = false;
  std::uint64_t seen_tpdos = 0;  ///< those of the first 64 that it has sent, a bit each
  KnownValues values{};
  std::optional<Misfit> misfit{};  ///< the first one
  std::uint32_t changes = 0;       ///< how often `values` may have changed

  /// Whether it has sent TPDO @p number, from 1; of the first 64 alone.
  [[nodiscard]] bool has_sent_tpdo(std::uint16_t number) const noexcept {
    return (seen_tpdos & bit_of(number)) != 0;
  }
  /// Its bit in seen_tpdos; 0: none.
  [[nodiscard]] static constexpr std::uint64_t bit_of(std::uint16_t number) noexcept {
    return number - 1U < 64 ? std::uint64_t{1} << (number - 1U) : 0;
  }

  /// The value of an entry: as it was told; or the default value of the EDS, if the node was heard to boot: one
  /// that ran before may have been told anything.
  [[nodiscard]] std::optional<std::uint64_t> value(std::uint16_t index, std::uint8_t sub_index) const;
};

/// All nodes of a bus, as far as they are known from what was heard.
class Network {
 public:
  static constexpr std::size_t kNodes = 128;

  Network();
  /// What @p description says holds for the node that it was read for.
  void describe(eds::Description description);

  [[nodiscard]] const Node& node(std::uint8_t id) const noexcept { return nodes_[id & (kNodes - 1)]; }
  [[nodiscard]] const std::array<Node, kNodes>& nodes() const noexcept { return nodes_; }
  /// Takes in what @p passage has changed, and @p transfer, if it has ended one.
  void follow(const Passage& passage, const Transfer* transfer);

 private:
  static void follow_tpdo(Node& node, const Passage& passage);
  void follow_command(const Heard& heard);
  static void command(Node& node, canopen::NmtCommand order, const Heard& heard);
  static void follow_error_control(Node& node, const Heard& heard);
  static void follow_transfer(Node& node, const Transfer& transfer);

  std::array<Node, kNodes> nodes_{};
};

}  // namespace audit
