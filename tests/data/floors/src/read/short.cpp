#include "../base/up.hpp"
#include "base/up.hpp"
#include "sibling.hpp"

#include <tbb/task.h>
