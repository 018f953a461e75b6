// In the place of the page in a program without it.
#include "viewer/page.hpp"

namespace winnow::viewer {

std::string_view page() {
  return {};
}

}  // namespace winnow::viewer
