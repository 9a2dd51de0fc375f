#pragma once

#include <array>

#include "drive/base/process_data_image.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/process_data_values.hpp"

namespace drive::rows {

using enum PzdInterface;

/// The PZD interface of PROFIdrive (IF1).
// clang-format off
inline constexpr std::array kIf1Rows{
    Row{922, 1, kAxes, I16, Unit::None, {1.0, 999.0}, 999.0, When::QuickReady, Agreed{}, Output::No, "IF1 PROFIdrive telegram selection", "wires and locks the inputs of the telegram; 999 frees them"},
    Row{922, 1, kControlUnit, I16, Unit::None, {390.0, 999.0}, 999.0, When::Ready, Agreed{}, Output::No, "IF1 PROFIdrive telegram selection", "wires and locks the inputs of the telegram; 999 frees them"},
    Row{925, 1, kAxes, U16, Unit::None, {0.0, 65535.0}, 1.0, When::Always, Agreed{}, Output::No, "PROFIdrive sign-of-life tolerance", "wrong values in a row that are allowed before F01912; 65535: any number"},
    Row{2030, 1, kControlUnit, I16, Unit::None, {0.0, 13.0}, 7.0, When::Ready, Agreed{}, Output::No, "Fieldbus interface protocol selection", "13 and locked while the configuration asks for Modbus TCP; kept otherwise"},
    Row{2037, 1, kWithProcessData, I16, Unit::None, {0.0, 2.0}, 0.0, When::Ready, Agreed{}, Output::No, "IF1 PROFIdrive STW1.10 = 0 mode", "of an axis: 0 keeps the words without control by PLC, 1 the sign of life too, 2 takes them"},
    Row{2038, 1, kWithProcessData, I16, Unit::None, {0.0, 2.0}, 0.0, When::Ready, Agreed{}, Output::No, "IF1 PROFIdrive STW/ZSW interface mode", "set and locked by the telegram"},
    Row{2040, 1, kControlUnit, U32, Unit::Milliseconds, {0.0, 1999999.0}, 100.0, When::Always, Agreed{}, Output::No, "Fieldbus interface monitoring time", "without process data for so long IF1 has failed; 0: never"},
    Row{2043, 1, kWithProcessData, U8, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::if1_state>, Output::Both, "IF1 PROFIdrive PZD state (BO)", ".0 setpoints have failed, .1 synchronous (never), .2 the fieldbus runs"},
    Row{2044, 1, kWithProcessData, F32, Unit::Seconds, {0.0, 100.0}, 0.0, When::Always, Agreed{}, Output::No, "IF1 PROFIdrive fault delay", "F01910 comes so long behind r2043.0"},
    Row{2045, 1, kWithProcessData, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Agreed{}, Output::No, "CI: IF1 PROFIdrive sign of life source", "the word of r2050 whose bits 12 to 15 are the sign of life"},
    Row{2047, 1, kControlUnit, F32, Unit::Milliseconds, {0.0, 20000.0}, 0.0, When::Always, Agreed{}, Output::No, "IF1 additional monitoring time", "behind p2040; then A01920 and r2043.0"},
    Row{2048, 1, kControlUnit, F32, Unit::Milliseconds, {1.0, 16.0}, 4.0, When::Ready, Agreed{}, Output::No, "IF1 PZD sampling time", "words are taken and sampled with the first cycle of p8848 after that"},
    Row{2050, 20, kControlUnit | kServo, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_word<If1>>, Output::Connector, "IF1 PZD receive word (CO)", "4000h = 100 %", Keep::Stored, nullptr, FullScale::Word},
    Row{2050, 32, kVector, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_word<If1>>, Output::Connector, "IF1 PZD receive word (CO)", "4000h = 100 %", Keep::Stored, nullptr, FullScale::Word},
    Row{2051, 25, kControlUnit, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::SentWord, 0, If1}, Output::No, "CI: IF1 PZD send word", "4000h = 100 %"},
    Row{2051, 28, kServo, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::SentWord, 0, If1}, Output::No, "CI: IF1 PZD send word", "4000h = 100 %"},
    Row{2051, 32, kVector, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::SentWord, 0, If1}, Output::No, "CI: IF1 PZD send word", "4000h = 100 %"},
    Row{2053, 25, kControlUnit, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::sent_word<If1>>, Output::No, "IF1 diagnostics PZD send word", "as of the end of the last cycle"},
    Row{2053, 28, kServo, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::sent_word<If1>>, Output::No, "IF1 diagnostics PZD send word", "as of the end of the last cycle"},
    Row{2053, 32, kVector, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::sent_word<If1>>, Output::No, "IF1 diagnostics PZD send word", "as of the end of the last cycle"},
    Row{2054, 1, kControlUnit, I16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "Fieldbus state", "1 no process data, 4 process data are exchanged"},
    Row{2060, 19, kServo, I32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_double_word<If1>>, Output::Connector, "IF1 PZD receive double word (CO)", "two words, the upper one first; 40000000h = 100 %", Keep::Stored, nullptr, FullScale::DoubleWord},
    Row{2060, 31, kVector, I32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_double_word<If1>>, Output::Connector, "IF1 PZD receive double word (CO)", "two words, the upper one first; 40000000h = 100 %", Keep::Stored, nullptr, FullScale::DoubleWord},
    Row{2061, 27, kServo, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::SentDoubleWord, 0, If1}, Output::No, "CI: IF1 PZD send double word", "two words, the upper one first; 40000000h = 100 %"},
    Row{2061, 31, kVector, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::SentDoubleWord, 0, If1}, Output::No, "CI: IF1 PZD send double word", "two words, the upper one first; 40000000h = 100 %"},
    Row{2063, 27, kServo, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::sent_double_word<If1>>, Output::No, "IF1 diagnostics PZD send double word", "as of the end of the last cycle"},
    Row{2063, 31, kVector, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::sent_double_word<If1>>, Output::No, "IF1 diagnostics PZD send double word", "as of the end of the last cycle"},
    Row{2065, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "IF1 sign-of-life diagnostics", "wrong values since the start"},
    Row{2067, 2, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Agreed{}, Output::No, "IF1 PZD interconnected maximum", "[0] received, [1] sent words"},
    Row{2074, 20, kWithProcessData, U16, Unit::None, kWhole, 65535.0, When::ReadOnly, Agreed{}, Output::No, "IF1 diagnostics: bus address of received word", "65535: none"},
    Row{2075, 20, kWithProcessData, U16, Unit::None, kWhole, 65535.0, When::ReadOnly, Agreed{}, Output::No, "IF1 diagnostics: telegram offset of received word", "byte of the telegram; 65535: not connected"},
    Row{2076, 28, kWithProcessData, U16, Unit::None, kWhole, 65535.0, When::ReadOnly, Agreed{}, Output::No, "IF1 diagnostics: telegram offset of sent word", "byte of the telegram; 65535: not connected"},
    Row{2079, 1, kAxes, I16, Unit::None, {1.0, 999.0}, 999.0, When::QuickReady, Agreed{}, Output::No, "IF1 PZD telegram selection extended", "as p0922, which it follows unless that is 999; what lies behind its words is free"},
    Row{2079, 1, kControlUnit, I16, Unit::None, {1.0, 999.0}, 999.0, When::Ready, Agreed{}, Output::No, "IF1 PZD telegram selection extended", "as p0922, which it follows unless that is 999; what lies behind its words is free"},
    Row{2080, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 0, If1}, Output::No, "BI: IF1 binector-connector converter status word 1", "r2089[0]"},
    Row{2081, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 1, If1}, Output::No, "BI: IF1 binector-connector converter status word 2", "r2089[1]"},
    Row{2082, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 2, If1}, Output::No, "BI: IF1 binector-connector converter free status word 3", "r2089[2]"},
    Row{2083, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 3, If1}, Output::No, "BI: IF1 binector-connector converter free status word 4", "r2089[3]"},
    Row{2084, 16, kWithProcessData, BinectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::BitOfWord, 4, If1}, Output::No, "BI: IF1 binector-connector converter free status word 5", "r2089[4]"},
    Row{2088, 5, kWithProcessData, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Always, setting<&If1Converters::invert_words_of_bits>, Output::No, "IF1 invert binector-connector converter", "acts on r2089; [0] is set by the telegram"},
    Row{2089, 5, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::word_of_bits<If1>>, Output::Both, "IF1 send binector-connector converter (CO)", "the bits of p2080 to p2084, inverted by p2088"},
    Row{2090, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_bits<If1, 0>>, Output::Both, "IF1 PZD1 receive bit-serial (BO)", "r2050[0]"},
    Row{2091, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_bits<If1, 1>>, Output::Both, "IF1 PZD2 receive bit-serial (BO)", "r2050[1]"},
    Row{2092, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_bits<If1, 2>>, Output::Both, "IF1 PZD3 receive bit-serial (BO)", "r2050[2]"},
    Row{2093, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::received_bits<If1, 3>>, Output::Both, "IF1 PZD4 receive bit-serial (BO)", "r2050[3]"},
    Row{2094, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::converted_bits<If1, 0>>, Output::Both, "IF1 connector-binector converter 1 (BO)", "the word of p2099[0], inverted by p2098[0]"},
    Row{2095, 1, kWithProcessData, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<process_value::converted_bits<If1, 1>>, Output::Both, "IF1 connector-binector converter 2 (BO)", "the word of p2099[1], inverted by p2098[1]"},
    Row{2098, 2, kWithProcessData, U16, Unit::None, {0.0, 65535.0}, 0.0, When::Always, setting<&If1Converters::invert_bits_of_words>, Output::No, "IF1 invert connector-binector converter", "acts on r2094 and r2095"},
    Row{2099, 2, kWithProcessData, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, ImageInput{ImageSink::WordOfBits, 0, If1}, Output::No, "CI: IF1 connector-binector converter source", "r2094 and r2095"},
};
// clang-format on

}  // namespace drive::rows
