#pragma once
/// \file
/// Private to meshing/delaunay: memory that goes back to the system as soon as it is given back.
///
/// The heap keeps what large lists leave behind, tens of megabytes, below what lives on; here the
/// lists of the order of insertion end just before the tetrahedra come.
///
/// Errors: std::bad_alloc if the system has no more room.

#include <sys/mman.h>

#include <cstddef>
#include <memory>
#include <new>

namespace hexatlas::delaunay {

template <class T>
class PageAllocator {
 public:
  using value_type = T;

  PageAllocator() = default;
  template <class U>
  explicit PageAllocator(const PageAllocator<U>&) noexcept {}

  [[nodiscard]] T* allocate(std::size_t count) {
    if (count < kLargeFrom) return std::allocator<T>().allocate(count);
    void* const pages = mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED) throw std::bad_alloc();
    return static_cast<T*>(pages);
  }
  void deallocate(T* items, std::size_t count) noexcept {
    if (count < kLargeFrom)
      std::allocator<T>().deallocate(items, count);
    else
      munmap(items, count * sizeof(T));
  }

  friend bool operator==(const PageAllocator&, const PageAllocator&) { return true; }

 private:
  static constexpr std::size_t kLargeFrom = 1U << 16;  // items
};

}  // namespace hexatlas::delaunay
