#pragma once

/// Marks a class that programs link against: its functions, virtual table and type are visible outside
/// libcanopen.so, everything else is hidden. What inline functions of a marked class use, destructors of members
/// included, is marked as well.
#if defined(__GNUC__)
#define CANOPEN_EXPORT __attribute__((visibility("default")))
#else
#define CANOPEN_EXPORT
#endif
