#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::emcy_rules {

inline constexpr Rule kIgnored{
    .id = "emcy.ignored",
    .text = "a node reports an error, and the master goes on as before",
    .clause = "CiA 301 7.2.7.1",
    .severity = Severity::Warning,
    .why = "The drive has stopped, or will; the master sends set-points to nobody and tells nobody.",
    .mend = "Listen to EMCY (80h + node-ID), read 1003h or 603Fh, and lead the drive out of its fault.",
    .example = R"((0.0000) can0 205#0F00
(0.1000) can0 085#3073810000000000
(0.5000) can0 205#0F00
(1.0000) can0 205#0F00
(1.5000) can0 205#0F00
(2.0000) can0 205#0F00
(2.5000) can0 205#0F00
(3.0000) can0 205#0F00
(3.5000) can0 205#0F00)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{&kIgnored};

}  // namespace audit::emcy_rules
