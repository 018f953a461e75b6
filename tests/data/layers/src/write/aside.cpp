#include "read/sibling.hpp"

#  include "read/sibling.hpp"
#include "io/bytes.hpp"
#include <read/angle.hpp>
