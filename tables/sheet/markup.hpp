#pragma once
/// \file
/// Text within XML and HTML.

#include <string>
#include <string_view>

namespace hexatlas::sheet {

/// The text with `&`, `<`, `>` and `"` as entities, so that it may stand between tags and in
/// attributes in double quotes. Not promised: that the bytes are UTF-8, or allowed in XML.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace hexatlas::sheet
