#pragma once

namespace os {

/// Gives back the pages of code and constants of the program and its libraries, all of them clean: the kernel
/// brings those in again that are wanted. After the start, which comes past most of them once, that is a small
/// part.
void give_back_clean_pages() noexcept;

}  // namespace os
