#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "drive/images/image_format.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace cia402 {

/// The groups of 1010h and 1011h, by their sub-indices.
enum class ObjectGroup : std::uint8_t { All = 1, Communication = 2, Application = 3 };

/// The objects that are saved, as an image (drive/images/image_format.hpp): what is not a set-point, a command or
/// an actual value. Content: U16 node-ID of CiA 305 with bit 8, 0 if none was set, U32 count, then for each entry
/// index U16, sub-index U8, value I64.
class ObjectImage {
 public:
  /// Of the entries of @p dictionary, in a device whose drives are @p unit; both outlive this.
  ObjectImage(canopen::Dictionary& dictionary, const drive::DriveUnit& unit);

  /// An image of the present values of @p group, with the values saved last for the others; valid until the next
  /// call.
  std::span<const std::byte> make(ObjectGroup group) noexcept;
  /// The same of what is saved already, with a node-ID that was set since.
  std::span<const std::byte> make_saved() noexcept;
  /// The image that was made last is saved from now on.
  void keep() noexcept;
  /// Saved values are those of @p image from now on; nothing changes if it does not fit.
  [[nodiscard]] tl::expected<void, drive::image_format::Error> adopt(std::span<const std::byte> image) noexcept;
  /// Nothing is saved of @p group any more.
  void forget(ObjectGroup group) noexcept;
  /// Puts the values of @p group into the dictionary: what is saved, else the initial ones.
  void restore(ObjectGroup group) noexcept;
  /// The node-ID that is saved (CiA 305): 1..127 or canopen::kNoNodeId, if one was set.
  std::optional<std::uint8_t> node_id() const noexcept { return node_id_; }
  void set_node_id(std::uint8_t node_id) noexcept { node_id_ = node_id; }
  /// Whether anything was saved.
  bool is_saved() const noexcept { return saved_; }
  /// Whether @p entry is saved.
  static bool is_kept(const canopen::Entry& entry) noexcept;

 private:
  struct Value {
    const canopen::Entry* entry;
    std::int64_t saved;
    std::int64_t next;
  };
  std::span<const std::byte> write() noexcept;
  bool can_have(const canopen::Entry& entry, std::int64_t value) const noexcept;
  tl::expected<void, drive::image_format::Error> read(drive::image_format::Reader& reader) noexcept;

  canopen::Dictionary& dictionary_;
  const drive::DriveUnit& unit_;
  std::vector<Value> values_;
  std::vector<std::byte> image_;
  std::optional<std::uint8_t> node_id_{};
  bool saved_ = false;
};

}  // namespace cia402
