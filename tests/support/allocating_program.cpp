// Allocates on purpose, so that the allocation counter can be proven: allocating_program FORM N.
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string_view>

#include <malloc.h>

namespace {

void* posix_memory(std::size_t alignment, std::size_t size) {
  void* block = nullptr;
  return posix_memalign(&block, alignment, size) == 0 ? block : nullptr;
}

struct Form {
  std::string_view name;
  void* (*allocate)();
  void (*release)(void*);
};

constexpr std::size_t kSize = 64;
constexpr std::align_val_t kAlignment{64};
// Not a constant: a compiler makes malloc of a realloc that has nothing to resize.
void* volatile nothing = nullptr;

constexpr Form kForms[] = {
    {"nothing", [] { return static_cast<void*>(nullptr); }, &std::free},
    {"malloc", [] { return std::malloc(kSize); }, &std::free},
    {"calloc", [] { return std::calloc(2, kSize); }, &std::free},
    {"realloc", [] { return std::realloc(nothing, kSize); }, &std::free},
    {"reallocarray", [] { return reallocarray(nothing, 2, kSize); }, &std::free},
    {"aligned_alloc", [] { return std::aligned_alloc(kSize, kSize); }, &std::free},
    {"posix_memalign", [] { return posix_memory(kSize, kSize); }, &std::free},
    {"memalign", [] { return memalign(kSize, kSize); }, &std::free},
    {"new", [] { return ::operator new(kSize); }, [](void* block) { ::operator delete(block); }},
    {"aligned new", [] { return ::operator new(kSize, kAlignment); },
     [](void* block) { ::operator delete(block, kAlignment); }},
};

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  for (const Form& form : kForms) {
    if (form.name != words[1]) continue;
    for (int i = std::atoi(words[2]); i > 0; --i) {
      void* volatile block = form.allocate();  // volatile: the pair must not be optimised away
      form.release(block);
    }
    return 0;
  }
  return 2;
}
