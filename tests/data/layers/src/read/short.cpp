#include "sibling.hpp"
#include "../base/up.hpp"
#include "base/up.hpp"
#include <tbb/task.h>
