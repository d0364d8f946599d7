#include "realize/exact/memory.hpp"

#include <gmp.h>

#include <cstdlib>
#include <new>

namespace hexatlas::exact {
namespace {

// The same functions as those of GMP by default, so that memory taken before is given back rightly.
void* allocate(std::size_t size) {
  void* result = std::malloc(size);  // NOLINT(cppcoreguidelines-no-malloc)
  if (result == nullptr) throw std::bad_alloc();
  return result;
}

void* reallocate(void* old, std::size_t /*old_size*/, std::size_t size) {
  void* result = std::realloc(old, size);  // NOLINT(cppcoreguidelines-no-malloc)
  if (result == nullptr) throw std::bad_alloc();
  return result;
}

void release(void* memory, std::size_t /*size*/) {
  std::free(memory);  // NOLINT(cppcoreguidelines-no-malloc)
}

}  // namespace

void throw_when_out_of_memory() { mp_set_memory_functions(allocate, reallocate, release); }

}  // namespace hexatlas::exact
