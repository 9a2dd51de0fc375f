#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/values/checks.hpp"
#include "drive/values/factory_values.hpp"

namespace drive::rows {

/// PDO parameters and mappings.
// clang-format off
inline constexpr std::array kPdoRows{
    Row{8700, 2, kAxes, U32, Unit::None, kWhole, factory::receive_pdo<0>, When::MotorReady, Agreed{}, Output::No, "CAN receive PDO 1: [0] COB-ID, [1] transmission type", "1400h", Keep::Stored, check::receive_pdo},
    Row{8701, 2, kAxes, U32, Unit::None, kWhole, factory::receive_pdo<1>, When::MotorReady, Agreed{}, Output::No, "CAN receive PDO 2: [0] COB-ID, [1] transmission type", "1401h", Keep::Stored, check::receive_pdo},
    Row{8702, 2, kAxes, U32, Unit::None, kWhole, factory::receive_pdo<2>, When::MotorReady, Agreed{}, Output::No, "CAN receive PDO 3: [0] COB-ID, [1] transmission type", "1402h", Keep::Stored, check::receive_pdo},
    Row{8703, 2, kAxes, U32, Unit::None, kWhole, factory::receive_pdo<3>, When::MotorReady, Agreed{}, Output::No, "CAN receive PDO 4: [0] COB-ID, [1] transmission type", "1403h", Keep::Stored, check::receive_pdo},
    Row{8704, 2, kAxes, U32, Unit::None, kWhole, factory::receive_pdo<4>, When::MotorReady, Agreed{}, Output::No, "CAN receive PDO 5: [0] COB-ID, [1] transmission type", "1404h", Keep::Stored, check::receive_pdo},
    Row{8705, 2, kAxes, U32, Unit::None, kWhole, factory::receive_pdo<5>, When::MotorReady, Agreed{}, Output::No, "CAN receive PDO 6: [0] COB-ID, [1] transmission type", "1405h", Keep::Stored, check::receive_pdo},
    Row{8706, 2, kAxes, U32, Unit::None, kWhole, factory::receive_pdo<6>, When::MotorReady, Agreed{}, Output::No, "CAN receive PDO 7: [0] COB-ID, [1] transmission type", "1406h", Keep::Stored, check::receive_pdo},
    Row{8707, 2, kAxes, U32, Unit::None, kWhole, factory::receive_pdo<7>, When::MotorReady, Agreed{}, Output::No, "CAN receive PDO 8: [0] COB-ID, [1] transmission type", "1407h", Keep::Stored, check::receive_pdo},
    Row{8710, 4, kAxes, U32, Unit::None, kWhole, factory::receive_mapping<0>, When::MotorReady, Agreed{}, Output::No, "CAN receive mapping RPDO 1", "1600h"},
    Row{8711, 4, kAxes, U32, Unit::None, kWhole, factory::receive_mapping<1>, When::MotorReady, Agreed{}, Output::No, "CAN receive mapping RPDO 2", "1601h"},
    Row{8712, 4, kAxes, U32, Unit::None, kWhole, factory::receive_mapping<2>, When::MotorReady, Agreed{}, Output::No, "CAN receive mapping RPDO 3", "1602h"},
    Row{8713, 4, kAxes, U32, Unit::None, kWhole, factory::receive_mapping<3>, When::MotorReady, Agreed{}, Output::No, "CAN receive mapping RPDO 4", "1603h"},
    Row{8714, 4, kAxes, U32, Unit::None, kWhole, 0.0, When::MotorReady, Agreed{}, Output::No, "CAN receive mapping RPDO 5", "1604h"},
    Row{8715, 4, kAxes, U32, Unit::None, kWhole, 0.0, When::MotorReady, Agreed{}, Output::No, "CAN receive mapping RPDO 6", "1605h"},
    Row{8716, 4, kAxes, U32, Unit::None, kWhole, 0.0, When::MotorReady, Agreed{}, Output::No, "CAN receive mapping RPDO 7", "1606h"},
    Row{8717, 4, kAxes, U32, Unit::None, kWhole, 0.0, When::MotorReady, Agreed{}, Output::No, "CAN receive mapping RPDO 8", "1607h"},
    Row{8720, 5, kAxes, U32, Unit::None, kWhole, factory::transmit_pdo<0>, When::MotorReady, Agreed{}, Output::No, "CAN transmit PDO 1: COB-ID, type, inhibit time (100 us), reserved, event timer (ms)", "1800h", Keep::Stored, check::transmit_pdo},
    Row{8721, 5, kAxes, U32, Unit::None, kWhole, factory::transmit_pdo<1>, When::MotorReady, Agreed{}, Output::No, "CAN transmit PDO 2: COB-ID, type, inhibit time (100 us), reserved, event timer (ms)", "1801h", Keep::Stored, check::transmit_pdo},
    Row{8722, 5, kAxes, U32, Unit::None, kWhole, factory::transmit_pdo<2>, When::MotorReady, Agreed{}, Output::No, "CAN transmit PDO 3: COB-ID, type, inhibit time (100 us), reserved, event timer (ms)", "1802h", Keep::Stored, check::transmit_pdo},
    Row{8723, 5, kAxes, U32, Unit::None, kWhole, factory::transmit_pdo<3>, When::MotorReady, Agreed{}, Output::No, "CAN transmit PDO 4: COB-ID, type, inhibit time (100 us), reserved, event timer (ms)", "1803h", Keep::Stored, check::transmit_pdo},
    Row{8724, 5, kAxes, U32, Unit::None, kWhole, factory::transmit_pdo<4>, When::MotorReady, Agreed{}, Output::No, "CAN transmit PDO 5: COB-ID, type, inhibit time (100 us), reserved, event timer (ms)", "1804h", Keep::Stored, check::transmit_pdo},
    Row{8725, 5, kAxes, U32, Unit::None, kWhole, factory::transmit_pdo<5>, When::MotorReady, Agreed{}, Output::No, "CAN transmit PDO 6: COB-ID, type, inhibit time (100 us), reserved, event timer (ms)", "1805h", Keep::Stored, check::transmit_pdo},
    Row{8726, 5, kAxes, U32, Unit::None, kWhole, factory::transmit_pdo<6>, When::MotorReady, Agreed{}, Output::No, "CAN transmit PDO 7: COB-ID, type, inhibit time (100 us), reserved, event timer (ms)", "1806h", Keep::Stored, check::transmit_pdo},
    Row{8727, 5, kAxes, U32, Unit::None, kWhole, factory::transmit_pdo<7>, When::MotorReady, Agreed{}, Output::No, "CAN transmit PDO 8: COB-ID, type, inhibit time (100 us), reserved, event timer (ms)", "1807h", Keep::Stored, check::transmit_pdo},
    Row{8730, 4, kAxes, U32, Unit::None, kWhole, factory::transmit_mapping<0>, When::MotorReady, Agreed{}, Output::No, "CAN transmit mapping TPDO 1", "1A00h"},
    Row{8731, 4, kAxes, U32, Unit::None, kWhole, factory::transmit_mapping<1>, When::MotorReady, Agreed{}, Output::No, "CAN transmit mapping TPDO 2", "1A01h"},
    Row{8732, 4, kAxes, U32, Unit::None, kWhole, factory::transmit_mapping<2>, When::MotorReady, Agreed{}, Output::No, "CAN transmit mapping TPDO 3", "1A02h"},
    Row{8733, 4, kAxes, U32, Unit::None, kWhole, factory::transmit_mapping<3>, When::MotorReady, Agreed{}, Output::No, "CAN transmit mapping TPDO 4", "1A03h"},
    Row{8734, 4, kAxes, U32, Unit::None, kWhole, 0.0, When::MotorReady, Agreed{}, Output::No, "CAN transmit mapping TPDO 5", "1A04h"},
    Row{8735, 4, kAxes, U32, Unit::None, kWhole, 0.0, When::MotorReady, Agreed{}, Output::No, "CAN transmit mapping TPDO 6", "1A05h"},
    Row{8736, 4, kAxes, U32, Unit::None, kWhole, 0.0, When::MotorReady, Agreed{}, Output::No, "CAN transmit mapping TPDO 7", "1A06h"},
    Row{8737, 4, kAxes, U32, Unit::None, kWhole, 0.0, When::MotorReady, Agreed{}, Output::No, "CAN transmit mapping TPDO 8", "1A07h"},
};
// clang-format on

}  // namespace drive::rows
