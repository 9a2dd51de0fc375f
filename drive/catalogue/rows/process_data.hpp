#pragma once

#include <array>

#include "drive/base/process_data_image.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/factory_values.hpp"
#include "drive/values/object_values.hpp"
#include "drive/values/process_data_values.hpp"

namespace drive::rows {

using enum PzdInterface;

/// The PZD interface that CAN uses (IF2), and constants for inputs.
// clang-format off
inline constexpr std::array kProcessDataRows{
    Row{2900, 1, kAll, F32, Unit::Percent, {-10000.0, 10000.0}, 0.0, When::Always, Slot{}, Output::Connector, "Fixed value 1 (CO)", "inputs that are connected to it"},
    Row{2901, 1, kAll, F32, Unit::Percent, {-10000.0, 10000.0}, 0.0, When::Always, Slot{}, Output::Connector, "Fixed value 2 (CO)", "inputs that are connected to it"},
    Row{2902, 15, kAll, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, shown<object_value::fixed_value>, Output::Connector, "Fixed values (CO)", "0, 5, 10, 20, 50, 100, 150, 200 and -5 to -200"},
    Row{2930, 1, kAll, F32, Unit::NewtonMetre, {-100000.0, 100000.0}, 0.0, When::Always, Slot{}, Output::Connector, "CO: fixed value torque", "inputs that are connected to it"},
    Row{8805, 2, kControlUnit, I16, Unit::None, kWhole, 0.0, When::Ready, Stored{"I&M data of PROFIdrive"}, Output::No, "I&M 4 configuration", ""},
    Row{8815, 2, kControlUnit, I16, Unit::None, {1.0, 2.0}, 1.0, When::Ready, Stored{"isochronous PROFIdrive and PROFIsafe"}, Output::No, "IF1/IF2 PZD functionality: [0] isochronous, [1] PROFIsafe", ""},
    Row{8837, 1, kWithProcessData, I16, Unit::None, {0.0, 2.0}, 2.0, When::Ready, Stored{"a control word with control by PLC on the CAN bus"}, Output::No, "IF2 STW1.10 = 0 mode", ""},
    Row{8839, 2, kControlUnit, I16, Unit::None, {0.0, 99.0}, 99.0, When::Ready, Agreed{}, Output::No, "PZD interface hardware assignment [0]=IF1 [1]=IF2", "which interfaces exchange process data from the next power-on on: 99 or 1 for IF1, 99 or 2 for IF2, 0 none"},
    Row{8843, 3, kWithProcessData, U8, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::interface_state<If2>>, Output::Bits, "IF2 PZD state bits", "[0] no setpoints come, [2] the bus is Operational"},
    Row{8848, 1, kControlUnit, F32, Unit::Milliseconds, {1.0, 16.0}, 4.0, When::DeviceConfiguration, Agreed{}, Output::No, "IF2 PZD sampling time (CAN cycle)", "receive and transmit cycle"},
    Row{8850, 20, kWithProcessData, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_word<If2>>, Output::Connector, "IF2 PZD receive word (CO)", "speeds and torques relative to p2000 and p2003", Keep::Stored, nullptr, FullScale::Word},
    Row{8851, 25, kWithProcessData, ConnectorInput, Unit::None, kWhole, factory::send_words, When::Always, ImageInput{ImageSink::SentWord}, Output::No, "IF2 PZD send word (CI)", "the free object of 16 bits that is mapped there"},
    Row{8853, 25, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::sent_word<If2>>, Output::No, "IF2 PZD send word diagnostics", "speeds and torques relative to p2000 and p2003"},
    Row{8859, 8, kControlUnit, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "COMM BOARD identification data", ""},
    Row{8860, 19, kWithProcessData, I32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_double_word<If2>>, Output::Connector, "IF2 PZD receive double word (CO)", "two words, the upper one first", Keep::Stored, nullptr, FullScale::DoubleWord},
    Row{8861, 24, kWithProcessData, ConnectorInput, Unit::None, kWhole, factory::send_double_words, When::Always, ImageInput{ImageSink::SentDoubleWord}, Output::No, "IF2 PZD send double word (CI)", "the free object of 32 bits that is mapped there"},
    Row{8863, 24, kWithProcessData, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::sent_double_word<If2>>, Output::No, "IF2 PZD send double word diagnostics", "two words, the upper one first"},
    Row{8867, 2, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "IF2 highest interconnected PZD [0] rx [1] tx", ""},
    Row{8874, 20, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "IF2 diagnostics sender bus address", ""},
    Row{8875, 20, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "IF2 diagnostics byte offset receive", ""},
    Row{8876, 25, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "IF2 diagnostics byte offset send", ""},
    Row{8880, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 0}, Output::No, "IF2 binector-connector converter status word 1", "r8889[0]"},
    Row{8881, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 1}, Output::No, "IF2 binector-connector converter status word 2", "r8889[1]"},
    Row{8882, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 2}, Output::No, "IF2 binector-connector converter free status word 3", "r8889[2]"},
    Row{8883, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 3}, Output::No, "IF2 binector-connector converter free status word 4", "r8889[3]"},
    Row{8884, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 4}, Output::No, "IF2 binector-connector converter free status word 5", "r8889[4]"},
    Row{8888, 5, kWithProcessData, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Always, setting<&Converters::invert_words_of_bits>, Output::No, "IF2 invert binector-connector converter", "acts on r8889"},
    Row{8889, 5, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::word_of_bits<If2>>, Output::Both, "IF2 binector-connector converter output words", "the bits of p8880 to p8884, inverted by p8888"},
    Row{8890, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_bits<If2, 0>>, Output::Both, "IF2 PZD1 receive bit-serial (BO)", "r8850[0]"},
    Row{8891, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_bits<If2, 1>>, Output::Both, "IF2 PZD2 receive bit-serial (BO)", "r8850[1]"},
    Row{8892, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_bits<If2, 2>>, Output::Both, "IF2 PZD3 receive bit-serial (BO)", "r8850[2]"},
    Row{8893, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_bits<If2, 3>>, Output::Both, "IF2 PZD4 receive bit-serial (BO)", "r8850[3]"},
    Row{8894, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::converted_bits<If2, 0>>, Output::Both, "IF2 connector-binector converter 1", "the word of p8899[0], inverted by p8898[0]"},
    Row{8895, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::converted_bits<If2, 1>>, Output::Both, "IF2 connector-binector converter 2", "the word of p8899[1], inverted by p8898[1]"},
    Row{8898, 2, kWithProcessData, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Always, setting<&Converters::invert_bits_of_words>, Output::No, "IF2 invert connector-binector converter", "acts on r8894 and r8895"},
    Row{8899, 2, kWithProcessData, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::WordOfBits}, Output::No, "IF2 connector-binector converter source (CI)", "r8894 and r8895"},
};
// clang-format on

}  // namespace drive::rows
