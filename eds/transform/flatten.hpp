#pragma once

#include <span>

#include "eds/document/document.hpp"

namespace eds {

/// The plain file of a device with @p modules, numbers of module types in the order of their places, made from the
/// modular @p document: fixed objects become objects, extensions entries, and the sections of the modules go. A
/// finding for each module that there is none of, or that finds no room; @p document is passed on unchanged then.
[[nodiscard]] Document flatten(const Document& document, std::span<const unsigned> modules, Findings& findings);

}  // namespace eds
