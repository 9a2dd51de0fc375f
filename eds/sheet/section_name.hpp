#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace eds {

/// What a section is, by its name.
enum class SectionKind : std::uint8_t {
  Unknown,
  FileInfo,
  DeviceInfo,
  DummyUsage,
  Comments,
  MandatoryObjects,
  OptionalObjects,
  ManufacturerObjects,
  DynamicChannels,
  Tools,
  Tool,  ///< Tool1 and so on
  SupportedModules,
  ConnectedModules,
  DeviceCommissioning,  ///< "DeviceComissioning" in CiA 306
  Object,               ///< xxxx
  SubObject,            ///< xxxxsubx
  Names,                ///< xxxxName, of CompactSubObj
  Values,               ///< xxxxValue, of a DCF
  Denotations,          ///< xxxxDenotation, of a DCF
  ObjectLinks,          ///< xxxxObjectLinks
  ModuleInfo,           ///< MxModuleInfo
  FixedObjects,         ///< MxFixedObjects
  SubExtends,           ///< MxSubExtends
  SubExtension,         ///< MxSubExtxxxx
};

/// A section name taken apart. Letters may have any case, the sub-index may have leading zeros.
struct SectionName {
  SectionKind kind = SectionKind::Unknown;
  unsigned module = 0;  ///< number of the module type, from 1; 0 for what belongs to the device itself
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;

  friend bool operator==(const SectionName&, const SectionName&) = default;
};

/// Takes @p name apart.
[[nodiscard]] SectionName parse_section_name(std::string_view name) noexcept;

/// The name of an object's section: "1018", of a module's "M2Fixed1400".
[[nodiscard]] std::string object_section(unsigned module, std::uint16_t index);
/// The name of an entry's section: "1018sub1".
[[nodiscard]] std::string entry_section(unsigned module, std::uint16_t index, std::uint8_t sub_index);

}  // namespace eds
