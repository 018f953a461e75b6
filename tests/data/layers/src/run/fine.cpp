#include "base/up.hpp"
#include "write/x.hpp"
#include "run/y.hpp"
