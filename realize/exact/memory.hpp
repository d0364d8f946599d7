#pragma once
/// \file
/// What exact arithmetic does when there is no more memory.

namespace hexatlas::exact {

/// From now on std::bad_alloc is thrown where GMP would end the program. For a program to call
/// once, before other threads and before numbers are made. After such an exception memory of GMP
/// may be lost; numbers that were to be changed may only be destroyed.
void throw_when_out_of_memory();

}  // namespace hexatlas::exact
