// The functions of xxHash, compiled here: nothing is linked.
#define XXH_IMPLEMENTATION
#include "base/checksum.hpp"
