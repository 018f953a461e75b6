#include "io/bytes.hpp"
#include "read/sibling.hpp"
#include "read/sibling.hpp"

#include <read/angle.hpp>
