#pragma once

#include <string_view>

#include "eds/sheet/data_sheet.hpp"

namespace eds {

/// Reads what is not objects: DeviceInfo, DummyUsage, DeviceComissioning, modules by number, DynamicChannels.
void read_info(DataSheet& sheet, Findings& findings);

/// Reads the numbered list of section @p name, counted under @p count_key.
[[nodiscard]] NumberedList read_list(const Document& document, std::string_view name, std::string_view count_key,
                                     Findings& findings);

}  // namespace eds
