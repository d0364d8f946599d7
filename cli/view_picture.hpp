#pragma once
/// \file
/// The picture of a page, made by a Chromium that runs without window and draws without graphics
/// hardware.

#include <string>

namespace hexatlas::cli {

/// The browser: what the variable CHROMIUM names, otherwise the first of chromium,
/// chromium-browser, google-chrome and google-chrome-stable in PATH. Throws ResourceFailure, which
/// says what to install, if there is none.
[[nodiscard]] std::string browser();

struct PictureRequest {
  int width = 0, height = 0;
  int timeout = 0;  ///< seconds
};

/// The page as PNG; nothing if stop_requested(). Its files are in a folder of its own among the
/// temporary ones, which is removed. Throws ResourceFailure if the browser fails, takes too long,
/// or the page does not say that it was drawn.
[[nodiscard]] std::string picture_of(const std::string& page, const std::string& browser,
                                     const PictureRequest& request);

}  // namespace hexatlas::cli
