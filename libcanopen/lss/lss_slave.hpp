#pragma once

#include "libcanopen/lss/lss_application.hpp"
#include "libcanopen/service/service.hpp"

namespace canopen {

namespace lss {
struct Part;
}

/// State of an LSS slave (CiA 305); the number is the mode in "switch state global".
enum class LssState : std::uint8_t {
  Waiting = 0,        ///< hears those who look for nodes
  Configuration = 1,  ///< selected: answers inquiries and takes a node-ID
};

/// Layer setting services of a node (CiA 305): identifiers 7E5h and 7E4h, in every NMT state and without a
/// node-ID. The identity is that of 1018h, sub-indices 1 to 4. A node has it if its owner constructs one with
/// Node::context() before Node::start().
///
/// A node-ID that the master configures comes into force as one of Node::set_node_id(): with the next reset, or,
/// if the node has none, when the slave goes back to waiting. A reset leads to waiting.
class CANOPEN_EXPORT LssSlave final : public Service {
 public:
  /// @p application must outlive this.
  LssSlave(Context& context, LssApplication& application);

  LssState state() const noexcept { return state_; }
  /// What a store would keep.
  LssSettings settings() const noexcept;
  /// The store that LssStored::Later has put off has ended with @p result, anything but Later. The master gets its
  /// answer unless it has gone on meanwhile or the node was reset.
  void answer_store(LssStored result) noexcept;

  void list_identifiers(IdentifierList& list) const noexcept override;
  /// A request of the master. A frame that is not eight bytes long is ignored.
  void on_frame(const Frame& frame, std::size_t slot) noexcept override;
  /// Afresh: waiting.
  void reload(Reload how) noexcept override;

 private:
  void switch_to(std::uint8_t mode) noexcept;
  void take_part(const lss::Part& part, const Frame& frame, std::uint8_t awaited) noexcept;
  void scan(const Frame& frame) noexcept;
  void configure(const Frame& frame) noexcept;
  void take_node_id(std::uint8_t node_id) noexcept;
  void take_bit_rate(std::uint8_t table, std::uint8_t index) noexcept;
  void store() noexcept;
  bool is_unconfigured() const noexcept;
  std::uint32_t identity(std::uint8_t sub_index) const noexcept;
  void answer(std::uint8_t command, std::uint32_t value = 0) noexcept;

  LssApplication& application_;
  LssState state_ = LssState::Waiting;
  std::uint8_t awaited_ = 0;    ///< the next request of a sequence that fits so far, 0 for none
  std::uint8_t scanned_ = 0;    ///< fastscan: the number of the identity that is being found, from 0
  std::uint16_t bit_rate_ = 0;  ///< pending, in kbit/s, 0 for none
  bool is_storing_ = false;     ///< the answer to a store is put off
};

}  // namespace canopen
