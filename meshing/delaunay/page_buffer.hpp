#pragma once
/// \file
/// Private to meshing/delaunay: an array that grows without being copied.
///
/// The pages of a mapping are moved by the system, not copied, and pages that were never written
/// take no memory: capacity is free, size is not. Large pages are asked for, since neighbours in
/// space are reached at random.
///
/// Errors: ResourceFailure if the system has no more room.

#include <sys/mman.h>

#include <cstddef>
#include <type_traits>
#include <utility>

#include "enum/core/errors.hpp"

namespace hexatlas::delaunay {

/// A wish; without it all works as well. The pages of small arrays would be cleared in vain.
inline void ask_for_large_pages(void* pages, std::size_t bytes) noexcept {
  constexpr std::size_t kFrom = std::size_t{1} << 24U;
  if (bytes >= kFrom) madvise(pages, bytes, MADV_HUGEPAGE);
}

template <class T>
class PageBuffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  PageBuffer() = default;
  PageBuffer(PageBuffer&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), capacity_(std::exchange(other.capacity_, 0)) {}
  PageBuffer& operator=(PageBuffer&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(capacity_, other.capacity_);
    return *this;
  }
  PageBuffer(const PageBuffer&) = delete;
  PageBuffer& operator=(const PageBuffer&) = delete;
  ~PageBuffer() {
    if (data_ != nullptr) munmap(data_, bytes_for(capacity_));
  }

  [[nodiscard]] T* data() noexcept { return data_; }
  [[nodiscard]] const T* data() const noexcept { return data_; }
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  [[nodiscard]] T& operator[](std::size_t i) noexcept { return data_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const noexcept { return data_[i]; }

  /// Room for so many; what is new is zero. Keeps the first values, invalidates addresses.
  void resize(std::size_t capacity) {
    void* const moved =
        data_ == nullptr ? mmap(nullptr, bytes_for(capacity), PROT_READ | PROT_WRITE,
                                MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)
                         : mremap(data_, bytes_for(capacity_), bytes_for(capacity), MREMAP_MAYMOVE);
    if (moved == MAP_FAILED) throw core::ResourceFailure("not enough memory for the tetrahedra");
    ask_for_large_pages(moved, bytes_for(capacity));
    data_ = static_cast<T*>(moved);
    capacity_ = capacity;
  }

 private:
  static constexpr std::size_t kPage = std::size_t{1} << 21U;
  [[nodiscard]] static std::size_t bytes_for(std::size_t count) noexcept {
    return (count * sizeof(T) + kPage - 1) / kPage * kPage;
  }

  T* data_ = nullptr;
  std::size_t capacity_ = 0;
};

}  // namespace hexatlas::delaunay
