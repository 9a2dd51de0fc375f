#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::storage_rules {

inline constexpr Rule kSignature{.id = "storage.signature",
                                 .text = "parameters are to be stored or restored with a wrong signature",
                                 .clause = "CiA 301 7.5.2.13",
                                 .why = "Nothing is stored: the device aborts with 08000020h.",
                                 .mend =
                                     "Write 65766173h (\"save\") to 1010h and 64616F6Ch (\"load\") to 1011h; the "
                                     "letters go out in their order.",
                                 .example = R"((0.0000) can0 605#2310100165766173
(0.0010) can0 585#8010100120000008)"};

inline constexpr Rule kOperational{.id = "storage.operational",
                                   .text = "parameters are stored while the node is Operational",
                                   .clause = "CiA 301 7.5.2.13",
                                   .severity = Severity::Warning,
                                   .why =
                                       "Many devices stop their services for the time of a store, or refuse it; "
                                       "what is stored may be a state in between.",
                                   .mend = "Store in Pre-operational, with the drive disabled.",
                                   .example = R"((0.0000) can0 705#05
(0.1000) can0 605#2310100173617665
(0.9000) can0 585#6010100100000000)"};

inline constexpr Rule kOften{
    .id = "storage.often",
    .text = "parameters are stored again and again",
    .clause = "CiA 301 7.5.2.13",
    .severity = Severity::Warning,
    .why = "The memory of a device bears some 100,000 stores; one a minute wears it out in weeks.",
    .mend = "Store at the end of commissioning; write what changes in operation without storing it.",
    .example = R"((0.0000) can0 605#2310100173617665
(0.9000) can0 585#6010100100000000
(5.0000) can0 605#2310100173617665
(5.9000) can0 585#6010100100000000
(10.0000) can0 605#2310100173617665
(10.9000) can0 585#6010100100000000
(15.0000) can0 605#2310100173617665
(15.9000) can0 585#6010100100000000
(20.0000) can0 605#2310100173617665
(20.9000) can0 585#6010100100000000)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{&kSignature, &kOperational, &kOften};

}  // namespace audit::storage_rules
