#include <winnow/version.hpp>

namespace winnow {

Version version() {
  return {WINNOW_VERSION_MAJOR, WINNOW_VERSION_MINOR, WINNOW_VERSION_PATCH};
}

}  // namespace winnow
