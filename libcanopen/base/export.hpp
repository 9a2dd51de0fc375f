#pragma once

/// Marks a class whose functions, virtual table and type are visible outside libcanopen.so, which hides everything
/// else: classes that users name, and those that inline functions of the headers work with.
#if defined(__GNUC__)
#define CANOPEN_EXPORT [[gnu::visibility("default")]]
#else
#define CANOPEN_EXPORT
#endif
