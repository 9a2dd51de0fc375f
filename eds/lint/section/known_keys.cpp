#include "eds/lint/section/known_keys.hpp"

#include <algorithm>
#include <array>

#include "eds/document/encoding.hpp"
#include "eds/sheet/field_reader.hpp"

namespace eds {
namespace {

using enum SectionKind;

constexpr Severity kError = Severity::Error;
constexpr Severity kWarning = Severity::Warning;

constexpr std::array kKeys{
    KnownKey{FileInfo, "FileName", kError},
    KnownKey{FileInfo, "FileVersion", kError},
    KnownKey{FileInfo, "FileRevision", kError},
    KnownKey{FileInfo, "EDSVersion"},
    KnownKey{FileInfo, "Description", kWarning},
    KnownKey{FileInfo, "CreationTime", kWarning},
    KnownKey{FileInfo, "CreationDate", kWarning},
    KnownKey{FileInfo, "CreatedBy", kWarning},
    KnownKey{FileInfo, "ModificationTime"},
    KnownKey{FileInfo, "ModificationDate"},
    KnownKey{FileInfo, "ModifiedBy"},
    KnownKey{FileInfo, "LastEDS"},
    KnownKey{DeviceInfo, "VendorName", kError},
    KnownKey{DeviceInfo, "VendorNumber", kError},
    KnownKey{DeviceInfo, "ProductName", kError},
    KnownKey{DeviceInfo, "ProductNumber", kError},
    KnownKey{DeviceInfo, "RevisionNumber", kError},
    KnownKey{DeviceInfo, "ProductVersion"},
    KnownKey{DeviceInfo, "ProductRevision"},
    KnownKey{DeviceInfo, "OrderCode"},
    KnownKey{DeviceInfo, "BaudRate_10", kWarning},
    KnownKey{DeviceInfo, "BaudRate_20", kWarning},
    KnownKey{DeviceInfo, "BaudRate_50", kWarning},
    KnownKey{DeviceInfo, "BaudRate_125", kWarning},
    KnownKey{DeviceInfo, "BaudRate_250", kWarning},
    KnownKey{DeviceInfo, "BaudRate_500", kWarning},
    KnownKey{DeviceInfo, "BaudRate_800", kWarning},
    KnownKey{DeviceInfo, "BaudRate_1000", kWarning},
    KnownKey{DeviceInfo, "BaudRate_auto"},
    KnownKey{DeviceInfo, "SimpleBootUpMaster", kWarning},
    KnownKey{DeviceInfo, "SimpleBootUpSlave", kWarning},
    KnownKey{DeviceInfo, "Granularity", kWarning},
    KnownKey{DeviceInfo, "DynamicChannelsSupported", kWarning},
    KnownKey{DeviceInfo, "CompactPDO"},
    KnownKey{DeviceInfo, "GroupMessaging", kWarning},
    KnownKey{DeviceInfo, "NrOfRXPDO", kWarning},
    KnownKey{DeviceInfo, "NrOfTXPDO", kWarning},
    KnownKey{DeviceInfo, "LSS_Supported", kWarning},
    KnownKey{DeviceInfo, "CANopenSafetySupported"},
    KnownKey{DummyUsage, "Dummy%"},
    KnownKey{Comments, "Lines", kError},
    KnownKey{Comments, "Line#"},
    KnownKey{MandatoryObjects, "SupportedObjects", kError},
    KnownKey{MandatoryObjects, "#"},
    KnownKey{OptionalObjects, "SupportedObjects", kError},
    KnownKey{OptionalObjects, "#"},
    KnownKey{ManufacturerObjects, "SupportedObjects", kError},
    KnownKey{ManufacturerObjects, "#"},
    KnownKey{DynamicChannels, "NrOfSeg", kError},
    KnownKey{DynamicChannels, "Type#"},
    KnownKey{DynamicChannels, "Dir#"},
    KnownKey{DynamicChannels, "Range#"},
    KnownKey{DynamicChannels, "PPOffset#"},
    KnownKey{DynamicChannels, "MaxCnt#"},
    KnownKey{Tools, "Items", kError},
    KnownKey{Tool, "Name", kError},
    KnownKey{Tool, "Command", kError},
    KnownKey{Tool, "Make"},
    KnownKey{Tool, "Wait"},
    KnownKey{SupportedModules, "NrOfEntries", kError},
    KnownKey{ConnectedModules, "NrOfEntries", kError},
    KnownKey{ConnectedModules, "#"},
    KnownKey{DeviceCommissioning, "NodeID", kError},
    KnownKey{DeviceCommissioning, "NodeName", kWarning},
    KnownKey{DeviceCommissioning, "NodeRefd"},
    KnownKey{DeviceCommissioning, "Baudrate", kError},
    KnownKey{DeviceCommissioning, "NetNumber", kWarning},
    KnownKey{DeviceCommissioning, "NetworkName"},
    KnownKey{DeviceCommissioning, "NetRefd"},
    KnownKey{DeviceCommissioning, "CANopenManager", kWarning},
    KnownKey{DeviceCommissioning, "LSS_SerialNumber"},
    KnownKey{Object, "ParameterName", kError},
    KnownKey{Object, "ObjectType"},
    KnownKey{Object, "DataType"},
    KnownKey{Object, "LowLimit"},
    KnownKey{Object, "HighLimit"},
    KnownKey{Object, "AccessType"},
    KnownKey{Object, "DefaultValue"},
    KnownKey{Object, "PDOMapping"},
    KnownKey{Object, "SubNumber"},
    KnownKey{Object, "ObjFlags"},
    KnownKey{Object, "CompactSubObj"},
    KnownKey{Object, "SRDOMapping"},
    KnownKey{Object, "InvertedSRAD"},
    KnownKey{Object, "ParameterValue"},
    KnownKey{Object, "Denotation"},
    KnownKey{Object, "ParamRefd"},
    KnownKey{Object, "UploadFile"},
    KnownKey{Object, "DownloadFile"},
    KnownKey{Names, "NrOfEntries", kError},
    KnownKey{Names, "#"},
    KnownKey{Values, "NrOfEntries", kError},
    KnownKey{Values, "#"},
    KnownKey{Denotations, "NrOfEntries", kError},
    KnownKey{Denotations, "#"},
    KnownKey{ObjectLinks, "ObjectLinks", kError},
    KnownKey{ObjectLinks, "#"},
    KnownKey{ModuleInfo, "ProductName", kError},
    KnownKey{ModuleInfo, "ProductVersion", kError},
    KnownKey{ModuleInfo, "ProductRevision", kError},
    KnownKey{ModuleInfo, "OrderCode", kError},
    KnownKey{FixedObjects, "NrOfEntries", kError},
    KnownKey{FixedObjects, "#"},
    KnownKey{SubExtends, "NrOfEntries", kError},
    KnownKey{SubExtends, "#"},
    KnownKey{SubExtension, "Count", kError},
    KnownKey{SubExtension, "ObjExtend"},
};

bool is_hexadecimal(std::string_view text) noexcept {
  return !text.empty() && text.find_first_not_of("0123456789ABCDEFabcdef") == std::string_view::npos;
}

}  // namespace

std::span<const KnownKey> known_keys() noexcept {
  return kKeys;
}

bool is_known(const KnownKey& row, std::string_view key) noexcept {
  const char last = row.key.back();
  if (last != '#' && last != '%') return equal_in_any_case(row.key, key);
  if (!take_in_any_case(key, row.key.substr(0, row.key.size() - 1))) return false;
  return last == '#' ? entry_number(key).has_value() : is_hexadecimal(key);
}

}  // namespace eds
