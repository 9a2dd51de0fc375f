#include "can/preload/socket/link.hpp"

#include <sys/mman.h>
#include <sys/stat.h>

#include "can/preload/hub.hpp"
#include "can/preload/next.hpp"

namespace preload {

namespace {

/// A page that is mapped: it is known by its file.
struct Page {
  std::atomic<uint64_t> file;  ///< inode, 0 = the place is free
  std::atomic<LinkWord*> word;
};

/// Hubs of one process; of more, each socket maps the page for itself.
constexpr int kMostPages = 16;
Page pages[kMostPages];

LinkWord* map(int file) noexcept {
  void* const page = mmap(nullptr, userbus::kLinkPageSize, PROT_READ, MAP_SHARED, file, 0);
  return page == MAP_FAILED ? nullptr : static_cast<LinkWord*>(page);
}

/// Where the page of @p inode is mapped, or is to be from now on; nullptr if there is no place.
Page* place_of(uint64_t inode) noexcept {
  for (Page& page : pages) {
    uint64_t present = 0;
    if (page.file.compare_exchange_strong(present, inode) || present == inode) return &page;
  }
  return nullptr;
}

}  // namespace

LinkWord* link_of(int descriptor) noexcept {
  int file = -1;
  const userbus::Answer answer = ask_for_descriptor(descriptor, userbus::Operation::Link, file);
  if (file < 0) return nullptr;
  struct stat status {};
  LinkWord* word = nullptr;
  if (answer.error == 0 && fstat(file, &status) == 0 && status.st_size == userbus::kLinkPageSize) {
    Page* const page = place_of(status.st_ino);
    if (page != nullptr) word = page->word.load();
    if (word == nullptr) word = map(file);
    if (page != nullptr) page->word.store(word);
  }
  next().close(file);
  return word;
}

}  // namespace preload
