#pragma once

#include <array>

#include "drive/external_messages/external_messages.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/factory_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<ExternalMessages> = std::array{
    Row{2103, 1, kAll, BinectorInput, Unit::None, kWhole, factory::acknowledge_source, When::Always, bit_input<&ExternalMessages::Inputs::acknowledge_1>, Output::No, "BI: 1st acknowledge faults", "a rising edge acknowledges the faults"},
    Row{2104, 1, kAll, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&ExternalMessages::Inputs::acknowledge_2>, Output::No, "BI: 2nd acknowledge faults", "a rising edge acknowledges the faults"},
    Row{2105, 1, kAll, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&ExternalMessages::Inputs::acknowledge_3>, Output::No, "BI: 3rd acknowledge faults", "a rising edge acknowledges the faults"},
    Row{2106, 1, kAll, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&ExternalMessages::Inputs::no_external_fault_1>, Output::No, "BI: external fault 1 (0 signal triggers)", "0 raises F07860"},
    Row{2107, 1, kAll, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&ExternalMessages::Inputs::no_external_fault_2>, Output::No, "BI: external fault 2", "0 raises F07861"},
    Row{2108, 1, kAll, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&ExternalMessages::Inputs::no_external_fault_3>, Output::No, "BI: external fault 3", "0 raises F07862"},
    Row{2112, 1, kAll, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&ExternalMessages::Inputs::no_external_alarm_1>, Output::No, "BI: external alarm 1", "0 raises A07850"},
};
// clang-format on

}  // namespace drive::rows
