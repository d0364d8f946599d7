#pragma once
/// \file
/// Internal to the judge: integers of 128 bits.

namespace hexatlas::check {

// The compilers' name for them is no standard one.
__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using)

}  // namespace hexatlas::check
