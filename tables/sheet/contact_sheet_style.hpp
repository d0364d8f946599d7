#pragma once
/// \file
/// What all contact sheets have in common: the style and the script of the page. Free of the signs
/// that XML gives a meaning.

#include <string_view>

namespace hexatlas::sheet {

/// In light and dark, on the screen and on paper.
[[nodiscard]] std::string_view page_style();
/// Shows the classes with the chosen answers; the page is complete without it.
[[nodiscard]] std::string_view page_script();

}  // namespace hexatlas::sheet
