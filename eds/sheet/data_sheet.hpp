#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "eds/sheet/section_name.hpp"
#include "eds/sheet/sheet_object.hpp"

namespace eds {

/// Bit rates with an entry BaudRate_... of their own, in kbit/s.
inline constexpr std::array<unsigned, 8> kBitRates{10, 20, 50, 125, 250, 500, 800, 1000};

/// What section DeviceInfo states.
struct DeviceInfo {
  Stated<std::string_view> vendor_name{};
  Stated<std::string_view> product_name{};
  Stated<std::string_view> order_code{};
  Stated<std::uint64_t> vendor_number{};
  Stated<std::uint64_t> product_number{};
  Stated<std::uint64_t> revision_number{};
  std::array<Stated<bool>, kBitRates.size()> bit_rates{};  ///< supported or not, as kBitRates
  Stated<bool> boot_up_master{};
  Stated<bool> boot_up_slave{};
  Stated<std::uint64_t> granularity{};  ///< of PDO mappings, in bits; 0: mappings are fixed
  Stated<std::uint64_t> dynamic_channels{};
  Stated<std::uint64_t> compact_pdo{};  ///< sub-indices of PDOs that are not described one by one
  Stated<bool> group_messaging{};
  Stated<std::uint64_t> rpdo_count{};
  Stated<std::uint64_t> tpdo_count{};
  Stated<bool> lss_supported{};
};

/// A numbered list of a section: objects, or modules.
struct NumberedList {
  struct Item {
    std::uint64_t position = 0;  ///< from 1
    Stated<std::uint64_t> number{};
  };
  const Section* section = nullptr;  ///< null where the file has none
  Stated<std::uint64_t> count{};
  std::vector<Item> items{};  ///< as they stand

  /// True when @p number is in the list.
  [[nodiscard]] bool contains(std::uint64_t number) const noexcept;
};

/// Entries that a module adds to an object of the device (MxSubExtxxxx).
struct SubExtension {
  std::uint16_t index = 0;
  SheetEntry entry{};                ///< its sub-index means nothing
  Stated<std::string_view> count{};  ///< as stated
  unsigned entries = 0;              ///< that each module brings
  unsigned bits = 0;                 ///< or bits that each module brings, which share entries
  Stated<std::uint64_t>
      last_sub{};  ///< ObjExtend: highest sub-index before the next object follows; 0: none follows
};

/// One type of module.
struct SheetModule {
  unsigned number = 0;
  const Section* info = nullptr;  ///< MxModuleInfo
  NumberedList fixed{};           ///< MxFixedObjects
  NumberedList extended{};        ///< MxSubExtends
  SheetObjects objects{};
  std::map<std::uint16_t, SubExtension> extensions{};
};

/// What section DeviceComissioning of a DCF states; the bit rate in kbit/s.
struct Commissioning {
  const Section* section = nullptr;  ///< null in an EDS
  Stated<std::uint64_t> node_id{};
  Stated<std::string_view> node_name{};
  Stated<std::uint64_t> bit_rate{};
  Stated<std::uint64_t> net_number{};
  Stated<std::string_view> network_name{};
  Stated<bool> manager{};
  Stated<std::uint64_t> serial_number{};
};

/// One segment of DynamicChannels.
struct DynamicChannel {
  std::uint64_t number = 0;
  Stated<std::uint64_t> type{};
  Stated<std::string_view> direction{};
  Stated<std::string_view> range{};
  Stated<std::string_view> offset{};
};

/// Everything an EDS or DCF says, typed. Points into the document, which must stay as it is.
struct DataSheet {
  const Document* document = nullptr;
  DeviceInfo device_info{};
  std::map<std::uint64_t, Stated<bool>> dummies{};  ///< DummyUsage by data type
  NumberedList mandatory{};
  NumberedList optional{};
  NumberedList manufacturer{};
  SheetObjects objects{};
  Stated<std::uint64_t> module_count{};       ///< SupportedModules
  std::map<unsigned, SheetModule> modules{};  ///< by number
  NumberedList connected_modules{};           ///< of a DCF
  Commissioning commissioning{};
  Stated<std::uint64_t> channel_count{};
  std::vector<DynamicChannel> channels{};

  /// True for a DCF: a file with a section DeviceComissioning.
  [[nodiscard]] bool is_configuration() const noexcept { return commissioning.section != nullptr; }
  /// The nodes that the file is for: that of a DCF, else any.
  [[nodiscard]] NodeRange nodes() const noexcept;
};

/// Reads @p document, with a finding for every value that is not of its type. Takes whatever it is given.
[[nodiscard]] DataSheet read_data_sheet(const Document& document, Findings& findings);

}  // namespace eds
