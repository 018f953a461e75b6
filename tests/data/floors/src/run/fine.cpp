#include "base/up.hpp"
#include "run/y.hpp"
#include "write/x.hpp"
