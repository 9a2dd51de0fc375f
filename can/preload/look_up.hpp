#pragma once

#include <cstddef>

#include <dlfcn.h>

namespace preload {

/// A call and where its address goes. All pointers to functions are of one size, and dlsym(3) has but one for all.
struct Entry {
  const char* name;
  void** address;
};

template <class Function>
void** address_of(Function*& call) noexcept {
  return reinterpret_cast<void**>(&call);
}

/// Finds what is behind this library; threads that come here at the same time write the same.
template <size_t count>
void look_up_all(const Entry (&entries)[count]) noexcept {
  for (const Entry& entry : entries) *entry.address = dlsym(RTLD_NEXT, entry.name);
}

}  // namespace preload
