#pragma once
/// \file
/// Private to meshing/delaunay: memory that goes back to the system as soon as it is given back.
///
/// The heap keeps what large lists leave behind, tens of megabytes, below what lives on; here the
/// lists of the order of insertion end just before the tetrahedra come. What a list is resized to
/// is not cleared, so the thread that writes it first is the one for which the system finds it.
///
/// Errors: std::bad_alloc if the system has no more room.

#include <sys/mman.h>

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#include "meshing/delaunay/page_buffer.hpp"

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
    ask_for_large_pages(pages, count * sizeof(T));
    return static_cast<T*>(pages);
  }
  void deallocate(T* items, std::size_t count) noexcept {
    if (count < kLargeFrom)
      std::allocator<T>().deallocate(items, count);
    else
      munmap(items, count * sizeof(T));
  }

  template <class U>
  void construct(U* place) noexcept {
    static_assert(std::is_trivially_default_constructible_v<U>);
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Values>
  void construct(U* place, Values&&... values) {
    std::construct_at(place, std::forward<Values>(values)...);
  }

  friend bool operator==(const PageAllocator&, const PageAllocator&) { return true; }

 private:
  static constexpr std::size_t kLargeFrom = 1U << 16;  // items
};

}  // namespace hexatlas::delaunay
