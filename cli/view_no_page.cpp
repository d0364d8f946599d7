#include "cli/view_page.hpp"

namespace hexatlas::cli {

PageParts page_parts() { return {}; }

}  // namespace hexatlas::cli
