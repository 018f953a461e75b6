#include "base/up.hpp"
