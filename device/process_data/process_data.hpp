#pragma once

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "device/objects/axis_scaling.hpp"
#include "device/process_data/process_data_buffers.hpp"
#include "device/process_data/process_objects.hpp"
#include "drive/axis/axis.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// The process data of one axis between its objects and its words: what a mapping places in the words is received
/// into them and sent out of them; an object without a place is received into the parameter that stands for it
/// (r8745, r8747, r8792, r8795 to r8797) and shows the axis itself. This is the only place where process data are
/// converted.
class ProcessData {
 public:
  /// Binds the objects of @p axis in @p dictionary; @p places says which are mapped. All arguments must outlive
  /// this.
  ProcessData(canopen::Dictionary& dictionary, drive::Axis& axis, const ProcessDataBuffers& places);

  /// The controlword that the master wrote last.
  std::uint16_t controlword() const noexcept { return controlword_.get(); }
  /// Brings what the objects hold to the axis, with @p controlword in place of the one in 6040h.
  void receive(std::uint16_t controlword) noexcept;
  /// Shows what the axis has put into its words, and the axis itself, to the master.
  void publish() noexcept;

 private:
  /// An object with its place in the words.
  struct Placed {
    const canopen::Entry* entry;
    WordForm form;
    std::uint8_t first;
    std::uint8_t words;
  };
  /// An object that is sent and has no place.
  struct Shown {
    const canopen::Entry* entry;
    const SentObject* object;
  };
  /// An object that is received, has no place and leads to a parameter.
  struct Written {
    const canopen::Entry* entry;
    std::variant<std::int16_t*, std::int32_t*> target;
  };
  const canopen::Entry& entry(std::uint16_t index) const;
  WordScaling scaling() const noexcept;
  void plan() noexcept;
  void plan_sent() noexcept;
  void plan_written() noexcept;

  canopen::Dictionary& dictionary_;
  drive::Axis& axis_;
  const ProcessDataBuffers& places_;
  AxisScaling scaling_;
  std::uint16_t controlword_index_;
  canopen::Cell<std::uint16_t> controlword_;
  std::vector<const canopen::Entry*> sent_entries_;  ///< of kSentObjects
  std::uint32_t version_ = 0;                        ///< of the places that the plans are made for
  std::vector<Placed> received_;
  std::vector<Placed> sent_;
  std::vector<Shown> shown_;
  std::vector<Written> written_;
  bool controlword_placed_ = false;
  const canopen::Entry* mode_ = nullptr;  ///< 6060h while it has a place
};

}  // namespace device
